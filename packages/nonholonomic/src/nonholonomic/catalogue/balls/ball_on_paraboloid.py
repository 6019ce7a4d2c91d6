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


_DEFAULTS = {"m": 1.0, "mu": 0.4, "b": 1.0, "p": 3.0, "q": 4.0, "g": 9.81}

ENTRIES = (
    ball_entry(
        name="marble-ball-on-paraboloid",
        title="Marble ball in a bowl",
        summary="A heavy homogeneous ball rolls in a bowl without slipping; its centre moves on an "
        "elliptic paraboloid.",
        defaults=_DEFAULTS,
        ball=_ball,
        start={"R": (3.0, 0.0, 1.5), "omega": (-1.0, 0.5, 2.0)},
        until=30.0,
    ),
    ball_entry(
        name="marble-ball-on-round-paraboloid",
        title="Marble ball in a round bowl",
        summary="A heavy homogeneous ball rolls in a bowl without slipping; its centre moves on a "
        "paraboloid of revolution.",
        defaults=_DEFAULTS | {"q": 3.0},
        ball=_ball,
        start={"R": (3.0, 0.0, 1.5), "omega": (-1.0, 0.5, 2.0)},
        until=30.0,
    ),
)
