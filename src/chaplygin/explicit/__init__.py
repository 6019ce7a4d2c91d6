"""Closed forms: the state of an integrable system at any time, without integrating its way there."""
