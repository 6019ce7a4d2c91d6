"""Claims of §1 of Borisov and Mamaev (2008)."""
