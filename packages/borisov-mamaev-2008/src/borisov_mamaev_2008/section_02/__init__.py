"""Claims of §2 of Borisov and Mamaev (2008)."""
