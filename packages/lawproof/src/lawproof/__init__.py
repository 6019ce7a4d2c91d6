"""Conservation laws of differential equations: stated, proved, refuted, searched for.

>>> import flowlanes
>>> import lawproof
>>> import sympy as sp
>>> x, v = sp.symbols("x v", real=True)
>>> energy = flowlanes.Integral("energy", v**2 / 2 - sp.cos(x))
>>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)}, laws=[energy])
>>> lawproof.prove(pendulum, energy).decision
'proven'

Names are imported when first used, so that importing the package costs nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
