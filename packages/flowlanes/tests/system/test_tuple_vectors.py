"""Products of vectors of any kind of numbers."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp
from flint import arb

from flowlanes.system.tuple_vectors import cross, dot

U, V = (1, -2, 5), (Fraction(1, 3), 7, 2)


def test_products_of_exact_vectors() -> None:
    assert dot(U, V) == Fraction(1, 3) - 14 + 10
    w = cross(U, V)
    assert w == list(sp.Matrix(U).cross(sp.Matrix(V)))
    assert dot(U, w) == dot(V, w) == 0
    assert dot([arb(2)], [arb(3)]) == 6


def test_components_are_as_many() -> None:
    with pytest.raises(ValueError, match="of 3 and 2 components"):
        dot(U, (1, 2))
