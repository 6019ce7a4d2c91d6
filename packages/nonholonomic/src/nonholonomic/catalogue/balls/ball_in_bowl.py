"""A heavy homogeneous marble ball on a sphere: it is integrable, like the Lagrange top.

Its spin about the normal is constant, since the normal turns as the ball goes, and so is the
vertical component of m̃ω − mσn.
"""

from __future__ import annotations

from ...mechanics.ball.ball import RollingBall
from ...mechanics.ball.surface import SphericalSurface
from ..catalogue_entry import Numbers
from .ball_entry import ball_entry


def _ball(numbers: Numbers) -> RollingBall:
    return RollingBall(
        mass=numbers["m"],
        inertia=numbers["mu"],
        radius=numbers["b"],
        surface=SphericalSurface(numbers["a"], side="inside"),
        gravity=numbers["g"],
    )


ENTRIES = (
    ball_entry(
        name="marble-ball-on-sphere",
        title="Homogeneous marble ball in a spherical bowl",
        summary="A heavy homogeneous ball rolls without slipping inside a sphere.",
        defaults={"m": 1.0, "mu": 0.1, "b": 0.5, "a": 2.5, "g": 9.81},
        ball=_ball,
        start={"R": (1.2, 0.0, -1.6), "omega": (-6.0, 2.0, 5.0)},
        until=10.0,
    ),
)
