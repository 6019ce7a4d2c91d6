"""Friction of a patch of contact: force and couple for each distribution of pressure."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
