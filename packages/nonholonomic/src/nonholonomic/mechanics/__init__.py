"""Equations of motion: from bodies, surfaces and contacts, or a Lagrangian, to a System."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
