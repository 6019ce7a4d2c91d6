"""Claims of §3 of Borisov and Mamaev (2008)."""
