"""Convex bodies given by an equation f = 0.

Their inverse Gauss map has no closed form: the contact point r itself is the state, and the shape
operator W⁻¹ follows from the derivatives of f.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.arguments import FormulaParameters, arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import Pairs, by_name
from flowlanes.system.vectors import Symmetric, Vector, constant, dot, norm_squared, real_symbol

from ..formula_parameters import formula_parameters
from .gauss_map import GaussMap, contact_points_of_normals
from .kinematics import Contact, LevelSurface, gamma, r, rdot
from .rays import require_closed
from .shape_base import Shape, check_centre, convexity, require_symbols
from .surfaces import Surface

#: Names in the equations of an implicit body: the contact point from the geometric centre, and
#: gradient and Hessian of f there.
IMPLICIT_POINT, IMPLICIT_GRADIENT, IMPLICIT_HESSIAN = Vector("x"), Vector("nu"), Symmetric("F")


@arguments_checked
@dataclass(frozen=True)
class ImplicitShape(Shape):
    """Any smooth convex body f = 0.

    Parameters
    ----------
    surface : sympy.Expr
        f in the symbols ``x``, ``y``, ``z`` (m; body axes from the geometric centre),
        negative inside.
    parameters : mapping of str or Symbol to float, or sequence of Parameter
        Further symbols in `surface`, with their values.
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
    >>> cushion = nonholonomic.ImplicitShape(x**4 + y**4 + z**4 + x**2 + y**2 + z**2 - 1)
    >>> nonholonomic.rolling_system(nonholonomic.Body(1.0, (0.2, 0.2, 0.2), cushion)).state
    (M, r)
    """

    surface: sp.Expr
    parameters: FormulaParameters = ()

    kind = "implicit"
    by_equation = True
    coordinates = (real_symbol("x"), real_symbol("y"), real_symbol("z"))

    def __post_init__(self) -> None:
        declared = formula_parameters(self.parameters, "parameter of the surface")
        object.__setattr__(self, "parameters", declared)
        known = (*self.coordinates, *self._values)
        object.__setattr__(self, "surface", by_name(self.surface, known))
        check_centre(self.centre)
        require_symbols(
            f"surface {self.surface} = 0",
            self.surface.free_symbols,
            set(known),
            "x, y, z",
        )
        inside = sp.N(self.surface.subs({**self._values, **dict.fromkeys(self.coordinates, 0)}))
        if not (inside.is_real and inside < 0):
            raise InputError(
                f"surface {self.surface} = 0: the left side is {inside} at the geometric centre "
                "x = y = z = 0, and must be negative there (negative inside, zero on the surface)"
            )
        level = sp.lambdify(self.coordinates, self.surface.subs(self._values), "numpy")
        require_closed(f"surface {self.surface} = 0", level)

    @property
    def _values(self) -> dict[sp.Symbol, float]:
        return {p.symbol: p.default for p in self.parameters}

    @property
    def title(self) -> str:
        """Name of the shape for titles."""
        return "Convex body"

    def gauss(self) -> GaussMap:
        """None.

        Raises
        ------
        InputError
            Always.
        """
        raise InputError(
            "shape: an implicit surface has no formula for its point of contact; give a ball, an "
            "ellipsoid, a disk, a torus or a body of revolution"
        )

    def contact(self, surface: Surface, swing: MatrixExpr, radius: sp.Expr) -> Contact:
        """The contact kinematics of f(r − c) = 0 with the state r and the shape operator S."""
        x = IMPLICIT_POINT
        f = self.level(x)
        slope, ell = IMPLICIT_GRADIENT, real_symbol("ell")
        F, G = IMPLICIT_HESSIAN, Symmetric("G")
        hessian = constant(sp.hessian(f, x.symbols))
        mean, gauss = real_symbol("sigma"), real_symbol("kappa")
        trace = sp.Add(*(F.entries[i, i] for i in range(3)))

        def shape_operator(vector: MatrixExpr) -> MatrixExpr:
            return (F * vector - dot(gamma, F * vector) * gamma) / ell

        # Curvatures of a level surface: S = (F − γ⊗Fγ)/ℓ on tangent vectors, tr S = (tr F − (γ,
        # Fγ))/ℓ and det S = (γ, adj(F) γ)/ℓ² (R. Goldman, Comput. Aided Geom. Design 22 (2005)
        # 632).
        body = LevelSurface(shape_operator, mean, gauss, ell)
        moving = surface.under_level_surface(body, swing, radius)
        definitions: Pairs = (
            (x, r - self.offset),
            (slope, constant([sp.diff(f, s) for s in x.symbols])),
            (ell, sp.sqrt(norm_squared(slope))),
            (gamma, -slope / ell),
            (F, hessian),
            (G, constant(F.entries.adjugate())),
            (mean, (trace - dot(gamma, F * gamma)) / ell),
            (gauss, dot(gamma, G * gamma) / ell**2),
            *moving.definitions,
        )
        return Contact(
            state=((r, rdot), *moving.state),
            relations=(self._level_of_state(f), *moving.relations),
            parameters=self.parameters + self.offset_parameters + surface.parameters,
            definitions=definitions,
            guards=(*convexity(gauss, mean), *moving.guards),
            r=r,
            rdot=rdot,
            gammadot=moving.rate,
            square=norm_squared(r),
            height=-dot(r, gamma),
            spread=body.spread,
            pull=moving.pull,
            volume=moving.volume,
            start=moving.start,
        )

    def level(self, point: Vector) -> sp.Expr:
        """f at a point from the geometric centre."""
        return self.surface.xreplace(dict(zip(self.coordinates, point.symbols, strict=True)))

    def _level_of_state(self, f: sp.Expr) -> sp.Expr:
        """f as a function of the state r."""
        offset = self.offset
        shift = (0, 0, 0) if not isinstance(offset, Vector) else offset.symbols
        names = zip(IMPLICIT_POINT.symbols, r.symbols, shift, strict=True)
        return f.xreplace({s: t - d for s, t, d in names})

    def _points(self) -> Callable[[FloatArray], FloatArray]:
        # by Newton's method
        centre = np.array(self.centre)
        f = self.surface.subs(self._values)
        return lambda gamma: centre + contact_points_of_normals(f, self.coordinates, gamma)

    @property
    def centre_outside(self) -> bool:
        """Whether f is positive at the centre of mass."""
        if not any(self.centre):
            return False
        at = dict(zip(self.coordinates, -np.array(self.centre), strict=True))
        return bool(self.surface.subs({**self._values, **at}) > 0)
