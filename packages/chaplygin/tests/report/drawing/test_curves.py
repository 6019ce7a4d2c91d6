"""Convex hulls of points in the plane."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from chaplygin.report.drawing.curves import convex_hull


@pytest.mark.parametrize("seed", range(20))
def test_a_hull_is_that_of_qhull(seed: int) -> None:
    generator = np.random.default_rng(seed)
    points = generator.normal(size=(generator.integers(3, 300), 2))
    if seed % 4 == 0:
        # many points on the sides of the hull
        points = np.round(points, 1)
    expected = points[ConvexHull(points).vertices]
    found = convex_hull(points)
    assert {*map(tuple, found)} == {*map(tuple, expected)}
    first = [*map(tuple, found)].index(tuple(expected[0]))
    assert np.array_equal(np.roll(found, -first, axis=0), expected)


@pytest.mark.parametrize("points", [np.empty((0, 2)), np.ones((1, 2)), np.ones((9, 2))])
def test_one_place_is_its_own_hull(points: np.ndarray) -> None:
    assert len(convex_hull(points)) == min(len(points), 1)


def test_a_line_has_two_ends() -> None:
    points = np.outer(np.random.default_rng(1).normal(size=50), [1.0, 2.0])
    ends = points[[np.argmin(points[:, 0]), np.argmax(points[:, 0])]]
    assert np.array_equal(convex_hull(points), ends)
