"""Squares, multiples and intervals that show a sign."""

from __future__ import annotations

import pytest
from flint import Ordering, fmpq, fmpq_mpoly_ctx

from lawproof.proof.fields.positive_forms import (
    completed_squares,
    in_one_variable,
    less_a_multiple,
    signs_in_one_variable,
)
from lawproof.proof.fields.signs import Sign, Signs

RING = fmpq_mpoly_ctx.get(("x", "y", "z"), Ordering.lex)
X, Y, Z = RING.gens()
BALL = 1 - X**2 - Y**2


@pytest.mark.parametrize(
    "poly", [X**4 - 2 * X**2 + 2, X**2 + X * Y + Y**2, (X**2 + X * Y) ** 2 + Z**2, X**6 + 1]
)
def test_squares_add_up(poly):
    squares = completed_squares(poly, RING)
    assert squares is not None
    assert sum((w * base**2 for w, base in squares), RING.constant(0)) == poly
    assert all(weight > 0 for weight, _ in squares)


@pytest.mark.parametrize("poly", [X**2 - Y**2, X * Y, -(X**2), X**4 - 2 * X**2, X**3 + X**2])
def test_what_takes_both_signs_is_no_sum_of_squares(poly):
    assert completed_squares(poly, RING) is None


@pytest.mark.parametrize(
    ("poly", "expected"), [(2 - X - Y, True), (1 - X, True), (1 - X - Y, False), (X, False)]
)
def test_planes_beside_a_disk(poly, expected):
    form = less_a_multiple(poly, BALL, RING, either_sign=False)
    assert (form is not None) is expected
    if form is not None:
        ratio, squares = form
        assert ratio > 0
        assert poly == ratio * BALL + sum((w * b**2 for w, b in squares), RING.constant(0))


@pytest.mark.parametrize(
    ("poly", "facts", "signs"),
    [
        (X - 2, [(1 - X**2, True)], {-1}),
        (X, [(1 - X**2, True)], {-1, 0, 1}),
        (X, [(X**2 - 2, True)], {-1, 1}),
        (X - 1, [(1 - X**2, False)], {-1, 0}),
        (X, [(-1 - X**2, True)], set()),
    ],
)
def test_signs_in_one_variable(poly, facts, signs):
    given = [(in_one_variable(fact, 0), strict) for fact, strict in facts]
    assert signs_in_one_variable(in_one_variable(poly, 0), given) == signs


def test_signs_from_facts():
    signs = Signs(RING, {}, facts=((BALL, Sign.POSITIVE),))
    assert signs.of(X**3 - 3 * X + 5) is Sign.POSITIVE
    assert signs.of(X - 2) is Sign.NEGATIVE
    assert signs.of(fmpq(1, 2) - X) is Sign.UNKNOWN
    assert signs.never_zero(X**2 - 4)
    assert not signs.never_zero(2 * X - 1)
