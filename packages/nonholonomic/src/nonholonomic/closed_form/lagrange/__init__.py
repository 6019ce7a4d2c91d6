"""The Lagrange top in elliptic functions."""
