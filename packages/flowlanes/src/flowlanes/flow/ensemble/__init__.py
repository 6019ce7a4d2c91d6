"""Many motions at once, in blocks that are kept on disk and may run on Dask."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
