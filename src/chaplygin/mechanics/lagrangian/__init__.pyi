from ..sympy_models.conversion import (
    from_sympy as from_sympy,
    mechanism_from_sympy as mechanism_from_sympy,
)
from .mechanism import (
    Frame as Frame,
    Mechanism as Mechanism,
    coordinates as coordinates,
    euclidean as euclidean,
)
from .plan import Plan as Plan
from .poincare_suslov import equations as equations
