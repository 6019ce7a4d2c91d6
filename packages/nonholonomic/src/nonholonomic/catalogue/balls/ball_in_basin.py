"""Homogeneous balls on surfaces given by an equation, as examples of surfaces of your own.

A basin z = h(ρ/s)⁴ carries the ball, so that the state is the contact point x; on a cushion
x⁴ + y⁴ + z⁴ = s⁴ the centre moves.  Laws that hold on every surface are proven with f unspecified.
"""

from __future__ import annotations

from dataclasses import replace

from flowlanes.system.laws import Integral, Law
from flowlanes.system.system import Parameter
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import cross, dot, real_symbol, vectors

from ...mechanics.ball.ball import RollingBall
from ...mechanics.ball.surface import ImplicitSurface
from ..ball_entry import ball_entry
from ..ball_laws import meridian_law
from ..catalogue_entry import Numbers
from .ball_on_any_surface import any_marble, any_supported_marble, any_supported_rubber

R, v = vectors("R v")
h, s = real_symbol("h"), real_symbol("s")
x, y, z = ImplicitSurface.coordinates
BASIN = z - h * (x**2 + y**2) ** 2 / s**4
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


def _basin(numbers: Numbers) -> RollingBall:
    height = Parameter(h, "height of the rim", numbers["h"], "m")
    return RollingBall(
        mass=numbers["m"],
        inertia=numbers["mu"],
        radius=numbers["b"],
        surface=ImplicitSurface(BASIN, (height, _width(numbers, "radius at that height"))),
        gravity=numbers["g"],
    )


def _rubber_basin(numbers: Numbers) -> RollingBall:
    return replace(_basin(numbers), contact="rubber")


def _meridian(ball: RollingBall) -> tuple[Law, ...]:
    return (meridian_law(),)


def _area(ball: RollingBall) -> tuple[Law, ...]:
    value = dot(cross(R, v), unit_vector(3))
    meaning = "areal velocity about the axis"
    return (Integral("area", value, meaning, source="Clairaut 1733", unit="m^2/s"),)


ENTRIES = (
    ball_entry(
        name="marble-ball-on-surface",
        ball=_cushion,
        general=any_marble,
    ),
    ball_entry(
        name="marble-ball-in-basin",
        ball=_basin,
        further=_meridian,
        general=any_supported_marble,
    ),
    ball_entry(
        name="rubber-ball-in-basin",
        ball=_rubber_basin,
        further=_area,
        general=any_supported_rubber,
    ),
)
