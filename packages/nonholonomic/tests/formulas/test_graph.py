"""Formulas as a graph: the same values, right derivatives, equal things made once."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

from flow.terms import balls
from flowlanes import lambdify
from flowlanes.errors import InputError
from flowlanes.formulas.graph import Graph, Reader, of_system, topological_order
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import cross, dot, vectors
from nonholonomic.catalogue import CATALOGUE

x, y, z, a, w, v = sp.symbols("x y z a w v", real=True)

#: A system in which every kind of formula can be written.
TRIAL = System(
    name="trial",
    title="Trial",
    parameters=(Parameter(a, "a number", 1.5),),
    definitions={w: x * y + a, v: sp.sqrt(1 + w**2)},
    field={x: y * v, y: z, z: -x / v},
)

POINT = {x: 0.3, y: -0.7, z: 1.9, a: 1.5}
LEAVES: Any = {("state", 0): 0.3, ("state", 1): -0.7, ("state", 2): 1.9, ("parameter", 0): 1.5}


def read(formula: Any) -> Any:
    """A formula of the trial system as a term."""
    return Reader(TRIAL, Graph())(formula)


def full(formula: Any) -> sp.Expr:
    """Without named intermediate quantities."""
    formula = sp.sympify(formula)
    for name, value in reversed(TRIAL.scalar_definitions):
        formula = formula.subs(name, value)
    return formula


def known(formula: Any) -> sp.Expr:
    """SymPy's value at the point, to 50 digits."""
    exact = {symbol: sp.Rational(value) for symbol, value in POINT.items()}
    return full(formula).subs(exact).evalf(50)


def assert_close(ball: Any, formula: Any) -> None:
    assert ball.is_finite()
    assert abs(sp.Float(ball.mid().str(50, radius=False), 50) - known(formula)) < 1e-40


FORMULAS = (
    x - y - z,
    -x - y,
    x * y / (z * a) - 2,
    x**5 / 3 - y**-3,
    sp.sqrt(z + 2) * (x + 1) ** sp.Rational(-3, 2),
    z**a + z ** sp.Rational(1, 3) + 2**x,
    sp.exp(x * y) - sp.exp(1) + sp.pi * x,
    sp.sin(x) * sp.cos(y) + sp.tan(z),
    sp.asin(x) + sp.acos(y) + sp.atan(z),
    sp.atan2(y, x) - sp.atan2(-x, -z),
    sp.sinh(x) + sp.cosh(y) * sp.tanh(z),
    sp.log(z) + sp.Abs(y) * sp.sign(y),
    sp.Float("0.1", 60) * x,
    w * v - w / v,
)


@pytest.mark.parametrize("formula", FORMULAS, ids=str)
def test_values_are_sympys(formula: sp.Expr) -> None:
    assert_close(balls([read(formula)], LEAVES, 240)[0][0], formula)


@pytest.mark.parametrize("symbol", [x, y, z, a], ids=str)
@pytest.mark.parametrize("formula", FORMULAS, ids=str)
def test_derivatives_are_sympys(formula: sp.Expr, symbol: sp.Symbol) -> None:
    reader = Reader(TRIAL, Graph())
    term, leaf = reader(formula), reader(symbol)
    (change,) = reader.graph.directional_derivative([term], {leaf: reader.graph.number(1)})
    assert_close(balls([change], LEAVES, 240)[0][0], full(formula).diff(symbol))


def test_derivative_along_a_motion() -> None:
    """All leaves at once: v(F) = Σ ∂F/∂x_i v_i."""
    reader, rates = of_system(TRIAL)
    leaves = [reader(symbol) for symbol in TRIAL.symbols]
    (change,) = reader.graph.directional_derivative(
        [reader(w * z + v)], dict(zip(leaves, rates, strict=True))
    )
    field = dict(zip((x, y, z), TRIAL.rates, strict=True))
    right = sum(full(w * z + v).diff(symbol) * rate for symbol, rate in field.items())
    assert_close(balls([change], LEAVES, 240)[0][0], right)


def test_second_derivatives() -> None:
    reader = Reader(TRIAL, Graph())
    one = {reader(x): reader.graph.number(1)}
    term = reader.graph.directional_derivative(
        reader.graph.directional_derivative([reader(sp.sin(x * y) / v)], one), one
    )
    assert_close(balls(term, LEAVES, 240)[0][0], full(sp.sin(x * y) / v).diff(x, 2))


def test_choice_and_its_derivative() -> None:
    """Where a test is positive the first branch counts, and its derivative with it."""
    reader = Reader(TRIAL, Graph())
    graph = reader.graph
    term = graph.where_positive(reader(y), reader(x**2), reader(x**3))
    (change,) = graph.directional_derivative([term], {reader(x): graph.number(1)})
    assert_close(balls([change], LEAVES, 240)[0][0], 3 * x**2)
    assert graph.where_positive(reader(y), reader(x), reader(x)) is reader(x)


def test_equal_things_are_made_once() -> None:
    reader = Reader(TRIAL, Graph())
    assert reader(x * y + z) is reader(z + y * x)
    assert reader(sp.sin(x * y)).args[0] is reader(x * y)
    graph, p, q = reader.graph, reader(x), reader(y)
    assert p * q is q * p
    assert p - p is graph.number(0)
    assert p + graph.number(0) is p
    assert p * graph.number(1) is p
    assert graph.neg(-p) is p
    assert -(p - q) is q - p
    assert p + (-q) is p - q
    assert graph.recip(graph.recip(p)) is p


def test_named_quantities_are_followed_not_expanded() -> None:
    """v stands in three places and is one term."""
    _, rates = of_system(TRIAL)
    assert sum(term.kind == "sqrt" for term in topological_order(rates)) == 1


def test_vectors_share_their_parts() -> None:
    M, gamma = vectors("M gamma")
    system = System(name="s", title="S", field={M: cross(M, gamma) * dot(M, gamma), gamma: M})
    _, rates = of_system(system)
    assert len(topological_order(rates)) < 30


def test_operands_come_first() -> None:
    _, rates = of_system(TRIAL)
    seen: set[int] = set()
    for term in topological_order(rates):
        assert all(id(operand) in seen for operand in term.operands)
        seen.add(id(term))


@pytest.mark.parametrize(
    ("formula", "sentence"),
    [
        (sp.gamma(x), "gamma(x): the machine code has no function gamma"),
        (x + sp.erf(y), "erf(y): the machine code has no function erf"),
    ],
    ids=str,
)
def test_unknown_functions(formula: sp.Expr, sentence: str) -> None:
    with pytest.raises(InputError) as caught:
        read(formula)
    assert str(caught.value) == sentence


#: Every fourth system at all times, the others among the slow tests.
SYSTEMS = [
    pytest.param(name, marks=[pytest.mark.slow] if i % 4 else [])
    for i, name in enumerate(CATALOGUE)
]


@pytest.mark.slow
@pytest.mark.parametrize("name", SYSTEMS)
def test_rates_of_the_catalogue(name: str) -> None:
    """The graph's rates and SymPy's own numbers at states drawn at random.

    SymPy's formulas round in an order of their own; balls of 40 bits hold what doubles make.
    """
    system = CATALOGUE[name].system()
    field = lambdify(system)
    _, rates = of_system(system)
    rng = np.random.default_rng(3)
    parameters = {("parameter", i): p.default for i, p in enumerate(system.parameters)}
    states = rng.uniform(-1, 1, (30, len(system.symbols)))
    with np.errstate(all="ignore"):
        pairs = [(state, np.asarray(field(0.0, state), dtype=float)) for state in states]
    defined = [(state, right) for state, right in pairs if np.isfinite(right).all()]
    assert len(defined) >= 3
    for state, right in defined[:3]:
        leaves = parameters | {("state", i): value for i, value in enumerate(state)}
        for found, value in zip(balls(rates, leaves, 40)[0], right, strict=True):
            assert found.contains(value)
