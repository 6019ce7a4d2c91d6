"""Constraints without slip as limits of friction, and of added inertia, with measured orders."""
