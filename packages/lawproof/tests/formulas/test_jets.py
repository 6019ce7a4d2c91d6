"""Formulas with their derivatives, against SymPy's own."""

from __future__ import annotations

import pytest
import sympy as sp
from flint import arb

from flowlanes.formulas.errors import OutOfReachError, UnknownSymbolError
from flowlanes.formulas.jets import Evaluator, Jet
from flowlanes.formulas.number_fields import Balls, ball_precision
from flowlanes.system.laws import Rate
from lawproof.proof.fields.function_field import FunctionField

x, y, k = sp.symbols("x y k", real=True)
f = sp.Function("f")

FORMULAS = {
    "rational": (x**2 * y - 3) / (x + 2 * y) ** 3,
    "root": sp.sqrt(x**2 + y) / (1 + x),
    "rational power": (1 + x * y) ** sp.Rational(-3, 2),
    "trigonometric": sp.sin(x + 2 * y) * sp.cot(y) + sp.tan(x) ** 2,
    "exponential": sp.exp(-x * y) + sp.cosh(x),
    "logarithm": sp.log(1 + x**2) / y,
    "symbolic power": (1 + x**2) ** (1 / (2 * k)),
    "angles": sp.atan2(y, x) + sp.atan(x * y) + sp.acos(x / 4),
}


def balls():
    return Balls({"x": arb("0.7"), "y": arb("1.3"), "k": arb("1.7")})


def seeded(field):
    numbers = {x: 0, y: 1}

    def seed(symbol):
        if symbol not in (x, y, k):
            return None
        slopes = {numbers[symbol]: field.one} if symbol in numbers else {}
        return Jet(field.generator(str(symbol)), slopes)

    return Evaluator(field, seed, {})


@pytest.mark.parametrize("name", FORMULAS)
def test_derivatives_as_sympy_takes_them(name):
    formula = FORMULAS[name]
    point = {x: sp.Rational(7, 10), y: sp.Rational(13, 10), k: sp.Rational(17, 10)}
    with ball_precision():
        evaluate = seeded(balls())
        for direction, symbol in ((None, None), (0, x), (1, y)):
            wanted = formula if symbol is None else sp.diff(formula, symbol)
            found = (
                evaluate.value(formula) if direction is None else evaluate.slope(formula, direction)
            )
            assert abs(found - arb(str(wanted.subs(point).evalf(60)))) < arb("1e-50")


@pytest.mark.parametrize("name", ["rational", "root", "rational power", "trigonometric"])
def test_exact_derivatives_equal_those_of_sympy(name):
    """The derivative taken along with the value equals the evaluated derivative."""
    field = FunctionField(["x", "y", "k"], spare=30, sample={"x": 0.7, "y": 1.3, "k": 1.7})
    evaluate = seeded(field)
    for direction, symbol in ((0, x), (1, y)):
        slope = evaluate.slope(FORMULAS[name], direction)
        assert field.vanishes(slope - evaluate.value(sp.diff(FORMULAS[name], symbol)))


def test_chain_rule_for_unspecified_functions():
    field = FunctionField(["x", "y", "k"], spare=30)
    evaluate = seeded(field)
    formula = f(x * y, x) ** 2
    slope = evaluate.slope(formula, 0)
    assert field.vanishes(slope - evaluate.value(sp.diff(formula, x)))
    assert not field.vanishes(slope)


def test_what_cannot_be_evaluated_is_said():
    evaluate = seeded(balls())
    with pytest.raises(OutOfReachError, match="kind"):
        evaluate(sp.floor(x))
    with pytest.raises(UnknownSymbolError, match="w"):
        evaluate(sp.Symbol("w"))
    with pytest.raises(OutOfReachError, match="exponent"):
        evaluate((1 + x**2) ** y)
    with pytest.raises(OutOfReachError, match="kind"):
        evaluate(sp.besselj(1, x))


def test_rates_need_an_evaluation_along_the_field():
    with ball_precision(), pytest.raises(OutOfReachError, match="rate"):
        seeded(balls())(Rate(x))
