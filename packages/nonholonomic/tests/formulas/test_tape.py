"""Derivatives through named definitions, and linear equations by named steps."""

from __future__ import annotations

import itertools

import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st

from flowlanes.formulas.tape import Derivation, Tape, simplify_small
from flowlanes.system.vectors import real_symbol
from nonholonomic.mechanics.lagrangian.ldl import Factorisation

x, y, z, a, b, c = (real_symbol(n) for n in "xyzabc")
STEPS = ((a, x**2 * y + sp.sin(x)), (b, a**3 / (1 + x**2)), (c, sp.sqrt(1 + a * b)))


def written(tape: Tape, value: sp.Expr) -> sp.Expr:
    for symbol, meaning in reversed(tape.steps([value])):
        value = value.xreplace({symbol: meaning})
    return value


@pytest.mark.parametrize("rates", [((x, sp.S.One),), ((x, y), (y, -x * y))])
def test_derivatives_are_those_of_the_expanded_formula(rates: tuple[tuple, ...]) -> None:
    tape = Tape(STEPS, (x, y))
    value = c * x + b**2
    found = written(tape, tape.along(Derivation(rates), value))
    plain = written(tape, value)
    expected = sum(rate * sp.diff(plain, s) for s, rate in rates)
    at = {x: sp.Rational(1, 3), y: sp.Rational(2, 7)}
    assert sp.N((found - expected).xreplace(at), 30) == pytest.approx(0, abs=1e-25)


@pytest.mark.slow
def test_nothing_is_expanded() -> None:
    """A chain of definitions costs as many operations as it has links, not 2 to their number."""
    links = [real_symbol(f"c_{i}") for i in range(1, 31)]
    steps = [(links[0], x * y)]
    steps += [(new, old**2 + x * old) for old, new in itertools.pairwise(links)]
    tape = Tape(steps, (x, y))
    slope = tape.along(Derivation(((x, sp.S.One),)), links[-1])
    total = sum(sp.count_ops(value) for _, value in tape.steps([slope]))
    assert total < 12 * len(links)


def test_equal_values_share_a_name() -> None:
    tape = Tape((), (x, y))
    first = tape.name(x**2 + y**2 + x * y)
    assert tape.name(y**2 + x * y + x**2) == first
    assert tape.name(2 * x) == 2 * x


def test_names_that_are_taken_are_not_given_again() -> None:
    tape = Tape(((real_symbol("z_1"), x * y),), (x, y, real_symbol("z_2")))
    assert str(tape.name(x**2 + y**2 + x * y)) == "z_3"


def test_small_formulas_are_tidied() -> None:
    s, k = sp.sin(x), sp.cos(x)
    assert simplify_small(a**2 * s**2 + a**2 * k**2) == a**2
    assert simplify_small((x**2 - 1) / (x - 1)) == x + 1
    assert simplify_small(sp.exp(s) * (s**2 + k**2)) in (sp.exp(s), sp.exp(s) * (s**2 + k**2))


@pytest.mark.slow
@given(st.integers(0, 10**6), st.integers(2, 5))
@settings(max_examples=20)
def test_linear_equations_are_solved(seed: int, size: int) -> None:
    import random

    rng = random.Random(seed)
    root = sp.Matrix(
        size, size, lambda i, j: rng.choice([0, 0, 1, 2]) * (x if i < j else 1) + 3 * (i == j)
    )
    matrix = root.T * root
    right = [sp.Integer(rng.randint(-5, 5)) + y * rng.randint(0, 2) for _ in range(size)]
    tape = Tape((), (x, y))
    found = Factorisation(tape, matrix.tolist()).solve(right)
    at = {x: sp.Rational(3, 7), y: sp.Rational(-2, 5)}
    solution = sp.Matrix([written(tape, value) for value in found]).xreplace(at)
    assert matrix.xreplace(at) * solution == sp.Matrix(right).xreplace(at)


def test_a_zero_pivot_is_told() -> None:
    with pytest.raises(ZeroDivisionError):
        Factorisation(Tape((), ()), [[sp.S.Zero, sp.S.One], [sp.S.One, sp.S.Zero]])
