"""The laboratory in a page: models of pages, the page itself, its server, notebooks."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
