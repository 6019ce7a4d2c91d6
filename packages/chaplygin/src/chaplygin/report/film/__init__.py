"""Motions as films, and as models that move."""
