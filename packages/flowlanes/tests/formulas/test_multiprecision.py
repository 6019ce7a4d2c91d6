"""Formulas as numbers of mpmath, and their derivatives."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.multiprecision import Multiprecision, number

x, phi, eta = sp.symbols("x phi eta", real=True)


@pytest.mark.parametrize(
    "formula",
    [sp.pi * x, sp.E**x, sp.sqrt(2) / x**3, sp.sin(x) + sp.atan2(x, 2), x ** sp.Rational(1, 3)],
    ids=str,
)
def test_values_have_the_working_precision(formula: sp.Expr) -> None:
    with mpmath.workdps(60):
        value = Multiprecision({x: mpmath.mpf(17) / 10})(formula)
        exact = mpmath.mpf(str(sp.N(formula.subs(x, sp.Rational(17, 10)), 60)))
        assert abs(value - exact) < mpmath.mpf(10) ** -56


def test_symbols_are_none_of_the_constants_of_mpmath() -> None:
    values = Multiprecision({phi: mpmath.mpf(3)})
    assert values(phi + 1) == 4
    with pytest.raises(KeyError):
        values(eta + 1)


@pytest.mark.slow
def test_steps_are_defined_in_order() -> None:
    names = sp.symbols("s:2000")
    values = Multiprecision({x: mpmath.mpf(0)})
    values.define((name, last + 1) for last, name in zip((x, *names[:-1]), names, strict=True))
    assert values(names[-1]) == 2000


def test_poles_and_negative_radicands() -> None:
    values = Multiprecision({x: mpmath.mpf(0)})
    with pytest.raises(ZeroDivisionError):
        values(1 / x)
    assert isinstance(values(sp.sqrt(x - 1)), mpmath.mpc)


def test_numbers_of_the_user() -> None:
    with mpmath.workdps(40):
        assert abs(number("sqrt(2)/3", "a") ** 2 - mpmath.mpf(2) / 9) < mpmath.mpf(10) ** -38
        assert number(0.1, "a") == mpmath.mpf("0.1")
    for wrong in ("sqrt(-1)", float("inf"), [1]):
        with pytest.raises(InputError):
            number(wrong, "a")
