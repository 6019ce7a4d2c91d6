"""Borisov and Mamaev (2008), claim by claim: modules ``section_*`` in reading order.

Each has ``CLAIMS`` (decided by computation) and ``REMARKS`` (not computed).
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
