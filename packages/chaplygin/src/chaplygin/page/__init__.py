"""The page of a study: what it knows of a motion, and the page itself."""
