"""The point of a convex body nearest to a sphere about the origin."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ..mechanics.shapes.rays import directions

#: Numbers of normals tried over the whole sphere and in each cap, and number of shrinking caps.
_NORMALS, _IN_CAP, _CAPS = 2000, 60, 14

#: Number of Newton steps, and the tolerance for |γ×y| relative to |y|.
_STEPS, _SLACK = 8, 1e-12


def nearest_normal(
    points: Callable[[FloatArray], FloatArray], centre: FloatArray, outside: bool
) -> FloatArray:
    """The normal of a sphere about the origin at the point nearest to a body.

    The plane with normal γ that touches the body at y(γ) has the distance (γ, y) from the origin.
    For a body outside the sphere the nearest point maximises (γ, y), for one inside it minimises
    it; there y is parallel to γ.  The best of a spiral grid of normals is improved in shrinking
    caps and then by Newton's method for the components of y perpendicular to γ.

    Parameters
    ----------
    points : callable
        Unit vectors γ (n, 3) ↦ points of the body with outward normal −γ, from the centre of mass.
    centre : array (3,)
        Centre of mass, in the same axes as the normals.
    outside : bool
        Whether the body is outside the sphere; false also for a sphere inside a hollow ball.

    Returns
    -------
    array (3,)
        Unit vector γ.

    Raises
    ------
    InputError
        If no such point is found.

    Examples
    --------
    >>> import numpy as np
    >>> from nonholonomic.contact.nearest_point import nearest_normal
    >>> ball = lambda gamma: -0.5 * gamma
    >>> gamma = nearest_normal(ball, np.array([3.0, 0.0, 4.0]), outside=True)
    >>> [round(float(x), 12) for x in gamma + 1]
    [1.6, 1.0, 1.8]
    """
    sign = 1.0 if outside else -1.0

    def best(normals: FloatArray) -> FloatArray:
        heights = sign * np.einsum("ni,ni->n", normals, centre + points(normals))
        if not np.isfinite(heights).any():
            raise _not_found()
        chosen: FloatArray = normals[int(np.nanargmax(heights))]
        return chosen

    # A plane may touch a sharp edge; the normals along its axis give NaN and are ignored.
    with np.errstate(invalid="ignore", divide="ignore"):
        gamma = best(directions(_NORMALS))
        width = 4 / math.sqrt(_NORMALS)
        for _ in range(_CAPS):
            gamma = best(_normals_in_cap(gamma, width))
            width *= 0.3
        for _ in range(_STEPS):
            gamma = _newton_step(points, centre, gamma)
    y = centre + points(gamma[None])[0]
    if not np.linalg.norm(np.cross(gamma, y)) <= _SLACK * np.linalg.norm(y):
        raise _not_found()
    return gamma


def _not_found() -> InputError:
    return InputError("position: no point of the body was found to be the nearest to the sphere")


def _tangents(gamma: FloatArray) -> FloatArray:
    """Two orthonormal vectors (2, 3) perpendicular to γ."""
    first = np.cross(gamma, np.eye(3)[int(np.argmin(np.abs(gamma)))])
    first = first / np.linalg.norm(first)
    return np.stack([first, np.cross(gamma, first)])


def _normals_in_cap(gamma: FloatArray, width: float) -> FloatArray:
    """Unit vectors within an angle `width` (rad) of γ, starting with γ."""
    numbers = np.arange(_IN_CAP)
    turns = np.pi * (3 - math.sqrt(5)) * numbers
    radii = width * np.sqrt(numbers / _IN_CAP)
    plane = np.stack([np.cos(turns), np.sin(turns)], axis=1) * radii[:, None]
    around = gamma + plane @ _tangents(gamma)
    unit: FloatArray = around / np.linalg.norm(around, axis=1)[:, None]
    return unit


def _newton_step(
    points: Callable[[FloatArray], FloatArray], centre: FloatArray, gamma: FloatArray
) -> FloatArray:
    """One Newton step for the part of y perpendicular to γ, with central differences."""
    across, step = _tangents(gamma), 1e-6
    normals = np.stack(
        [gamma, *(gamma + step * t for t in across), *(gamma - step * t for t in across)]
    )
    normals = normals / np.linalg.norm(normals, axis=1)[:, None]
    places = centre + points(normals)
    heights = np.einsum("ni,ni->n", normals, places)
    defects = (places - heights[:, None] * normals) @ across.T
    slopes = ((defects[1:3] - defects[3:5]) / (2 * step)).T
    try:
        move = np.linalg.solve(slopes, -defects[0])
    except np.linalg.LinAlgError:
        return gamma
    if not np.isfinite(move).all() or np.abs(move).max() > 1e-2:
        return gamma
    turned = gamma + move @ across
    unit: FloatArray = turned / np.linalg.norm(turned)
    return unit
