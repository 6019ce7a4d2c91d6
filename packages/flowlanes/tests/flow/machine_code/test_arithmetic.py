"""Doubles and pairs in registers: what is special about zeros, infinities and single words.

Errors of sums, products, quotients and roots are measured in `test_simd`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings, strategies as st

from flow.machine import run
from flowlanes.flow.machine_code.arithmetic import Double, Pair, PairWithoutFused
from flowlanes.flow.machine_code.ir_writer import IRWriter

ARITHMETICS = pytest.mark.parametrize("kind", [Double, Pair])
NUMBERS = st.floats(-1e100, 1e100, allow_subnormal=False)


def words(kind: Any, rows: Sequence[Sequence[float]]) -> np.ndarray:
    """Numbers without a second word."""
    made = np.zeros((len(rows), len(rows[0]), kind.words))
    made[:, :, 0] = rows
    return made


@settings(max_examples=60)
@given(a=NUMBERS, b=NUMBERS)
def test_sums_of_doubles_without_error(a: float, b: float) -> None:
    """Sum and rest are the sum exactly; the rest is no more than half a unit."""
    found = run(Pair, 4, lambda k, v: [k.two_sum(v[0][0], v[1][0])], words(Pair, [[a, b]]))[0, 0]
    assert Fraction(found[0]) + Fraction(found[1]) == Fraction(a) + Fraction(b)
    assert found[0] == a + b
    ordered = sorted((a, b), key=abs, reverse=True)
    fast = run(Pair, 4, lambda k, v: [k.fast_sum(v[0][0], v[1][0])], words(Pair, [ordered]))[0, 0]
    assert fast.tolist() == found.tolist()


@settings(max_examples=60)
@given(a=NUMBERS, b=NUMBERS)
def test_products_are_exact_without_fused_operations(a: float, b: float) -> None:
    """Product and rest are the product exactly, where neither is lost at the end of all numbers."""
    assume(a == 0 or abs(a) > 1e-100)
    assume(b == 0 or abs(b) > 1e-100)
    kind = PairWithoutFused
    found = run(kind, 4, lambda k, v: [k.mul(v[0], v[1])], words(kind, [[a, b]]))[0, 0]
    assert Fraction(found[0]) + Fraction(found[1]) == Fraction(a) * Fraction(b)


@ARITHMETICS
@pytest.mark.parametrize("lanes", [1, 4, 16])
def test_constants_are_rounded_once(kind: Any, lanes: int) -> None:
    values = [Fraction(1, 3), Fraction(-22, 7), Fraction(1, 2**60) + 1, Fraction(0), Fraction(5)]
    found = run(kind, lanes, lambda k, v: [k.number(x) for x in values], words(kind, [[1.0]]))[0]
    for value, made in zip(values, found, strict=True):
        error = abs(sum(Fraction(float(word)) for word in made) - value)
        assert error <= abs(value) / 2 ** (kind.bits - 1)
        assert made[0] == float(value)


@ARITHMETICS
def test_simple_numbers_have_simple_results(kind: Any) -> None:
    """Whole numbers stay exact in every operation."""
    rows = [[6.0, 3.0, 4.0], [-8.0, 2.0, 16.0], [0.0, -1.0, 0.0]]

    def build(k: Any, v: Sequence[Any]) -> list[Any]:
        a, b, c = v
        return [k.add(a, b), k.sub(a, b), k.mul(a, b), k.fma(a, b, c), k.neg(a), k.sqrt(c)]

    found = run(kind, 2, build, words(kind, rows))
    right = [[a + b, a - b, a * b, a * b + c, -a, math.sqrt(c)] for a, b, c in rows]
    assert found[:, :, 0].tolist() == right
    assert not found[:, :, 1:].any()


@ARITHMETICS
def test_what_cannot_be_computed_is_no_number(kind: Any) -> None:
    """Roots of negatives, reciprocals of zero; never a plausible number."""
    found = run(kind, 4, lambda k, v: [k.sqrt(v[0]), k.recip(v[1])], words(kind, [[-1.0, 0.0]]))[0]
    assert math.isnan(found[0, 0])
    assert not math.isfinite(found[1, 0])
    nothing = words(kind, [[math.nan, math.nan]])
    found = run(kind, 4, lambda k, v: [k.add(*v), k.mul(*v), k.recip(v[0]), k.sqrt(v[0])], nothing)
    assert np.isnan(found[0, :, 0]).all()


@ARITHMETICS
def test_leading_whole_and_choice(kind: Any) -> None:
    """One register becomes a number and is its leading part; lanes choose whole numbers."""

    def build(k: Any, v: Sequence[Any]) -> list[Any]:
        a, b = v
        third = k.mul(a, k.number(Fraction(1, 3)))
        mask = k.writer.compare("olt", k.leading(b), k.writer.constant(0.0))
        return [k.whole(k.leading(third)), k.choose(mask, third, a)]

    found = run(kind, 4, build, words(kind, [[1.0, -1.0], [1.0, 1.0]]))
    assert found[:, 0, 0].tolist() == [1 / 3, 1 / 3]
    assert not found[:, 0, 1:].any()
    assert found[1, 1, 0] == 1.0
    assert found[0, 1, 0] == 1 / 3
    assert found[0, 1, 1:].any() == (kind is Pair)


def test_memory_of_pairs() -> None:
    """The words of a number lie beside each other, a vector each."""
    number = Pair(IRWriter(4))
    number.store(("%high", "%low"), "%place", 3)
    text = "\n".join(number.writer.lines)
    assert "getelementptr [2 x <4 x double>], ptr %place, i64 3" in text
    assert text.count("store <4 x double>") == 2
    assert (Pair.words, Double.words) == (2, 1)
