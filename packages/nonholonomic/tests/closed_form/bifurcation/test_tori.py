"""Tori over pairs of ovals, by the signs that a round changes."""

from __future__ import annotations

import pytest
from flint import fmpq, fmpq_poly

from nonholonomic.closed_form.bifurcation.tori import Oval, families, family, group

POLES = (fmpq(1), fmpq(2), fmpq(3))


@pytest.mark.parametrize(
    ("first", "second", "tori", "kept", "two_way"),
    [
        ((1, 0), (2, 3), 2, (), False),
        ((1, 2), (0, 3), 2, (), False),
        ((0, 2), (0, 3), 2, (1,), True),
        ((1, 0), (2, 0), 2, (3,), True),
        ((0, 0), (2, 3), 4, (1,), False),
        ((1, 2), (0, 0), 4, (3,), False),
        ((1, 0), (0, 3), 2, (2,), True),
        ((0, 0), (0, 3), 4, (1, 2), True),
        ((0, 0), (0, 0), 8, (1, 2, 3), True),
    ],
)
def test_a_pair_of_ovals(first, second, tori, kept, two_way):
    found = family(Oval(*first), Oval(*second))
    assert (found.tori, found.nonvanishing, found.two_way) == (tori, kept, two_way)


def test_group():
    assert group([]) == {0}
    assert group([0b011, 0b110]) == {0, 0b011, 0b110, 0b101}
    assert group([0b011, 0b011]) == {0, 0b011}


@pytest.mark.parametrize(
    ("rest", "texts"),
    [
        # y² = ∏(z − e)(r − z): the Veselova system and its likes
        ([fmpq(3, 2), -1], [("[e1, r]", "[e2, e3]")]),
        ([fmpq(5, 2), -1], [("[e1, e2]", "[r, e3]")]),
        ([fmpq(1, 2), -1], []),
        ([fmpq(7, 2), -1], []),
        # turned over, z₂ has no oval
        ([fmpq(-3, 2), 1], []),
        # two movable roots: ∓(z − 3/2)(z − 5/2)
        ([fmpq(-15, 4), 4, -1], [("[r, e2]", "[r, e3]")]),
        ([fmpq(15, 4), -4, 1], [("[e1, r]", "[e2, r]")]),
        # −(z − 5/4)(z − 7/4)
        ([fmpq(-35, 16), 3, -1], [("[r, r]", "[e2, e3]")]),
    ],
)
def test_ovals_of_a_curve(rest, texts):
    found = families(POLES, fmpq_poly(rest))
    assert [(each.first.text, each.second.text) for each in found] == texts
