"""The inverse Gauss map in numbers: contact points at many normals at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache

import numpy as np
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import flat_pairs
from flowlanes.system.vectors import Vector, to_components

from .implicit import Implicit
from .rays import directions
from .shapes import Ball, Disk, Shape, Torus

_ITERATIONS = 200

#: Tangent planes examined.
PLANES = 2000


def contact_points(shape: Shape) -> Callable[[FloatArray], FloatArray]:
    """The function γ ↦ r of a shape, for unit vectors (n, 3) in body axes.

    r runs from the centre of mass to the point of the surface whose outward normal is −γ.
    """
    centre = np.array(shape.centre)
    if isinstance(shape, Implicit):
        f = shape.surface.subs(dict(shape.values))
        return lambda gamma: centre + contact_points_of_normals(f, shape.coordinates, gamma)
    body = shape.gauss()
    gamma_symbols = Vector("gamma").symbols
    steps = list(flat_pairs(body.definitions))
    values = {p.symbol: p.default for p in body.parameters}
    reach = sp.lambdify(
        [*gamma_symbols, *values],
        list(to_components(body.reach)),
        "numpy",
        cse=lambda formulas: (steps, formulas),
    )

    def points(gamma: FloatArray) -> FloatArray:
        columns = reach(*np.asarray(gamma, dtype=float).T, *values.values())
        points: FloatArray = centre + np.stack(np.broadcast_arrays(*columns), axis=1)
        return points

    return points


@lru_cache(maxsize=64)
def half_breadth(shape: Shape) -> float:
    """Half the largest distance of two points with opposite normals, by many tangent planes."""
    if isinstance(shape, Ball):
        return float(shape.radius)
    normals = directions(PLANES)
    points = contact_points(shape)
    chords = points(normals) - points(-normals)
    return float(np.nanmax(np.linalg.norm(chords, axis=1))) / 2


def centre_outside(shape: Shape) -> bool:
    """Whether the centre of mass lies outside a shape, by many tangent planes.

    A hollow ball has nothing inside; there it is whether the centre lies outside its sphere.  A
    disk or a torus is the rim on which a body rolls, a cylinder or a cup of any height: the centre
    is outside where it is farther from the axis than the rim.
    """
    centre = np.array(shape.centre)
    if not centre.any():
        return False
    match shape:
        case Ball():
            return bool(np.linalg.norm(centre) > shape.radius)
        case Disk():
            return bool(np.linalg.norm(centre[:2]) > shape.radius)
        case Torus():
            return bool(np.linalg.norm(centre[:2]) > shape.radius + shape.tube)
        case Implicit():
            at = dict(zip(shape.coordinates, -centre, strict=True))
            return bool(shape.surface.subs({**dict(shape.values), **at}) > 0)
        case _:
            normals = directions(PLANES)
            heights = -np.einsum("ni,ni->n", contact_points(shape)(normals), normals)
            return bool((heights < 0).any())


def contact_points_of_normals(
    f: sp.Expr, coordinates: Sequence[sp.Symbol], gamma: FloatArray
) -> FloatArray:
    """Points of the surface f = 0 whose outward normals are −γ.

    Solves ∇f + ℓγ = 0, ℓ = |∇f|, by damped Newton iteration from the points below the origin of
    the coordinates, which must lie inside.

    Parameters
    ----------
    f : sympy.Expr
        In `coordinates` alone, negative inside.
    coordinates : 3 Symbols
    gamma : array (n, 3)
        Unit vectors.

    Returns
    -------
    array (n, 3)

    Raises
    ------
    InputError
        If the surface is not closed.
    """
    gamma = np.asarray(gamma, dtype=float)
    numbers = sp.lambdify(
        [tuple(coordinates)],
        [f, *(f.diff(s) for s in coordinates), *sp.hessian(f, coordinates)],
        "numpy",
    )

    def at(x: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        rows = [np.broadcast_to(row, len(x)) for row in numbers(x.T)]
        return rows[0], np.stack(rows[1:4], axis=1), np.stack(rows[4:], axis=1).reshape(-1, 3, 3)

    x = -gamma * _radius(lambda far: at(-gamma * far[:, None])[0], len(gamma))[:, None]
    for _ in range(_ITERATIONS):
        level, slope, hessian = at(x)
        length = np.linalg.norm(slope, axis=1)
        matrix = np.zeros((len(x), 4, 4))
        matrix[:, :3, :3] = hessian
        matrix[:, :3, 3] = gamma
        matrix[:, 3, :3] = slope
        defect = np.concatenate([slope + length[:, None] * gamma, level[:, None]], axis=1)
        # where f is flat the equations are nearly singular; the least-squares step is the
        # one that does not run away
        step = -np.einsum("nij,nj->ni", np.linalg.pinv(matrix), defect)[:, :3]
        move = np.abs(step).max(axis=1)
        size = np.abs(x).max(axis=1)
        damping = np.minimum(1.0, 0.3 * size / np.maximum(move, 1e-300))
        x = x + damping[:, None] * step
        if np.all(move <= 1e-14 * size):
            break
    return x


def _radius(level: Callable[[FloatArray], FloatArray], count: int) -> FloatArray:
    """Distance from the centre at which a ray leaves the body, by bisection."""
    near, far = np.zeros(count), np.ones(count)
    for _ in range(80):
        inside = level(far) <= 0
        if not inside.any():
            break
        far = np.where(inside, 2 * far, far)
    else:
        raise InputError("surface f = 0: it is not closed, f stays negative far from the centre")
    for _ in range(60):
        middle = (near + far) / 2
        outside = level(middle) > 0
        near, far = np.where(outside, near, middle), np.where(outside, middle, far)
    return near
