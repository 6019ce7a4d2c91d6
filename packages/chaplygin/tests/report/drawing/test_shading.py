"""Light, shadow and curves of the drawings, against closed forms."""

import numpy as np
import pytest
from hypothesis import given, strategies as st

from chaplygin.geometry.mesh import outline_from_contact
from chaplygin.geometry.view import View, unit
from chaplygin.report.drawing.curves import convex_hull, cut_by_plane, runs, smooth_curve
from chaplygin.report.drawing.shading import (
    PlaneGround,
    SphereGround,
    cast_shadow,
    shaded_colours,
    sphere_shades,
)

VIEW = View(0.7, 0.4)


def ball(radius, centre=(0.0, 0.0, 0.0)):
    return lambda gamma: np.asarray(centre) - radius * gamma


def ellipsoid(*axes):
    squares = np.square(axes)
    return lambda gamma: -gamma * squares / np.sqrt(gamma**2 @ squares)[:, None]


def cross(u, v):
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]


def area(polygon):
    x, y = np.asarray(polygon).T
    return abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) / 2


def test_near_facets_cover_the_body_once():
    facets = outline_from_contact(ellipsoid(1.0, 0.6, 0.3)).facets
    near = facets.select(facets.faces_reader(VIEW))
    a, b, c, d = np.moveaxis(VIEW.project(near.polygons), 1, 0)
    pieces = cross(c - a, d - b) / 2
    assert np.min(pieces) > 0
    border = convex_hull(VIEW.project(facets.polygons.reshape(-1, 3)))
    assert np.sum(pieces) == pytest.approx(area(border), rel=1e-3)


def test_shading_darkens_what_turns_from_the_lamp():
    grey = np.full((3, 3), 0.5)
    away = unit(np.cross(VIEW.light, VIEW.toward))
    lit = shaded_colours(grey, np.stack([VIEW.light, away, -VIEW.light]), VIEW, 0.5)[:, 0]
    assert lit[0] > lit[1] > lit[2] > 0.2
    flat = shaded_colours(grey, np.stack([VIEW.light, away, -VIEW.light]), VIEW, 0.0)
    assert np.ptp(flat) == 0


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_regions_of_equal_light_on_a_sphere(side):
    """A point lies inside a region exactly if its normal is turned enough to the lamp."""
    random = np.random.default_rng(1)
    seen = unit(random.normal(size=(400, 3)))
    # Polygons stay off the very border by the height of their arcs.
    seen = seen[seen @ VIEW.toward > 0.08]
    light = np.clip((seen @ VIEW.light + 0.4) / 1.4, 0, 1)
    for corners, brightness in sphere_shades(2.0, VIEW, side, 9)[1:]:
        points = side * 2.0 * VIEW.project(seen)
        following = np.roll(corners, -1, axis=0) - corners
        offsets = points[:, None] - corners
        inside = np.all(cross(following, offsets) >= 0, axis=1)
        clear = np.abs(light - brightness) > 0.01
        np.testing.assert_array_equal(inside[clear], (light > brightness)[clear])


def test_convex_hull_of_a_square_with_points_inside():
    random = np.random.default_rng(0).uniform(-1, 1, size=(200, 2))
    square = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    np.testing.assert_array_equal(convex_hull(np.concatenate([random, square])), square)


def test_convex_hull_of_few_points():
    np.testing.assert_array_equal(convex_hull(np.array([[1.0, 2.0]] * 3)), [[1.0, 2.0]])
    line = convex_hull(np.array([[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]))
    np.testing.assert_array_equal(line, [[0.0, 0.0], [2.0, 2.0]])


def test_shadow_of_a_ball_on_the_plane_is_an_ellipse_at_its_foot():
    light = unit(np.array([0.3, 0.1, 1.0]))
    body = outline_from_contact(ball(1.0)).in_space(np.eye(3), np.array([4.0, 5.0, 1.0]))
    shadow = cast_shadow(body.vertices, PlaneGround(), light)
    np.testing.assert_array_equal(shadow[:, 2], 0.0)
    assert area(shadow[:, :2]) == pytest.approx(np.pi / light[2], rel=0.01)
    np.testing.assert_allclose(shadow[:, :2].mean(axis=0), [4 - 0.3, 5 - 0.1], atol=0.02)


@pytest.mark.parametrize(("radius", "height"), [(2.0, 2.5), (-2.0, -1.5)])
def test_shadow_lies_on_the_sphere_under_the_ball(radius, height):
    body = outline_from_contact(ball(0.5)).in_space(np.eye(3), np.array([0.0, 0.0, height]))
    shadow = cast_shadow(body.vertices, SphereGround(radius), np.array([0.0, 0.0, 1.0]))
    np.testing.assert_allclose(np.linalg.norm(shadow, axis=1), 2.0)
    np.testing.assert_allclose(np.hypot(*shadow[:, :2].T), 0.5, rtol=0.01)
    np.testing.assert_array_equal(np.sign(shadow[:, 2]), np.sign(radius))


def test_body_under_a_sphere_casts_no_shadow_on_it():
    body = outline_from_contact(ball(0.5)).in_space(np.eye(3), np.array([0.0, 0.0, -2.5]))
    assert len(cast_shadow(body.vertices, SphereGround(2.0), np.array([0.0, 0.0, 1.0]))) == 0


def test_polygon_is_cut_by_a_plane():
    square = np.array([[-1.0, 0, 0], [1, 0, 0], [1, 2, 0], [-1, 2, 0]])
    kept = cut_by_plane(square, np.array([1.0, 0, 0]))
    assert area(kept[:, :2]) == pytest.approx(2.0)
    assert np.min(kept[:, 0]) == 0.0
    assert len(cut_by_plane(square, np.array([0.0, -1.0, 0]))) == 0


@given(st.lists(st.booleans(), max_size=30))
def test_runs_take_every_marked_step_once(marks):
    taken = np.zeros(len(marks), dtype=int)
    for run in runs(np.array(marks, dtype=bool)):
        taken[run.start : run.stop - 1] += 1
    np.testing.assert_array_equal(taken, np.array(marks, dtype=int))


def test_smooth_curve_goes_through_the_samples_and_between_them():
    times = np.linspace(0.0, 2 * np.pi, 30)
    points = np.stack([np.cos(times), np.sin(times)], axis=1)
    fine, curve = smooth_curve(times, points, 500)
    assert len(fine) >= 500
    np.testing.assert_allclose(curve[np.searchsorted(fine, times - 1e-12)], points, atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(curve, axis=1), 1.0, atol=1e-3)
