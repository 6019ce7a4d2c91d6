"""Claims of §4 of Borisov and Mamaev (2008)."""
