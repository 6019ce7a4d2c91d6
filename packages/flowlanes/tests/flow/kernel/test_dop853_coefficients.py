"""The method of order 8 with all its digits: every order condition holds."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from flint import arb, fmpq
from scipy.integrate import DOP853

from flowlanes.flow.kernel.dop853_coefficients import explicit_table, trees, weights

TABLE = explicit_table()


def _numbers(values: Sequence[Fraction]) -> Any:
    with flint.ctx.workprec(400):
        return np.array([arb(fmpq(v.numerator, v.denominator)) for v in values])


def _matrix() -> Any:
    rows = [[*row, *[Fraction(0)] * (12 - len(row))] for row in TABLE.a]
    return np.array([_numbers(row) for row in rows])


def _largest(values: Any) -> float:
    return float(max(map(abs, values)))


def _conditions(b: Sequence[Fraction], order: int) -> Any:
    with flint.ctx.workprec(400):
        return weights(_matrix(), _numbers(b), order)


def test_trees_are_counted() -> None:
    """Sequence A000081, and none twice."""
    found = [trees(n) for n in range(1, 9)]
    assert [len(set(t)) for t in found] == [len(t) for t in found]
    assert [len(t) for t in found] == [1, 1, 2, 4, 9, 20, 48, 115]


def test_conditions_of_a_known_method() -> None:
    """The classical method of order 4 meets the conditions to order 4 and no more."""
    a = np.array([[0, 0, 0, 0], [0.5, 0, 0, 0], [0, 0.5, 0, 0], [0, 0, 1, 0]])
    b = np.array([1, 2, 2, 1]) / 6
    np.testing.assert_allclose(weights(a, b, 4), 1, rtol=1e-14)
    assert np.abs(weights(a, b, 5) - 1).max() > 0.01


def test_all_order_conditions() -> None:
    """Two hundred trees."""
    found = _conditions(TABLE.b, 8)
    assert len(found) == 200
    assert _largest(found - 1) < 1e-60
    assert _largest(_conditions(TABLE.b, 9) - 1) > 1e-3


@pytest.mark.parametrize(("name", "order"), [("e3", 3), ("e5", 5)])
def test_estimates_of_the_error(name: str, order: int) -> None:
    """They vanish to their order, and not beyond."""
    found = getattr(TABLE, name)
    assert _largest(_conditions(found, order)) < 1e-60
    assert _largest(_conditions(found, order + 1)) > 1e-3


def test_rows_sum_to_the_nodes() -> None:
    for row, node in zip(TABLE.a, TABLE.c, strict=True):
        assert abs(sum(row, Fraction(0)) - node) < Fraction(1, 10**70)


def test_first_digits_are_those_of_scipy() -> None:
    """Rounded to doubles the coefficients are the same ones to the last place or two."""
    a = np.array([[*map(float, row), *[0.0] * (12 - len(row))] for row in TABLE.a])
    np.testing.assert_allclose(a, DOP853.A[:12, :12], rtol=1e-15)
    for found, doubles in ((TABLE.b, DOP853.B), (TABLE.c, DOP853.C), (TABLE.e3, DOP853.E3)):
        np.testing.assert_allclose([float(v) for v in found], doubles[:12], rtol=1e-14, atol=1e-16)
    np.testing.assert_allclose([float(v) for v in TABLE.e5], DOP853.E5[:12], rtol=1e-14)


@pytest.mark.parametrize(
    ("found", "printed"),
    [
        (TABLE.b[0], "0.0542937341165687622380535766363"),
        (TABLE.b[5], "4.45031289275240888144113950566"),
        (TABLE.a[4][2], "-0.884549479328286085344864962717"),
        (TABLE.b[0] - TABLE.e3[0], "0.244094488188976377952755905512"),
        (TABLE.b[11] - TABLE.e3[11], "0.0220588235294117647058823529412"),
    ],
    ids=["b1", "b6", "a53", "third order 1", "third order 12"],
)
def test_printed_digits(found: Fraction, printed: str) -> None:
    """Thirty digits from the program DOP853 of Hairer and Wanner, of what is not left free."""
    assert float(abs(found / Fraction(printed) - 1)) < 1e-29
