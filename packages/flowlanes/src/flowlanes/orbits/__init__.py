"""Periodic orbits, their continuation and multipliers; rotation numbers; limit cycles."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
