"""The limit set of a patch at rest: formulas under Hertz's pressure, numbers under any."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from contact.patches import exact_factors
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from nonholonomic.contact.pressure.pressure import Hertz, PowerPressure, Ring, Uniform
from nonholonomic.contact.pressure.pressure_approximations import ellipsoid_law
from nonholonomic.contact.pressure.pressure_limits import (
    COUPLE_AT_ONE,
    FORCE_AT_ONE,
    hertz_limit,
    load_factor,
    slip_ratio,
    x,
    z,
)
from nonholonomic.contact.pressure.pressure_ranges import hertz_ranges, k

LAWS = [Hertz(), Uniform(), Ring(), PowerPressure(0.2), PowerPressure(4), ellipsoid_law()]
laws = pytest.mark.parametrize("law", LAWS, ids=str)
LIMIT = hertz_limit()
HERTZ = Hertz()


def test_the_inner_curve_is_exact():
    force, couple = hertz_ranges()[0].factors()
    w = sp.Symbol("w", positive=True)
    root = sp.sqrt(8 * z / sp.pi - sp.Rational(1, 2))
    # k² = w: the root is (1 − 3k²/4) in magnitude, and positive up to k = 1
    square = sp.expand((root**2).subs(z, couple.subs(k, sp.sqrt(w))))
    assert sp.factor(square) == sp.factor((1 - 3 * w / 4) ** 2)
    at = LIMIT.greatest_force_squared.subs(root, 1 - 3 * w / 4)
    assert sp.expand(at - force.subs(k, sp.sqrt(w)) ** 2) == 0


def test_values_at_the_corner():
    assert sp.simplify(LIMIT.greatest_couple.subs(x, 0)) == 3 * sp.pi / 16
    assert sp.simplify(LIMIT.greatest_force_squared.subs(z, COUPLE_AT_ONE)) == FORCE_AT_ONE**2
    assert sp.simplify(LIMIT.greatest_force_squared.subs(z, 3 * sp.pi / 16)) == 0
    with mp.workdps(30):
        assert abs(LIMIT.greatest_couple.subs(x, FORCE_AT_ONE).n(30) - COUPLE_AT_ONE.n(30)) < 1e-28


@pytest.mark.parametrize(
    ("formula", "given", "ratios", "tolerance"),
    [
        ("greatest_couple", x, np.linspace(0, 1, 60), 1e-15),
        ("greatest_force_squared", z, np.linspace(0, 1, 60), 1e-15),
        ("greatest_force", z, 1 + np.geomspace(1e-12, 1e6, 100), 1e-15),
    ],
)
def test_formulas_follow_the_curve(formula, given, ratios, tolerance):
    function = sp.lambdify(given, getattr(LIMIT, formula), "numpy")
    with mp.workdps(40):
        force, couple = np.array([exact_factors(0.5, r) for r in ratios]).T
    if formula == "greatest_force_squared":
        values, expected = couple, force**2
    elif formula == "greatest_force":
        values, expected = couple, force
    else:
        values, expected = force, couple
    # compared where the rounded argument is
    computed = function(values.astype(float))
    assert np.abs(computed - expected.astype(float)).max() < tolerance


def test_the_outer_part_is_not_smooth_in_the_couple_itself():
    # without the square root the same degree loses five digits: δ^(5/2) at the corner
    t = np.cos(np.pi * (np.arange(27) + 0.5) / 27)
    dense = np.linspace(1, 40, 4000)
    corner = float(COUPLE_AT_ONE)
    at = corner * (1 + t) / 2
    forces = sp.lambdify(z, LIMIT.greatest_force, "numpy")(at)
    plain = np.polynomial.Chebyshev.fit(at, forces, 26, domain=[0, corner])
    error = np.abs(plain(HERTZ.couple(dense)) - HERTZ.force(dense)).max()
    assert 1e-11 < error < 1e-9


def test_margins_are_positive_inside_and_negative_outside():
    couple, inner, outer = (
        sp.lambdify((x, z), margin, "numpy")
        for margin in (LIMIT.couple_margin, LIMIT.inner_force_margin, LIMIT.outer_force_margin)
    )
    random = np.random.default_rng(5)
    r = np.concatenate([random.uniform(0, 1, 200), 1 / random.uniform(0, 1, 200)])
    for scale, sign in ((0.999, 1), (1.001, -1)):
        force, torque = scale * HERTZ.force(r), scale * HERTZ.couple(r)
        low = force <= float(FORCE_AT_ONE)
        assert np.all(np.sign(couple(force[low], torque[low])) == sign)
        high = torque >= float(COUPLE_AT_ONE)
        assert np.all(np.sign(inner(force[high], torque[high])) == sign)
        assert np.all(np.sign(outer(force[~high], torque[~high])) == sign)


@laws
def test_the_ratio_of_a_load_is_that_of_its_ray(law):
    ratios = np.geomspace(1e-5, 1e5, 101)
    for scale in (1e-3, 1.0, 30.0):
        force, couple = scale * law.force(ratios), scale * law.couple(ratios)
        np.testing.assert_allclose(slip_ratio(law, force, couple), ratios, rtol=1e-13)
        np.testing.assert_allclose(load_factor(law, force, couple), scale, rtol=1e-14)


@laws
def test_axes_and_extreme_loads(law):
    assert slip_ratio(law, 0.3, 0) == np.inf
    assert slip_ratio(law, 0, 0.3) == 0
    assert load_factor(law, 0.3, 0) == 0.3
    assert load_factor(law, 0, 0.3) == pytest.approx(0.3 / law.couple(0), rel=1e-15)
    np.testing.assert_array_equal(load_factor(law, [[0.0], [0.0]], [0.0]), [[0], [0]])
    k = slip_ratio(law, [1e-200, 1e200], [1e200, 1e-200])
    np.testing.assert_array_equal(k, [0, np.inf])
    tiny = slip_ratio(law, 1e-140, 1.0)
    assert law.force(tiny) / law.couple(tiny) == pytest.approx(1e-140, rel=1e-12)


def test_load_factor_and_margin_agree():
    random = np.random.default_rng(9)
    force, couple = random.uniform(0, 1.1, 400), random.uniform(0, 0.65, 400)
    inside = load_factor(HERTZ, force, couple) < 1
    low = couple >= float(COUPLE_AT_ONE)
    margins = np.where(
        low,
        sp.lambdify((x, z), LIMIT.inner_force_margin)(force, np.maximum(couple, 9 * np.pi / 128)),
        sp.lambdify((x, z), LIMIT.outer_force_margin)(force, np.minimum(couple, 0.22)),
    )
    np.testing.assert_array_equal(inside, margins > 0)
    assert 50 < inside.sum() < 350


def test_the_flow_is_along_the_normal_of_the_limit_set():
    # greatest power lost: over all held loads, x k + z is greatest at (F(k), M(k))
    random = np.random.default_rng(2)
    force, couple = random.uniform(0, 1, 300), random.uniform(0, 0.6, 300)
    scale = load_factor(HERTZ, force, couple)
    for ratio in (0.2, 0.9, 1.3, 5.0):
        power = (force * ratio + couple) / scale
        assert power.max() <= HERTZ.force(ratio) * ratio + HERTZ.couple(ratio)
        assert power.max() > 0.99 * (HERTZ.force(ratio) * ratio + HERTZ.couple(ratio))


@pytest.mark.parametrize("pair", [(-0.1, 0.2), (0.1, -0.2), (np.nan, 0.1), (0.1, np.inf)])
def test_loads_that_are_none_are_refused(pair):
    for function in (slip_ratio, load_factor):
        with pytest.raises(InputError, match="finite and at least 0"):
            function(HERTZ, *pair)


def test_without_load_there_is_no_ratio():
    with pytest.raises(InputError, match="no ratio"):
        slip_ratio(HERTZ, [0.1, 0.0], [0.1, 0.0])


@pytest.mark.slow
def test_the_engine_integrates_the_outer_part_to_the_last_digit():
    # ∫F dM along the curve is ∫F F′ k dk = [kF²/2] − ½∫F² dk
    area = real_symbol("w")
    system = System("limit", "Limit", {z: sp.Integer(-1), area: LIMIT.greatest_force})
    start, end = HERTZ.couple([1.001, 4.0])
    trajectory = integrate(system, [start, 0.0], [0.0, start - end])
    with mp.workdps(20):
        squares = mp.quad(lambda r: exact_factors(0.5, r)[0] ** 2, [1.001, 1.1, 1.5, 4.0])
    force = HERTZ.force([1.001, 4.0])
    exact = (4 * force[1] ** 2 - 1.001 * force[0] ** 2 - float(squares)) / 2
    assert trajectory.states[-1][1] == pytest.approx(exact, abs=2e-15)
