"""A body of any smooth convex shape that rolls on a plane or a sphere."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
