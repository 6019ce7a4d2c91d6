"""Sliding bodies with friction, whose laws are proved for any force at the contact."""
