"""The surface f = 0 in pictures: its crossings with lines of sight.

As in :mod:`chaplygin.report.drawing.view` everything is plain geometry in arrays; all lengths
are in the units of the trajectory.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.ndimage import map_coordinates

from ...core.arrays import BoolArray, FloatArray
from ..drawing.view import View, unit

_GRID = 60
"""Points of the grid on which f is known beforehand, along the longest side of the box."""

_ALONG = 110
"""Samples along a line of sight through the box."""

_LAYERS = 4
"""Crossings of a line of sight that are kept, counted from the reader."""

_SETTLE = 6
"""Steps by which the place of a centre is found from a point of the surface below it."""


@dataclass(frozen=True)
class SurfaceGround:
    """The ball rolls on a surface.

    Attributes
    ----------
    level : callable
        f at points (n, 3) as (n,); positive on the ball's side, NaN where there is no surface.
    slope : callable
        ∇f at points (n, 3) as (n, 3).
    shift : float
        0 if f = 0 carries the ball; its radius if the centre moves on f = 0.
    """

    level: Callable[[FloatArray], FloatArray]
    slope: Callable[[FloatArray], FloatArray]
    shift: float

    def centres(self, points: FloatArray) -> FloatArray:
        """Points (n, 3) of the given surface, for points of the one that carries the ball."""
        centres = points
        if self.shift:
            for _ in range(_SETTLE):
                centres = points + self.shift * self.normals_at(centres)
        return centres

    def normals_at(self, points: FloatArray) -> FloatArray:
        """Unit normals of the level surfaces through points (n, 3)."""
        return unit(np.nan_to_num(self.slope(points)))

    def height(self, points: FloatArray) -> FloatArray:
        """A function (n,) that vanishes on the surface, about the distance from it."""
        centres = self.centres(points)
        steep = np.linalg.norm(self.slope(centres), axis=-1)
        return np.asarray(self.level(centres) / np.where(steep > 0.0, steep, 1.0), np.float64)

    def normals(self, points: FloatArray) -> FloatArray:
        """Unit normals (n, 3) towards the ball, on the carrying surface."""
        return self.normals_at(self.centres(points))


class Box(NamedTuple):
    """The drawn part of a surface, between two corners of space."""

    low: FloatArray
    high: FloatArray


def frame_of(points: FloatArray, margin: FloatArray, ground: SurfaceGround) -> Box:
    """A box around points (n, 3) with margins (3,), or around a closed surface."""
    low, high = points.min(axis=0) - margin, points.max(axis=0) + margin
    middle, half = (low + high) / 2, (high - low) / 2
    wide = Box(middle - 1.6 * np.max(half), middle + 1.6 * np.max(half))
    share = np.linspace(0.0, 1.0, 41)
    first, second = (grid.ravel() for grid in np.meshgrid(share, share))
    faces = []
    for axis in range(3):
        for end in (0.0, 1.0):
            face = np.empty((len(first), 3))
            face[:, axis] = end
            face[:, (axis + 1) % 3], face[:, (axis + 2) % 3] = first, second
            faces.append(wide.low + face * (wide.high - wide.low))
    with np.errstate(all="ignore"):
        outside = ground.height(np.concatenate(faces))
    if np.all(outside > 0.0) or np.all(outside < 0.0):
        return _shrunk(wide, ground)
    return Box(low, high)


def _shrunk(box: Box, ground: SurfaceGround) -> Box:
    """The box that a closed surface fills."""
    points, inside = _grid(box, ground)
    signs = np.sign(inside)
    other = signs != signs.flat[0]
    if not np.any(other):
        return box
    step = (box.high - box.low) / (np.array(inside.shape) - 1)
    filled = points[other]
    return Box(filled.min(axis=0) - 2 * step, filled.max(axis=0) + 2 * step)


def _grid(box: Box, ground: SurfaceGround) -> tuple[FloatArray, FloatArray]:
    """Points of a grid in the box and the height of each."""
    size = box.high - box.low
    counts = np.maximum(8, np.ceil(_GRID * size / size.max())).astype(int)
    axes = [np.linspace(a, b, n) for a, b, n in zip(box.low, box.high, counts, strict=True)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    with np.errstate(all="ignore"):
        heights = ground.height(points.reshape(-1, 3)).reshape(points.shape[:3])
    return points, heights


@dataclass(frozen=True, eq=False)
class Crossings:
    """The crossings of lines of sight with a surface, nearest to the reader first.

    Attributes
    ----------
    extent : (left, right, bottom, top)
        Of the picture on paper.
    points, normals : (layers, rows, columns, 3) arrays
    depth : (layers, rows, columns) array
        Nearness to the reader; −∞ where there is no such crossing.
    """

    extent: tuple[float, float, float, float]
    points: FloatArray
    normals: FloatArray
    depth: FloatArray

    @property
    def met(self) -> BoolArray:
        """Whether each line of sight meets the surface so many times."""
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
    # samples reach beyond the box, so that it cuts the surface between two of them
    room = 0.04 * float(np.max(box.high - box.low))
    wide = Box(box.low - room, box.high + room)
    _, heights = _grid(wide, ground)
    scale = (np.array(heights.shape) - 1) / (wide.high - wide.low)
    first = np.full((_LAYERS, len(start), 3), np.nan)
    count = np.zeros(len(start), dtype=int)
    before = np.full(len(start), np.nan)
    for index, along in enumerate(run):
        points = start + along * view.toward
        inside = _within(points, wide)
        now = np.full(len(start), np.nan)
        places = ((points[inside] - wide.low) * scale).T
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
    return np.asarray(np.all((points >= box.low) & (points <= box.high), axis=1), dtype=np.bool_)


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
