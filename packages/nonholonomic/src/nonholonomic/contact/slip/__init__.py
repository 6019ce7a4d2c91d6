"""Slip close to zero: how it ends, and how it begins."""
