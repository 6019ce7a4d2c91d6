"""The inverse Gauss map of a body, symbolic and numerical: contact points at many normals."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import Pairs, flat_pairs, scalars
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import Vector

from .kinematics import Operator

_ITERATIONS = 200


@dataclass(frozen=True)
class GaussMap:
    """The inverse Gauss map of a shape, as formulas in γ.

    Attributes
    ----------
    parameters : tuple of Parameter
    definitions : pairs
        Named intermediate quantities used below.
    reach : MatrixExpr
        From the geometric centre to the contact point (body axes).
    spread : callable
        u ↦ W u for a vector u of the tangent plane; the rate of `reach` is −W γ̇.
    trace, determinant : sympy.Expr
        Sum and product of the principal radii of curvature at the contact.
    support : sympy.Expr
        Height of the geometric centre above the tangent plane.
    guards : tuple of Guard
    """

    parameters: tuple[Parameter, ...]
    definitions: Pairs
    reach: MatrixExpr
    spread: Operator
    trace: sp.Expr
    determinant: sp.Expr
    support: sp.Expr
    guards: tuple[Guard, ...] = ()


def points_of_map(body: GaussMap, centre: Sequence[float]) -> Callable[[FloatArray], FloatArray]:
    """The function γ ↦ r of a Gauss map at its default parameters, for unit vectors (n, 3)."""
    origin = np.array(centre)
    gamma_symbols = Vector("gamma").symbols
    steps = list(flat_pairs(body.definitions))
    values = {p.symbol: p.default for p in body.parameters}
    reach = sp.lambdify(
        [*gamma_symbols, *values],
        scalars(body.reach),
        "numpy",
        cse=lambda formulas: (steps, formulas),
    )

    def points(gamma: FloatArray) -> FloatArray:
        columns = reach(*np.asarray(gamma, dtype=float).T, *values.values())
        points: FloatArray = origin + np.stack(np.broadcast_arrays(*columns), axis=1)
        return points

    return points


def contact_points_of_normals(
    f: sp.Expr, coordinates: Sequence[sp.Symbol], gamma: FloatArray
) -> FloatArray:
    """Points of the surface f = 0 whose outward normals are −γ.

    Solves ∇f + ℓγ = 0, ℓ = |∇f|, by damped Newton iteration; it starts where the rays −γ from the
    origin, which must lie inside, leave the body.

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
        # unknowns (x, ℓ): the rows are ∇²f dx + γ dℓ = −(∇f + ℓγ) and (∇f, dx) = −f
        matrix = np.zeros((len(x), 4, 4))
        matrix[:, :3, :3] = hessian
        matrix[:, :3, 3] = gamma
        matrix[:, 3, :3] = slope
        defect = np.concatenate([slope + length[:, None] * gamma, level[:, None]], axis=1)
        # where the Hessian of f is nearly singular, the least-squares step stays bounded
        step = -np.einsum("nij,nj->ni", np.linalg.pinv(matrix), defect)[:, :3]
        move = np.abs(step).max(axis=1)
        size = np.abs(x).max(axis=1)
        # a step of at most 0.3 of the distance from the origin cannot jump across the body
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
