"""What polynomials in one variable imply of each other."""

from __future__ import annotations

import pytest

from certificate_checker.claim.polynomials import Ring
from certificate_checker.identities.one_variable import is_positive_where

RING = Ring(["x", "y"])
X, Y = RING.context.gens()


@pytest.mark.parametrize(
    ("poly", "facts", "expected"),
    [
        (X**4 - X + 1, [], True),
        (X**4 - 2 * X**2 + 1, [], False),
        (1 - X, [(1 - X**2, True)], True),
        # the end of the interval belongs to it
        (1 - X, [(1 - X**2, False)], False),
        (2 - X**2, [(1 - X, True)], False),
        (2 - X**2, [(1 - X, True), (1 + X, True)], True),
        # a root that is irrational and shared
        (X**2 - 2, [(X**3 - 2 * X, True), (X, True)], True),
        (X**2 - 2, [(X**3 - 2 * X, False), (X, True)], False),
        (X**2 - 3, [(X**3 - 2 * X, True), (X, True)], False),
        # a single point is left
        (X, [(-((X - 1) ** 2), False)], True),
        (X - 1, [(-((X - 1) ** 2), False)], False),
        (X - Y, [(X, True)], False),
    ],
)
def test_signs_between_roots(poly, facts, expected):
    assert is_positive_where(poly, facts) is expected
