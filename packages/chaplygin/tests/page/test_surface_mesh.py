"""Meshes of surfaces f = 0."""

from __future__ import annotations

from collections import Counter

import numpy as np

from chaplygin.geometry.ball_surface import Box, SurfaceGround
from chaplygin.page.surface_mesh import surface_mesh


def sphere(radius: float, side: float) -> SurfaceGround:
    return SurfaceGround(
        lambda p: side * (np.sum(p**2, axis=-1) - radius**2),
        lambda p: side * 2.0 * np.asarray(p),
        0.0,
    )


def mesh_of_sphere(side):
    return surface_mesh(sphere(1.3, side), Box(np.full(3, -2.0), np.full(3, 2.0)), 24)


def test_a_sphere_is_closed_and_lies_on_itself():
    for side in (1.0, -1.0):
        mesh = mesh_of_sphere(side)
        np.testing.assert_allclose(np.linalg.norm(mesh.positions, axis=1), 1.3, atol=1e-9)
        np.testing.assert_allclose(mesh.normals, side * mesh.positions / 1.3, atol=1e-9)
        edges = Counter(
            (int(a), int(b))
            for face in mesh.indices
            for a, b in zip(face, np.roll(face, -1), strict=True)
        )
        assert all(edges[b, a] == 1 for a, b in edges) and max(edges.values()) == 1
        assert len(mesh.positions) - len(edges) // 2 + len(mesh.indices) == 2


def test_triangles_are_seen_from_the_side_of_the_ball():
    for side in (1.0, -1.0):
        mesh = mesh_of_sphere(side)
        a, b, c = (mesh.positions[mesh.indices[:, k]] for k in range(3))
        crossed = np.cross(b - a, c - a)
        assert np.all(np.sum(crossed * mesh.normals[mesh.indices[:, 0]], axis=1) > 0.0)
        area = np.sum(np.linalg.norm(crossed, axis=1)) / 2
        assert abs(area / (4 * np.pi * 1.3**2) - 1) < 0.02


def test_the_rim_lies_on_the_sides_of_the_box():
    """Of a cap of a sphere: edges without a neighbour form one circle, where it is cut."""
    box = Box(np.array([-2.0, -2.0, -2.0]), np.array([2.0, 2.0, 0.37]))
    mesh = surface_mesh(sphere(1.3, -1.0), box, 24)
    edges = {
        (int(a), int(b))
        for face in mesh.indices
        for a, b in zip(face, np.roll(face, -1), strict=True)
    }
    rim = dict(edge for edge in edges if edge[::-1] not in edges)
    place = first = next(iter(rim))
    passed = 0
    while passed == 0 or place != first:
        place, passed = rim[place], passed + 1
    assert passed == len(rim)
    round_points = mesh.positions[list(rim)]
    np.testing.assert_allclose(round_points[:, 2], 0.37, atol=1e-12)
    radius = np.sqrt(1.3**2 - 0.37**2)
    np.testing.assert_allclose(np.hypot(*round_points[:, :2].T), radius, atol=0.01)
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1.0, atol=1e-12)
    assert mesh.indices.max() + 1 == len(mesh.positions)
