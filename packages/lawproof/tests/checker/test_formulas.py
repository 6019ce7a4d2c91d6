"""Formulas are read exactly, and nothing else is read."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp

from certificate_checker.claim.errors import CheckError
from certificate_checker.claim.evaluate import exact_value
from certificate_checker.claim.formulas import Formula, function, name
from certificate_checker.claim.parsing import parse, parse_condition


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0.1", Fraction(1, 10)),
        ("1.5e-3", Fraction(3, 2000)),
        ("-2**2", Fraction(-4)),
        ("2**3**2", Fraction(512)),
        ("2**-1", Fraction(1, 2)),
        ("1 - 2 - 3", Fraction(-4)),
        ("8/4/2", Fraction(1)),
        ("-(1/3)*6", Fraction(-2)),
        ("+-+3", Fraction(-3)),
        ("(1 + 1/2)**2", Fraction(9, 4)),
    ],
)
def test_numbers(text: str, value: Fraction) -> None:
    assert exact_value(parse(text, "it"), {}) == value


@pytest.mark.parametrize(
    "text",
    [
        *("", "x +", "(x", "x)", "x y", "2x", "x[0]", "x.y", "__import__('os')", "f()"),
        *("x if y else z", "lambda: 1", "x; y", "x\n= 3", "x > 1", "sin(x, y)", "atan2(x)"),
        *("Derivative(x**2, x)", "Derivative(f(x**2), x)", "Subs(f(x), 2, y)"),
        "(" * 500 + "x" + ")" * 500,
    ],
)
def test_what_is_no_formula(text: str) -> None:
    with pytest.raises(CheckError):
        parse(text, "it")


def test_equal_formulas_are_one_object() -> None:
    assert parse("x + y*2", "it") is parse(" x+ y *2", "it")
    assert parse("x + y", "it") is not parse("y + x", "it")


def test_derivatives() -> None:
    x, y = sp.symbols("x y")
    U = sp.Function("U")
    first = parse(str(sp.diff(U(x, y), x, 2, y)), "it")
    assert first is function("U", [2, 1], [name("x"), name("y")])
    inner = parse(str(sp.diff(U(2 * x, y), x) / 2), "it")
    wanted = function("U", [1, 0], [parse("2*x", "it"), name("y")])
    assert inner is wanted
    both = parse("Subs(Derivative(U(a, b), a), (a, b), (x, 1))", "it")
    assert both is function("U", [1, 0], [name("x"), parse("1", "it")])


def test_conditions() -> None:
    def read(text: str) -> list[tuple[Formula, str]]:
        return parse_condition(text, "it")

    x, y = name("x"), name("y")
    assert read("x > 0") == [(x, ">")]
    assert read("0 <= x") == [(parse("x", "it"), ">=")]
    assert read("Ne(x, 0)") == [(x, "!=")]
    assert read("(x > 0) & (y != 0)") == [(x, ">"), (y, "!=")]
    assert read("x >= y") == read("y <= x")
    with pytest.raises(CheckError, match="contains no comparison"):
        read("x + 1")
