"""Fast integration and analysis of smooth vector fields.

Motions, ensembles, Poincaré sections, periodic orbits, Lyapunov exponents and scans of a
`System`, which is written once in symbols and compiled to machine code.

>>> import sympy as sp
>>> import flowlanes
>>> x, v = sp.symbols("x v", real=True)
>>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
>>> motion = flowlanes.integrate(pendulum, {"x": 1.0, "v": 0.0}, [0.0, 5.0])
>>> motion["x"].shape
(2,)

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
