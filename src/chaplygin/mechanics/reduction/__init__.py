"""Chaplygin's reduction and its reducing multiplier."""
