"""From what one can touch (a body, a surface, a contact) to a System."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
