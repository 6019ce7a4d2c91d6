"""Separations of variables, one module per system."""
