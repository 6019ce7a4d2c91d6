"""Decimal numbers mean the rational numbers that they say."""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.expansion import TaylorExpansion
from flowlanes.formulas.taylor import Rational
from flowlanes.parsing.exact_decimals import exact_number, with_exact_decimals
from flowlanes.system.vectors import real_symbol
from lawproof.search.modular_jets import Evaluator, prime
from nonholonomic.mechanics.constraints.integrability import nonholonomy_at
from nonholonomic.mechanics.lagrangian.mechanism import Mechanism, coordinates

x = real_symbol("x")


@pytest.mark.parametrize(
    ("number", "expected"),
    [
        (0.1, "1/10"),
        (0.333333333333333, "333333333333333/1000000000000000"),
        (1 / 3, "3333333333333333/10000000000000000"),
        (0.1 + 0.2, "30000000000000004/100000000000000000"),
        (sp.Float(1 / 3), "3333333333333333/10000000000000000"),
        (sp.Float(0.1), "1/10"),
        (sp.Float("0.333", 3), "333/1000"),
        (sp.Float("0.1", 50), "1/10"),
        (sp.Float("1e-40", 60), "1/1" + 40 * "0"),
        (sp.Float(str(math.pi)), "3141592653589793/1000000000000000"),
        (np.float64(0.25), "1/4"),
        (np.float32(0.25), "1/4"),
        (np.int64(-7), "-7"),
        (Fraction(1, 3), "1/3"),
        (sp.Rational(1, 3), "1/3"),
        (5e-324, "1/2" + 323 * "0"),
        (-0.0, "0"),
    ],
)
def test_what_a_decimal_says(number, expected):
    found = exact_number(number)
    assert isinstance(found, sp.Rational)
    assert found == sp.Rational(expected)


def test_numbers_of_mpmath_by_their_digits():
    with mpmath.workdps(40):
        assert exact_number(mpmath.mpf("0.1")) == sp.Rational(1, 10)
        assert exact_number(mpmath.mpf(1) / 3) == sp.Rational("0." + 40 * "3")


def test_nothing_is_guessed_in_formulas():
    formula = 0.333333333333333 * x + sp.sqrt(2) * 1.41421356237310
    found = with_exact_decimals(formula)
    assert not found.has(sp.Float)
    assert found.coeff(x) == sp.Rational("0.333333333333333")
    assert found - found.coeff(x) * x == sp.sqrt(2) * sp.Rational("1.41421356237310")
    assert with_exact_decimals(x + 1) == x + 1
    assert with_exact_decimals(0.5) == sp.S.Half


@pytest.mark.parametrize("number", [math.inf, math.nan, mpmath.inf, sp.oo, sp.nan, sp.pi, "1", x])
def test_what_has_no_exact_value_is_refused(number):
    with pytest.raises(InputError, match=r"is not a finite number|is no number"):
        exact_number(number)


def test_the_search_reads_decimals_alike():
    jet = Evaluator({}, 1, 1, {})(sp.Float(0.1 + 0.2))
    expected = exact_number(0.1 + 0.2)
    assert jet.value[0] == int(expected.p) * pow(int(expected.q), -1, prime()) % prime()


def test_germs_read_decimals_alike():
    germs = TaylorExpansion(Rational(), (), {}, {}, {}, {}, 0)
    value = germs.series(sp.Float(0.1 + 0.2)).value
    assert sp.Rational(int(value.p), int(value.q)) == exact_number(0.1 + 0.2)


def test_a_point_is_taken_as_it_is_written():
    """At y = 1/3 the constraint is singular; at 0.333333333333333 it is not."""
    y, z, w = real_symbol("y"), real_symbol("z"), real_symbol("w")
    frame = coordinates(y, z, w)
    ydot, zdot, wdot = frame.w
    plane = Mechanism("plane", frame, (ydot**2 + zdot**2 + wdot**2) / 2, (3 * y * zdot - zdot,))
    assert nonholonomy_at(plane, {y: 0.333333333333333, z: 0, w: 0}).growth
    with pytest.raises(InputError, match="dependent or singular at this point"):
        nonholonomy_at(plane, {y: sp.Rational(1, 3), z: 0, w: 0})
