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
        ball=_ball,
    ),
)
