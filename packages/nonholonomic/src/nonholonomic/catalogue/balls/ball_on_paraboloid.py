"""A heavy marble ball whose centre moves on a paraboloid, elliptic or hyperbolic.

Joachimsthal's integral in gravity survives on it.  On a paraboloid of revolution two integrals
linear in ω hold besides, with the exponents ±√(μ/(μ + mb²)) of ℓ = |∇f|; their product is
quadratic without a root.
"""

from __future__ import annotations

from ...mechanics.ball.ball import RollingBall
from ...mechanics.ball.surface import Paraboloid
from ..catalogue_entry import Numbers
from .ball_entry import ball_entry


def _ball(numbers: Numbers) -> RollingBall:
    return RollingBall(
        mass=numbers["m"],
        inertia=numbers["mu"],
        radius=numbers["b"],
        surface=Paraboloid((numbers["p"], numbers["q"])),
        carrier="centre",
        gravity=numbers["g"],
    )


ENTRIES = (
    ball_entry(
        name="marble-ball-on-paraboloid",
        ball=_ball,
    ),
    ball_entry(
        name="marble-ball-on-round-paraboloid",
        ball=_ball,
    ),
)
