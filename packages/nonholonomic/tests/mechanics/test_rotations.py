"""Rotations as quaternions and matrices, of any kind of numbers."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.tuple_vectors import dot
from nonholonomic.mechanics.rotations import quaternion_product, rotation_rows


def test_product_of_quaternions_is_that_of_rotations() -> None:
    p, q = (1, 2, 3, 4), (2, -1, 0, 5)
    turned = [
        sp.Matrix(rotation_rows(x, sp.Rational(2, dot(x, x))))
        for x in (p, q, quaternion_product(p, q))
    ]
    assert turned[0] * turned[1] == turned[2]
