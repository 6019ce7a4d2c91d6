"""Short formulas of the literature for Hertz's factors: their ends and their errors."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from nonholonomic.contact.pressure.pressure import Hertz, Uniform
from nonholonomic.contact.pressure.pressure_approximations import (
    ApproximateFriction,
    best_constants,
    ellipsoid_law,
    greatest_errors,
    zhuravlev_first_order,
    zhuravlev_second_order,
)
from nonholonomic.contact.pressure.pressure_ranges import hertz_ranges, k

INNER, _, OUTER = (part.factors() for part in hertz_ranges())


def at_zero(formula, order=0):
    return sp.simplify(sp.diff(formula, k, order).subs(k, 0))


@pytest.mark.parametrize("law", [zhuravlev_first_order(), zhuravlev_second_order()])
def test_pade_forms_have_the_values_and_slopes_of_hertz(law):
    force, couple = law.force_formula, law.couple_formula
    assert at_zero(force) == at_zero(INNER[0]) == 0
    assert at_zero(force, 1) == at_zero(INNER[0], 1) == 3 * sp.pi / 8
    assert at_zero(couple) == at_zero(INNER[1]) == 3 * sp.pi / 16
    assert sp.limit(force, k, sp.oo) == 1
    assert sp.limit(k * couple, k, sp.oo) == sp.Rational(1, 5)
    assert sp.limit(k * OUTER[1], k, sp.oo) == sp.Rational(1, 5)


def test_of_second_order_also_the_slope_of_the_couple_and_the_approach_to_one():
    beta, b = sp.symbols("beta b", positive=True)
    law = zhuravlev_second_order(beta, b)
    assert at_zero(law.couple_formula, 1) == at_zero(INNER[1], 1) == 0
    assert at_zero(law.force_formula, 1) == 3 * sp.pi / 8
    assert sp.limit(k * law.couple_formula, k, sp.oo) == sp.Rational(1, 5)
    # 1 − F falls like 1/k² in both
    assert sp.limit(k**2 * (1 - law.force_formula), k, sp.oo) == beta
    assert at_zero(zhuravlev_first_order().couple_formula, 1) != 0
    plain = zhuravlev_second_order(1, 1)
    c, d = 3 * sp.pi / 8, sp.Rational(16, 15) / sp.pi
    assert sp.simplify(plain.force_formula - (k**2 + c * k) / (k**2 + c * k + 1)) == 0
    assert (
        sp.simplify(plain.couple_formula - 3 * sp.pi / 16 * (1 + d * k) / (1 + d * k + k**2)) == 0
    )


@pytest.mark.parametrize(
    ("law", "force", "couple"),
    [
        (zhuravlev_first_order(), 0.343703269, 0.391616216),
        (zhuravlev_second_order(), 0.198379716, 0.199480263),
        (ellipsoid_law(), 0.111126350, 0.140360515),
    ],
    ids=["first", "second", "ellipsoid"],
)
def test_greatest_errors(law, force, couple):
    # by brute force, independently of the search
    ratios = np.geomspace(1e-4, 1e4, 200_001)
    by_force = np.abs(law.force(ratios) - Hertz().force(ratios)).max()
    by_couple = np.abs(law.couple(ratios) - Hertz().couple(ratios)).max() * 16 / (3 * np.pi)
    assert (by_force, by_couple) == pytest.approx((force, couple), rel=1e-7)
    assert greatest_errors(law) == pytest.approx((force, couple), rel=1e-8)


@pytest.mark.slow
def test_best_constants_make_both_signs_of_the_error_alike():
    beta, b = best_constants()
    assert (beta, b) == pytest.approx((0.281246, 2.293861), abs=1e-6)
    law = zhuravlev_second_order(beta, b)
    assert greatest_errors(law) == pytest.approx((0.0591429, 0.0690428), abs=1e-7)
    ratios = np.geomspace(1e-3, 1e3, 20_001)
    for mine, exact in ((law.force, Hertz().force), (law.couple, Hertz().couple)):
        error = mine(ratios) - exact(ratios)
        assert error.max() == pytest.approx(-error.min(), rel=1e-5)


def test_the_ellipsoid_law_is_an_ellipse():
    law = ellipsoid_law()
    assert sp.simplify(law.force_formula**2 + (law.couple_formula / (3 * sp.pi / 16)) ** 2) == 1


def test_exact_factors_have_no_error_and_others_have_one():
    assert greatest_errors(Hertz()) == (0, 0)
    assert min(greatest_errors(Uniform())) > 0.02
    wrong = ApproximateFriction("wrong", k / (k + 1), zhuravlev_first_order().couple_formula)
    assert greatest_errors(wrong)[0] > 0.35


@pytest.mark.parametrize(
    "law", [zhuravlev_first_order(), zhuravlev_second_order(), ellipsoid_law()]
)
def test_numbers_at_the_ends(law):
    np.testing.assert_array_equal(law.force([0.0, np.inf, 1e300]), [0, 1, 1])
    np.testing.assert_array_equal(law.couple(np.inf), 0)
    with pytest.raises(InputError, match="at least 0"):
        law.force(-1.0)


@pytest.mark.parametrize("wrong", [0, -1.0, float("inf"), float("nan")])
def test_constants_must_be_positive(wrong):
    with pytest.raises(InputError, match="force constant"):
        zhuravlev_second_order(wrong)
    with pytest.raises(InputError, match="couple constant"):
        zhuravlev_second_order(1, wrong)
