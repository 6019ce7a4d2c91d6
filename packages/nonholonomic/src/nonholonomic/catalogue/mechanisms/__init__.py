"""Sleighs, wheels, trailers and other mechanisms in the plane."""
