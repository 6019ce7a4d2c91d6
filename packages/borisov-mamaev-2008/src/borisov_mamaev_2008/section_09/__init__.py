"""Claims of §9 of Borisov and Mamaev (2008)."""
