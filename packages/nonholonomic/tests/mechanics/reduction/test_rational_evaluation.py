"""Exact arithmetic of the reductions: fractions, linear equations, tangents of half angles."""

from fractions import Fraction

import pytest
import sympy as sp
from flint import fmpq
from hypothesis import given, settings, strategies as st

from flowlanes.errors import InputError
from flowlanes.system.vectors import Vector, real_symbol
from nonholonomic.mechanics.reduction.factors import (
    HalfAngleChart,
    determinant,
    in_angles,
    on_sphere,
)
from nonholonomic.mechanics.reduction.linear_algebra import inverse, kernel
from nonholonomic.mechanics.reduction.rational_evaluation import (
    Formulas,
    circle,
    is_rational,
    on_circles,
)
from nonholonomic.mechanics.reduction.rational_functions import quotients

x, y, theta, phi, J = (real_symbol(name) for name in ("x", "y", "theta", "phi", "J"))
ONE, NAMES = quotients([x, y])
NUMBERS = st.fractions(min_value=-9, max_value=9, max_denominator=7)


def exact(number: Fraction) -> fmpq:
    return fmpq(number.numerator, number.denominator)


def formula(a: Fraction, b: Fraction, c: Fraction) -> sp.Expr:
    first, second, third = (sp.Rational(n.numerator, n.denominator) for n in (a, b, c))
    return (first * x**2 - second * y) / (x * y + third + 20)


@pytest.mark.slow
@settings(max_examples=25)
@given(NUMBERS, NUMBERS, NUMBERS, NUMBERS, NUMBERS, NUMBERS)
def test_fractions_are_those_of_sympy(
    a: Fraction, b: Fraction, c: Fraction, d: Fraction, e: Fraction, f: Fraction
) -> None:
    first, second = formula(a, b, c), formula(d, e, f)
    for made in (first + second, first * second, first - 2 * second, (1 - first) ** 2):
        (value,) = Formulas([made]).at(NAMES, ONE)
        assert sp.cancel(value.formula() - made) == 0


def test_division_by_zero() -> None:
    with pytest.raises(ZeroDivisionError):
        _ = ONE / (NAMES[x] - NAMES[x])


@pytest.mark.slow
@given(st.lists(NUMBERS, min_size=9, max_size=9))
def test_inverse_and_determinant(entries: list[Fraction]) -> None:
    rows = [[exact(n) for n in entries[i : i + 3]] for i in (0, 3, 6)]
    if determinant(rows) == 0:
        with pytest.raises(ZeroDivisionError):
            inverse(rows, fmpq(1))
        return
    solve = inverse(rows, fmpq(1))
    for i in range(3):
        for j in range(3):
            entry = sum((rows[i][k] * solve[k][j] for k in range(3)), fmpq(0))
            assert entry == int(i == j)


@pytest.mark.slow
@given(st.lists(NUMBERS, min_size=8, max_size=8))
def test_kernel(entries: list[Fraction]) -> None:
    rows = [[exact(n) for n in entries[i : i + 4]] for i in (0, 4)]
    found = kernel(rows, fmpq(1))
    assert len(found) >= 2
    for solution in found:
        assert any(v != 0 for v in solution)
        for row in rows:
            assert sum((a * b for a, b in zip(row, solution, strict=True)), fmpq(0)) == 0


def test_multiple_angles_and_tangents() -> None:
    sine, cosine = circle(theta)
    assert sp.expand(on_circles(sp.sin(2 * theta)) - 2 * sine * cosine) == 0
    assert sp.cancel(on_circles(sp.tan(theta)) - sine / cosine) == 0
    assert not is_rational(sp.exp(theta))
    assert not is_rational(sp.sqrt(1 + x))
    with pytest.raises(InputError, match="rational in the coordinates"):
        on_circles(sp.sin(x * y))


def test_a_factor_back_in_the_angles_and_in_the_unit_vector() -> None:
    chart = HalfAngleChart.of((theta, phi), [*circle(theta), *circle(phi)])
    one, names = quotients([*chart.variables, J])
    place = {**names, **chart.point([names[t] for t in chart.variables])}
    gamma = Vector("gamma")
    unit = (sp.sin(theta) * sp.sin(phi), sp.sin(theta) * sp.cos(phi), sp.cos(theta))
    in_unit = dict(zip(gamma.symbols, unit, strict=True))
    g1, g2, g3 = gamma.symbols
    for form in (J * g1**2 + 2 * g2**2 + 3 * g3**2 + g1 * g3, g1**3 + J * g2 * g3**2 - g3**2):
        (value,) = Formulas([form.xreplace(in_unit)]).at(place, one)
        poly = max((f for f, _ in value.above.factor()[1]), key=len)
        found = on_sphere(poly, chart, gamma)
        assert found is not None
        assert sp.cancel(found / form).is_number
        angles = in_angles(poly, chart)
        there = {theta: sp.Rational(7, 10), phi: sp.Rational(13, 10), J: 3}
        assert abs((angles - found.xreplace(in_unit)).evalf(30, subs=there)) < 1e-25


def test_what_is_no_function_on_the_sphere() -> None:
    chart = HalfAngleChart.of((theta, phi), [*circle(theta), *circle(phi)])
    one, names = quotients([*chart.variables, J])
    place = {**names, **chart.point([names[t] for t in chart.variables])}
    (value,) = Formulas([sp.cos(phi) ** 2 + J]).at(place, one)
    poly = max((f for f, _ in value.above.factor()[1]), key=len)
    assert on_sphere(poly, chart, Vector("gamma")) is None
