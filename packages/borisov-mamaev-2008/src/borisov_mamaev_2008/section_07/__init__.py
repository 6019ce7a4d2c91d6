"""Claims of §7 of Borisov and Mamaev (2008)."""
