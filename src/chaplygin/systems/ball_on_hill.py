"""Homogeneous balls on surfaces given by an equation: those of a user, in a few examples.

A hill z = h/(1 + ρ²/s²) carries the ball, so that the state is the contact point x; on a cushion
x⁴ + y⁴ + z⁴ = s⁴ the centre moves.  What holds on every surface is proven with f unspecified.
"""

from __future__ import annotations

from dataclasses import replace

from ..mechanics.rolling_ball import RollingBall
from ..mechanics.smooth import ImplicitSurface
from ..statements import Integral, Law
from ..system import Parameter
from ..vectors import cross, dot, scalar, unit, vectors
from .ball_entry import ball_entry
from .ball_laws import meridian_law
from .ball_on_any_surface import any_marble, any_supported_marble, any_supported_rubber
from .entry import Numbers

__all__ = ["ENTRIES"]

R, v = vectors("R v")
h, s = scalar("h"), scalar("s")
x, y, z = ImplicitSurface.coordinates
HILL = z * (1 + (x**2 + y**2) / s**2) - h
CUSHION = (x**4 + y**4 + z**4) / s**4 - 1


def _width(numbers: Numbers, meaning: str) -> Parameter:
    return Parameter(s, meaning, numbers["s"], "m", (s > 0,))


def _cushion(numbers: Numbers) -> RollingBall:
    return RollingBall(
        mass=numbers["m"],
        inertia=numbers["mu"],
        radius=numbers["b"],
        surface=ImplicitSurface(CUSHION, (_width(numbers, "half width"),), side="inside"),
        carrier="centre",
    )


def _hill(numbers: Numbers) -> RollingBall:
    height = Parameter(h, "height", numbers["h"], "m")
    return RollingBall(
        mass=numbers["m"],
        inertia=numbers["mu"],
        radius=numbers["b"],
        surface=ImplicitSurface(HILL, (height, _width(numbers, "half width at half height"))),
        gravity=numbers["g"],
    )


def _rubber_hill(numbers: Numbers) -> RollingBall:
    return replace(_hill(numbers), contact="rubber")


def _meridian(ball: RollingBall) -> tuple[Law, ...]:
    return (meridian_law(),)


def _area(ball: RollingBall) -> tuple[Law, ...]:
    value = dot(cross(R, v), unit(3))
    meaning = "areal velocity about the axis"
    return (Integral("area", value, meaning, source="Clairaut 1733", unit="m^2/s"),)


_DEFAULTS = {"m": 1.0, "mu": 0.036, "b": 0.3, "h": 1.0, "s": 2.0, "g": 9.81}

ENTRIES = (
    ball_entry(
        name="marble-ball-on-surface",
        title="Marble ball in a cushion",
        summary="A homogeneous ball rolls without slipping, free of gravity; its centre moves on "
        "x⁴ + y⁴ + z⁴ = s⁴.",
        defaults={"m": 1.0, "mu": 0.1, "b": 0.5, "s": 2.0},
        ball=_cushion,
        start={"R": (2.0, 0.0, 0.0), "omega": (1.0, 3.0, 2.0)},
        until=30.0,
        general=any_marble,
    ),
    ball_entry(
        name="marble-ball-on-hill",
        title="Marble ball on a hill",
        summary="A heavy homogeneous ball rolls without slipping over a round hill, which carries "
        "it; the state is its contact point.",
        defaults=_DEFAULTS,
        ball=_hill,
        start={"x": (-2.0, 0.0, 0.5), "omega": (1.0, 11.0, 2.0)},
        until=1.5,
        further=_meridian,
        general=any_supported_marble,
    ),
    ball_entry(
        name="rubber-ball-on-hill",
        title="Rubber ball on a hill",
        summary="A heavy homogeneous ball rolls with neither slipping nor spinning over a round "
        "hill, which carries it; the state is its contact point.",
        defaults=_DEFAULTS,
        ball=_rubber_hill,
        start={"x": (-2.0, 0.0, 0.5), "omega": (1.0, 11.0, 0.25)},
        until=1.5,
        further=_area,
        general=any_supported_rubber,
    ),
)
