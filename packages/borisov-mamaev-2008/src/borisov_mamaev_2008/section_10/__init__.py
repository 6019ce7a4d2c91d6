"""Claims of §10 of Borisov and Mamaev (2008)."""
