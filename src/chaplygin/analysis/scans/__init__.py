"""Quantities over a grid of parameters or starts, and the coordinates they are drawn in."""
