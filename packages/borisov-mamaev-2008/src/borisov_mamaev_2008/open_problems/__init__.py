"""Decisions on the open problems of §12: findings, and their computations."""
