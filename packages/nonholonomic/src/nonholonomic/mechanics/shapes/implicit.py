"""Convex bodies given by an equation f = 0.

They have no closed inverse of the Gauss map: the contact point r itself is the state, and the shape
operator W⁻¹ follows from f(r) = 0.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.named_formulas import by_name
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import Symmetric, Vector, real_symbol

from .rays import require_closed
from .shape_base import CentredShape, check_centre, check_values, real_values, require_symbols

#: Names in the equations of an implicit body: the contact point from the geometric centre, and
#: gradient and Hessian of f there.
IMPLICIT_POINT, IMPLICIT_GRADIENT, IMPLICIT_HESSIAN = Vector("x"), Vector("nu"), Symmetric("F")


@arguments_checked
@dataclass(frozen=True)
class Implicit(CentredShape):
    """Any smooth convex body f = 0.

    Parameters
    ----------
    surface : sympy.Expr
        f in the symbols ``x``, ``y``, ``z`` (m; body axes from the geometric centre),
        negative inside.
    values : mapping of Symbol to float
        Values of further symbols in `surface`.
    centre : 3 floats
        Geometric centre relative to the centre of mass (m, body axes).

    Raises
    ------
    InputError
        If `surface` uses an unknown symbol or is not negative at the geometric centre.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, y, z = sp.symbols("x y z")
    >>> cushion = nonholonomic.Implicit(x**4 + y**4 + z**4 + x**2 + y**2 + z**2 - 1)
    >>> nonholonomic.roll(nonholonomic.Body(1.0, (0.2, 0.2, 0.2), cushion)).state
    (M, r)
    """

    surface: sp.Expr
    values: tuple[tuple[sp.Symbol, float], ...] = ()

    coordinates = (real_symbol("x"), real_symbol("y"), real_symbol("z"))

    def __post_init__(self) -> None:
        object.__setattr__(self, "values", real_values(self.values))
        known = (*self.coordinates, *dict(self.values))
        object.__setattr__(self, "surface", by_name(self.surface, known))
        check_values(self.values)
        check_centre(self.centre)
        require_symbols(
            f"surface {self.surface} = 0",
            self.surface.free_symbols,
            set(known),
            "x, y, z",
        )
        inside = sp.N(
            self.surface.subs({**dict(self.values), **dict.fromkeys(self.coordinates, 0)})
        )
        if not (inside.is_real and inside < 0):
            raise InputError(
                f"surface {self.surface} = 0: the left side is {inside} at the geometric centre "
                "x = y = z = 0, and must be negative there (negative inside, zero on the surface)"
            )
        level = sp.lambdify(self.coordinates, self.surface.subs(dict(self.values)), "numpy")
        require_closed(f"surface {self.surface} = 0", level)

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The further symbols of f."""
        return tuple(Parameter(s, "parameter of the surface", value) for s, value in self.values)
