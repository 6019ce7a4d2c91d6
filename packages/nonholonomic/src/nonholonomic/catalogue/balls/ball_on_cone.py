"""A homogeneous ball in an upright funnel: its centre moves on a circular cone.

Of the marble ball ω₃ is constant, and so is (ω, R) with R from the apex: the spin about the ruling
falls off as the distance from the apex grows.  On a cone of any base (ω, R) is constant without
gravity.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import dot, norm_squared, vectors

from ...mechanics.ball.equations import ball_equations, ball_parameters, centre_surface
from ..ball_laws import ROLLING

R, omega, v = vectors("R omega v")


def any_cone() -> System:
    """A marble ball whose centre moves on any cone R₃ = R₁ h(R₂/R₁), drawn to the apex or not."""
    first, second, third = R.symbols
    shape = first * sp.Function("h")(second / first)
    central = sp.Function("U")(*scalars(norm_squared(R)))
    system = ball_equations(
        "marble",
        centre_surface(third - shape),
        -gradient(central, R),
        ball_parameters(1.0, 0.4, 1.0),
        name="marble-ball-on-any-cone",
        title="Marble ball on any cone",
    )
    field = dict(system.field)
    speed_1, speed_2, _ = v.symbols
    on_cone = replace(
        system,
        field={first: speed_1, second: speed_2, omega: field[omega]},
        definitions=((third, shape), *system.definitions),
        reconstruction=None,
    )
    return on_cone.with_laws(
        Integral(
            "ray",
            dot(omega, R),
            "turning about the ruling times its length, on every cone",
            source=ROLLING,
            unit="m rad/s",
        )
    )
