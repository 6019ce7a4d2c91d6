"""Claims of §6 of Borisov and Mamaev (2008)."""
