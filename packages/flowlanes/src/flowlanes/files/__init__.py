"""Files that the program keeps: the cache, partial files, files of one user."""
