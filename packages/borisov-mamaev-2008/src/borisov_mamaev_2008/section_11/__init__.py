"""Claims of §11 of Borisov and Mamaev (2008)."""
