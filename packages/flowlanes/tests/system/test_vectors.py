"""Vectors obey the identities of vector algebra, exactly, and agree with SymPy's matrices."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st

from flowlanes.system.vector_operators import gradient, hat, outer, unit_vector
from flowlanes.system.vectors import (
    Cross,
    Diagonal,
    Dot,
    Symmetric,
    Vector,
    constant,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
    zero,
)

u, v, w = vectors("u v w")
a, b = real_symbol("a"), real_symbol("b")
D, S = Diagonal("D"), Symmetric("S")


def same(left: Any, right: Any) -> bool:
    """Whether two formulas have the same components, as polynomials."""
    difference = to_components(left) - to_components(right)
    if isinstance(difference, sp.MatrixBase):
        return all(sp.expand(entry) == 0 for entry in difference)
    return bool(sp.expand(difference) == 0)


def test_components_are_real_symbols_named_after_the_vector() -> None:
    assert [str(s) for s in u] == ["u_1", "u_2", "u_3"]
    assert all(s.is_real for s in u)
    assert [str(s) for s in Vector("q", 4)] == ["q_w", "q_x", "q_y", "q_z"]
    assert [str(s) for s in Vector("p", 2)] == ["p_x", "p_y"]
    assert Vector("u") == u
    assert to_components(u) == constant(list(u.symbols))


def test_jacobi_identity() -> None:
    cyclic = cross(u, cross(v, w)) + cross(v, cross(w, u)) + cross(w, cross(u, v))
    assert same(cyclic, zero)


def test_lagrange_identity() -> None:
    assert same(norm_squared(cross(u, v)), norm_squared(u) * norm_squared(v) - dot(u, v) ** 2)


def test_triple_products() -> None:
    assert same(cross(u, cross(v, w)), dot(u, w) * v - dot(u, v) * w)
    assert same(dot(u, cross(v, w)), dot(w, cross(u, v)))
    assert same(dot(u, cross(u, v)), sp.S.Zero)


@pytest.mark.parametrize("product", [cross, dot])
def test_products_are_bilinear(product: Callable[[Any, Any], Any]) -> None:
    assert same(product(a * u + b * v, w), a * product(u, w) + b * product(v, w))
    assert same(product(w, a * u + b * v), a * product(w, u) + b * product(w, v))


def test_products_of_parallel_vectors_vanish_at_once() -> None:
    assert cross(u, u) == zero
    assert cross(2 * u, a * u) == zero
    assert cross(cross(u, v), cross(v, u)) == zero
    assert cross(u, zero) == zero
    assert dot(u, zero) == 0


def test_scalar_factors_leave_the_products() -> None:
    assert cross(a * u, b * v) == a * b * Cross(u, v)
    assert dot(a * u, b * v) == a * b * Dot(u, v)
    assert dot(-u, v) == -Dot(u, v)


def test_antisymmetry_and_symmetry() -> None:
    assert same(cross(u, v), -cross(v, u))
    assert same(dot(u, v), dot(v, u))


def test_hat_and_outer_are_matrices_of_their_maps() -> None:
    assert same(hat(u) * v, cross(u, v))
    assert same(outer(u, v) * w, dot(v, w) * u)
    assert same(outer(u, v), constant([[p * q for q in v] for p in u]))
    assert same(identity * u, u)


def test_unit_vectors_are_right_handed() -> None:
    e = [unit_vector(i) for i in (1, 2, 3)]
    assert same(cross(e[0], e[1]), e[2])
    assert same(dot(e[1], e[1]), sp.S.One)


def test_gradient_is_the_vector_of_partial_derivatives() -> None:
    value = a * u.symbols[0] ** 2 * u.symbols[1] + sp.sin(u.symbols[2])
    assert list(to_components(gradient(value, u))) == [value.diff(s) for s in u]
    assert same(gradient(dot(u, S * u), u), 2 * (S * u))
    assert gradient(norm_squared(v), u) == zero


@pytest.mark.parametrize("tensor", [D, S])
def test_inverse_of_a_tensor(tensor: Any) -> None:
    product = to_components(tensor**-1) * tensor.entries
    assert sp.simplify(product) == sp.eye(3)


@pytest.mark.parametrize("tensor", [D, S])
def test_independent_entries_come_in_the_order_of_the_symbols(tensor: Any) -> None:
    assert tensor.independent(tensor.entries) == tensor.symbols
    assert tensor.entries == tensor.entries.T
    assert same(dot(u, tensor * v), dot(v, tensor * u))


def test_nothing_is_expanded() -> None:
    total = to_components(dot(u + v, w))
    products = [sp.Mul(p + q, r) for p, q, r in zip(u, v, w, strict=True)]
    assert total == sp.Add(*products)


# --- random formulas against SymPy's own matrices ------------------------------------------


@dataclass(frozen=True)
class Case:
    """A vector formula and the same vector by SymPy's Matrix."""

    formula: Any
    value: sp.Matrix


NUMBERS = dict(
    zip(
        [*u, *v, *w, *D.symbols, *S.symbols],
        map(sp.Rational, [2, -3, 5, 1, 7, -4, -6, 3, 1, 1, 2, 4, 2, 1, -1, 3, 2, 5]),
        strict=True,
    )
)
LEAVES = [
    *(Case(x, sp.Matrix([NUMBERS[s] for s in x])) for x in (u, v, w)),
    *(Case(unit_vector(i), sp.eye(3).col(i - 1)) for i in (1, 2, 3)),
    Case(zero, sp.zeros(3, 1)),
]
TENSORS = [
    *(Case(t, sp.Matrix(t.entries.xreplace(NUMBERS))) for t in (D, S)),
    *(Case(t**-1, sp.Matrix(t.entries.xreplace(NUMBERS)).inv()) for t in (D, S)),
    Case(outer(u, v), LEAVES[0].value * LEAVES[1].value.T),
    Case(identity, sp.eye(3)),
]
FACTORS = st.fractions(Fraction(-3), Fraction(3), max_denominator=4).map(sp.Rational)


def longer(shorter: st.SearchStrategy[Case]) -> st.SearchStrategy[Case]:
    pairs = st.tuples(shorter, shorter)
    return st.one_of(
        pairs.map(lambda p: Case(cross(p[0].formula, p[1].formula), p[0].value.cross(p[1].value))),
        pairs.map(lambda p: Case(p[0].formula + p[1].formula, p[0].value + p[1].value)),
        st.tuples(FACTORS, shorter).map(lambda p: Case(p[0] * p[1].formula, p[0] * p[1].value)),
        st.tuples(st.sampled_from(TENSORS), shorter).map(
            lambda p: Case(p[0].formula * p[1].formula, p[0].value * p[1].value)
        ),
    )


CASES = st.recursive(st.sampled_from(LEAVES), longer, max_leaves=6)


@pytest.mark.slow
@settings(max_examples=150)
@given(CASES, CASES)
def test_explicit_agrees_with_matrices(left: Case, right: Case) -> None:
    assert sp.Matrix(to_components(left.formula).xreplace(NUMBERS)) == left.value
    product = to_components(cross(left.formula, right.formula))
    assert sp.Matrix(product.xreplace(NUMBERS)) == left.value.cross(right.value)
    number = sp.sympify(to_components(dot(left.formula, right.formula))).xreplace(NUMBERS)
    assert number == left.value.dot(right.value)


def test_a_product_alone_and_inside_another_is_made_explicit_in_both_places() -> None:
    nested = dot(u, v) * dot(dot(u, v) * w + u, w)
    assert not to_components(nested).has(Dot)
    assert same(nested, dot(u, v) ** 2 * dot(w, w) + dot(u, v) * dot(u, w))
