"""Computations shared by several claims of Borisov and Mamaev (2008)."""
