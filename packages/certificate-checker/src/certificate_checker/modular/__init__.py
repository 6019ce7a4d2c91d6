"""Arithmetic modulo a random prime: the field, and small relations between residues."""
