"""Closed-form solutions: the state of an integrable system at any time, without time steps."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
