"""Arithmetic modulo a random prime: its field, and small relations between residues."""
