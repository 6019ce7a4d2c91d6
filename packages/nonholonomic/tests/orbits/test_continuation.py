"""Branches of orbits through folds and bifurcations that are known in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from flow.known_maps import DELAYED, HENON, STANDARD, TWICE, TWIST
from flowlanes.errors import InputError
from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.flow.sections.poincare_map import PoincareMap
from flowlanes.orbits.continuation import continue_orbit
from flowlanes.orbits.periodic import find_periodic
from flowlanes.orbits.return_map import ReturnMap, parameters_to_state
from nonholonomic.catalogue import from_catalogue


def events(made, guess, varied, until, **options):
    orbit = find_periodic(made, np.array(guess), hold=(varied,))
    branch = continue_orbit(made, orbit, varied, until, **options)
    return branch, [(event.kind, event.place) for event in branch.events]


def test_doubling_of_the_henon_map():
    branch, found = events(HENON, [0.6, 0.2, 1.4], "a", 0.2)
    assert [kind for kind, _ in found] == ["doubling"]
    assert found[0][1] == pytest.approx(3 * 0.7**2 / 4, abs=1e-13)
    assert branch.places[-1] == pytest.approx(0.2, abs=1e-13)
    assert branch.reason == "a reached 0.2"


def test_a_fold_is_passed():
    branch, found = events(HENON, [0.6, 0.2, 1.4], "a", -1.0, max_iterations=60)
    assert dict(found)["fold"] == pytest.approx(-(0.7**2) / 4, abs=1e-12)
    kinds = [orbit.kind for orbit in branch.orbits]
    assert "attracting node" in kinds
    assert kinds[-1] == "saddle"


def test_a_pair_goes_through_the_unit_circle():
    _, found = events(DELAYED, [0.4, 0.4, 1.7], "a", 2.2)
    assert found == [("torus", pytest.approx(2.0, abs=1e-12))]


def test_two_branches_meet():
    _, found = events(DELAYED, [0.4, 0.4, 1.7], "a", 0.8)
    assert found == [("branch", pytest.approx(1.0, abs=1e-4))]


def test_areas_kept_are_no_bifurcation():
    _, found = events(STANDARD, [np.pi, 0.0, 0.9], "K", 5.0)
    assert found == [("doubling", pytest.approx(4.0, abs=1e-12))]


def test_families_of_more_dimensions_are_refused():
    orbit = find_periodic(TWIST, np.array([0.3, 2.1]), 3)
    with pytest.raises(InputError, match="cannot be held and varied"):
        continue_orbit(TWIST, orbit, "p", 3.0, ("p",))
    with pytest.raises(InputError, match="a family of 2 dimensions"):
        continue_orbit(TWICE, find_periodic(TWICE, np.array([0.3, 1.1, 1.0]), 3), "p", 3.0)


@pytest.mark.slow
def test_a_limit_cycle_is_followed_in_a_parameter():
    """To the same cycle that is found for the last value directly."""
    ball = from_catalogue("unbalanced-rubber-ball-centred")
    hold = {"energy": 0.5, "quadratic": 0.95}
    near = np.array([-1.31476800, 0.10200860, -0.24651476, 0.0, -0.92401353, -0.38235977])
    system = parameters_to_state(ball, "kappa_3")
    made = ReturnMap(PoincareMap(system, poincare_section(system, "gamma_1"), tolerance=1e-15))
    orbit = find_periodic(made, np.append(near, 0.15), hold=hold | {"kappa_3": 0.15})
    branch = continue_orbit(made, orbit, "kappa_3", 0.12, hold)
    last = branch.orbits[-1]
    assert branch.reason == "kappa_3 reached 0.12"
    assert last.kind == "attracting"
    assert last.multipliers.trivial == ("flow", "energy", "quadratic", "kappa_3")
    direct = ReturnMap(
        PoincareMap(ball, poincare_section(ball, "gamma_1"), {"kappa_3": 0.12}, 1e-15)
    )
    same = find_periodic(direct, last.points[0, :6], hold=hold)
    assert last.points[0, :6] == pytest.approx(same.points[0], abs=1e-12)
    assert last.multipliers.values == pytest.approx(same.multipliers.values, abs=1e-11)
