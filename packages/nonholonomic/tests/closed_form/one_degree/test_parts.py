"""Divided differences, panels, reduction of phases, formulas."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from flint import acb, arb, ctx, fmpq

from flowlanes.errors import InputError
from nonholonomic.closed_form.one_degree.angles import displacement_sum, displacement_sums
from nonholonomic.closed_form.one_degree.chebyshev_integrals import integrals, working_bits
from nonholonomic.closed_form.one_degree.divided_differences import jet, slope, value
from nonholonomic.closed_form.one_degree.formula import program
from nonholonomic.closed_form.one_degree.phase_reduction import fraction, pair, reduced_phase

x = sp.Symbol("x", real=True)


def formula(expression: sp.Expr):
    compiled = program(expression)
    return lambda point: compiled({x: point})


FORMULAS = (
    x**3 - 2 * x + sp.Rational(1, 3),
    1 / (2 + x),
    sp.sqrt(3 - x**2),
    sp.exp(x) * sp.cos(2 * x) - sp.sin(x) / 7,
    (1 + x**2) ** sp.Rational(-3, 2),
)


@pytest.mark.parametrize("number", range(len(FORMULAS)))
def test_divided_differences(number: int) -> None:
    function = formula(FORMULAS[number])
    a, b, c = arb("0.3"), arb("-0.7"), arb("0.9")
    first, second, third = (value(function, point) for point in (a, b, c))
    assert slope(function, a, b).overlaps((first - second) / (a - b))
    left, right = (first - second) / (a - b), (second - third) / (b - c)
    assert slope(function, a, b, c).overlaps((left - right) / (a - c))
    derivatives = [FORMULAS[number].diff(x, k).subs(x, sp.Rational(3, 10)) for k in range(3)]
    for ball, exact, factor in zip(jet(function, a), derivatives, (1, 1, 2), strict=True):
        assert abs(factor * ball - arb(str(sp.N(exact, 30)))) < 1e-12


def test_roots_have_no_value_across_their_cut() -> None:
    function = formula(sp.sqrt(x))
    assert not value(function, acb(arb(-1), arb(0, 0.5))).is_finite()
    assert value(function, acb(arb(2), arb(0, 0.5))).is_finite()


def test_formulas_of_other_functions_are_refused() -> None:
    with pytest.raises(InputError, match="sums, products, roots"):
        program(sp.log(x))


def test_a_power_of_a_ball_around_zero() -> None:
    ball = formula(x**2)(arb(0, 0.5))
    assert ball.contains(arb("0.2"))
    assert ball.is_finite()


def test_integrals_hold_the_exact_value() -> None:
    digits = 30
    with ctx.workprec(working_bits(digits)):
        # almost singular at ±i/100
        known = integrals(
            lambda s: [1 / (s * s + arb("0.0001")), s.cos()], arb(-2), arb(3), digits, (1, 1)
        )
        for place in (arb(3), arb(-2), arb("0.7"), arb("1e-5")):
            exact = 100 * (100 * place.mid()).atan()
            assert known.value(0, place.mid()).overlaps(exact)
            assert known.value(1, place.mid()).overlaps(place.mid().sin())
            assert known.value(0, place.mid()).rad() < 1e-24
        table = known.table()
        phase = table.phase(table.inverse(np.array([100 * np.arctan(70.0)])))
        assert abs(phase[0] - 0.7) < 1e-12


def test_mirrored_integrals_are_those_of_the_whole() -> None:
    with ctx.workprec(working_bits(20)):

        def rates(s: acb) -> list[acb]:
            return [1 + s.cos() / 2, s]

        whole = integrals(rates, arb(-2), arb(2), 20, (1, 1))
        half = integrals(rates, arb(-2), arb(2), 20, (1, 1), parities=(-1, 1))
        for index in range(2):
            for place in (arb("-1.9"), arb("-0.3"), arb("1.1")):
                assert whole.value(index, place).overlaps(half.value(index, place))


def test_nested_integrals() -> None:
    with ctx.workprec(working_bits(25)):
        # y = ∫ cos(x) dσ with x = σ²/2 + σ is a Fresnel integral
        known = integrals(
            lambda s: [1 + s],
            arb(-1),
            arb(2),
            25,
            (1, 1),
            lambda s, rates, sums: [sums[0].cos() * rates[0]],
        )
        assert known.value(1, arb(2)).overlaps(arb(4).sin())
        assert known.value(1, arb(2)).rad() < 1e-20


def test_a_singular_integral_is_refused() -> None:
    with ctx.workprec(working_bits(19)), pytest.raises(InputError, match="singular"):
        integrals(lambda s: [1 / (s - 1)], arb(0), arb(2), 19, (1,))


def test_reduced_phases_are_exact() -> None:
    period = Fraction("2.718281828459045235360287471352662497757")
    offset = Fraction("0.5772156649015328606065120900824024310422")
    with ctx.workprec(200):
        pairs = [pair(arb(fmpq(v.numerator, v.denominator))) for v in (offset, period)]
    times = np.array([1e3, 123456.789, 1e6 / 3, 1e12])
    counts, remainders = reduced_phase(times, *pairs)
    for time, count, phase in zip(times, counts, remainders, strict=True):
        exact = Fraction(float(time)) + offset - int(count) * period
        assert abs(float(exact) - phase) < 3e-16
        assert abs(exact) <= period / 2 * (1 + Fraction(1, 10**9))
    shares = fraction(counts, pairs[0])
    for count, phase in zip(counts, shares, strict=True):
        exact = int(count) * offset
        assert abs(float(exact - round(exact)) - phase) < 3e-16


@pytest.mark.parametrize("turn", ["0.3", "6.2831853071795864769252867665590057684", "0"])
def test_sums_of_displacements(turn: str) -> None:
    with ctx.workprec(120):
        angle, step = arb(turn), acb(1, 2)
        direct = sum((step * acb(0, k * angle).exp() for k in range(7)), acb(0))
        assert abs(displacement_sum(7, angle, step) - direct) < 1e-15
        assert (
            abs(complex(displacement_sums(np.array([7.0]), angle, step)[0]) - complex(direct))
            < 1e-13
        )
        back = -sum((step * acb(0, -k * angle).exp() for k in range(1, 4)), acb(0))
        assert abs(displacement_sum(-3, angle, step) - back) < 1e-15
