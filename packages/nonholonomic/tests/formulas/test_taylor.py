"""Truncated series against SymPy's, over the rationals and modulo a prime."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given, strategies as st

from flowlanes.formulas.expansion import TaylorExpansion, angles
from flowlanes.formulas.taylor import PRIMES, IrrationalError, Modular, Rational
from nonholonomic.mechanics.constraints.exact_points import ConfigurationSpace, random_point

x, y = sp.symbols("x y", real=True)
KINDS = (Rational(), *(Modular(p) for p in PRIMES))
KIND_NAMES = ("rational", *(f"modulo {p}" for p in PRIMES))
ORDER = 4


def germs(numbers, formula, place):
    values = {s: numbers.number(v) for s, v in place.items()}
    return TaylorExpansion(numbers, (x, y), values, {}, angles([formula], {}), {}, ORDER)


def derivatives(formula, place):
    """Taylor coefficients by SymPy's own differentiation."""
    found = {}
    for i in range(ORDER + 1):
        for j in range(ORDER + 1 - i):
            value = sp.diff(formula, x, i, y, j) if i + j else formula
            value = sp.nsimplify(value.subs(place)) / (sp.factorial(i) * sp.factorial(j))
            if value != 0:
                found[i, j] = value
    return found


@pytest.mark.parametrize("numbers", KINDS, ids=KIND_NAMES)
@pytest.mark.parametrize(
    ("formula", "place"),
    [
        (x**3 * y - 2 * x * y**2 + 5, {x: sp.Rational(1, 2), y: 3}),
        ((x - 2 * y) / (1 + x * y), {x: 3, y: sp.Rational(-2, 7)}),
        (sp.sqrt(1 + 3 * x + y**2), {x: 1, y: 0}),
        ((8 + x * y) ** sp.Rational(-2, 3), {x: 0, y: 5}),
    ],
    ids=str,
)
def test_taylor_coefficients(numbers, formula, place):
    series = germs(numbers, formula, place).series(formula)
    found = {k: numbers.number(v) for part in series.parts for k, v in part.to_dict().items()}
    assert found == {k: numbers.number(v) for k, v in derivatives(formula, place).items()}


IDENTITIES = (
    sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1,
    sp.sin(x + 2 * y) - sp.sin(x) * sp.cos(2 * y) - sp.cos(x) * sp.sin(2 * y),
    sp.cos(x / 2) ** 2 - (1 + sp.cos(x)) / 2,
    sp.tan(x / 3) * sp.cos(x / 3) - sp.sin(x / 3),
    sp.sin(x + sp.pi / 2) - sp.cos(x),
    sp.exp(x / 2 + y) ** 2 - sp.exp(x) * sp.exp(2 * y),
    sp.sin(x * y) ** 2 + sp.cos(x * y) ** 2 - 1,
    sp.sin(3 * x * y) - 3 * sp.sin(x * y) + 4 * sp.sin(x * y) ** 3,
)


@pytest.mark.parametrize("numbers", KINDS, ids=KIND_NAMES)
@pytest.mark.parametrize("formula", IDENTITIES, ids=str)
def test_identities_between_functions_hold_exactly(numbers, formula):
    space = ConfigurationSpace((x, y), (), (), (formula, formula + x))
    for seed in (6, 7, 8):
        found = random_point(space, numbers, random.Random(seed)).germs(space, 5)
        assert found.series(formula).is_zero
        assert not found.series(formula + x**5).is_zero


@pytest.mark.parametrize(
    ("function", "slope"),
    [
        (sp.log(x * y), 1 / x),
        (sp.atan(x / y), y / (x**2 + y**2)),
        (sp.sin(x**2), 2 * x * sp.cos(x**2)),
        (sp.exp(x * y), y * sp.exp(x * y)),
        (sp.Function("f")(x, y), sp.Derivative(sp.Function("f")(x, y), x)),
    ],
    ids=str,
)
def test_derivatives_of_functions(function, slope):
    numbers = Modular()
    space = ConfigurationSpace((x, y), (), (), (function, slope))
    found = random_point(space, numbers, random.Random(5)).germs(space, 4)
    left, right = found.series(function).derivative(0), found.series(slope).truncation(3)
    assert (left - right).is_zero
    assert not left.is_zero


@given(st.integers(-(10**9), 10**9), st.integers(1, 10**9))
def test_fractions_are_recognised_modulo_a_prime(top, bottom):
    numbers, value = Modular(), Fraction(top, bottom)
    assert numbers.fraction(numbers.number(value)) == value


@pytest.mark.parametrize("numbers", KINDS, ids=KIND_NAMES)
def test_roots_of_squares_are_positive(numbers):
    for value in (Fraction(1, 4), Fraction(9), Fraction(25, 49)):
        assert numbers.root(numbers.number(value), 2) ** 2 == numbers.number(value)
        assert numbers.root(numbers.number(value), 2) == numbers.number(
            Fraction(sp.sqrt(value).p, sp.sqrt(value).q)
        )


def test_irrational_roots_are_not_made_up():
    with pytest.raises(IrrationalError):
        Rational().root(Rational().number(2), 2)
    with pytest.raises(IrrationalError):
        Rational().root(Rational().number(-4), 2)
    assert Modular().root(Modular().number(2), 2) ** 2 == Modular().number(2)


@pytest.mark.parametrize("numbers", KINDS, ids=KIND_NAMES)
def test_zeros_of_polynomials(numbers):
    coefficients = [numbers.number(c) for c in (-6, 11, -6, 1)]
    zero = numbers.zero_of(coefficients)
    assert zero in [numbers.number(n) for n in (1, 2, 3)]
