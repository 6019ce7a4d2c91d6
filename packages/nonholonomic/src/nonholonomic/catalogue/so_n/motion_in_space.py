"""The lift of an n-dimensional body to space: attitude and, of a ball, its contact point."""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.matrices import Column, Skew, SquareMatrix
from flowlanes.system.system import Observable, Reconstruction
from flowlanes.system.vectors import Components, Vector

Field = dict[MatrixExpr, MatrixExpr]


def omega_of(dimension: int) -> Skew:
    """The angular velocity ω, body axes: γ̇ = −ωγ for a direction γ fixed in space."""
    return Skew("omega", dimension)


def gamma_of(dimension: int) -> Column:
    """The unit vector γ fixed in space, body axes: the last row of the attitude."""
    return Column("gamma", dimension)


def attitude_of(dimension: int) -> SquareMatrix:
    """The attitude g, from body to space: its rows are the space axes seen from the body."""
    return SquareMatrix("attitude", dimension)


def contact_of(dimension: int) -> Vector:
    """The contact point of a ball in its hyperplane, by n − 1 coordinates of space."""
    return Column("contact", dimension - 1)


def unit_length(vector: Vector) -> sp.Expr:
    """Vanishes for a unit vector."""
    return sp.Add(*(s**2 for s in vector.symbols)) - 1


def angular_velocity(dimension: int) -> Observable:
    """The entries ω_12, ω_13, …, as they are recorded."""
    entries = sp.ImmutableDenseMatrix(omega_of(dimension).symbols)
    return Observable("omega", entries, "angular velocity, body axes", "rad/s", "pair")


def motion_in_space(dimension: int, radius: sp.Expr | None = None) -> Reconstruction:
    """ġ = g ω and, for a ball of this radius, ẋ = R g ω γ.

    Parameters
    ----------
    dimension : int
    radius : sympy.Expr, optional
        R; None for a body about a fixed point.
    """
    n = dimension
    g, omega, gamma = attitude_of(n), omega_of(n), gamma_of(n)
    turning: Field = {g: g * omega}
    if radius is not None:
        velocity = g.entries * (omega.entries * gamma.entries)
        turning[contact_of(n)] = Components(radius * velocity[: n - 1, 0])
    rows = [g.entries.row(i) for i in range(n)]
    orthonormal = [
        (rows[i] * rows[j].T)[0] - int(i == j) for i in range(n - 1) for j in range(i, n)
    ]
    tied = [a - b for a, b in zip(rows[-1], gamma.entries, strict=True)]
    return Reconstruction(field=turning, relations=(*orthonormal, *tied), observables=())
