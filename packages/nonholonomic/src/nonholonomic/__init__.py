"""Nonholonomic mechanics: equations of motion, contact, closed forms, the catalogue.

>>> import nonholonomic
>>> ball = nonholonomic.Body(1.0, (1.0, 1.5, 2.1), nonholonomic.Ball(1.0))
>>> system = nonholonomic.rolling_system(ball, nonholonomic.Plane(), "marble")
>>> print(system.title)
Rolling body

Names are imported when first used, so that importing the package costs nothing.
"""

import lazy_loader

from flowlanes.displays import use_letters

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def _letters() -> object:
    from .letters import LETTERS

    return LETTERS


use_letters(_letters)
del use_letters
