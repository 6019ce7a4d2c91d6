"""Polygons in the plane, and smooth curves through samples."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from scipy.interpolate import CubicSpline

from flowlanes.system.arrays import BoolArray, FloatArray

from ...geometry.view import unit

_DIRECTIONS = 8
"""Number of directions whose extreme points are found before a hull is computed."""


def convex_hull(points: FloatArray) -> FloatArray:
    """Corners (k, 2) of the convex hull of points (n, 2), anticlockwise.

    Collinear points give two corners, coincident points one.
    """
    ordered = [(float(x), float(y)) for x, y in np.unique(_outer(points), axis=0)]
    if len(ordered) < 3:
        return np.array(ordered)

    def chain(sequence: list[tuple[float, float]]) -> list[tuple[float, float]]:
        corners: list[tuple[float, float]] = []
        for x, y in sequence:
            while len(corners) > 1:
                (x0, y0), (x1, y1) = corners[-2:]
                if (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) > 0.0:
                    break
                corners.pop()
            corners.append((x, y))
        return corners[:-1]

    return np.array(chain(ordered) + chain(ordered[::-1]))


def _outer(points: FloatArray) -> FloatArray:
    """Points without most of those inside their hull (Akl and Toussaint)."""
    if len(points) < 3:
        return points
    angles = np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS
    heights = points @ np.array([np.cos(angles), np.sin(angles)])
    corners = points[np.argmax(np.hstack([heights, -heights]), axis=0)]
    sides = np.roll(corners, -1, axis=0) - corners
    # A point is inside if it lies to the left of all sides, by more than rounding.
    least = 1e-9 * np.max(np.abs(heights)) * np.linalg.norm(sides, axis=1)
    offsets = points[:, None] - corners
    areas = sides[:, 0] * offsets[..., 1] - sides[:, 1] * offsets[..., 0]
    true_sides = least > 0.0
    inside = np.all(areas[:, true_sides] > least[true_sides], axis=1) & np.any(true_sides)
    outer: FloatArray = points[~inside]
    return outer


def cut_by_plane(polygon: FloatArray, normal: FloatArray) -> FloatArray:
    """The part of a polygon (k, 3) on one side of a plane through the origin."""
    side = polygon @ normal
    corners: list[FloatArray] = []
    for index in range(len(polygon)):
        before, after = side[index - 1], side[index]
        if (before > 0.0) != (after > 0.0):
            step = before / (before - after)
            corners.append(polygon[index - 1] + step * (polygon[index] - polygon[index - 1]))
        if after > 0.0:
            corners.append(polygon[index])
    return np.array(corners) if corners else np.empty((0, 3))


def runs(mask: BoolArray) -> Iterator[slice]:
    """Stretches of a curve on which every step is marked.

    Parameters
    ----------
    mask : (n - 1,) array of bool
        One mark for each step between neighbouring points of a curve of n points.

    Yields
    ------
    slice
        The points at the ends of consecutive marked steps.
    """
    padded = np.concatenate([[False], mask, [False]]).astype(np.int8)
    changes = np.flatnonzero(np.diff(padded))
    for start, stop in zip(changes[::2], changes[1::2], strict=True):
        yield slice(int(start), int(stop) + 1)


def smooth_curve(
    times: FloatArray, points: FloatArray, count: int
) -> tuple[FloatArray, FloatArray]:
    """A curve through samples, fine enough to look smooth on paper.

    Samples too sparse to determine the curve between them (most turns exceed half a radian) are
    left as they are, and so are fewer than four.

    Parameters
    ----------
    times : (n,) array
        Increasing.
    points : (n, d) array
        Samples of the curve.
    count : int
        Minimum number of points of a refined result.

    Returns
    -------
    times, points : (m,) and (m, d) arrays
        Cubic spline through the samples, which are among its points.
    """
    if not 4 <= len(times) < count:
        return times, points
    steps = unit(np.diff(points, axis=0))
    turns = np.sum(steps[1:] * steps[:-1], axis=-1)
    if np.median(turns) < np.cos(0.5):
        return times, points
    parts = -(-count // (len(times) - 1))
    fractions = np.linspace(0.0, 1.0, parts, endpoint=False)
    fine = (times[:-1, None] + np.diff(times)[:, None] * fractions).ravel()
    fine = np.append(fine, times[-1])
    return fine, np.asarray(CubicSpline(times, points)(fine), dtype=np.float64)
