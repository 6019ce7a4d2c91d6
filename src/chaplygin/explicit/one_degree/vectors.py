"""Vectors of three components and quaternions (w, x, y, z), of balls or of arrays."""

from __future__ import annotations

from collections.abc import Sequence

from .functions import N


def dot(a: Sequence[N], b: Sequence[N]) -> N:
    """The scalar product of two vectors."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Sequence[N], b: Sequence[N]) -> list[N]:
    """The vector product of two vectors."""
    return [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]


def product(turn: Sequence[N], vector: Sequence[N]) -> list[N]:
    """A vector turned by a unit quaternion."""
    w, axis = turn[0], turn[1:]
    once = cross(axis, vector)
    twice = cross(axis, once)
    return [vector[k] + 2 * (w * once[k] + twice[k]) for k in range(3)]


def times(p: Sequence[N], q: Sequence[N]) -> list[N]:
    """The product of two quaternions."""
    side = cross(p[1:], q[1:])
    scalar = p[0] * q[0] - dot(p[1:], q[1:])
    return [scalar] + [p[0] * q[k + 1] + q[0] * p[k + 1] + side[k] for k in range(3)]


def conjugate(q: Sequence[N]) -> list[N]:
    """The inverse of a unit quaternion."""
    return [q[0], -q[1], -q[2], -q[3]]
