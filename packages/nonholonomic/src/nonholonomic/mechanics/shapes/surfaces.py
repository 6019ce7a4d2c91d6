"""Surfaces on which a body rolls: their protocol, the plane and the sphere."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Literal, TypeAlias

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import Vector, constant, cross, dot, real_symbol, to_components

from .gauss_map import GaussMap
from .kinds import Registered
from .kinematics import (
    LevelSurface,
    NormalMotion,
    Placement,
    a,
    gamma,
    gammadot,
    omega,
    r,
    rdot,
    zeta,
)

place = Vector("place", 2)

#: The matrix from body to space components.
Rotation: TypeAlias = sp.ImmutableDenseMatrix


class Surface(Registered, ABC):
    """A fixed surface on which a body rolls; the base of all surfaces.

    A new surface defines its curvature (`swing`, `under_map`), the position of a body in space
    (`placement`, `height`), and its equation for drawings (`equation`).

    Notes
    -----
    A class that sets `kind` is known by that word to experiment files as soon as its module is
    imported; its fields are the keys of the table [surface].

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.mechanics.shapes.surfaces import Surface
    >>> isinstance(nonholonomic.Plane(), Surface), Surface.of_kind("sphere") is nonholonomic.Sphere
    (True, True)
    """

    turntable: float = 0.0
    numbers_are_parameters: ClassVar[bool] = False
    """Whether all members with positive numbers have the same equations."""
    is_flat: ClassVar[bool] = False
    """Whether the surface is a horizontal plane, whose normal is the vertical."""
    vertical: ClassVar[Vector] = zeta
    """Name of the vertical in body axes."""
    relations_of_vertical: ClassVar[tuple[sp.Expr, ...]] = ()
    """Expressions besides ζ² − 1 that vanish for every position, if ζ is a state variable."""
    level: ClassVar[sp.Expr] = a
    """(γ, x) at the contact point x, measured from the origin of space."""

    @property
    @abstractmethod
    def words(self) -> str:
        """Name of the surface in sentences."""

    @property
    def title(self) -> str:
        """Name of the surface in titles."""
        return self.words

    @property
    def setting(self) -> str:
        """The surface with its numbers, for a one-line description of a motion."""
        return self.words

    @property
    def signed_radius(self) -> float | None:
        """Radius a of a sphere, negative inside; None for other surfaces."""
        return None

    @property
    def is_even(self) -> bool:
        """Whether the curvature is constant and isotropic: plane and sphere."""
        return self.is_flat or self.signed_radius is not None

    @property
    @abstractmethod
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters of the surface."""

    @abstractmethod
    def swing(self, slip: MatrixExpr, radius: sp.Expr) -> MatrixExpr:
        """γ×ω + K u, the right-hand side of (E + KW) γ̇ = γ×ω + K u.

        Parameters
        ----------
        slip : MatrixExpr
            u, tangential, in body axes; zero without slip.
        radius : sympy.Expr
            The symbol a, or the radius of a concentric sphere; used by spheres only.
        """

    @abstractmethod
    def under_map(self, body: GaussMap, swing: MatrixExpr, radius: sp.Expr) -> NormalMotion:
        """The rate of the normal under a body with spread W: (E + KW) γ̇ = `swing`."""

    def under_ball(self, ball: GaussMap, swing: MatrixExpr, radius: sp.Expr) -> NormalMotion:
        """The rate of the normal under a ball, whose spread is a multiple of E."""
        return self.under_map(ball, swing, radius)

    def under_level_surface(
        self, body: LevelSurface, swing: MatrixExpr, radius: sp.Expr
    ) -> NormalMotion:
        """The rate of the normal under a body f = 0 with the state r; the definitions have ṙ."""
        return _through_spread(self, body, swing, radius)

    @abstractmethod
    def placement(
        self, reach: MatrixExpr, rate: MatrixExpr, height: sp.Expr, turn: Rotation
    ) -> Placement:
        """The position in space of a body whose contact point is at `reach`.

        Parameters
        ----------
        reach, rate : MatrixExpr
            Contact vector r and its rate, body axes.
        height : sympy.Expr
            −(r, γ).
        turn : matrix
            From body to space components, by the quaternion `attitude`.
        """

    def height(self, reach: MatrixExpr, height: sp.Expr) -> sp.Expr:
        """Height of the centre of mass, for the potential energy of the weight."""
        return dot(a * gamma - reach, zeta)

    def refusal_of_normal(self, normal: Sequence[float]) -> str:
        """Message why the surface has no such normal in space; empty if it has."""
        return ""

    @abstractmethod
    def equation(self, point: Sequence[sp.Symbol]) -> sp.Expr:
        """f of the surface f = 0 in space, in its parameters; positive where the body is."""


@arguments_checked
@dataclass(frozen=True)
class Plane(Surface):
    """The horizontal plane z = 0, with the body above it.

    Parameters
    ----------
    turntable : float
        Angular velocity with which it turns about the z axis (rad/s); only a contact with
        friction can be on a turning support.

    Raises
    ------
    InputError
        If the angular velocity is not finite.

    Examples
    --------
    >>> import nonholonomic
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
    >>> nonholonomic.rolling_system(
    ...     ball, nonholonomic.Plane(), field=nonholonomic.Forces(gravity=9.81)
    ... ).state  # gamma is the vertical
    (M, gamma)
    """

    turntable: float = 0.0

    kind = "plane"
    numbers_are_parameters = True
    is_flat = True
    vertical = gamma
    level = sp.S.Zero

    def __post_init__(self) -> None:
        _require_turn(self.turntable)

    @property
    def words(self) -> str:
        """Name of the surface in sentences."""
        return "a horizontal plane"

    @property
    def title(self) -> str:
        """Name of the surface in titles."""
        return "a plane"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """None."""
        return ()

    def swing(self, slip: MatrixExpr, radius: sp.Expr) -> MatrixExpr:
        """γ×ω, as K = 0."""
        return cross(gamma, omega)

    def under_map(self, body: GaussMap, swing: MatrixExpr, radius: sp.Expr) -> NormalMotion:
        """γ̇ = γ×ω."""
        return NormalMotion(swing, _unchanged)

    def under_level_surface(
        self, body: LevelSurface, swing: MatrixExpr, radius: sp.Expr
    ) -> NormalMotion:
        """γ̇ = γ×ω and ṙ = −W(γ×ω)."""
        wandering = (body.shape_operator(swing) - body.mean * swing) / body.gauss
        return NormalMotion(
            swing, _unchanged, ((rdot, wandering),), volume=(body.slope, body.gauss)
        )

    def placement(
        self, reach: MatrixExpr, rate: MatrixExpr, height: sp.Expr, turn: Rotation
    ) -> Placement:
        """The centre of mass has the velocity r×ω in body axes; its height follows from γ."""
        at = turn * to_components(reach)
        velocity = turn * to_components(cross(reach, omega))
        x, y = place.symbols
        return Placement(
            centre=constant([x, y, height]),
            point=constant([x + at[0], y + at[1], 0]),
            field=((place, constant(velocity[:2])),),
        )

    def height(self, reach: MatrixExpr, height: sp.Expr) -> sp.Expr:
        """−(r, γ)."""
        return height

    def refusal_of_normal(self, normal: Sequence[float]) -> str:
        """Refuse any normal but the vertical."""
        if tuple(normal) == (0.0, 0.0, 1.0):
            return ""
        return "normal is for a sphere alone; on a plane it is always [0, 0, 1]"

    def equation(self, point: Sequence[sp.Symbol]) -> sp.Expr:
        """z."""
        return point[2]


@arguments_checked
@dataclass(frozen=True)
class Sphere(Surface):
    """A fixed sphere about the origin of space.

    Parameters
    ----------
    radius : float
        Positive (m).
    side : ``"outside"`` or ``"inside"``
        Whether the body rolls on the outside (a dome) or on the inside (a bowl).
    turntable : float
        Angular velocity with which it turns about the z axis (rad/s), as for :class:`Plane`.

    Raises
    ------
    InputError
        If the radius is not a positive finite number, or the angular velocity not finite.

    Examples
    --------
    >>> import nonholonomic
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
    >>> bowl = nonholonomic.Sphere(3.0, side="inside")
    >>> nonholonomic.rolling_system(
    ...     ball, bowl, field=nonholonomic.Forces(gravity=9.81)
    ... ).state  # zeta: the vertical, body axes
    (M, gamma, zeta)
    """

    radius: float
    side: Literal["outside", "inside"] = "outside"
    turntable: float = 0.0

    kind = "sphere"
    numbers_are_parameters = True

    def __post_init__(self) -> None:
        _require_turn(self.turntable)
        if self.side not in ("outside", "inside"):
            raise InputError(f"side {self.side!r}: it must be 'outside' or 'inside'")
        if not (math.isfinite(self.radius) and self.radius > 0):
            instead = ""
            if math.isfinite(self.radius) and self.radius < 0:
                instead = f'; for the inside write Sphere({-self.radius!r}, side="inside")'
            raise InputError(
                f"radius {self.radius} of the supporting sphere: it must be a positive finite "
                f"number{instead}"
            )

    @classmethod
    @arguments_checked
    def of_signed_radius(cls, a: float) -> Sphere:
        """The sphere with the radius a of the equations, which is negative inside."""
        return cls(abs(a), "inside" if a < 0 else "outside")

    @property
    def signed_radius(self) -> float:
        """The radius a of the equations, negative inside."""
        return self.radius if self.side == "outside" else -self.radius

    @property
    def words(self) -> str:
        """Name of the surface in sentences."""
        return f"the {self.side} of a fixed sphere"

    @property
    def title(self) -> str:
        """Name of the surface in titles."""
        return "a sphere" if self.side == "outside" else "the inside of a sphere"

    @property
    def setting(self) -> str:
        """The sphere with its radius."""
        return f"a sphere of radius {self.radius:g}, {self.side}"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The signed radius a."""
        meaning = "radius of the supporting sphere, negative inside"
        return (Parameter(a, meaning, self.signed_radius, "m", (sp.Ne(a, 0),)),)

    def swing(self, slip: MatrixExpr, radius: sp.Expr) -> MatrixExpr:
        """γ×ω + u/a."""
        return cross(gamma, omega) + slip / radius

    def under_map(self, body: GaussMap, swing: MatrixExpr, radius: sp.Expr) -> NormalMotion:
        """(E + W/a) γ̇ = `swing`, solved with the Cayley–Hamilton theorem."""
        # With τ = tr W on the tangent plane tr(E + W/a) = 2 + τ/a and a² det(E + W/a) = A_a; the
        # inverse of a 2×2 operator A is (tr A − A)/det A.
        area, trace = real_symbol("A_a"), real_symbol("tau")

        def solve(vector: MatrixExpr) -> MatrixExpr:
            return ((radius**2 + radius * trace) / area) * vector - (radius / area) * body.spread(
                vector
            )

        return NormalMotion(
            gammadot,
            solve,
            (
                (area, radius**2 + radius * body.trace + body.determinant),
                (trace, body.trace),
                (gammadot, solve(swing)),
            ),
            fits(area, 2 * radius**2 + radius * trace),
            volume=(area,),
        )

    def under_ball(self, ball: GaussMap, swing: MatrixExpr, radius: sp.Expr) -> NormalMotion:
        """γ̇ = k `swing` with k = a/(a + R)."""
        k = real_symbol("k")
        return NormalMotion(
            k * swing, lambda force: k * force, ((k, radius / (radius + ball.support)),)
        )

    def under_level_surface(
        self, body: LevelSurface, swing: MatrixExpr, radius: sp.Expr
    ) -> NormalMotion:
        """(S + E/a) ṙ = −`swing`, with the operator S of the curvature of the body."""
        area = real_symbol("A_a")

        def solve(vector: MatrixExpr) -> MatrixExpr:
            """The inverse of S + E/a on tangent vectors."""
            return (1 / area) * ((body.mean + 1 / radius) * vector - body.shape_operator(vector))

        return NormalMotion(
            gammadot,
            lambda force: force - solve(force - dot(gamma, force) * gamma) / radius,
            (
                (area, body.gauss + body.mean / radius + 1 / radius**2),
                (rdot, -solve(swing)),
                (gammadot, swing + rdot / radius),
            ),
            fits(area * radius**2, body.mean + 2 / radius),
            volume=(area, body.slope),
        )

    def placement(
        self, reach: MatrixExpr, rate: MatrixExpr, height: sp.Expr, turn: Rotation
    ) -> Placement:
        """The contact point is aγ, independent of the path of the body."""
        point = a * turn * to_components(gamma)
        return Placement(centre=point - turn * to_components(reach), point=point)

    def equation(self, point: Sequence[sp.Symbol]) -> sp.Expr:
        """√(x, x) − a outside; −a − √(x, x) inside, where a is negative."""
        distance = sp.sqrt(sum(s**2 for s in point))
        return distance - a if self.side == "outside" else -a - distance


def _through_spread(
    surface: Surface, body: LevelSurface, swing: MatrixExpr, radius: sp.Expr
) -> NormalMotion:
    """`under_level_surface` in terms of `under_map`, with W = S⁻¹."""
    as_map = GaussMap(
        parameters=(),
        definitions=(),
        reach=r,
        spread=body.spread,
        trace=body.mean / body.gauss,
        determinant=1 / body.gauss,
        support=-dot(r, gamma),
    )
    moving = surface.under_map(as_map, swing, radius)
    return NormalMotion(
        moving.rate,
        moving.pull,
        (*moving.definitions, (rdot, -body.spread(moving.rate))),
        moving.guards,
        (body.slope, body.gauss, *moving.volume),
        moving.state,
        moving.relations,
        moving.start,
    )


def fits(product: sp.Expr, total: sp.Expr) -> tuple[Guard, Guard]:
    """Guards on product and sum of the eigenvalues of E + KW, up to positive factors."""
    message = "the body does not fit into the sphere at the contact"
    return Guard("fits", product, message), Guard("fits", total, message)


def _unchanged(force: MatrixExpr) -> MatrixExpr:
    return force


def _require_turn(turntable: float) -> None:
    if not math.isfinite(turntable):
        raise InputError(f"turntable {turntable}: it must be a finite angular velocity")
