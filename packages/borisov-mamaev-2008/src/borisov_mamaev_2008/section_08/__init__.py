"""Claims of §8 of Borisov and Mamaev (2008)."""
