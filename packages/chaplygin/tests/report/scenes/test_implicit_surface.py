"""Lines of sight and surfaces."""

from __future__ import annotations

import numpy as np
import pytest

from chaplygin.geometry.ball_surface import SurfaceGround, frame_of, ground_of_ball
from chaplygin.geometry.view import View
from chaplygin.report.scenes.implicit_surface import crossings
from mechanics.balls import POINTS, SURFACES, on

VIEW = View(0.3, 0.4)


def sphere(radius, shift):
    return SurfaceGround(
        lambda p: np.sum(p**2, axis=-1) - radius**2, lambda p: 2.0 * np.asarray(p), shift
    )


@pytest.mark.parametrize("shift", [0.0, 0.5])
def test_a_sphere_is_met_twice(shift):
    """The ball's centre moves on a sphere of radius 2, or the ball on it."""
    ground = sphere(2.0, shift)
    radius = 2.0 - shift
    path = radius * np.array([[0.0, 0.0, 1.0], [0.8, -0.6, 0.0], [-0.8, 0.6, 0.0]])
    box = frame_of(path, np.full(3, 0.5), ground)
    assert np.all(box.low < -radius) and np.all(box.high > radius)
    seen = crossings(ground, box, VIEW, 80)
    met = seen.is_hit
    assert np.array_equal(met[0], met[1]) and not met[2].any()
    np.testing.assert_allclose(np.linalg.norm(seen.points[met], axis=-1), radius, rtol=2e-3)
    np.testing.assert_allclose(seen.normals[met], seen.points[met] / radius, atol=5e-3)
    assert np.all(seen.depth[0][met[0]] >= seen.depth[1][met[1]])
    left, right, bottom, top = seen.extent
    dots = met[0].sum() * (right - left) * (top - bottom) / met[0].size
    assert dots == pytest.approx(np.pi * radius**2, rel=0.03)


def test_an_open_surface_is_cut_by_the_box():
    flat = SurfaceGround(lambda p: p[:, 2], lambda p: np.tile([0.0, 0.0, 1.0], (len(p), 1)), 0.0)
    path = np.array([[0.0, 0.0, 0.0], [3.0, 1.0, 0.0]])
    box = frame_of(path, np.array([0.5, 0.5, 0.5]), flat)
    np.testing.assert_allclose(box.low, [-0.5, -0.5, -0.5])
    seen = crossings(flat, box, VIEW, 60)
    points = seen.points[seen.is_hit]
    np.testing.assert_allclose(points[:, 2], 0.0, atol=1e-9)
    assert points[:, 0].min() >= -0.5 and points[:, 0].max() <= 3.5


@pytest.mark.parametrize("name", SURFACES)
def test_the_ground_of_a_ball_is_where_it_touches(name):
    """Of a ball whose centre moves on a surface, what carries it is the parallel one."""
    place = np.array([POINTS[name]])
    carried = ground_of_ball(on(SURFACES[name]))
    np.testing.assert_allclose(carried.height(place), 0.0, atol=1e-9)
    centred = ground_of_ball(on(SURFACES[name], radius=0.1, carrier="centre"))
    below = place - 0.1 * carried.normals(place)
    np.testing.assert_allclose(centred.height(below), 0.0, atol=2e-3)


def test_the_other_half_of_a_cone_is_no_ground():
    ground = ground_of_ball(on(SURFACES["cone"]))
    assert np.isnan(ground.height(np.array([[0.0, 1.0, -1.0]])))
