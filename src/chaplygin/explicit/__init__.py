"""Closed forms: the state of an integrable system at any time, not integrated step by step."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
