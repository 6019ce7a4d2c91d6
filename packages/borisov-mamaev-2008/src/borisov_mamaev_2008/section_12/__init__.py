"""Claims of §12 of Borisov and Mamaev (2008)."""
