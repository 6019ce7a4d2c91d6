"""Obstructions to integrals and to invariant measures, for claims of Borisov and Mamaev (2008)."""
