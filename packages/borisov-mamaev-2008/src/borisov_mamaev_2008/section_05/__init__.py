"""Claims of §5 of Borisov and Mamaev (2008)."""
