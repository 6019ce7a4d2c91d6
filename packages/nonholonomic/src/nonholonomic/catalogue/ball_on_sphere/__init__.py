"""Balls that roll on a sphere or around one, and systems isomorphic to them."""
