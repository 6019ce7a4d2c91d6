"""Constraints without slip as limits of friction or added inertia, with measured orders."""
