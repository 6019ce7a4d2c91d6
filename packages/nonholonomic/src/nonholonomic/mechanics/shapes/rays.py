"""Rays from the geometric centre of a body, in all directions."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable

import numpy as np

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

#: Number of rays on which a surface is tested, and of distances (powers of two) on each.
RAYS, FARTHEST = 1000, 80


def directions(count: int) -> FloatArray:
    """Nearly uniform unit vectors (count, 3), on a golden-angle spiral."""
    heights = 1 - (2 * np.arange(count) + 1) / count
    turns = np.pi * (3 - math.sqrt(5)) * np.arange(count)
    widths = np.sqrt(1 - heights**2)
    return np.stack([widths * np.cos(turns), widths * np.sin(turns), heights], axis=1)


def require_closed(name: str, level: Callable[..., FloatArray]) -> None:
    """Refuse a surface that some ray from the geometric centre never meets.

    Parameters
    ----------
    name : str
        The surface, as in messages.
    level : callable
        A function of arrays x, y, z, negative inside and zero on the surface.

    Raises
    ------
    InputError
        If it stays negative along a ray.
    """
    # cylinders are open only along their axis, usually a coordinate axis, which the spiral misses
    corners = np.array([x for x in itertools.product((-1.0, 0.0, 1.0), repeat=3) if any(x)])
    rays = np.concatenate([corners, directions(RAYS)])
    with np.errstate(all="ignore"):
        far = np.ldexp(1.0, np.arange(FARTHEST))[:, None, None] * rays
        values = np.broadcast_to(level(*np.moveaxis(far, 2, 0)), far.shape[:2])
        # not (f <= 0) rather than f > 0: an overflow to NaN counts as outside
        never = np.flatnonzero(~np.any(~(values <= 0), axis=0))
    if len(never):
        way = ", ".join(f"{x:.2g}" for x in rays[never[0]])
        raise InputError(
            f"{name}: it is not closed; in the direction ({way}) the left side stays negative, "
            "however far from the geometric centre"
        )
