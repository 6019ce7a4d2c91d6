"""Hertz's factors in three ranges: exact relations, accuracy, and how the ranges meet."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from contact.patches import exact_factors, relative_error
from flowlanes.flow.integrator import integrate
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from nonholonomic.contact.pressure.pressure import Hertz
from nonholonomic.contact.pressure.pressure_ranges import INNER_BOUND, OUTER_BOUND, hertz_ranges, k

INNER, MIDDLE, OUTER = hertz_ranges()


def test_the_ranges_cover_every_ratio():
    bounds = [(r.lower, r.upper) for r in hertz_ranges()]
    assert bounds == [(0, INNER_BOUND), (INNER_BOUND, OUTER_BOUND), (OUTER_BOUND, sp.oo)]


@pytest.mark.parametrize("part", hertz_ranges(), ids=lambda part: part.name)
def test_accuracy_in_floating_point_numbers(part):
    low, high = float(part.lower), min(float(part.upper), 1e3)
    ratios = np.concatenate(
        [low + (high - low) * np.array([1e-12, 1e-9, 1e-6, 1e-3]), np.linspace(low, high, 60)[1:]]
    )
    function = sp.lambdify(k, part.factors(), "math")
    with mp.workdps(40):
        values = zip(*map(function, ratios.tolist()), strict=True)
        exact = zip(*(exact_factors(0.5, x) for x in ratios), strict=True)
        force, couple = map(relative_error, values, exact)
    assert force < 1e-15
    assert couple < 4e-15


@pytest.mark.parametrize("part", (INNER, MIDDLE), ids=lambda part: part.name)
def test_couple_and_force_are_tied(part):
    force, couple = part.factors()
    difference = sp.diff(couple, k) + k * sp.diff(force, k)
    assert (
        sp.simplify(difference.xreplace({k: sp.sqrt(1 + sp.Symbol("s", positive=True) ** 2)})) == 0
    )


def test_couple_and_force_of_the_series_are_tied():
    # (2n + 1) m_n = −2(n + 1) f_{n+1}, from dM = −k dF
    force = sp.Poly(OUTER.force, OUTER.argument).all_coeffs()[::-1]
    couple = sp.Poly(OUTER.couple, OUTER.argument).all_coeffs()[::-1]
    assert all(c.is_Rational for c in (*force, *couple))
    assert (force[0], force[1], couple[0]) == (1, sp.Rational(-1, 10), sp.Rational(1, 5))
    for n, (m, f) in enumerate(zip(couple, force[1:], strict=False)):
        assert (2 * n + 1) * m == -2 * (n + 1) * f
    assert min(len(force), len(couple)) >= 16


def test_inner_and_middle_meet_with_two_derivatives_of_the_force():
    # in s = √(k² − 1): the two forms of F differ by s⁵/5, those of M by −s⁵/5, to lowest order
    s = sp.Symbol("s", positive=True)
    for inner, middle, sign in zip(INNER.factors(), MIDDLE.factors(), (1, -1), strict=True):
        difference = (middle - inner).xreplace({sp.sqrt((k - 1) * (k + 1)): s})
        difference = difference.xreplace({k: sp.sqrt(1 + s**2)})
        assert sp.series(difference, s, 0, 6).removeO() == sign * s**5 / 5


def test_middle_and_outer_meet():
    with mp.workdps(40):
        bound = mp.mpf(int(OUTER_BOUND))
        for middle, outer in zip(MIDDLE.factors(), OUTER.factors(), strict=True):
            one, other = (sp.lambdify(k, form, "mpmath") for form in (middle, outer))
            for order in range(4):
                gap = mp.diff(one, bound, order) - mp.diff(other, bound, order)
                # each derivative brings one factor of the series' degree, about 2·20/k
                assert abs(gap) < 1e-17 * 20**order
            assert abs(one(bound) - other(bound)) > 1e-22, "the series is longer than needed"


def test_the_formulas_are_the_numbers():
    x = np.linspace(0.01, 5, 200)
    for part in hertz_ranges():
        inside = x[(x > float(part.lower)) & (x < float(part.upper))]
        force, couple = sp.lambdify(k, part.factors(), "numpy")(inside)
        np.testing.assert_allclose(force, Hertz().force(inside), rtol=1e-15)
        np.testing.assert_allclose(couple, Hertz().couple(inside), rtol=4e-15)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("part", "start", "end"),
    [(INNER, 0.1, 1.0), (MIDDLE, 1 + 1e-6, 2.0), (OUTER, 2.0, 6.0)],
    ids=["inner", "middle", "outer"],
)
def test_the_engine_integrates_them_to_the_last_digit(part, start, end):
    # ∫F dk = φ, and φ = M + kF
    impulse = real_symbol("w")
    force, _ = part.factors()
    system = System("sliding", "Sliding", {k: sp.Integer(1), impulse: force})
    trajectory = integrate(system, [start, 0.0], [0.0, end - start])
    phi = Hertz().couple([start, end]) + [start, end] * Hertz().force([start, end])
    assert trajectory.states[-1][1] == pytest.approx(phi[1] - phi[0], abs=2e-15)
