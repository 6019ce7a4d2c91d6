"""Polynomials near smooth functions: good enough, and no longer than that needs."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest

from flowlanes.flow.machine_code.approximation import PARTS, parts, series


@pytest.mark.parametrize("bits", [59, 110])
@pytest.mark.parametrize("name", sorted(PARTS))
def test_polynomials_are_near(name: str, bits: int) -> None:
    """The error on the whole interval, at points between those of interpolation."""
    smooth, first, last = PARTS[name]
    found = series(name, bits)
    mp = mpmath.MPContext()
    mp.prec = 4 * bits
    coefficients = [mp.mpf(c.numerator) / c.denominator for c in reversed(found.coefficients)]
    for k in range(1, 60):
        t = first + (last - first) * mp.mpf(k) / 60
        assert abs(mp.polyval(coefficients, t) - smooth(mp, t)) < mp.mpf(2) ** (1 - bits)


@pytest.mark.parametrize(("name", "terms"), [("sin", 7), ("cos", 6), ("exp", 11), ("atanh", 8)])
def test_polynomials_are_short(name: str, terms: int) -> None:
    """For what 59 bits need."""
    assert len(series(name, 59).coefficients) == terms


@pytest.mark.parametrize(("name", "value"), [("pi", mpmath.mp.pi), ("ln2", mpmath.mp.ln2)])
def test_constants_in_pieces(name: str, value: object) -> None:
    """Short numbers, the rest behind them; together the constant."""
    *pieces, rest = parts(name, (42, 53, 53))
    for piece, bits in zip(pieces, (42, 53, 53), strict=True):
        assert piece.numerator.bit_length() <= bits
    assert 0 < abs(rest) < Fraction(1, 2**140)
    with mpmath.workprec(300):
        total = sum((*pieces, rest), Fraction(0))
        assert abs(mpmath.mpf(total.numerator) / total.denominator - value) < mpmath.mpf(2) ** -290
