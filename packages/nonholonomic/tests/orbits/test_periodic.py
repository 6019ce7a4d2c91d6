"""Periodic orbits of maps whose orbits are known, and of a system."""

from __future__ import annotations

import numpy as np
import pytest

from flow.known_maps import HENON, STANDARD, TWIST
from flowlanes.errors import InputError
from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.flow.sections.poincare_map import PoincareMap
from flowlanes.orbits.floquet import stability_type
from flowlanes.orbits.periodic import NoOrbitError, find_periodic
from flowlanes.orbits.return_map import ReturnMap, parameters_to_state
from nonholonomic.catalogue import from_catalogue


def test_fixed_point_of_the_henon_map():
    orbit = find_periodic(HENON, np.array([0.6, 0.2, 1.4]), hold=("a",))
    x = (-0.7 + np.sqrt(0.49 + 5.6)) / 2.8
    trace = -2.8 * x
    roots = np.roots([1, -trace, -0.3])
    assert orbit.points[0] == pytest.approx([x, 0.3 * x, 1.4], abs=1e-15)
    assert sorted(orbit.multipliers.values.real) == pytest.approx(sorted(roots), abs=1e-14)
    assert orbit.kind == "saddle"
    assert orbit.multipliers.trivial == ("a",)


def test_orbit_of_two_points_of_the_henon_map():
    orbit = find_periodic(HENON, np.array([0.9, -0.1, 1.4]), 2, {"a": 1.4})
    # x and its image are the roots of a²x² − a(1 − b)x + (1 − b)² − a
    assert sorted(orbit.points[:, 0]) == pytest.approx(
        sorted(np.roots([1.96, -0.98, 0.49 - 1.4])), abs=1e-14
    )
    assert np.prod(orbit.multipliers.values) == pytest.approx(0.09, abs=1e-14)
    assert orbit.gap < 1e-15


@pytest.mark.parametrize(("place", "kind"), [(0.1, "saddle"), (3.0, "elliptic")])
def test_fixed_points_of_the_standard_map(place, kind):
    orbit = find_periodic(STANDARD, np.array([place, 0.1, 0.9]), hold=("K",))
    trace = 2 + 0.9 * np.cos(orbit.points[0, 0])
    assert orbit.kind == kind
    assert orbit.multipliers.values.sum() == pytest.approx(trace, abs=1e-14)


def test_turns_of_angles_are_counted():
    orbit = find_periodic(STANDARD, np.array([3.1, 3.1, 0.9]), 2, ("K",))
    assert orbit.turns.tolist() == [1, 0, 0]
    assert orbit.points[:, 1] == pytest.approx([np.pi, np.pi], abs=1e-14)


def test_family_is_reached_where_it_is_next():
    orbit = find_periodic(TWIST, np.array([0.3, 2.1]), 3)
    assert orbit.points[:, 1] == pytest.approx([2 * np.pi / 3] * 3, abs=1e-15)
    assert orbit.kind == "neutral"
    assert orbit.multipliers.trivial == ("p",)


@pytest.mark.parametrize(
    ("values", "kind"),
    [
        ([0.5], "attracting"),
        ([-1.5], "repelling"),
        ([1.0], "neutral"),
        ([0.5, 0.2], "attracting node"),
        ([0.3 + 0.4j, 0.3 - 0.4j], "attracting focus"),
        ([2 + 1j, 2 - 1j], "repelling focus"),
        ([2.0, 0.5], "saddle"),
        ([0.6 + 0.8j, 0.6 - 0.8j], "elliptic"),
        ([-1.0, -1.0], "neutral"),
        ([2.0, 0.5, 0.6 + 0.8j, 0.6 - 0.8j], "saddle and elliptic"),
        ([1.0, 0.5], "undecided"),
        ([], "neutral"),
    ],
)
def test_kinds(values, kind):
    assert stability_type(np.array(values, dtype=complex), np.full(len(values), 1e-9)) == kind


@pytest.mark.slow
def test_closed_orbit_of_a_ball_on_a_sphere():
    """It turns about its third axis, along a great circle."""
    system = parameters_to_state(from_catalogue("rubber-ball-of-ratio"), "k")
    made = ReturnMap(PoincareMap(system, poincare_section(system, "n_2")))
    start = np.array([0.0, 0.0, 0.5, -1.0, 0.0, 0.0, 1.0])
    orbit = find_periodic(made, start, hold=("energy", "k"))
    assert orbit.duration == pytest.approx(4 * np.pi, abs=1e-11)
    assert set(orbit.multipliers.trivial) == {"flow", "energy", "k"}
    assert np.prod(orbit.multipliers.values).real == pytest.approx(1, abs=1e-10)
    assert orbit.multipliers.errors.max() < 1e-6


def test_mistakes_are_told():
    with pytest.raises(InputError, match="hold: 'b' is not an integral"):
        find_periodic(HENON, np.zeros(3), hold=("b",))
    with pytest.raises(InputError, match="period = 0"):
        find_periodic(HENON, np.zeros(3), 0)
    with pytest.raises(InputError, match="guess: its shape"):
        find_periodic(HENON, np.zeros(2))
    with pytest.raises(InputError, match="no parameter q"):
        parameters_to_state(from_catalogue("rubber-ball-of-ratio"), "q")


def test_no_orbit_is_said_to_be_found_where_there_is_none():
    with pytest.raises(NoOrbitError, match="no periodic orbit"):
        find_periodic(HENON, np.array([0.6, 0.2, -1.0]), hold=("a",))


@pytest.mark.parametrize("scale", [1e-15, 1e5, 1e15])
def test_orbits_are_the_same_in_all_units(scale):
    # moments of inertia and (mass times length²) in other units: centimetres, grams
    ball = from_catalogue("unbalanced-rubber-ball-centred")
    near = np.array([-1.15, 0.31, -0.13, 0.19, 0.905, 0.38])
    near[3:] /= np.linalg.norm(near[3:])
    near[:3] -= near[3:] * (near[:3] @ near[3:])
    found = []
    for factor in (1.0, scale):
        numbers = {str(symbol): factor * value for symbol, value in ball.defaults.items()}
        made = ReturnMap(PoincareMap(ball, poincare_section(ball, "gamma_1"), numbers))
        hold = {"energy": 0.5 * factor, "quadratic": 0.95 * factor**2}
        found.append(find_periodic(made, made.section.iterate(near[None], 100)[0], hold=hold))
    plain, scaled = found
    assert scaled.values["energy"] == pytest.approx(0.5 * scale, rel=1e-11)
    assert scaled.values["quadratic"] == pytest.approx(0.95 * scale**2, rel=1e-11)
    assert scaled.duration == pytest.approx(plain.duration, rel=1e-10)
    assert scaled.multipliers.values == pytest.approx(plain.multipliers.values, rel=1e-7)
    assert scaled.multipliers.trivial == plain.multipliers.trivial
