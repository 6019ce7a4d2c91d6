"""Friction of a patch of contact: force and couple for each distribution of pressure."""
