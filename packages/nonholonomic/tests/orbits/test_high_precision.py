"""Orbits with 30 digits."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.flow.sections.poincare_map import PoincareMap
from flowlanes.orbits.high_precision import refine_orbit
from flowlanes.orbits.periodic import find_periodic
from flowlanes.orbits.return_map import ReturnMap
from nonholonomic.catalogue import from_catalogue
from nonholonomic.catalogue.ball_on_sphere import rubber_ball_ratio


@pytest.mark.slow
def test_a_period_in_closed_form():
    """A ball that turns about its third axis along a great circle: k ω T = 2π."""
    system = rubber_ball_ratio.rolling().with_laws(rubber_ball_ratio.ENERGY)
    made = ReturnMap(PoincareMap(system, poincare_section(system, "n_2"), {"k": -0.5}))
    guess = np.array([1e-3, 0.0, 0.7, 1.0, 0.0, 0.0])
    # the energy of ω = 0.7 about an axis with the moment 3.1, as a double
    energy = 3.1 * 0.7**2 / 2
    orbit = find_periodic(made, guess, hold={"energy": energy})
    found = refine_orbit(made, orbit, {"energy": energy})
    with mpmath.workdps(40):
        omega = mpmath.sqrt(2 * mpmath.mpf(energy) / mpmath.mpf(3.1))
        assert abs(found.duration - 4 * mpmath.pi / omega) < 1e-28
        assert abs(found.point[2] - omega) < 1e-29


@pytest.mark.slow
def test_limit_cycle_against_the_orbit_in_doubles():
    ball = from_catalogue("unbalanced-rubber-ball-centred")
    made = ReturnMap(PoincareMap(ball, poincare_section(ball, "gamma_1"), tolerance=1e-15))
    near = np.array([-1.31476800, 0.10200860, -0.24651476, 0.0, -0.92401353, -0.38235977])
    hold = {"energy": 0.5, "quadratic": 0.95}
    orbit = find_periodic(made, near, hold=hold)
    found = refine_orbit(made, orbit, hold)
    assert found.error < 1e-28
    assert [float(x) for x in found.point] == pytest.approx(orbit.points[0].tolist(), abs=1e-12)
    assert float(found.duration) == pytest.approx(orbit.duration, abs=1e-12)
