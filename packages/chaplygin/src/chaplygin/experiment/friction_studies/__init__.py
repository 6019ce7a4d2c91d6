"""Ensembles, charts and sections of motions with friction."""
