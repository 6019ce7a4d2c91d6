"""Euler's top, the free rigid body, in elliptic functions."""
