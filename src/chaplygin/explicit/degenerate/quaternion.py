"""Quaternions in balls: turning a vector, and back from a matrix to the quaternion."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

__all__ = ["cross", "dot", "product", "quaternion", "times", "times_array"]


def product(turn: Sequence[Any], vector: Sequence[Any]) -> list[Any]:
    """A vector turned by a unit quaternion (w, x, y, z)."""
    w, *axis = turn
    once = cross(axis, vector)
    twice = cross(axis, once)
    return [v + 2 * (w * a + b) for v, a, b in zip(vector, once, twice, strict=True)]


def dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    """Scalar product of three components each."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
    """Sequence[Any] product of three components each."""
    return [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]


def times(p: Sequence[Any], q: Sequence[Any]) -> tuple[Any, ...]:
    """The product of two quaternions in balls."""
    side = cross(p[1:], q[1:])
    vector = [p[0] * b + q[0] * a + c for a, b, c in zip(p[1:], q[1:], side, strict=True)]
    return (p[0] * q[0] - dot(p[1:], q[1:]), *vector)


def times_array(p: Any, q: Any) -> Any:
    """Products of quaternions (n, 4), scalar first, signs kept."""
    scalar = p[:, :1] * q[:, :1] - np.sum(p[:, 1:] * q[:, 1:], axis=1, keepdims=True)
    vector = p[:, :1] * q[:, 1:] + q[:, :1] * p[:, 1:] + np.cross(p[:, 1:], q[:, 1:])
    return np.concatenate([scalar, vector], axis=1)


def quaternion(rows: Sequence[Sequence[Any]], near: Sequence[float]) -> list[Any]:
    """The unit quaternion of a rotation matrix in balls, the one of two that is nearer to `near`.

    Parameters
    ----------
    rows : three rows of three arb
        Body to space.
    near : 4 floats
        Roughly the quaternion.
    """
    (a, b, c), (d, e, f), (g, h, i) = rows
    squares = [1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i]
    largest = max(range(4), key=lambda k: abs(near[k]))
    parts = [
        [squares[0], h - f, c - g, d - b],
        [h - f, squares[1], b + d, c + g],
        [c - g, b + d, squares[2], f + h],
        [d - b, c + g, f + h, squares[3]],
    ][largest]
    size = 2 * squares[largest].sqrt()
    sign = 1 if near[largest] > 0 else -1
    return [sign * part / size for part in parts]
