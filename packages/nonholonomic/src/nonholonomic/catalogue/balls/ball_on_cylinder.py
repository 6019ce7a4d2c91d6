"""A homogeneous ball inside an upright pipe goes round, and comes up again instead of falling.

On a circular cylinder ω₃ is constant, and so is the rate Ω at which the ball goes round.  So is
(ω, R) = ω₃z − cσ, where the centre moves inside at the distance c from the axis with the spin σ
about the normal.  With it the height z obeys

    z̈ + μ/(μ + mb²) Ω² z = const:

the ball oscillates, √(7/2) turns to one oscillation if it is solid.  A rubber ball falls.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import real_symbol, vectors

from ...mechanics.ball.equations import ball_equations, ball_parameters, centre_surface
from ..ball_laws import ROLLING

R, omega = vectors("R omega")
m, g = real_symbol("m"), real_symbol("g")


def any_cylinder() -> System:
    """A heavy marble ball in an upright pipe of any cross-section f(R₁, R₂) = const."""
    first, second, _ = R.symbols
    weight = Parameter(g, "acceleration of gravity", 9.81, "m/s^2")
    system = ball_equations(
        "marble",
        centre_surface(sp.Function("f")(first, second)),
        -m * g * unit_vector(3),
        (*ball_parameters(1.0, 0.4, 1.0), weight),
        name="marble-ball-on-any-cylinder",
        title="Marble ball on any cylinder",
    )
    rotation = Integral(
        "rotation",
        omega.symbols[2],
        "angular velocity about the vertical, on every cylinder",
        source=ROLLING,
        unit="rad/s",
    )
    return replace(system, reconstruction=None).with_laws(rotation)
