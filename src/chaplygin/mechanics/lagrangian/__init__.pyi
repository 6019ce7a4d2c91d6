from .mechanism import (
    Frame as Frame,
    Mechanism as Mechanism,
    coordinates as coordinates,
    euclidean as euclidean,
)
from .plan import Plan as Plan
from .poincare_suslov import equations as equations
from .sympy_import import from_sympy as from_sympy, mechanism_from_sympy as mechanism_from_sympy
