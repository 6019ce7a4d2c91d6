"""Logarithms and real powers of divided differences."""

from __future__ import annotations

import mpmath
import pytest
from flint import acb, arb, ctx, fmpq

from nonholonomic.closed_form.one_degree.divided_differences import DividedDifferences, power, slope

EXPONENTS = [fmpq(7, 3), fmpq(-7, 3), fmpq(-3, 2), fmpq(5), fmpq(-2), fmpq(41, 2)]


@pytest.fixture(autouse=True)
def _precise():
    with ctx.workprec(200):
        yield


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_equal_points_give_derivatives(exponent):
    x = arb("0.7")
    for order in range(4):
        exact = mpmath.mpf(1)
        with mpmath.workdps(50):
            e = mpmath.mpf(int(exponent.p)) / int(exponent.q)
            exact = mpmath.binomial(e, order) * mpmath.mpf("0.7") ** (e - order)
        value = slope(lambda y: power(y, exponent), *([x] * (order + 1)))
        assert abs(value.real - arb(mpmath.nstr(exact, 45))) < arb("1e-38") * (1 + abs(value.real))
        assert value.real.rad() < 1e-35


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_distinct_points_give_quotients(exponent):
    a, b, c = arb("0.3"), arb("0.300001"), arb("1.9")

    def f(y):
        return power(y * 2 + arb("0.1"), exponent)

    first, second = (f(a) - f(b)) / (a - b), (f(b) - f(c)) / (b - c)
    assert slope(f, a, b).real.overlaps(first)
    assert slope(f, a, b, c).real.overlaps((first - second) / (a - c))
    assert slope(f, a, b, c).real.rad() < 1e-40


def test_a_logarithm_undoes_the_exponential():
    x = DividedDifferences.variable([arb("0.3"), arb("0.3"), arb("1.7")])
    back = (x * x + 1).log().exp().matrix
    for j, exact in enumerate((arb("1.09"), arb("0.6"), arb(1))):
        assert back[0, j].real.overlaps(exact)
        assert back[0, j].real.rad() < 1e-45


def test_a_ball_that_meets_the_branch_cut_has_no_value():
    box = acb(arb(0.5, 0.3), arb(0, 0.3))
    assert slope(lambda y: power(y + 1, fmpq(7, 3)), box).is_finite()
    assert not slope(lambda y: power(y - 1, fmpq(7, 3)), box).is_finite()
    assert not power(box - 1, fmpq(7, 3)).is_finite()
