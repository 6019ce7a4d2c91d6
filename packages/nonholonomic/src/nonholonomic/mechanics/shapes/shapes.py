"""Convex shapes with a closed-form inverse Gauss map.

The maps are those of :mod:`nonholonomic.mechanics.shapes.shape_base`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vector_operators import outer, unit_vector
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    constant,
    dot,
    identity,
    norm_squared,
    real_symbol,
    to_components,
)

from .gauss_map import GaussMap
from .kinematics import Contact, gamma, r
from .shape_base import AxialSymmetry, SupportShape, check_centre, length, require_positive
from .surfaces import Surface

#: Smallest angle between symmetry axis and normal (rad); below it the body lies flat.
FLAT = 1e-6

R = real_symbol("R")
rho = real_symbol("rho")
b = tuple(real_symbol(f"b_{i}") for i in (1, 2, 3))
g_3 = gamma.symbols[2]


@arguments_checked
@dataclass(frozen=True)
class Ball(SupportShape):
    """A ball; a hollow one rolls with its inner surface around a sphere.

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
    >>> import nonholonomic
    >>> ball = nonholonomic.Ball(0.01, centre=(0.0, 0.0, 0.002))
    >>> ball.gauss().reach  # from the geometric centre to the contact point, body axes
    (-R)*gamma
    """

    radius: float
    hollow: bool = False

    kind = "ball"
    numbers_are_parameters = True

    def __post_init__(self) -> None:
        require_positive("ball", radius=self.radius)
        check_centre(self.centre)

    @property
    def title(self) -> str:
        """Name of the shape for titles."""
        return "Hollow ball" if self.hollow else "Ball"

    @property
    def signed_radius(self) -> float:
        """The radius, negative of a hollow ball."""
        return -self.radius if self.hollow else self.radius

    @property
    def axial_symmetry(self) -> AxialSymmetry:
        """Symmetry without conditions."""
        return AxialSymmetry((), -R if self.hollow else R)

    def gauss(self) -> GaussMap:
        """The map r = c − R γ, and r = c + R γ for a hollow ball."""
        signed = -R if self.hollow else R
        return GaussMap(
            parameters=(length(R, "radius of the ball", self.radius),),
            definitions=(),
            reach=-signed * gamma,
            spread=lambda u: signed * u,
            trace=2 * signed,
            determinant=R**2,
            support=signed,
        )

    def contact(self, surface: Surface, swing: MatrixExpr, radius: sp.Expr) -> Contact:
        """γ̇ and ṙ are multiples of `swing`.

        Raises
        ------
        InputError
            If the ball is larger than its bowl, or a hollow ball is not around a smaller sphere.
        """
        self._require_room(surface)
        ball, c = self.gauss(), self.offset
        moving = surface.under_ball(ball, swing, radius)
        definitions = moving.definitions
        reach, square = ball.reach, ball.determinant
        if any(self.centre):
            definitions += ((r, c + ball.reach),)
            reach, square = r, norm_squared(r)
        return Contact(
            state=((gamma, moving.rate), *moving.state),
            relations=(norm_squared(gamma) - 1, *moving.relations),
            parameters=ball.parameters + self.offset_parameters + surface.parameters,
            definitions=definitions,
            guards=moving.guards,
            r=reach,
            rdot=-ball.spread(moving.rate),
            gammadot=moving.rate,
            square=square,
            height=ball.support - dot(c, gamma),
            spread=ball.spread,
            pull=moving.pull,
            volume=moving.volume,
            start=moving.start,
        )

    def _require_room(self, surface: Surface) -> None:
        around = surface.signed_radius
        if self.hollow and (around is None or not 0 < around < self.radius):
            raise InputError(
                f"hollow ball of radius {self.radius:g}: it rolls around the outside of a sphere "
                "of positive, smaller radius"
            )
        if not self.hollow and around is not None and -self.radius <= around < 0:
            raise InputError(
                f"ball of radius {self.radius:g} in a bowl of radius {-around:g}: the bowl must be "
                "the larger one"
            )

    @property
    def centre_outside(self) -> bool:
        """Whether the centre of mass lies outside the sphere."""
        return bool(np.linalg.norm(np.array(self.centre)) > self.radius)

    def heights(self, normals: FloatArray) -> FloatArray:
        """Extent from the centre of mass along unit vectors (n, 3)."""
        heights: FloatArray = normals @ np.array(self.centre) + self.radius
        return heights


def _tensor_map(
    B: MatrixExpr,
    determinant: sp.Expr,
    trace: sp.Expr,
    tube: sp.Expr,
    parameters: tuple[Parameter, ...],
    definitions: Pairs,
    guards: tuple[Guard, ...] = (),
) -> GaussMap:
    """The map of the support function √(ν, Bν) + ρ: an ellipsoid or a disk, thickened by a ball."""
    # h(ν) = s + ρ|ν| with s = √(ν, Bν) gives ∇h = Bν/s + ρν and W = ∂²h = ρE + B/s − Bν⊗Bν/s³ at ν
    # = −γ. The normal is a null vector of W − ρE, so that the trace over space is that over the
    # tangent plane; there the product of the eigenvalues of W − ρE is det B/s⁴.
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
class Ellipsoid(SupportShape):
    """An ellipsoid with semi-axes `axes`, its third axis along body axis 3.

    Parameters
    ----------
    axes : 3 floats
        Semi-axes (m).
    turn : float
        Angle δ between the first semi-axis, (cos δ, sin δ, 0) in body axes, and body axis 1 (rad).
        With δ ≠ 0 and unequal principal moments this is a rattleback.
    centre : 3 floats
        Geometric centre relative to the centre of mass (m, body axes).

    Raises
    ------
    InputError
        If there are not three positive semi-axes, or the angle is not finite.

    Examples
    --------
    >>> import lawproof
    >>> import nonholonomic
    >>> shape = nonholonomic.Ellipsoid((0.2, 0.03, 0.02), turn=-0.0143, centre=(0.0, 0.0, 0.01))
    >>> stone = nonholonomic.rolling_system(
    ...     nonholonomic.Body(1.0, (2e-4, 16e-4, 17e-4), shape),
    ...     field=nonholonomic.Forces(gravity=9.81),
    ... )
    >>> lawproof.prove(stone, "energy").decision
    'proven'
    """

    axes: tuple[float, float, float]
    turn: float = 0.0

    kind = "ellipsoid"
    numbers_are_parameters = True
    is_ellipsoid = True

    def __post_init__(self) -> None:
        if len(self.axes) != 3:
            raise InputError(f"axes {self.axes} of the ellipsoid: three semi-axes are needed")
        if not math.isfinite(self.turn):
            raise InputError(f"turn {self.turn} of the ellipsoid: it must be a finite angle")
        for i, value in enumerate(self.axes, 1):
            require_positive("ellipsoid", **{f"semi-axis {i}": value})
        check_centre(self.centre)

    @property
    def is_turned(self) -> bool:
        """Whether the semi-axes are turned from the body axes."""
        return self.turn != 0

    @property
    def axial_symmetry(self) -> AxialSymmetry:
        """Symmetry if the first two semi-axes agree."""
        support = sp.sqrt(b[0] ** 2 * (1 - g_3**2) + b[2] ** 2 * g_3**2)
        return AxialSymmetry((b[0] - b[1],), support)

    def gauss(self) -> GaussMap:
        """The map r = c − Bγ/√(γ, Bγ), where B has the squared semi-axes as eigenvalues."""
        squares = [x**2 for x in b]
        parameters = tuple(
            length(s, f"semi-axis {i} of the ellipsoid", x)
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
        (length(R, f"radius of the {what}", radius), *parameters),
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
class Disk(SupportShape):
    """A disk with a sharp circular edge of the given radius, normal to body axis 3.

    Parameters
    ----------
    radius : float
        R > 0, in m.
    centre : 3 floats
        Geometric centre relative to the centre of mass (m, body axes).

    Raises
    ------
    InputError
        If the radius is not positive.

    Examples
    --------
    >>> import nonholonomic
    >>> coin = nonholonomic.Body(0.005, (1.25e-7, 1.25e-7, 2.5e-7), nonholonomic.Disk(0.01))
    >>> system = nonholonomic.rolling_system(coin, field=nonholonomic.Forces(gravity=9.81))
    >>> [guard.message for guard in system.guards]
    ['the body lies flat (tilt below 1e-06 rad)', 'the normal force changes sign']
    """

    radius: float

    kind = "disk"
    numbers_are_parameters = True
    has_flat_face = True

    def __post_init__(self) -> None:
        require_positive("disk", radius=self.radius)
        check_centre(self.centre)

    @property
    def edge_radius(self) -> float:
        """Radius of the disk."""
        return self.radius

    @property
    def axial_symmetry(self) -> AxialSymmetry:
        """Symmetry without conditions."""
        return AxialSymmetry((), R * sp.sqrt(1 - g_3**2))

    @property
    def centre_outside(self) -> bool:
        """Whether the centre of mass is farther from the axis than the rim."""
        return bool(np.linalg.norm(np.array(self.centre)[:2]) > self.radius)

    def gauss(self) -> GaussMap:
        """The map r = c − R (γ₁, γ₂, 0)/√(γ₁² + γ₂²); lying flat is outside its domain."""
        return _rim(self.radius, sp.S.Zero, (), "disk")


@arguments_checked
@dataclass(frozen=True)
class Torus(SupportShape):
    """A disk with a rounded edge: the convex outer part of a torus about body axis 3.

    Parameters
    ----------
    radius : float
        Radius R of the circle of the tube's centres (m).
    tube : float
        Radius ρ of the tube (m).
    centre : 3 floats
        Geometric centre relative to the centre of mass (m, body axes).

    Raises
    ------
    InputError
        If a radius is not positive.

    Examples
    --------
    >>> import nonholonomic
    >>> coin = nonholonomic.Body(
    ...     0.005, (1.25e-7, 1.25e-7, 2.5e-7), nonholonomic.Torus(0.009, 0.001)
    ... )
    >>> nonholonomic.rolling_system(coin).defaults
    {m: 0.005, I_1: 1.25e-07, I_2: 1.25e-07, I_3: 2.5e-07, R: 0.009, rho: 0.001}
    """

    radius: float
    tube: float

    kind = "torus"
    numbers_are_parameters = True
    has_flat_face = True

    def __post_init__(self) -> None:
        require_positive("torus", radius=self.radius, tube=self.tube)
        check_centre(self.centre)

    @property
    def title(self) -> str:
        """Name of the shape for titles."""
        return "Disk with a rounded edge"

    @property
    def axial_symmetry(self) -> AxialSymmetry:
        """Symmetry without conditions."""
        return AxialSymmetry((), rho + R * sp.sqrt(1 - g_3**2))

    @property
    def centre_outside(self) -> bool:
        """Whether the centre of mass is farther from the axis than the rim."""
        return bool(np.linalg.norm(np.array(self.centre)[:2]) > self.radius + self.tube)

    def gauss(self) -> GaussMap:
        """The map of a disk, thickened by ρ: r = c − R (γ₁, γ₂, 0)/√(γ₁² + γ₂²) − ργ."""
        return _rim(
            self.radius, rho, (length(rho, "radius of the tube", self.tube),), "centre circle"
        )
