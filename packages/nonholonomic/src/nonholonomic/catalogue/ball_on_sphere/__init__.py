"""Balls that roll on a sphere or around one, and what they are isomorphic to."""
