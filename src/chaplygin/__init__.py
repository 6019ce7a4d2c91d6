"""A laboratory for nonholonomic mechanics: equations, laws, motions and reports.

>>> import chaplygin
>>> ball = chaplygin.Body(1.0, (1.0, 1.5, 2.1), chaplygin.Ball(1.0))
>>> system = chaplygin.roll(ball, chaplygin.Plane(), "marble")
>>> print(system.title)
Rolling body

Names are imported when first used, so that importing the package costs nothing.
"""

import lazy_loader

from .displays import use_printers

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def _printers() -> object:
    from . import printing
    from .printing import formula, system  # noqa: F401  (attributes of the folder)

    return printing


use_printers(_printers)
del use_printers
