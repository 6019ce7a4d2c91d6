"""Spherical robots: balls controlled by internal rotors and masses, and path planning."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
