"""Constraints: whether they are integrable, growth vectors, reconstruction."""
