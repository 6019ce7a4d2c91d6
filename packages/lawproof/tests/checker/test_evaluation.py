"""Values and derivatives agree with those of another program."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp
from flint import arb, ctx

from certificate_checker.claim.errors import UndefinedError
from certificate_checker.claim.evaluate import Point
from certificate_checker.claim.parsing import parse
from certificate_checker.claim.real_functions import RealFunctions, ball

x, y = sp.symbols("x y")
POINT = {"x": Fraction(3, 7), "y": Fraction(-2, 5)}
FORMULAS = [
    "x**3/y - 2*x*y",
    "sqrt(x)*x**(-5/3)",
    "sin(x)*cos(y) + tan(x*y) - cot(x) + sec(y)*csc(x)",
    "sinh(x) + cosh(y)*tanh(x*y)",
    "exp(x/y)*log(x - y)",
    "asin(x) + acos(y) + atan(x/y) + atan2(x, y)",
    "x**(y + 1/3)",
    "Abs(y)*Abs(x)",
    "pi*x + exp(1)*y",
]


def place() -> Point:
    values = {word: ball(value) for word, value in POINT.items()}
    rates = {"x": parse("y*x", "it"), "y": parse("-x + y**2", "it")}
    return Point(values, {"d": parse("x*y", "it")}, rates, RealFunctions("it"))


def expected(formula: sp.Expr) -> arb:
    real = formula.subs(sp.Derivative(sp.Abs(y), y), -1)
    values = {x: sp.Rational(3, 7), y: sp.Rational(-2, 5)}
    number = sp.N(real.subs(values), 60)
    return arb(str(number), arb(10) ** -50)


def flow(formula: sp.Expr) -> sp.Expr:
    return sp.diff(formula, x) * y * x + sp.diff(formula, y) * (y**2 - x)


def symbolic(text: str) -> sp.Expr:
    real = dict(zip("xy", sp.symbols("x y", real=True), strict=True))
    made = sp.sympify(text, locals=real)
    return made.subs(real["x"], x).subs(real["y"], y) if "Abs" not in text else -x * y


@pytest.mark.parametrize("text", FORMULAS)
def test_values_and_rates(text: str) -> None:
    formula = symbolic(text)
    with ctx.workprec(300):
        here = place()
        assert here(parse(text, "it")).overlaps(expected(formula))
        assert here(parse(f"Rate({text})", "it")).overlaps(expected(flow(formula)))
        twice = flow(flow(formula))
        assert here(parse(f"Rate(Rate({text}))", "it")).overlaps(expected(twice))
        partial = here.partial(["y", "x"]).slopes(parse(f"Rate({text})", "it"))
        assert partial[0].overlaps(expected(sp.diff(flow(formula), y)))
        assert partial[1].overlaps(expected(sp.diff(flow(formula), x)))


def test_unspecified_functions_obey_the_chain_rule() -> None:
    with ctx.workprec(300):
        here = place()
        rate = here(parse("Rate(U(x*y, x))", "it"))
        slopes = [
            here(parse(f"Subs(Derivative(U(a, b), {v}), (a, b), (x*y, x))", "it")) for v in "ab"
        ]
        by_hand = slopes[0] * here(parse("Rate(x*y)", "it")) + slopes[1] * here(parse("x*y", "it"))
        assert rate.overlaps(by_hand)
        assert here(parse("U(d, x)", "it")).overlaps(here(parse("U(y*x, x)", "it")))
        assert not here(parse("U(x, d)", "it")).overlaps(here(parse("U(d, x)", "it")))


@pytest.mark.parametrize(
    "text",
    ["1/(x - 3/7)", "sqrt(y)", "log(y)", "asin(1 + x)", "y**x", "1/(1 - 1)", "Rate(Abs(x - x))"],
)
def test_what_is_undefined(text: str) -> None:
    with pytest.raises(UndefinedError):
        place()(parse(text, "it"))


def test_settled_exponents_are_whole_numbers() -> None:
    here = Point({"y": arb(-2)}, {}, {}, RealFunctions("it"), {"k": parse("3", "it")})
    assert here(parse("y**(k - 1)", "it")) == 4


def test_long_chains_of_definitions() -> None:
    chain = {f"d{i}": parse(f"d{i - 1} + 1" if i else "x", "it") for i in range(3000)}
    assert Point({"x": arb(1)}, chain, {}, RealFunctions("it"))(parse("d2999", "it")) == 3000
