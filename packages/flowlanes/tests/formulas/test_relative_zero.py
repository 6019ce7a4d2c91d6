"""Zero relative to the size of its terms."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from flint import arb

from flowlanes.formulas.relative_zero import (
    RESOLUTION,
    ROUNDING,
    SizedNumber,
    state_sizes,
    values_with_sizes,
    vanishes,
)
from flowlanes.system.vectors import dot, to_components, vectors

M, gamma = vectors("M gamma")
x, y, z = sp.symbols("x y z", real=True)


def level(momentum: tuple[Fraction, ...], normal: tuple[Fraction, ...]) -> SizedNumber:
    """(M, γ) with its size."""
    symbols = (*M.symbols, *gamma.symbols)
    known = state_sizes((M, gamma), symbols, (*momentum, *normal))
    return values_with_sizes([to_components(dot(M, gamma))], known)[0]


@pytest.mark.parametrize("size", [Fraction(1, 10**15), Fraction(1), Fraction(10**15)], ids=float)
def test_a_sum_is_judged_beside_its_terms(size: Fraction) -> None:
    normal = (Fraction(3, 5), Fraction(4, 5), Fraction(0))
    exact = level((4 * size, -3 * size, 5 * size), normal)
    assert exact.value == 0
    assert exact.vanishes()
    rounded = level((4 * size, -3 * size * (1 + Fraction(1, 10**15)), 5 * size), normal)
    assert rounded.vanishes(ROUNDING)
    assert not rounded.vanishes(RESOLUTION)
    assert not level((4 * size, -2 * size, 5 * size), normal).vanishes(ROUNDING)


def test_a_component_is_as_large_as_its_vector() -> None:
    # what is left of M₁ is the rounding of M₂
    left = level((Fraction(1, 10**17), Fraction(1), Fraction(0)), (Fraction(1), *[Fraction(0)] * 2))
    assert left.vanishes(ROUNDING)
    assert left.share < 1e-16


def test_nothing_at_all_vanishes() -> None:
    zero = Fraction(0)
    assert level((zero,) * 3, (Fraction(1), zero, zero)).vanishes()
    assert level((zero,) * 3, (Fraction(1), zero, zero)).share == 0


@pytest.mark.parametrize(
    ("formula", "value", "size"),
    [
        (x - y, -1, 5),
        (x * (x - y), -2, 10),
        (1 / (x - y), -1, 5),
        ((x - y) ** 2, 1, 25),
        (sp.sqrt(x + 2), 2, 2),
        (z, -1, 5),
    ],
    ids=str,
)
def test_sizes_of_formulas(formula: sp.Expr, value: int, size: int) -> None:
    known = {x: SizedNumber(Fraction(2), Fraction(2)), y: SizedNumber(Fraction(3), Fraction(3))}
    (found,) = values_with_sizes([formula], known, [(z, x - y)])
    assert (found.value, found.size) == (value, size)


def test_functions_are_evaluated_too() -> None:
    (found,) = values_with_sizes([sp.cos(x)], {x: SizedNumber(Fraction(0), Fraction(0))})
    assert (found.value, found.size) == (1, 1)
    (found,) = values_with_sizes([sp.pi - x], {x: SizedNumber(Fraction(3), Fraction(3))})
    assert abs(float(found.value) - float(mpmath.pi - 3)) < 1e-15


def test_a_symbol_without_value_is_told() -> None:
    with pytest.raises(KeyError):
        values_with_sizes([x + y], {x: SizedNumber(Fraction(1), Fraction(1))})


def test_balls() -> None:
    for size in (arb("1e-30"), arb(1), arb("1e30")):
        assert vanishes(size * arb("1e-41"), size)
        assert not vanishes(size * arb("1e-39"), size)
        assert vanishes(size * arb("1e-13"), size, ROUNDING)
    assert vanishes(arb(0), arb(0))
    assert not vanishes(arb("nan"), arb(1))
