"""The laboratory in a browser and in a notebook: the server of its page."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
