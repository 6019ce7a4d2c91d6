"""Geometry of drawn bodies, against closed forms."""

from collections import Counter

import numpy as np
import pytest
from hypothesis import given, strategies as st

from chaplygin.geometry.mesh import outline_from_contact, sphere_cap
from chaplygin.geometry.view import View, rotation_matrices
from chaplygin.report.drawing.curves import smooth_curve

VIEW = View(0.7, 0.4)


def ball(radius, centre=(0.0, 0.0, 0.0)):
    return lambda gamma: np.asarray(centre) - radius * gamma


def ellipsoid(*axes):
    squares = np.square(axes)
    return lambda gamma: -gamma * squares / np.sqrt(gamma**2 @ squares)[:, None]


def rounded_disk(radius, tube):
    def contact(gamma):
        flat = gamma * [1.0, 1.0, 0.0]
        return -radius * flat / np.linalg.norm(flat, axis=1, keepdims=True) - tube * gamma

    return contact


def cushion(gamma):
    """The body x^4 + y^4 + z^4 = 1, flat to third order at six points."""
    return -np.cbrt(gamma) * np.sum(np.abs(gamma) ** (4 / 3), axis=1, keepdims=True) ** -0.25


BODIES = {
    "ball": ball(1.3, (0.1, -0.2, 0.3)),
    "ellipsoid": ellipsoid(1.0, 0.6, 0.3),
    "thin disk": rounded_disk(1.0, 0.0),
    "rounded disk": rounded_disk(0.8, 0.2),
    "cushion": cushion,
}


def volume(outline):
    """By the divergence theorem, quadrilaterals cut into triangles."""
    a, b, c, d = np.moveaxis(outline.facets.polygons, 1, 0)
    return (np.sum(a * np.cross(b, c)) + np.sum(a * np.cross(c, d))) / 6


def cross(u, v):
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]


def test_view_is_an_orthonormal_frame():
    frame = np.stack([VIEW.right, VIEW.up, VIEW.toward])
    np.testing.assert_allclose(frame @ frame.T, np.eye(3), atol=1e-15)
    assert np.linalg.det(frame) == pytest.approx(1.0)
    assert VIEW.light @ VIEW.toward > 0 > VIEW.light @ VIEW.right


def test_view_from_above_is_a_map():
    above = View(-np.pi / 2, np.pi / 2)
    points = np.array([[1.0, 2.0, 5.0], [-3.0, 0.5, -1.0]])
    np.testing.assert_allclose(above.project(points), points[:, :2], atol=1e-15)
    np.testing.assert_allclose(above.depth(points), points[:, 2], atol=1e-15)


@given(st.floats(-4, 4), st.floats(-1.5, 1.5))
def test_projection_and_depth_lose_nothing(azimuth, elevation):
    view = View(azimuth, elevation)
    point = np.array([0.3, -1.2, 2.5])
    x, y = view.project(point)
    back = x * view.right + y * view.up + view.depth(point) * view.toward
    np.testing.assert_allclose(back, point, atol=1e-14)


def test_rotation_matrices_turn_body_into_space():
    half = np.sqrt(0.5)
    quarter, twice = rotation_matrices(np.array([[half, 0, 0, half], [0, 0, 3.0, 0]]))
    np.testing.assert_allclose(quarter @ [1, 0, 0], [0, 1, 0], atol=1e-15)
    np.testing.assert_allclose(twice, np.diag([-1, 1, -1]), atol=1e-15)


@pytest.mark.parametrize("name", BODIES)
def test_meshes_are_closed_and_face_outwards(name):
    outline = outline_from_contact(BODIES[name])
    corners = outline.vertices[outline.faces]
    # The poles of a round body are points, seen with this tolerance.
    keys = np.unique(np.round(corners.reshape(-1, 3), 5), axis=0, return_inverse=True)[1]
    edges = Counter()
    for face in keys.reshape(len(corners), 4):
        for start, stop in zip(face, np.roll(face, -1), strict=True):
            if start != stop:
                edges[int(start), int(stop)] += 1
    assert set(edges.values()) == {1}
    assert all((stop, start) in edges for start, stop in edges)
    geometric = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    assert np.min(np.sum(geometric * outline.normals, axis=1)) > 0
    assert not outline.hollow


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("ball", 4 / 3 * np.pi * 1.3**3),
        ("ellipsoid", 4 / 3 * np.pi * 1.0 * 0.6 * 0.3),
        ("thin disk", np.pi * 0.04),
        # Disk of radius R and height 2r, and the outer half of the tube (Pappus).
        (
            "rounded disk",
            np.pi * 0.8**2 * 0.4 + np.pi * 0.2**2 / 2 * 2 * np.pi * (0.8 + 4 * 0.2 / (3 * np.pi)),
        ),
    ],
)
def test_meshes_have_the_volume_of_the_body(name, expected):
    assert volume(outline_from_contact(BODIES[name])) == pytest.approx(expected, rel=0.01)


def test_vertices_lie_on_the_surface():
    vertices = outline_from_contact(cushion).vertices
    np.testing.assert_allclose(np.sum(vertices**4, axis=1), 1.0, atol=2e-3)


def test_flat_places_are_not_left_without_facets():
    polygons = outline_from_contact(cushion).facets.polygons
    sides = np.linalg.norm(polygons - np.roll(polygons, 1, axis=1), axis=2)
    assert np.max(sides) < 0.15


def test_flat_faces_are_filled():
    outline = outline_from_contact(rounded_disk(0.8, 0.2))
    top = outline.normals[:, 2] > 1 - 1e-6
    polygons = outline.facets.polygons[top]
    np.testing.assert_allclose(polygons[..., 2], 0.2, atol=1e-6)
    a, b, c, d = np.moveaxis(polygons[..., :2], 1, 0)
    covered = np.sum(cross(c - a, d - b)) / 2
    assert covered == pytest.approx(np.pi * 0.8**2, rel=0.01)


def test_thin_disk_is_given_a_thickness_and_an_ellipsoid_is_not():
    assert np.ptp(outline_from_contact(BODIES["thin disk"]).vertices[:, 2]) == pytest.approx(0.04)
    assert np.ptp(outline_from_contact(ellipsoid(1, 1, 0.1)).vertices[:, 2]) == pytest.approx(0.2)


def test_octants_alternate():
    outline = outline_from_contact(ball(1.0))
    middles = outline.facets.polygons.mean(axis=1)
    parities = np.sum(middles > 0, axis=1) % 2
    assert len(set(zip(parities.tolist(), outline.tones.tolist(), strict=True))) == 2


def test_shell_that_rolls_with_its_inner_side_is_hollow():
    outline = outline_from_contact(lambda gamma: np.array([0.1, 0.0, 0.0]) + 2 * gamma)
    assert outline.hollow
    assert volume(outline) == pytest.approx(4 / 3 * np.pi * 8, rel=0.01)


def test_placing_moves_everything_rigidly():
    outline = outline_from_contact(ellipsoid(1.0, 0.6, 0.3))
    rotation = rotation_matrices(np.array([0.3, -0.5, 0.2, 0.7]))
    placed = outline.in_space(rotation, np.array([1.0, 2.0, 3.0]))
    np.testing.assert_allclose(placed.vertices[5], rotation @ outline.vertices[5] + [1, 2, 3])
    np.testing.assert_allclose(placed.normals[5], rotation @ outline.normals[5])
    seam, moved = outline.seams[0], placed.seams[0]
    np.testing.assert_allclose(moved.points[7], rotation @ seam.points[7] + [1, 2, 3])
    np.testing.assert_allclose(moved.normals[7], rotation @ seam.normals[7])


def test_seams_lie_on_the_body():
    for seam in outline_from_contact(ball(2.0)).seams:
        np.testing.assert_allclose(np.linalg.norm(seam.points, axis=1), 2.0, rtol=1e-3)
        np.testing.assert_allclose(np.linalg.norm(seam.normals, axis=1), 1.0)


def test_cap_of_a_sphere():
    cap = sphere_cap(3.0, -1.0, 0.8, 10, 20)
    np.testing.assert_allclose(np.linalg.norm(cap.polygons, axis=2), 3.0)
    assert np.max(cap.polygons[..., 2]) == pytest.approx(-3.0 * np.cos(0.8))
    below = View(0.0, -np.pi / 2)
    assert np.all(cap.faces_reader(below))


@pytest.mark.parametrize("count", [1, 3, 9])
def test_coarse_or_few_samples_are_left_alone(count):
    times = np.arange(float(count))
    points = np.stack([np.cos(2.5 * times), np.sin(2.5 * times)], axis=1)
    fine, curve = smooth_curve(times, points, 500)
    np.testing.assert_array_equal(fine, times)
    np.testing.assert_array_equal(curve, points)
