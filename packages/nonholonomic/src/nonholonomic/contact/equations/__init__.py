"""Equations of motion of a body with friction in each mode of its contact."""
