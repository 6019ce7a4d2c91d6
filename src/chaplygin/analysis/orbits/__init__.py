"""Periodic orbits, their continuation and multipliers; rotation numbers; limit cycles."""
