"""Three-component vectors and quaternions (w, x, y, z), of balls or arrays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import sympy as sp
from flint import arb

from flowlanes.system.arrays import FloatArray
from flowlanes.system.tuple_vectors import cross

from .functions import N

#: Balls, or formulas.
Number = TypeVar("Number", arb, sp.Expr)


def product(turn: Sequence[N], vector: Sequence[N]) -> list[N]:
    """A vector rotated by a unit quaternion."""
    w, axis = turn[0], turn[1:]
    once = cross(axis, vector)
    twice = cross(axis, once)
    return [vector[k] + 2 * (w * once[k] + twice[k]) for k in range(3)]


def conjugate(q: Sequence[N]) -> list[N]:
    """The inverse of a unit quaternion."""
    return [q[0], -q[1], -q[2], -q[3]]


def quaternion_products(rows: Sequence[Sequence[Number]]) -> list[list[Number]]:
    """4 q_i q_j of the quaternion of a rotation matrix, body to space."""
    (a, b, c), (d, e, f), (g, h, i) = rows
    return [
        [1 + a + e + i, h - f, c - g, d - b],
        [h - f, 1 + a - e - i, b + d, c + g],
        [c - g, b + d, 1 - a + e - i, f + h],
        [d - b, c + g, f + h, 1 - a - e + i],
    ]


def quaternion_near(rows: Sequence[Sequence[arb]], rough: FloatArray) -> list[arb]:
    """The unit quaternion of a rotation matrix, with the sign closer to an approximate one."""
    # It is safe to divide by the largest component.
    place = max(range(4), key=lambda i: abs(rough[i]))
    products = [x / 4 for x in quaternion_products(rows)[place]]
    largest = products[place].sqrt() * (1 if rough[place] > 0 else -1)
    return [x / largest if i != place else largest for i, x in enumerate(products)]
