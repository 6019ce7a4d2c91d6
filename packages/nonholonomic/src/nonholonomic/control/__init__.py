"""Spherical robots: rotors and masses inside a ball as controls, and the planning of paths."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
