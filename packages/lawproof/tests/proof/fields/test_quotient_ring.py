"""The field of fractions: arithmetic, relations, roots, powers, functions."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st

from flowlanes.formulas.errors import NeedMoreGeneratorsError, NoRealValueError, OutOfReachError
from lawproof.proof.fields.budget import Budget
from lawproof.proof.fields.function_field import FunctionField
from lawproof.proof.fields.quotient_ring import QuotientRing, initial_of


def plain(names="xyz", **options):
    return FunctionField(list(names), **options)


def evaluated(element, point):
    """Value of an element at rational numbers, by Python's own fractions."""
    home = element.home

    def at(poly):
        total = Fraction(0)
        for exponents, number in poly.to_dict().items():
            term = Fraction(int(number.p), int(number.q))
            for name, n in zip(home.names, exponents, strict=True):
                term *= point.get(name, Fraction(1)) ** int(n)
            total += term
        return total

    value = at(element.poly)
    for number, power in element.powers.items():
        value *= at(home.factors[number]) ** power
    return value


numbers = st.fractions(min_value=-3, max_value=3, max_denominator=7)


@st.composite
def formulas(draw, depth=4):
    """A rational formula as a function of three values of any kind."""
    if depth == 0:
        kind = draw(st.sampled_from(["x", "y", "z", "number"]))
        number = draw(st.integers(1, 5))
        if kind == "number":
            return lambda v, c: c(number)
        return lambda v, c: v["xyz".index(kind)]
    first, second = draw(formulas(depth=depth - 1)), draw(formulas(depth=draw(st.integers(0, 2))))
    kind = draw(st.sampled_from("+-*/^"))
    return {
        "+": lambda v, c: first(v, c) + second(v, c),
        "-": lambda v, c: first(v, c) - second(v, c),
        "*": lambda v, c: first(v, c) * second(v, c),
        "/": lambda v, c: first(v, c) / second(v, c),
        "^": lambda v, c: first(v, c) ** 2,
    }[kind]


@pytest.mark.slow
@given(formulas(), numbers, numbers, numbers)
@settings(max_examples=200)
def test_arithmetic_agrees_with_numbers(formula, x, y, z):
    field = plain()
    symbols = [field.generator(n) for n in "xyz"]
    try:
        expected = formula([x, y, z], Fraction)
        found = evaluated(formula(symbols, field.rational), dict(x=x, y=y, z=z))
    except ZeroDivisionError:
        return
    assert found == expected


def test_quotients_cancel():
    field = plain()
    x, y = field.generator("x"), field.generator("y")
    total = (x + y) / (x * y) - field.one / x - field.one / y
    assert field.vanishes(total)
    assert not field.vanishes(total + field.rational(sp.Rational(1, 10**30)))


def test_division_by_what_vanishes_modulo_the_relations_is_refused():
    field = plain()
    field.impose("x", field.generators["x"] ** 2 - field.generators["y"])
    x, y = field.generator("x"), field.generator("y")
    with pytest.raises(ZeroDivisionError):
        field.one / (x * x - y)


def test_relations_with_a_leading_coefficient_need_pseudo_division():
    field = plain()
    x, y, z = (field.generators[n] for n in "xyz")
    field.impose("x", x * (y + z) - z)
    x, y, z = (field.generator(n) for n in "xyz")
    assert field.vanishes(x - z / (y + z))
    assert not field.vanishes(x - y / (y + z))


def test_roots_know_their_relation_and_their_sign():
    field = plain(sample={"x": 2.0, "y": -3.0, "z": 1.0})
    x, y = field.generator("x"), field.generator("y")
    assert field.vanishes(field.root(x * x * x * x, 2) - x * x)
    assert field.vanishes(field.root(y * y, 2) + y)
    root = field.root(x + y * y, 2)
    assert field.vanishes(root * root - x - y * y)
    assert not field.vanishes(root - x)
    assert field.vanishes(field.root(x * (x + y * y), 2) - field.root(x, 2) * root)
    assert field.vanishes(field.one / root - root / (x + y * y))


def test_roots_of_numbers():
    field = plain()
    two, eight = field.rational(2), field.rational(8)
    assert field.vanishes(field.root(eight, 2) - two * field.root(two, 2))
    assert field.vanishes(field.root(field.rational(sp.Rational(9, 4)), 2) - field.rational("3/2"))
    with pytest.raises(NoRealValueError):
        field.root(field.rational(-1), 2)


def test_symbolic_powers_of_roots_and_products_agree():
    field = plain(sample={"x": 2.0, "y": 3.0, "z": 1.0})
    x, y = field.generator("x"), field.generator("y")
    k = sp.Symbol("k", real=True)

    def power(base, number):
        return field.power(base, [(1 / k, sp.Rational(number))], None)

    assert field.vanishes(power(x * y, 1) - power(x, 1) * power(y, 1))
    assert field.vanishes(power(field.root(x, 2), 1) - power(x, sp.Rational(1, 2)))
    assert not field.vanishes(power(x, 1) - power(x, 2))


def test_sine_and_cosine_of_one_angle():
    field = plain()
    sine, cosine = field.circle(field.generator("x"))
    assert field.vanishes(sine * sine + cosine * cosine - field.one)
    again, _ = field.circle(field.generator("x") + field.generator("y") - field.generator("y"))
    assert field.vanishes(sine - again)
    other, _ = field.circle(field.generator("y"))
    assert not field.vanishes(sine - other)


def test_functions_of_equal_arguments_are_equal():
    field = plain()
    x, y = field.generator("x"), field.generator("y")
    first = field.unspecified_value("U", (0,), [x * (x + y)])
    assert field.vanishes(first - field.unspecified_value("U", (0,), [x * x + x * y]))
    assert not field.vanishes(first - field.unspecified_value("U", (0,), [x]))
    assert field.vanishes(field.exponential(x) * field.exponential(-x) - field.one)


def test_too_many_auxiliary_symbols_are_reported():
    field = plain(spare=1)
    field.root(field.generator("x"), 2)
    with pytest.raises(NeedMoreGeneratorsError):
        field.root(field.generator("y"), 2)


def test_the_budget_stops_large_products():
    field = plain(budget=Budget(terms=100))
    total = field.one + field.generator("x") + field.generator("y") + field.generator("z")
    with pytest.raises(OutOfReachError, match="terms"):
        for _ in range(20):
            total = total * total


def test_the_budget_stops_when_its_operations_are_used_up():
    field = plain(budget=Budget(effort=1))
    with pytest.raises(OutOfReachError, match="effort"):
        field.generator("x") * field.generator("x")


def test_reduction_leaves_the_class_unchanged():
    """On the sphere x² + y² + z² = 1 a product and its remainder agree at rational points."""
    field = plain()
    x, y, z = (field.generators[n] for n in "xyz")
    field.impose("x", x**2 + y**2 + z**2 - 1)
    generator = random.Random(5)
    element = field.one
    expected = Fraction(1)
    s, t = Fraction(generator.randint(1, 9), 7), Fraction(generator.randint(1, 9), 5)
    square = s * s + t * t
    point = dict(x=2 * s / (1 + square), y=2 * t / (1 + square), z=(square - 1) / (1 + square))
    for _ in range(6):
        a, b, c = (generator.randint(-3, 3) for _ in range(3))
        element = element * (
            field.rational(a) * field.generator("x")
            + field.rational(b) * field.generator("y")
            + field.rational(c)
        )
        expected *= a * point["x"] + b * point["y"] + c
    assert evaluated(element, point) == expected
    assert int(element.poly.degrees()[field.names.index("x")]) < 2


def test_initial_against_sympy():
    ring, symbols = QuotientRing("xyz").ring, sp.symbols("x y z")
    dice = random.Random(5)
    for _ in range(30):
        monomials = [tuple(dice.randrange(4) for _ in symbols) for _ in range(8)]
        poly = ring.from_dict({m: dice.randint(1, 9) for m in monomials})
        for position, symbol in enumerate(symbols):
            right = sp.LC(sp.sympify(str(poly)), symbol)
            assert sp.sympify(str(initial_of(poly, position))).equals(right)
