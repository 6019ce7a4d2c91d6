"""Poincaré maps and sections."""
