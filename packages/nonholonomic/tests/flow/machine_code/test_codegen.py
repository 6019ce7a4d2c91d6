"""Terms as vector instructions: right to rounding, in doubles and in pairs, at every width."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings, strategies as st

from flow.machine import exact, pairs, run
from flow.terms import balls
from flowlanes.flow.machine_code.arithmetic import Double, Pair
from flowlanes.flow.machine_code.codegen import evaluate, parameter_only_terms
from flowlanes.flow.machine_code.ir_writer import IRWriter, literal
from flowlanes.formulas.graph import Graph, Reader, Term, of_system
from flowlanes.system.system import Parameter, System
from nonholonomic.catalogue import CATALOGUE

DIGITS = 60
WIDTHS = (1, 2, 4, 8, 16)
ARITHMETICS = pytest.mark.parametrize("arithmetic", [Double, Pair])

x, y, z, a = sp.symbols("x y z a", real=True)
TRIAL = System(
    name="trial",
    title="Trial",
    parameters=(Parameter(a, "a number", 1.0),),
    field={x: y, y: z, z: a * x},
)


# --- formulas drawn at random -----------------------------------------------------------------


def _grown(smaller: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    one = st.sampled_from([sp.sin, sp.cos, sp.atan, sp.exp, sp.tanh, sp.Abs, sp.cosh])
    guarded = st.sampled_from([lambda f: sp.sqrt(1 + f**2), lambda f: sp.log(2 + sp.sin(f))])
    two = [lambda f, g: f + g, lambda f, g: f - g, lambda f, g: f * g, lambda f, g: f / g]
    return st.one_of(
        st.builds(lambda f, g: f(g), one, smaller),
        st.builds(lambda f, g: f(g), guarded, smaller),
        st.builds(lambda f, n: f**n, smaller, st.integers(-3, 4)),
        *(st.builds(join, smaller, smaller) for join in two),
    )


LEAVES = st.sampled_from([x, y, z, sp.Rational(1, 3), sp.Integer(2), sp.pi])
FORMULAS = st.lists(st.recursive(LEAVES, _grown, max_leaves=8), min_size=4, max_size=4)
POINTS = st.lists(st.floats(-3, 3, width=32), min_size=3, max_size=3)


def _leaf(values: Sequence[Any]) -> Any:
    """State variables are what is given, everything else is computed."""
    return lambda term: values[term.args[0]] if term.kind == "state" else None


def _evaluated(arithmetic: Any, terms: Sequence[Term], point: Sequence[float]) -> Any:
    given_values = np.zeros((1, len(point), arithmetic.words))
    given_values[0, :, 0] = point
    return run(arithmetic, 8, lambda k, v: evaluate(k, terms, _leaf(v)), given_values)[0]


@pytest.mark.slow
@ARITHMETICS
@settings(max_examples=25)
@given(formulas=FORMULAS, point=POINTS)
def test_formulas_are_right_to_rounding(
    arithmetic: Any, formulas: list[sp.Expr], point: list[float]
) -> None:
    """Against SymPy at 400 digits; allowed is what rounding to a few bits less can do."""
    assume(not any(formula.has(sp.zoo, sp.nan, sp.oo) for formula in formulas))
    reader = Reader(TRIAL, Graph())
    terms = [reader(formula) for formula in formulas]
    leaves = {("state", i): value for i, value in enumerate(point)}
    bounds, everything = balls(terms, leaves, arithmetic.bits - 3)
    assume(all(b.is_finite() and abs(b) < 1e9 for b in everything))
    assume(all(b == 0 or abs(b) > 1e-60 for b in everything))
    found = _evaluated(arithmetic, terms, point)
    where = {s: sp.Rational(value) for s, value in zip((x, y, z), point, strict=True)}
    with mpmath.workdps(400):
        for formula, bound, words in zip(formulas, bounds, found, strict=True):
            right = mpmath.mpf(str(sp.sympify(formula).subs(where).evalf(400)))
            assert abs(exact(words) - right) <= mpmath.mpf(bound.rad().str(30, radius=False))


@ARITHMETICS
def test_choices(arithmetic: Any) -> None:
    """Lanes take their own branch; at zero the second."""
    graph = Graph()
    p, q = graph.state(0), graph.state(1)
    term = graph.where_positive(p, q, -q)
    points = np.zeros((3, 2, arithmetic.words))
    points[:, :, 0] = [(1, 5), (-1, 5), (0, 5)]
    found = run(arithmetic, 4, lambda k, v: evaluate(k, [term], _leaf(v)), points)
    assert found[:, 0, 0].tolist() == [5, -5, -5]


# --- bits -------------------------------------------------------------------------------------


@pytest.mark.slow
@ARITHMETICS
@pytest.mark.parametrize("name", ["chaplygin-ball", "unbalanced-rubber-ball", "rattleback"])
def test_bits_do_not_depend_on_the_number_of_lanes(name: str, arithmetic: Any) -> None:
    """Nor on the neighbours: the rates of a System at 37 states, in order and backwards."""
    _, rates = of_system(CATALOGUE[name].system())
    system = CATALOGUE[name].system()
    rng = np.random.default_rng(8)
    states = np.zeros((37, len(system.symbols), arithmetic.words))
    states[:, :, 0] = rng.uniform(0.2, 0.8, states.shape[:2])
    numbers = [Fraction(p.default) for p in system.parameters]

    def build(k: Any, values: Sequence[Any]) -> Any:
        def leaf(term: Term) -> Any:
            if term.kind == "parameter":
                return k.number(numbers[term.args[0]])
            return values[term.args[0]] if term.kind == "state" else None

        return evaluate(k, rates, leaf)

    found = {run(arithmetic, lanes, build, states).tobytes() for lanes in WIDTHS}
    assert len(found) == 1
    backwards = run(arithmetic, 8, build, states[::-1].copy())[::-1].tobytes()
    assert found == {backwards}
    assert np.isfinite(np.frombuffer(backwards)).all()


def test_products_are_fused_into_sums_once() -> None:
    """A product used once is part of a fused instruction; one used twice is computed."""
    graph = Graph()
    p, q, r = (graph.state(i) for i in range(3))
    w = IRWriter(4)
    evaluate(Double(w), [p * q + r, p * r - q, p - q * r], _leaf(["%a", "%b", "%c"]))
    text = "\n".join(w.lines)
    assert text.count("@llvm.fma") == 3
    assert "fmul" not in text
    w = IRWriter(4)
    evaluate(Double(w), [p * q + r, p * q - r], _leaf(["%a", "%b", "%c"]))
    text = "\n".join(w.lines)
    assert (text.count("fmul"), text.count("@llvm.fma")) == (1, 0)


def test_literals_are_exact() -> None:
    assert literal(1.0) == "0x3FF0000000000000"
    assert literal(-0.1) == "0xBFB999999999999A"


# --- pairs ------------------------------------------------------------------------------------

#: Relative errors that are proven for sums and products (Joldes, Muller and Popescu 2017: 3 u²
#: and 4 u² with u = 2⁻⁵³), and what Newton's steps add to them.
BOUNDS = {"add": 3.0, "sub": 3.0, "mul": 4.0, "fma": 8.0, "recip": 4.0, "sqrt": 4.0}


def _operands(rng: np.random.Generator, count: int) -> np.ndarray:
    """Pairs of all sizes; sums nearly cancel in half of them."""
    heads = rng.choice([-1, 1], (3, count)) * 2.0 ** rng.uniform(-30, 30, (3, count))
    half = count // 2
    heads[1, :half] = -heads[0, :half] * (1 + 2.0 ** rng.uniform(-52, -1, half))
    rests = np.spacing(np.abs(heads)) * rng.uniform(-0.5, 0.5, heads.shape)
    # a pair is one only if its sum rounds to its head
    rests[heads + rests != heads] = 0
    return np.stack([heads, rests], axis=2).transpose(1, 0, 2)


OPERATIONS: dict[str, tuple[int, Any]] = {
    "add": (2, lambda p, q: p + q),
    "sub": (2, lambda p, q: p - q),
    "mul": (2, lambda p, q: p * q),
    "recip": (1, lambda p: 1 / p),
    "sqrt": (1, mpmath.sqrt),
}


@pytest.mark.parametrize("name", sorted(OPERATIONS))
def test_pairs_keep_their_bounds(name: str) -> None:
    """Errors of single operations, and the second word below half a unit of the first."""
    count, operation = OPERATIONS[name]
    words = _operands(np.random.default_rng(11), 3000)[:, :count]
    if name == "sqrt":
        words = words * np.sign(words[:, :, :1])
    found = run(Pair, 8, lambda k, v: [getattr(k, name)(*v)], words)[:, 0]
    with mpmath.workdps(DIGITS):
        worst = 0.0
        for given_words, result in zip(words, found, strict=True):
            right = operation(*map(exact, given_words))
            worst = max(worst, float(abs(exact(result) - right) / abs(right) * 2**106))
    assert worst <= BOUNDS[name]
    assert np.array_equal(found[:, 0] + found[:, 1], found[:, 0])


def test_fused_pairs_keep_their_bound() -> None:
    """a b + c, relative to the larger of product and sum."""
    words = _operands(np.random.default_rng(12), 3000)
    found = run(Pair, 8, lambda k, v: [k.fma(*v)], words)[:, 0]
    with mpmath.workdps(DIGITS):
        for given_words, result in zip(words, found, strict=True):
            p, q, r = map(exact, given_words)
            scale = max(abs(p * q), abs(p * q + r))
            assert abs(exact(result) - (p * q + r)) <= BOUNDS["fma"] * scale / 2**106


def test_root_of_zero() -> None:
    found = run(Pair, 2, lambda k, v: [k.sqrt(*v)], np.zeros((1, 1, 2)))
    assert found.tolist() == [[[0.0, 0.0]]]


def test_constants_have_both_words() -> None:
    """1/3 to 106 bits."""
    third = Fraction(1, 3)
    found = run(Pair, 2, lambda k, v: [k.number(third)], np.zeros((1, 1, 2)))[0, 0]
    with mpmath.workdps(DIGITS):
        right = mpmath.mpf(1) / 3
        assert abs(exact(found) - right) <= right / 2**106
        assert found.tolist() == pairs([right])[0].tolist()


# --- what is computed once --------------------------------------------------------------------


def test_what_depends_on_parameters_alone_is_found() -> None:
    """The largest terms without state variables that others use, but no bare numbers."""
    graph = Graph()
    p, b = graph.state(0), graph.parameter(0)
    inner = graph.recip(b * b + graph.number(1))
    assert parameter_only_terms([p * inner + graph.number(2) * p]) == [inner]
    assert parameter_only_terms([inner, p]) == [inner]
