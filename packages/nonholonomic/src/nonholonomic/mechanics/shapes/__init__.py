"""Convex bodies by the inverse of their Gauss map, and the surfaces on which they roll."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
