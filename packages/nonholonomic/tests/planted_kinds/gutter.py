"""A new surface: the inside of a cylinder that lies along the x axis of space."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import (
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
)
from nonholonomic.mechanics.rolling.attitude import rotation
from nonholonomic.mechanics.shapes.gauss_map import GaussMap
from nonholonomic.mechanics.shapes.kinematics import (
    NormalMotion,
    Placement,
    a,
    gamma,
    gammadot,
    omega,
    zeta,
)
from nonholonomic.mechanics.shapes.surfaces import Rotation, Surface

#: Direction of the cylinder in body axes, and across it along the surface; way along it.
generator, across, along = Vector("generator"), Vector("across"), real_symbol("along")


@dataclass(frozen=True)
class Gutter(Surface):
    """The inside of a cylinder of some radius about the x axis."""

    radius: float

    kind = "gutter"
    words = "the inside of a horizontal cylinder"
    relations_of_vertical = (dot(generator, zeta),)

    def __post_init__(self) -> None:
        if not self.radius > 0:
            raise InputError(f"radius {self.radius} of the gutter: it must be positive")

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The signed radius, negative as for the inside of a sphere."""
        return (Parameter(a, "radius of the gutter, negative", -self.radius, "m", (a < 0,)),)

    def swing(self, slip: MatrixExpr, radius: sp.Expr) -> MatrixExpr:
        """γ×ω + K u, where K u = (d, u) d/a with d = γ×e."""
        bend = (dot(cross(gamma, generator), slip) / radius) * cross(gamma, generator)
        return cross(gamma, omega) + bend

    def under_map(self, body: GaussMap, swing: MatrixExpr, radius: sp.Expr) -> NormalMotion:
        """(E + KW)⁻¹ by Sherman and Morrison: u − d (d, Wu)/(a + (d, Wd))."""
        fit = real_symbol("A_a")
        bent = body.spread(across)
        motion = self.under_ball(body, swing, radius)
        return replace(
            motion,
            rate=gammadot,
            pull=lambda force: force - (dot(across, force) / fit) * bent,
            definitions=(
                (across, cross(gamma, generator)),
                (fit, radius + dot(across, bent)),
                (gammadot, swing - (dot(bent, swing) / fit) * across),
            ),
            guards=(Guard("fits", -fit, "the body does not fit into the gutter"),),
        )

    def under_ball(self, ball: GaussMap, swing: MatrixExpr, radius: sp.Expr) -> NormalMotion:
        """The same with (d, Wu) = R (d, u)."""

        def solve(vector: MatrixExpr) -> MatrixExpr:
            share = ball.support / (radius + ball.support)
            around = cross(gamma, generator)
            return vector - (share * dot(around, vector)) * around

        return NormalMotion(
            solve(swing),
            solve,
            state=((generator, cross(generator, omega)),),
            relations=(norm_squared(generator) - 1, dot(generator, gamma)),
            start=((generator, constant(list(rotation().row(0)))), (along, sp.S.Zero)),
        )

    def placement(
        self, reach: MatrixExpr, rate: MatrixExpr, height: sp.Expr, turn: Rotation
    ) -> Placement:
        """The contact wanders along the cylinder as over the body."""
        point = sp.Matrix([along, 0, 0]) + a * turn * to_components(gamma)
        row = turn.row(0)
        return Placement(
            centre=constant(list(point - turn * to_components(reach))),
            point=constant(list(point)),
            field=((along, dot(generator, rate)),),
            relations=tuple(x - y for x, y in zip(row, to_components(generator), strict=True)),
        )

    def refusal_of_normal(self, normal: Sequence[float]) -> str:
        """The normal has no part along x."""
        return "normal has no part along x in a gutter" if normal[0] else ""

    def equation(self, point: Sequence[sp.Symbol]) -> sp.Expr:
        """The distance from the wall."""
        return -a - sp.sqrt(point[1] ** 2 + point[2] ** 2)
