"""Closed forms: the state of an integrable system at any time, not integrated step by step."""
