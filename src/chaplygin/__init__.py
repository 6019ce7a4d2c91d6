"""A laboratory for nonholonomic mechanics: equations, laws, motions and reports.

>>> import chaplygin
>>> ball = chaplygin.Body(1.0, (1.0, 1.5, 2.1), chaplygin.Ball(1.0))
>>> system = chaplygin.roll(ball, chaplygin.Plane(), "marble")
>>> print(system.title)
Rolling body

Names are imported when first used, so that importing the package costs nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
