"""The start of a ball on a surface, and what is refused."""

from __future__ import annotations

import re

import numpy as np
import pytest

from flowlanes.errors import InputError
from mechanics.balls import POINTS, SURFACES, on, x, y, z
from nonholonomic.mechanics.ball.surface import EllipsoidSurface, ImplicitSurface, Ring
from nonholonomic.starts import initial_state


def start(ball, place, omega=(0.0, 0.0, 0.0)):
    return [float(value) for value in initial_state(ball, omega, place=place)]


@pytest.mark.parametrize("name", SURFACES)
def test_a_contact_point_is_a_start(name):
    ball = on(SURFACES[name])
    state = start(ball, POINTS[name], (1.0, 2.0, 3.0))
    distance = 0.3 if str(ball.kinematics.place) == "R" else 0.0
    away = np.linalg.norm(np.array(state[:3]) - POINTS[name])
    assert away == pytest.approx(distance, abs=1e-12)
    assert state[3:] == [1.0, 2.0, 3.0, 1.0, 0.0, 0.0, 0.0]


def test_a_centre_is_a_start():
    ball = on(SURFACES["bowl"], carrier="centre")
    assert start(ball, POINTS["bowl"])[:3] == list(POINTS["bowl"])


def test_rounding_is_taken_away():
    ball = on(SURFACES["sphere"])
    place = (2 / 3**0.5,) * 3
    radius = np.linalg.norm(start(ball, place)[:3])
    assert radius == pytest.approx(2.3, rel=1e-15)


@pytest.mark.parametrize("place", [(1.6, 1.2, 0.5), (0.1, 0.1, 0.1), (0.0, 3.0, 3.0)])
def test_the_nearest_point_is_told(place):
    ball = on(EllipsoidSurface((1.5, 2.0, 3.0)))
    with pytest.raises(InputError, match="misses the surface") as refused:
        start(ball, place)
    near = np.array(last_list(str(refused.value)))
    slope = 2 * near / np.array([1.5, 2.0, 3.0]) ** 2
    assert np.sum(near**2 / np.array([1.5, 2.0, 3.0]) ** 2) == pytest.approx(1.0, abs=1e-12)
    np.testing.assert_allclose(np.cross(near - place, slope), 0.0, atol=1e-9)


def last_list(message):
    """The last list of numbers in a message."""
    return [float(part) for part in re.findall(r"\[([^]]*)\]", message)[-1].split(",")]


def test_where_the_surface_is_flatter_a_large_ball_fits():
    ball = on(SURFACES["ellipsoid"], radius=1.2, carrier="centre")
    assert start(ball, (1.5, 0.0, 0.0))[:3] == [1.5, 0.0, 0.0]


@pytest.mark.parametrize(
    ("ball", "place", "omega", "message"),
    [
        (
            on(ImplicitSurface(x * y * z)),
            (0.0, 0.0, 0.0),
            (0.0, 0.0, 0.0),
            "contact: the surface has no normal at [0.0, 0.0, 0.0], since the gradient of its "
            "equation vanishes there; start at another point",
        ),
        (
            on(EllipsoidSurface((1.5, 2.0, 3.0), side="inside"), radius=1.0),
            (0.0, 0.0, 3.0),
            (0.0, 0.0, 0.0),
            "contact: a ball of radius 1 does not fit into the surface there, whose radius of "
            "curvature is 0.75; it must be smaller than that",
        ),
        (
            on(SURFACES["ellipsoid"], radius=1.0, carrier="centre"),
            (0.0, 0.0, 3.0),
            (0.0, 0.0, 0.0),
            "centre: no surface can carry a ball of radius 1 there, since the surface of its "
            "centre has the radius of curvature 0.75; the ball must be smaller than that",
        ),
        (
            on(SURFACES["plane"], contact="rubber"),
            (0.0, 0.0, 0.0),
            (1.0, 2.0, 3.0),
            "omega: (omega, n) = 3, and a rubber ball, which does not spin about the normal, "
            "needs 0; the nearest admissible omega is [1.0, 2.0, 0.0]",
        ),
        (
            on(SURFACES["cone"]),
            (0.0, 2.0, -2.0),
            (0.0, 0.0, 0.0),
            "contact: [0.0, 2.0, -2.0] is outside the domain; the ball has come to the apex of "
            "the cone",
        ),
        (
            on(SURFACES["plane"]),
            (0.0, float("nan"), 0.0),
            (0.0, 0.0, 0.0),
            "contact: nan is not a finite number",
        ),
    ],
)
def test_refusals(ball, place, omega, message):
    with pytest.raises(InputError) as refused:
        start(ball, place, omega)
    assert str(refused.value) == message


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"radius": 0.0}, "radius 0.0: it must be a positive finite number"),
        ({"gravity": -1.0}, "gravity -1.0: it must be finite and not negative"),
        ({"direction": (0.0, 0.0, 0.0)}, "it must be three finite numbers, not all zero"),
        ({"mass": 0.0}, "mass 0.0: it must be a positive finite number"),
        ({"inertia": -1.0}, "must all be positive"),
    ],
)
def test_a_ball_has_admissible_numbers(changes, message):
    with pytest.raises(InputError, match=re.escape(message)):
        on(SURFACES["plane"], **changes)


def test_a_ball_inside_is_smaller_than_the_tube():
    inside = Ring(3.0, 1.0, side="inside")
    with pytest.raises(InputError, match=r"radius: 1\.5 is too large .* smaller than 1"):
        on(inside, radius=1.5)
