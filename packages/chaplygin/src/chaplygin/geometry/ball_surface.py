"""The surface f = 0 that carries a ball, as functions of points in space."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import sympy as sp

from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import Vector
from nonholonomic.mechanics.ball.ball import RollingBall
from nonholonomic.mechanics.shapes.surfaces import Surface

from .view import unit

_GRID = 60
"""Number of grid points along the longest side of the box at which f is sampled."""

_SETTLE = 6
"""Number of fixed-point steps from a point of the carrying surface to the centre above it."""


def _everywhere(points: FloatArray) -> FloatArray:
    return np.ones(len(points))


@dataclass(frozen=True)
class SurfaceGround:
    """The surface on which a ball rolls.

    Attributes
    ----------
    level : callable
        f at points (n, 3) as (n,); positive on the ball's side.
    slope : callable
        ∇f at points (n, 3) as (n, 3).
    shift : float
        0 if f = 0 carries the ball; its radius if the centre moves on f = 0.
    domain : callable
        A function of the same points that is positive where f = 0 belongs to the surface.
    """

    level: Callable[[FloatArray], FloatArray]
    slope: Callable[[FloatArray], FloatArray]
    shift: float
    domain: Callable[[FloatArray], FloatArray] = _everywhere

    def centres(self, points: FloatArray) -> FloatArray:
        """Points (n, 3) of f = 0 above points of the surface that carries the ball."""
        centres = points
        if self.shift:
            for _ in range(_SETTLE):
                centres = points + self.shift * self.normals_at(centres)
        return centres

    def normals_at(self, points: FloatArray) -> FloatArray:
        """Unit normals of the level surfaces through points (n, 3)."""
        return unit(np.nan_to_num(self.slope(points)))

    def height(self, points: FloatArray) -> FloatArray:
        """The approximate signed distance (n,) from the surface; NaN where there is no surface."""
        return np.where(self.extent(points) > 0.0, self.continued_height(points), np.nan)

    def extent(self, points: FloatArray) -> FloatArray:
        """A function (n,) that vanishes at the border of the surface and is positive on it."""
        return self.domain(self.centres(points))

    def continued_height(self, points: FloatArray) -> FloatArray:
        """The height (n,), continued beyond the border of the surface."""
        centres = self.centres(points)
        # f/|∇f| is the distance to first order
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
    # f has one sign on a wider box: the surface is closed and is drawn as a whole
    if np.all(outside > 0.0) or np.all(outside < 0.0):
        return _shrunk(wide, ground)
    return Box(low, high)


def _shrunk(box: Box, ground: SurfaceGround) -> Box:
    """The smallest box around a closed surface, by a grid."""
    points, inside = heights_on_grid(box, ground)
    signs = np.sign(inside)
    other = signs != signs.flat[0]
    if not np.any(other):
        return box
    step = (box.high - box.low) / (np.array(inside.shape) - 1)
    filled = points[other]
    return Box(filled.min(axis=0) - 2 * step, filled.max(axis=0) + 2 * step)


def heights_on_grid(box: Box, ground: SurfaceGround) -> tuple[FloatArray, FloatArray]:
    """Points of a grid in the box and their heights."""
    size = box.high - box.low
    counts = np.maximum(8, np.ceil(_GRID * size / size.max())).astype(int)
    axes = [np.linspace(a, b, n) for a, b, n in zip(box.low, box.high, counts, strict=True)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    with np.errstate(all="ignore"):
        heights = ground.height(points.reshape(-1, 3)).reshape(points.shape[:3])
    return points, heights


def ground_of_ball(ball: RollingBall) -> SurfaceGround:
    """The surface that carries the ball, by its own equation if it has a simple one."""
    shift = 0.0 if ball.carrier == "support" else ball.radius
    below = ball.surface.equation(_PLACE, -sp.Float(shift)) if shift else ball.carrying
    f = ball.carrying if below is None else below
    guards = [guard.value for guard in ball.surface.domain(_PLACE)]
    return _ground(f, ball.surface.parameters, guards, shift if below is None else 0.0)


def ground_of_surface(surface: Surface) -> SurfaceGround:
    """A surface on which bodies roll, by its equation."""
    return _ground(surface.equation(_PLACE), surface.parameters, (), 0.0)


_PLACE = Vector("x").symbols


def _ground(
    f: sp.Expr, parameters: Iterable[Parameter], guards: Iterable[sp.Expr], shift: float
) -> SurfaceGround:
    """f = 0 at the default parameters."""
    f = f.subs({p.symbol: p.default for p in parameters})

    def values(formula: sp.Expr) -> Callable[[FloatArray], FloatArray]:
        function = sp.lambdify(_PLACE, formula, "numpy")

        def values_at(points: FloatArray) -> FloatArray:
            heights = np.asarray(function(*points.T), dtype=np.float64)
            return np.broadcast_to(heights, points.shape[:1])

        return values_at

    slopes = [values(f.diff(s)) for s in _PLACE]
    borders = [values(guard) for guard in guards]

    def domain(points: FloatArray) -> FloatArray:
        found = [_everywhere(points), *(border(points) for border in borders)]
        return np.asarray(np.minimum.reduce(found), dtype=np.float64)

    return SurfaceGround(
        values(f),
        lambda points: np.stack([slope(points) for slope in slopes], axis=-1),
        shift,
        domain,
    )
