"""Formulas as the integrator's expressions: every function, at both precisions."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import dot, vectors
from needs import optional

hy = optional("heyoka")
Translator = optional("flowlanes.flow.taylor.heyoka_expressions").Translator

x, y, w, p = sp.symbols("x y w p", real=True)

FORMULAS = {
    "sum": x + y + 1,
    "product": 3 * x * y,
    "negative": -x - 2 * y,
    "third": x / 3,
    "a ratio of long integers": sp.Rational(10**20 + 1, 3**30) * x,
    "decimal": sp.Float("0.1", 40) * x,
    "pi": sp.pi * x,
    "number e": sp.E + x,
    "golden ratio": sp.GoldenRatio * x,
    "root of a number": sp.sqrt(2) * x,
    "cube root of a number": sp.Rational(7) ** sp.Rational(1, 3) + x,
    "reciprocal": 1 / x,
    "reciprocals alone": 1 / (x * y),
    "ratio": sp.Rational(2, 3) * x / y**2,
    "square": x**2,
    "fourth power": x**4,
    "fifth power": x**5,
    "eleventh power": x**11,
    "negative powers": x**-3 + y**-5,
    "root": sp.sqrt(x),
    "reciprocal root": 1 / sp.sqrt(x),
    "half power": x ** sp.Rational(3, 2),
    "negative half power": x ** sp.Rational(-5, 2) * y,
    "third power": x ** sp.Rational(1, 3),
    "power of two": 2**x,
    "general power": x**y,
    "power of a sum": (x + y) ** -2,
    "sin": sp.sin(x),
    "cos": sp.cos(x),
    "tan": sp.tan(x),
    "asin": sp.asin(x),
    "acos": sp.acos(x),
    "atan": sp.atan(x),
    "atan2": sp.atan2(x, y),
    "sinh": sp.sinh(x),
    "cosh": sp.cosh(x),
    "tanh": sp.tanh(x),
    "exp": sp.exp(-x),
    "log": sp.log(x),
    "absolute value": sp.Abs(x - y),
    "nested": sp.exp(sp.sin(x / y) ** 2 / sp.log(2 + x)) / sp.sqrt(1 + sp.cosh(x * y)),
    "parameter": p * x,
    "definition": w + x,
}

POINTS = ((0.3, 1.7), (0.83, 0.4))
VALUE_OF_P = 0.7
SYSTEM = System(
    name="test",
    title="Test",
    parameters=(Parameter(p, "a number", VALUE_OF_P),),
    definitions={w: sp.sin(x) * p / 3},
    field={x: y, y: -x},
)
KINDS = {"double": (float, 4e-15), "quad": (hy.real128, 4e-33)}


def evaluated(formula: sp.Expr, point: tuple[float, float], kind: type) -> object:
    translate = Translator(SYSTEM)
    function = hy.cfunc([translate(formula)], translate.variables, fp_type=kind)
    state = np.array([kind(repr(value)) for value in point], dtype=kind)
    return function(state, pars=np.array([kind(repr(VALUE_OF_P))], dtype=kind)[: function.nparams])[
        0
    ]


@pytest.mark.parametrize("point", POINTS, ids=str)
@pytest.mark.parametrize("precision", KINDS)
@pytest.mark.parametrize("name", FORMULAS)
def test_every_formula(name, precision, point):
    kind, slack = KINDS[precision]
    formula = FORMULAS[name]
    numbers = {
        x: sp.Float(repr(point[0]), 50),
        y: sp.Float(repr(point[1]), 50),
        p: sp.Float("0.7", 50),
    }
    exact = formula.subs(dict(SYSTEM.scalar_definitions)).subs(numbers).evalf(50)
    found = evaluated(formula, point, kind)
    with mpmath.workdps(50):
        error = abs(mpmath.mpf(str(found)) - mpmath.mpf(exact)) / abs(mpmath.mpf(exact))
    assert error < slack


def test_a_third_is_exact_in_quad():
    assert evaluated(sp.Rational(1, 3) + 0 * x, POINTS[0], hy.real128) == hy.real128(1) / 3


def test_vectors_are_flattened():
    u, v = vectors("u v")
    system = System(name="test", title="Test", field={u: v, v: -u})
    translate = Translator(system)
    function = hy.cfunc(translate.all([u + 2 * v, dot(u, v)]), translate.variables)
    assert function(np.array([1.0, 2.0, 3.0, 10.0, 20.0, 30.0])).tolist() == [21, 42, 63, 140]


def test_one_variable_is_enough():
    system = System(name="test", title="Test", field={x: x**2})
    assert Translator(system)(x**2) == hy.make_vars("x") * hy.make_vars("x")


def test_unused_definitions_cost_nothing():
    system = System(name="test", title="Test", field={x: x}, definitions={w: sp.zeta(x)})
    assert Translator(system)(x) == hy.make_vars("x")


def test_a_definition_is_translated_once():
    translate = Translator(SYSTEM)
    assert translate(w) is translate(w)


def test_an_unknown_function_is_named():
    with pytest.raises(InputError) as caught:
        Translator(SYSTEM)(1 + sp.zeta(x) * y)
    assert str(caught.value) == "zeta(x): the integrator has no function zeta"
