"""A homogeneous ball inside an upright pipe: the marble ball comes up again, the rubber one falls.

On a circular cylinder ω₃ is constant, and so is the rate Ω at which the ball goes round.  The
spin σ about the normal and the height z are tied by σ + ω₃z/c = const on the inside of a cylinder
on which the centre moves at the distance c from the axis, and the height obeys

    z̈ + μ/(μ + mb²) Ω² z = const:

the ball oscillates, √(7/2) turns to one oscillation if it is solid.
"""

from __future__ import annotations

from dataclasses import replace

from ..mechanics.rolling_ball import RollingBall
from ..mechanics.smooth import CircularCylinder
from ..statements import Law, Rate, Reduction
from ..vectors import scalar, vectors
from .ball_entry import ball_entry
from .entry import Numbers

__all__ = ["ENTRIES"]

(R,) = vectors("R")
m, g, mtilde = (scalar(name) for name in ("m", "g", "mtilde"))


def _pipe(numbers: Numbers) -> RollingBall:
    return RollingBall(
        mass=numbers["m"],
        inertia=numbers["mu"],
        radius=numbers["b"],
        surface=CircularCylinder(numbers["a"], side="inside"),
        gravity=numbers["g"],
    )


def _rubber_pipe(numbers: Numbers) -> RollingBall:
    return replace(_pipe(numbers), contact="rubber")


def _fall(ball: RollingBall) -> tuple[Law, ...]:
    _, _, height = R.symbols
    return (
        Reduction(
            "fall",
            {},
            (Rate(Rate(height)) + m * g / mtilde,),
            "the rubber ball falls, slower than freely by the factor m/m̃",
            source="Proposition 3",
        ),
    )


_DEFAULTS = {"m": 1.0, "mu": 0.064, "b": 0.4, "a": 2.0, "g": 9.81}

ENTRIES = (
    ball_entry(
        name="marble-ball-on-cylinder",
        title="Marble ball in an upright pipe",
        summary="A heavy homogeneous ball rolls inside an upright pipe without slipping: it goes "
        "round and oscillates up and down instead of falling out.",
        defaults=_DEFAULTS,
        ball=_pipe,
        start={"R": (1.6, 0.0, 0.0), "omega": (0.0, 0.0, -16.0)},
        until=6.0,
    ),
    ball_entry(
        name="rubber-ball-on-cylinder",
        title="Rubber ball in an upright pipe",
        summary="The same ball neither slips nor spins: it falls like a particle that slides "
        "down the wall.",
        defaults=_DEFAULTS,
        ball=_rubber_pipe,
        start={"R": (1.6, 0.0, 0.0), "omega": (0.0, 3.0, -16.0)},
        until=1.2,
        further=_fall,
    ),
)
