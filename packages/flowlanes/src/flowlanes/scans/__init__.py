"""Quantities over a grid of parameters or starts, and the coordinates they are drawn in."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
