"""Computations that several claims of Borisov and Mamaev (2008) share."""
