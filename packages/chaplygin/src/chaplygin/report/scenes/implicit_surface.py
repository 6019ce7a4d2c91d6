"""The surface f = 0 in pictures: its intersections with lines of sight.

As in :mod:`chaplygin.geometry.view` everything is plain geometry in arrays; all lengths are in the
units of the trajectory.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import map_coordinates

from flowlanes.system.arrays import BoolArray, FloatArray

from ...geometry.ball_surface import Box, SurfaceGround, heights_on_grid
from ...geometry.view import View

_ALONG = 110
"""Number of samples along a line of sight through the box."""

_LAYERS = 4
"""Number of crossings of a line of sight that are kept, counted from the reader."""


@dataclass(frozen=True, eq=False)
class Crossings:
    """The crossings of lines of sight with a surface, nearest to the viewer first.

    Attributes
    ----------
    extent : (left, right, bottom, top)
        Extent of the picture on paper.
    points, normals : (layers, rows, columns, 3) arrays
    depth : (layers, rows, columns) array
        Nearness to the reader; −∞ if there is no crossing.
    """

    extent: tuple[float, float, float, float]
    points: FloatArray
    normals: FloatArray
    depth: FloatArray

    @property
    def is_hit(self) -> BoolArray:
        """Whether each line of sight has a crossing in each layer."""
        return np.asarray(np.isfinite(self.depth), dtype=np.bool_)


def crossings(ground: SurfaceGround, box: Box, view: View, columns: int) -> Crossings:
    """The crossings of the lines of sight of a picture with a surface in a box.

    Parameters
    ----------
    ground : SurfaceGround
    box : Box
    view : View
    columns : int
        Width of the picture in lines of sight.
    """
    corners = np.array(np.meshgrid(*zip(*box, strict=True))).reshape(3, -1).T
    flat = view.project(corners)
    (left, bottom), (right, top) = flat.min(axis=0), flat.max(axis=0)
    rows = max(2, round(columns * (top - bottom) / (right - left)))
    right_of = left + (np.arange(columns) + 0.5) * (right - left) / columns
    above = bottom + (np.arange(rows) + 0.5) * (top - bottom) / rows
    start = right_of[None, :, None] * view.right + above[:, None, None] * view.up
    depths = view.depth(corners)
    beyond = 0.04 * float(np.ptp(depths))
    run = np.linspace(depths.max() + beyond, depths.min() - beyond, _ALONG)
    first = _first_crossings(ground, box, view, start.reshape(-1, 3), run)
    points = first.reshape(_LAYERS, rows, columns, 3)
    flat_points = np.nan_to_num(points.reshape(-1, 3))
    with np.errstate(all="ignore"):
        normals = ground.normals(flat_points).reshape(points.shape)
    depth = np.where(np.isfinite(points[..., 0]), view.depth(np.nan_to_num(points)), -np.inf)
    return Crossings((left, right, bottom, top), points, normals, depth)


def _first_crossings(
    ground: SurfaceGround, box: Box, view: View, start: FloatArray, run: FloatArray
) -> FloatArray:
    """Crossings (layers, n, 3) of lines start + t·toward, NaN where there is none."""
    # Samples reach beyond the box, so that the surface can cross the box boundary between samples.
    room = 0.04 * float(np.max(box.high - box.low))
    wide = Box(box.low - room, box.high + room)
    _, heights = heights_on_grid(wide, ground)
    scale = (np.array(heights.shape) - 1) / (wide.high - wide.low)
    # Component-wise, for all rays at once: (n, 3) arrays are slower.
    starts = np.ascontiguousarray(start.T)
    first = np.full((_LAYERS, len(start), 3), np.nan)
    count = np.zeros(len(start), dtype=int)
    before = np.full(len(start), np.nan)
    for index, along in enumerate(run):
        points = starts + (along * view.toward)[:, None]
        inside = np.flatnonzero(_within(points.T, wide))
        now = np.full(len(start), np.nan)
        places = (points[:, inside] - wide.low[:, None]) * scale[:, None]
        now[inside] = map_coordinates(heights, places, order=1, mode="nearest")
        with np.errstate(invalid="ignore"):
            crossed = np.flatnonzero((before * now < 0.0) & (count < _LAYERS))
        if len(crossed):
            share = before[crossed] / (before[crossed] - now[crossed])
            depth = run[index - 1] + share * (along - run[index - 1])
            met = _refined_crossings(ground, view, start[crossed], depth)
            in_box = _within(met, box)
            crossed = crossed[in_box]
            first[count[crossed], crossed] = met[in_box]
            count[crossed] += 1
        before = now
    return first


def _within(points: FloatArray, box: Box) -> BoolArray:
    """Whether points (n, 3) lie in a box."""
    within = np.ones(len(points), dtype=np.bool_)
    for places, low, high in zip(points.T, box.low, box.high, strict=True):
        within &= (places >= low) & (places <= high)
    return within


def _refined_crossings(
    ground: SurfaceGround, view: View, start: FloatArray, depth: FloatArray
) -> FloatArray:
    """Crossings on the surface itself, by two secant steps from those on the grid."""
    points = start + depth[:, None] * view.toward
    with np.errstate(all="ignore"):
        for _ in range(2):
            lean = ground.normals(points) @ view.toward
            step = ground.height(points) / np.where(np.abs(lean) > 0.15, lean, np.inf)
            points = points - np.nan_to_num(step)[:, None] * view.toward
    return points
