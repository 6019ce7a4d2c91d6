"""A heavy homogeneous ball on a ring lying flat: energy, area and two linear equations.

The linear integrals of the marble ball exist, as on every surface of revolution, but on a torus no
closed form of them is known; the law "meridian" gives the equations whose solutions they are.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import real_symbol, vectors

from ...mechanics.ball.equations import ball_equations, ball_parameters, centre_surface
from ..ball_laws import meridian_law

(R,) = vectors("R")
m, g = real_symbol("m"), real_symbol("g")


def any_revolution() -> System:
    """A heavy marble ball whose centre moves on any surface of revolution, with its axis up."""
    first, second, third = R.symbols
    profile = sp.Function("h")(first**2 + second**2)
    weight = Parameter(g, "acceleration of gravity", 9.81, "m/s^2")
    system = ball_equations(
        "marble",
        centre_surface(third - profile),
        -m * g * unit_vector(3),
        (*ball_parameters(1.0, 0.4, 1.0), weight),
        name="marble-ball-on-any-surface-of-revolution",
        title="Marble ball on any surface of revolution",
    )
    return replace(system, reconstruction=None).with_laws(meridian_law())
