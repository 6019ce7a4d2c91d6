"""Surfaces f = 0 on which a homogeneous ball rolls, or on which its centre moves.

f grows towards the ball. The centre of the ball moves on the parallel surface. For planes, spheres,
circular cylinders and tori this has an equation of the same kind; for other surfaces it has no
simple equation.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal, TypeAlias

import sympy as sp

from flowlanes.arguments import FormulaParameters, arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.named_formulas import by_name
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import real_symbol

from ..formula_parameters import formula_parameters
from ..shapes.kinds import Registered

Axis = Literal["x", "y", "z"]
Side = Literal["outside", "inside"]
Point: TypeAlias = tuple[sp.Symbol, ...]

a, c, k, p, q = (real_symbol(name) for name in ("a", "c", "k", "p", "q"))
axes = tuple(real_symbol(f"a_{i}") for i in (1, 2, 3))


@dataclass(frozen=True, kw_only=True)
class SmoothSurface(Registered, ABC):
    """The interface of all surfaces.

    Parameters
    ----------
    side : ``"outside"`` or ``"inside"``
        Side of the surface with the ball: f of `level` is larger outside, which includes above, and
        smaller inside.
    axis : ``"x"``, ``"y"`` or ``"z"``
        Space axis along the third axis of the surface; the others follow cyclically.
    """

    side: Side = "outside"
    axis: Axis = "z"

    @property
    def title(self) -> str:
        """Name of the surface for titles, with an article."""
        return f"a {self.kind.replace('_', ' ').replace('-', ' ')}"

    @property
    @abstractmethod
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters of the surface."""

    @abstractmethod
    def level(self, point: Point, offset: sp.Expr) -> sp.Expr | None:
        """f of the parallel surface at distance `offset`; None if it has no simple equation."""

    def guards(self, point: Point) -> tuple[Guard, ...]:
        """Further quantities that must stay positive."""
        return ()

    @property
    def widest(self) -> float | None:
        """Upper bound of the radius of a ball inside; None if only the curvature limits it."""
        return None

    @property
    def sign(self) -> int:
        """1 outside, −1 inside."""
        return 1 if self.side == "outside" else -1

    def own_coordinates(self, point: Point) -> Point:
        """Coordinates along the surface's own axes."""
        first = {"z": 0, "x": 1, "y": 2}[self.axis]
        return (*point[first:], *point[:first])

    def equation(self, point: Point, offset: sp.Expr = sp.S.Zero) -> sp.Expr | None:
        """f, positive on the ball's side, of the parallel surface at distance `offset`.

        None if that surface has no simple equation, which happens for nonzero `offset` only.
        """
        level = self.level(self.own_coordinates(point), self.sign * offset)
        return None if level is None else self.sign * level

    def domain(self, point: Point) -> tuple[Guard, ...]:
        """`guards` in space axes."""
        return self.guards(self.own_coordinates(point))


def _number(symbol: sp.Symbol, meaning: str, value: float) -> Parameter:
    _finite(meaning, (value,))
    if value <= 0:
        raise InputError(f"{meaning} {value}: it must be a positive finite number")
    return Parameter(symbol, meaning, float(value), "m", (symbol > 0,))


def _finite(meaning: str, values: Iterable[float]) -> None:
    for value in values:
        if not math.isfinite(value):
            raise InputError(f"{meaning} {value}: it must be a finite number")


@arguments_checked
@dataclass(frozen=True)
class FlatSurface(SmoothSurface):
    """The plane z = 0.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> surface = nonholonomic.mechanics.ball.FlatSurface()
    >>> surface.equation(sp.symbols("x y z", real=True)), isinstance(surface, SmoothSurface)
    (z, True)
    """

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """None."""
        return ()

    def level(self, point: Point, offset: sp.Expr) -> sp.Expr:
        """z − offset."""
        return point[2] - offset


@arguments_checked
@dataclass(frozen=True)
class SphericalSurface(SmoothSurface):
    """A sphere of radius a about the origin.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> surface = nonholonomic.mechanics.ball.SphericalSurface(2.0)
    >>> surface.equation(sp.symbols("x y z", real=True))
    -a**2 + x**2 + y**2 + z**2
    """

    radius: float

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The radius."""
        return (_number(a, "radius of the sphere", self.radius),)

    @property
    def widest(self) -> float | None:
        """The radius, inside."""
        return self.radius if self.side == "inside" else None

    def level(self, point: Point, offset: sp.Expr) -> sp.Expr:
        """x² + y² + z² − (a + offset)²."""
        return sp.Add(*(s**2 for s in point)) - (a + offset) ** 2


@arguments_checked
@dataclass(frozen=True)
class CircularCylinder(SmoothSurface):
    """A circular cylinder of radius a.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> surface = nonholonomic.mechanics.ball.CircularCylinder(2.0)
    >>> surface.equation(sp.symbols("x y z", real=True))
    -a**2 + x**2 + y**2
    """

    radius: float

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The radius."""
        return (_number(a, "radius of the cylinder", self.radius),)

    @property
    def widest(self) -> float | None:
        """The radius, inside."""
        return self.radius if self.side == "inside" else None

    def level(self, point: Point, offset: sp.Expr) -> sp.Expr:
        """x² + y² − (a + offset)²."""
        return point[0] ** 2 + point[1] ** 2 - (a + offset) ** 2


@arguments_checked
@dataclass(frozen=True)
class EllipticCylinder(SmoothSurface):
    """An elliptic cylinder with the semi-axes a₁, a₂.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> surface = nonholonomic.mechanics.ball.EllipticCylinder((2.0, 3.0))
    >>> surface.equation(sp.symbols("x y z", real=True))
    -1 + y**2/a_2**2 + x**2/a_1**2
    """

    axes: tuple[float, float]

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The semi-axes."""
        return tuple(
            _number(s, f"semi-axis {i} of the cylinder", value)
            for i, (s, value) in enumerate(zip(axes[:2], self.axes, strict=True), 1)
        )

    def level(self, point: Point, offset: sp.Expr) -> sp.Expr | None:
        """x²/a₁² + y²/a₂² − 1; None for a nonzero offset."""
        x, y, _ = point
        return x**2 / axes[0] ** 2 + y**2 / axes[1] ** 2 - 1 if offset == 0 else None


@arguments_checked
@dataclass(frozen=True)
class Cone(SmoothSurface):
    """The half z > 0 of a circular cone about the axis with the apex at the origin.

    Parameters
    ----------
    slope : float
        k = tan of the angle between the axis and the rulings: x² + y² = k²z².

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> surface = nonholonomic.mechanics.ball.Cone(1.0, side="inside")
    >>> surface.equation(sp.symbols("x y z", real=True))
    k**2*z**2 - x**2 - y**2
    """

    slope: float

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The slope."""
        meaning = "radius of the cone at unit height"
        return (Parameter(k, meaning, _number(k, meaning, self.slope).default, "1", (k > 0,)),)

    def level(self, point: Point, offset: sp.Expr) -> sp.Expr | None:
        """x² + y² − k²z²; None for a nonzero offset, which moves the apex by a root of 1 + k²."""
        x, y, z = point
        return x**2 + y**2 - k**2 * z**2 if offset == 0 else None

    def guards(self, point: Point) -> tuple[Guard, ...]:
        """The height above the apex."""
        return (Guard("apex", point[2], "the ball has come to the apex of the cone"),)


@arguments_checked
@dataclass(frozen=True)
class EllipsoidSurface(SmoothSurface):
    """An ellipsoid with the semi-axes a₁, a₂, a₃ about the origin.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> surface = nonholonomic.mechanics.ball.EllipsoidSurface((2.0, 3.0, 4.0))
    >>> surface.equation(sp.symbols("x y z", real=True))
    -1 + z**2/a_3**2 + y**2/a_2**2 + x**2/a_1**2
    """

    axes: tuple[float, float, float]

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The semi-axes."""
        return tuple(
            _number(s, f"semi-axis {i} of the ellipsoid", value)
            for i, (s, value) in enumerate(zip(axes, self.axes, strict=True), 1)
        )

    def level(self, point: Point, offset: sp.Expr) -> sp.Expr | None:
        """x²/a₁² + y²/a₂² + z²/a₃² − 1; None for a nonzero offset."""
        if offset != 0:
            return None
        return sp.Add(*(s**2 / axis**2 for s, axis in zip(point, axes, strict=True))) - 1


@arguments_checked
@dataclass(frozen=True)
class Paraboloid(SmoothSurface):
    """The paraboloid z = x²/2p + y²/2q, hyperbolic if p and q differ in sign.

    Parameters
    ----------
    radii : 2 floats
        Radii of curvature p, q at the vertex; positive where it bends up.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> surface = nonholonomic.mechanics.ball.Paraboloid((2.0, 3.0))
    >>> surface.equation(sp.symbols("x y z", real=True))
    z - y**2/(2*q) - x**2/(2*p)
    """

    radii: tuple[float, float]

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The radii of curvature at the vertex."""
        parameters = []
        for symbol, value, name in zip((p, q), self.radii, "xy", strict=True):
            meaning = f"radius of curvature at the vertex, along {name}"
            _finite(meaning, (value,))
            if value == 0:
                raise InputError(f"{meaning}: it must not be zero")
            parameters.append(Parameter(symbol, meaning, float(value), "m", (sp.Ne(symbol, 0),)))
        return tuple(parameters)

    def level(self, point: Point, offset: sp.Expr) -> sp.Expr | None:
        """z − x²/2p − y²/2q; None for a nonzero offset."""
        x, y, z = point
        return z - x**2 / (2 * p) - y**2 / (2 * q) if offset == 0 else None


@arguments_checked
@dataclass(frozen=True)
class Ring(SmoothSurface):
    """A torus about the axis: tubes of radius c around a circle of radius a.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> surface = nonholonomic.mechanics.ball.Ring(3.0, 1.0)
    >>> surface.equation(sp.symbols("x y z", real=True))
    -4*a**2*(x**2 + y**2) + (a**2 - c**2 + x**2 + y**2 + z**2)**2
    """

    radius: float
    tube: float

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Both radii."""
        radius = _number(a, "radius of the circle in the tube", self.radius)
        tube = _number(c, "radius of the tube", self.tube)
        return (radius, tube)

    @property
    def widest(self) -> float | None:
        """The radius, inside."""
        return self.tube if self.side == "inside" else None

    def level(self, point: Point, offset: sp.Expr) -> sp.Expr:
        """(x² + y² + z² + a² − c²)² − 4a²(x² + y²), with c + offset for c."""
        x, y, z = point
        tube = c + offset
        return (x**2 + y**2 + z**2 + a**2 - tube**2) ** 2 - 4 * a**2 * (x**2 + y**2)


@arguments_checked
@dataclass(frozen=True)
class ImplicitSurface(SmoothSurface):
    """Any surface f(x, y, z) = 0; f is positive outside and negative inside.

    Parameters
    ----------
    formula : sympy.Expr
        f in the symbols ``x``, ``y``, ``z`` and those of `parameters`.
    parameters : mapping of str or Symbol to float, or sequence of Parameter

    Examples
    --------
    >>> import nonholonomic
    >>> x, y, z = nonholonomic.mechanics.ball.ImplicitSurface.coordinates
    >>> nonholonomic.mechanics.ball.ImplicitSurface(x**4 + y**4 + z**4 - 1).formula
    x**4 + y**4 + z**4 - 1
    """

    formula: sp.Expr
    parameters: FormulaParameters = ()

    coordinates = tuple(real_symbol(name) for name in "xyz")

    def __post_init__(self) -> None:
        declared = formula_parameters(self.parameters, "number in the surface")
        object.__setattr__(self, "parameters", declared)

    def level(self, point: Point, offset: sp.Expr) -> sp.Expr | None:
        """The formula; no simple equation elsewhere."""
        known = (*self.coordinates, *(p.symbol for p in self.parameters))
        replaced = dict(zip(self.coordinates, point, strict=True))
        return by_name(self.formula, known).xreplace(replaced) if offset == 0 else None
