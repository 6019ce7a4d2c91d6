"""Convex shapes: where a body touches, and how fast the contact point wanders over it.

A shape is described by its support function h(ν), the distance of the tangent plane with outward
normal ν from the geometric centre.  The contact point with ν = −γ is ∇h, and its derivative,
the *spread* W = ∂²h, is a symmetric operator on the tangent plane whose eigenvalues are the
principal radii of curvature.  :class:`Implicit` has no closed inverse of the Gauss map; there the
contact point r itself is the state, and the shape operator W⁻¹ follows from f(r) = 0.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from ...arguments import arguments_checked
from ...core.named_formulas import Pairs
from ...core.system import Guard, Parameter
from ...core.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    by_name,
    constant,
    dot,
    identity,
    norm_squared,
    outer,
    real_symbol,
    to_components,
    unit_vector,
    zero,
)
from ...errors import InputError
from .rays import require_closed

__all__ = [
    "Ball",
    "Disk",
    "Ellipsoid",
    "GaussMap",
    "Implicit",
    "Revolution",
    "Shape",
    "Torus",
]


#: A flat face is reached when the symmetry axis leans from the normal by less than this (radians).
FLAT = 1e-6

R = real_symbol("R")
rho = real_symbol("rho")
gamma = Vector("gamma")
c = Vector("c")

#: Names in the equations of an implicit body: the contact point from the geometric centre, and
#: gradient and Hessian of f there.
IMPLICIT_POINT, IMPLICIT_GRADIENT, IMPLICIT_HESSIAN = Vector("x"), Vector("nu"), Symmetric("F")


@dataclass(frozen=True)
class GaussMap:
    """A shape seen through its inverse Gauss map, as formulas in γ.

    Attributes
    ----------
    parameters : tuple of Parameter
    definitions : pairs
        Named intermediate quantities used below.
    reach : MatrixExpr
        From the geometric centre to the contact point (body axes).
    spread : callable
        u ↦ W u for a vector u of the tangent plane; the rate of `reach` is −W γ̇.
    trace, determinant : sympy.Expr
        Sum and product of the principal radii of curvature at the contact.
    support : sympy.Expr
        Height of the geometric centre above the tangent plane.
    guards : tuple of Guard
    """

    parameters: tuple[Parameter, ...]
    definitions: Pairs
    reach: MatrixExpr
    spread: Callable[[MatrixExpr], MatrixExpr]
    trace: sp.Expr
    determinant: sp.Expr
    support: sp.Expr
    guards: tuple[Guard, ...] = ()


def convexity(product: sp.Expr, total: sp.Expr) -> tuple[Guard, Guard]:
    """Product and sum of the principal curvatures, up to positive factors: both are positive."""
    message = "the contact leaves the convex part of the body"
    return Guard("convex", product, message), Guard("convex", total, message)


def _length(symbol: sp.Symbol, meaning: str, value: float) -> Parameter:
    return Parameter(symbol, meaning, value, "m", (symbol > 0,))


def _positive(shape: str, **lengths: float) -> None:
    for name, value in lengths.items():
        if not (math.isfinite(value) and value > 0):
            raise InputError(f"{name} {value} of the {shape}: it must be a positive finite number")


def real_values(values: Any) -> tuple[tuple[sp.Symbol, float], ...]:
    """Values by real symbols, whatever else was assumed of these."""
    return tuple((real_symbol(str(symbol)), value) for symbol, value in dict(values).items())


def check_values(values: tuple[tuple[sp.Symbol, float], ...]) -> None:
    """Raise InputError unless every parameter of a formula has a finite value."""
    for symbol, value in values:
        if not math.isfinite(value):
            raise InputError(f"parameter {symbol} = {value}: it must be a finite number")


def _require_known(what: str, used: set[sp.Symbol], known: set[sp.Symbol], variables: str) -> None:
    """Raise InputError if a formula uses a symbol that is neither variable nor parameter."""
    unknown = sorted(map(str, used - known))
    if unknown:
        raise InputError(
            f"{what}: {', '.join(unknown)} is not known; it may use {variables} and the "
            "parameters of the shape"
        )


def _check_centre(centre: tuple[float, float, float]) -> None:
    if len(centre) != 3 or not all(math.isfinite(x) for x in centre):
        raise InputError(f"centre {centre}: it must be three finite numbers")


@dataclass(frozen=True)
class _Centred:
    """Common to all shapes: `centre` is the geometric centre minus the centre of mass."""

    centre: tuple[float, float, float] = field(default=(0.0, 0.0, 0.0), kw_only=True)

    @property
    def offset(self) -> MatrixExpr:
        """The vector c from the centre of mass to the geometric centre; zero if they agree."""
        return c if any(self.centre) else zero

    @property
    def offset_parameters(self) -> tuple[Parameter, ...]:
        """The components of c, if it is not zero."""
        if not any(self.centre):
            return ()
        return tuple(
            Parameter(s, f"geometric centre minus centre of mass, body axis {i}", x, "m")
            for i, (s, x) in enumerate(zip(c.symbols, self.centre, strict=True), 1)
        )


@arguments_checked
@dataclass(frozen=True)
class Ball(_Centred):
    """A ball of the given radius; a hollow one rolls with its inner surface around a sphere.

    Parameters
    ----------
    radius : float
        R > 0, in m.
    hollow : bool
    centre : 3 floats
        Geometric centre minus centre of mass, body axes (m); so for all shapes.

    Raises
    ------
    InputError
        If the radius is not positive.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ball = ch.Ball(0.01, centre=(0.0, 0.0, 0.002))
    >>> ball.gauss().reach  # from the geometric centre to the contact point, body axes
    (-R)*gamma
    """

    radius: float
    hollow: bool = False

    def __post_init__(self) -> None:
        _positive("ball", radius=self.radius)
        _check_centre(self.centre)

    def gauss(self) -> GaussMap:
        """The map r = c − R γ, and r = c + R γ for a hollow ball."""
        signed = -R if self.hollow else R
        return GaussMap(
            parameters=(_length(R, "radius of the ball", self.radius),),
            definitions=(),
            reach=-signed * gamma,
            spread=lambda u: signed * u,
            trace=2 * signed,
            determinant=R**2,
            support=signed,
        )


def _tensor_map(
    B: MatrixExpr,
    determinant: sp.Expr,
    trace: sp.Expr,
    tube: sp.Expr,
    parameters: tuple[Parameter, ...],
    definitions: Pairs,
    guards: tuple[Guard, ...] = (),
) -> GaussMap:
    """The support function √(ν, Bν) + ρ: an ellipsoid, or a disk, thickened by a ball."""
    s = real_symbol("s")
    Bg = B * gamma
    return GaussMap(
        parameters=parameters,
        definitions=(*definitions, (s, sp.sqrt(dot(gamma, Bg)))),
        reach=-tube * gamma - Bg / s,
        spread=lambda u: tube * u + B * u / s - (dot(Bg, u) / s**3) * Bg,
        trace=2 * tube + trace / s - norm_squared(Bg) / s**3,
        determinant=tube**2 + tube * (trace / s - norm_squared(Bg) / s**3) + determinant / s**4,
        support=tube + s,
        guards=guards,
    )


@arguments_checked
@dataclass(frozen=True)
class Ellipsoid(_Centred):
    """An ellipsoid with semi-axes `axes`, its third axis along body axis 3.

    Parameters
    ----------
    axes : 3 floats
        Semi-axes (m).
    turn : float
        Angle δ between the first semi-axis, (cos δ, sin δ, 0) in body axes, and body axis 1 (rad).
        With δ ≠ 0 and unequal principal moments this is a rattleback.

    Raises
    ------
    InputError
        If there are not three positive semi-axes, or the angle is not finite.

    Examples
    --------
    >>> import chaplygin as ch
    >>> shape = ch.Ellipsoid((0.2, 0.03, 0.02), turn=-0.0143, centre=(0.0, 0.0, 0.01))
    >>> stone = ch.roll(ch.Body(1.0, (2e-4, 16e-4, 17e-4), shape), field=ch.Forces(gravity=9.81))
    >>> ch.prove(stone, "energy").decision
    'proven'
    """

    axes: tuple[float, float, float]
    turn: float = 0.0

    def __post_init__(self) -> None:
        if len(self.axes) != 3:
            raise InputError(f"axes {self.axes} of the ellipsoid: three semi-axes are needed")
        if not math.isfinite(self.turn):
            raise InputError(f"turn {self.turn} of the ellipsoid: it must be a finite angle")
        for i, value in enumerate(self.axes, 1):
            _positive("ellipsoid", **{f"semi-axis {i}": value})
        _check_centre(self.centre)

    def gauss(self) -> GaussMap:
        """The map r = c − Bγ/√(γ, Bγ), where B has the squared semi-axes as eigenvalues."""
        b = tuple(real_symbol(f"b_{i}") for i in (1, 2, 3))
        squares = [x**2 for x in b]
        parameters = tuple(
            _length(s, f"semi-axis {i} of the ellipsoid", x)
            for i, (s, x) in enumerate(zip(b, self.axes, strict=True), 1)
        )
        B: Diagonal | Symmetric = Diagonal("B")
        matrix = constant(sp.diag(*squares))
        if self.turn:
            B = Symmetric("B")
            delta = real_symbol("delta")
            cos, sin = sp.cos(delta), sp.sin(delta)
            turn = constant([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]])
            matrix = turn * matrix * turn.T
            parameters += (
                Parameter(delta, "angle from body axis 1 to semi-axis 1", self.turn, "rad"),
            )
        return _tensor_map(
            B, sp.Mul(*squares), sp.Add(*squares), sp.S.Zero, parameters, ((B, matrix),)
        )


def _rim(radius: float, tube: sp.Expr, parameters: tuple[Parameter, ...], what: str) -> GaussMap:
    across = identity - outer(unit_vector(3), unit_vector(3))
    B = Diagonal("B")
    lean = gamma.symbols[0] ** 2 + gamma.symbols[1] ** 2
    return _tensor_map(
        B,
        sp.S.Zero,
        2 * R**2,
        tube,
        (_length(R, f"radius of the {what}", radius), *parameters),
        ((B, R**2 * to_components(across)),),
        (
            Guard(
                "flat",
                lean - sp.Rational(str(FLAT)) ** 2,
                f"the body lies flat (tilt below {FLAT:g} rad)",
            ),
        ),
    )


@arguments_checked
@dataclass(frozen=True)
class Disk(_Centred):
    """A disk with a sharp circular edge of the given radius, normal to body axis 3.

    Parameters
    ----------
    radius : float
        R > 0, in m.

    Raises
    ------
    InputError
        If the radius is not positive.

    Examples
    --------
    >>> import chaplygin as ch
    >>> coin = ch.Body(0.005, (1.25e-7, 1.25e-7, 2.5e-7), ch.Disk(0.01))
    >>> system = ch.roll(coin, field=ch.Forces(gravity=9.81))
    >>> [guard.message for guard in system.guards]
    ['the body lies flat (tilt below 1e-06 rad)', 'the normal force changes sign']
    """

    radius: float

    def __post_init__(self) -> None:
        _positive("disk", radius=self.radius)
        _check_centre(self.centre)

    def gauss(self) -> GaussMap:
        """The map r = c − R (γ₁, γ₂, 0)/√(γ₁² + γ₂²); lying flat is outside its domain."""
        return _rim(self.radius, sp.S.Zero, (), "disk")


@arguments_checked
@dataclass(frozen=True)
class Torus(_Centred):
    """A disk with a rounded edge: the convex outer part of a torus about body axis 3.

    Parameters
    ----------
    radius : float
        Radius R of the circle of the tube's centres (m).
    tube : float
        Radius ρ of the tube (m).

    Raises
    ------
    InputError
        If a radius is not positive.

    Examples
    --------
    >>> import chaplygin as ch
    >>> coin = ch.Body(0.005, (1.25e-7, 1.25e-7, 2.5e-7), ch.Torus(0.009, 0.001))
    >>> ch.roll(coin).defaults
    {m: 0.005, I_1: 1.25e-07, I_2: 1.25e-07, I_3: 2.5e-07, R: 0.009, rho: 0.001}
    """

    radius: float
    tube: float

    def __post_init__(self) -> None:
        _positive("torus", radius=self.radius, tube=self.tube)
        _check_centre(self.centre)

    def gauss(self) -> GaussMap:
        """The map of a disk, thickened by ρ: r = c − R (γ₁, γ₂, 0)/√(γ₁² + γ₂²) − ργ."""
        return _rim(
            self.radius, rho, (_length(rho, "radius of the tube", self.tube),), "centre circle"
        )


@arguments_checked
@dataclass(frozen=True)
class Revolution(_Centred):
    """A convex body of revolution about body axis 3.

    Parameters
    ----------
    support : sympy.Expr
        Height p(γ₃) of the geometric centre above the plane (m), in the symbol ``gamma_3``.
    values : mapping of Symbol to float
        Values of further symbols in `support`.

    Raises
    ------
    InputError
        If `support` uses an unknown symbol, or is not positive for an upright axis.

    See Also
    --------
    Revolution.from_profile : the same from the functions χ₁, χ₂ of §5.

    Examples
    --------
    >>> import chaplygin as ch
    >>> import sympy as sp
    >>> u, a, b = sp.symbols("gamma_3 a b")
    >>> egg = ch.Revolution(sp.sqrt(a**2 * (1 - u**2) + b**2 * u**2), {a: 0.02, b: 0.03})
    >>> system = ch.roll(ch.Body(0.05, (8e-6, 8e-6, 6e-6), egg), contact="rubber")
    >>> ch.prove(system, "energy").decision
    'proven'
    """

    support: sp.Expr
    values: tuple[tuple[sp.Symbol, float], ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "values", real_values(self.values))
        known = (gamma.symbols[2], *dict(self.values))
        object.__setattr__(self, "support", by_name(self.support, known))
        check_values(self.values)
        _check_centre(self.centre)
        _require_known(
            f"support function {self.support}",
            self.support.free_symbols,
            set(known),
            "gamma_3",
        )
        for cosine in (-1.0, -0.5, 0.0, 0.5, 1.0):
            value = self._at(self.support, cosine)
            if not (math.isfinite(value) and value > 0):
                raise InputError(
                    f"support function {self.support} is {value:g} at gamma_3 = {cosine:g}: it "
                    "must be positive, the distance of the tangent plane from the centre"
                )

    @classmethod
    @arguments_checked
    def from_profile(
        cls,
        chi_1: sp.Expr,
        chi_2: sp.Expr,
        values: Mapping[sp.Symbol, float] | None = None,
        centre: tuple[float, float, float] = (0.0, 0.0, 0.0),
    ) -> Revolution:
        """The body with r − c = (χ₁γ₁, χ₁γ₂, χ₂), χ₁ and χ₂ in ``gamma_3`` (§5).

        Raises
        ------
        InputError
            If an unknown symbol occurs, or χ₁ and χ₂ do not belong to one surface with normal
            −γ, that is, if −γ₃χ₁ + (1 − γ₃²)χ₁′ + γ₃χ₂′ is not zero.
        """
        u = gamma.symbols[2]
        table = dict(real_values(values or {}))
        chi_1, chi_2 = (by_name(chi, (u, *table)) for chi in (chi_1, chi_2))
        _require_known(
            f"profile chi_1 = {chi_1}, chi_2 = {chi_2}",
            chi_1.free_symbols | chi_2.free_symbols,
            {u, *table},
            "gamma_3",
        )
        defect = -u * chi_1 + (1 - u**2) * chi_1.diff(u) + u * chi_2.diff(u)
        for cosine in (sp.Rational(n, 17) for n in (-16, -9, -2, 5, 12)):
            here = {**table, u: cosine}
            number = sp.N(defect.subs(here))
            if abs(number) > 1e-9 * (1 + abs(sp.N(chi_1.subs(here)))):
                raise InputError(
                    f"profile chi_1 = {chi_1}, chi_2 = {chi_2}: the surface has no normal -gamma, "
                    f"since -gamma_3 chi_1 + (1 - gamma_3^2) chi_1' + gamma_3 chi_2' is {number} "
                    f"at gamma_3 = {cosine} and must be zero"
                )
        return cls(-(chi_1 * (1 - u**2) + chi_2 * u), tuple(table.items()), centre=centre)

    def _at(self, expression: sp.Expr, cosine: float) -> float:
        number = expression.subs({**dict(self.values), gamma.symbols[2]: cosine})
        return float(sp.N(number)) if number.is_real is not False else math.nan

    def gauss(self) -> GaussMap:
        """The map r = c − pγ − p′(e₃ − γ₃γ); radii of curvature p − γ₃p′ and that + (1 − γ₃²)p″."""
        u = gamma.symbols[2]
        p, first, second = real_symbol("p"), real_symbol("pprime"), real_symbol("pprime2")
        slope = unit_vector(3) - u * gamma
        parallel = p - u * first
        meridian = parallel + (1 - u**2) * second
        return GaussMap(
            parameters=tuple(
                Parameter(s, "parameter of the profile", value) for s, value in self.values
            ),
            definitions=(
                (p, self.support),
                (first, self.support.diff(u)),
                (second, self.support.diff(u, 2)),
            ),
            reach=-p * gamma - first * slope,
            spread=lambda w: parallel * w + (second * dot(slope, w)) * slope,
            trace=parallel + meridian,
            determinant=parallel * meridian,
            support=p,
            guards=convexity(parallel * meridian, parallel + meridian),
        )


@arguments_checked
@dataclass(frozen=True)
class Implicit(_Centred):
    """Any smooth convex body f = 0.

    Parameters
    ----------
    surface : sympy.Expr
        f in the symbols ``x``, ``y``, ``z`` (m; body axes from the geometric centre),
        negative inside.
    values : mapping of Symbol to float
        Values of further symbols in `surface`.

    Raises
    ------
    InputError
        If `surface` uses an unknown symbol or is not negative at the geometric centre.

    Examples
    --------
    >>> import chaplygin as ch
    >>> import sympy as sp
    >>> x, y, z = sp.symbols("x y z")
    >>> cushion = ch.Implicit(x**4 + y**4 + z**4 + x**2 + y**2 + z**2 - 1)
    >>> ch.roll(ch.Body(1.0, (0.2, 0.2, 0.2), cushion)).state
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
        _check_centre(self.centre)
        _require_known(
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


Shape = Ball | Ellipsoid | Disk | Torus | Revolution | Implicit
