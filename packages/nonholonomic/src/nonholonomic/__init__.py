"""Nonholonomic mechanics: equations of motion, contact, closed forms, the catalogue.

>>> import nonholonomic
>>> ball = nonholonomic.Body(1.0, (1.0, 1.5, 2.1), nonholonomic.Ball(1.0))
>>> system = nonholonomic.rolling_system(ball, nonholonomic.Plane(), "marble")
>>> print(system.title)
Rolling body

Names are imported when first used, so that importing the package costs nothing.
"""

import lazy_loader

from flowlanes.printing.symbol_names import use_letters

from .letters import LETTERS

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

use_letters(LETTERS)
del use_letters, LETTERS
