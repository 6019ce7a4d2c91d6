"""Rotation numbers that are known."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

from flow.known_maps import TURN, arnold
from flowlanes.errors import InputError
from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.flow.sections.poincare_map import PoincareMap
from flowlanes.orbits.return_map import rotations
from flowlanes.orbits.rotation import (
    average,
    frequency,
    rotation,
    rotation_number,
    simplest,
    unwrapped_turns,
)
from nonholonomic import from_catalogue

GOLDEN = (np.sqrt(5) - 1) / 2


def wavy(count):
    """A rotation by the golden mean in another coordinate."""
    turns = 0.1 + GOLDEN * np.arange(count + 1)
    return turns + 0.1 * np.sin(TURN * turns)


def test_ten_digits_of_a_quasi_periodic_motion():
    found = rotation_number(wavy)
    assert found.value == pytest.approx(GOLDEN, abs=1e-10)
    assert abs(found.value - GOLDEN) <= found.error
    assert found.verdict == "quasi-periodic"
    assert found.fraction is None


def test_the_average_beats_the_plain_mean():
    values = np.diff(wavy(4000))
    mean, error = average(values)
    assert abs(mean - GOLDEN) < 1e-14
    assert abs(values.mean() - GOLDEN) > 1e-6
    assert error < 1e-10


def test_locked_motion_and_its_approach():
    found = rotation_number(lambda n: arnold(0.8)(np.array([0.1]), np.array([0.5]), n)[0])
    points = arnold(0.8)(np.array([0.1]), np.array([0.5]), 400)[0, -2:]
    factor = np.prod(1 - 0.8 * np.cos(TURN * points))
    assert (found.verdict, found.fraction) == ("locked", Fraction(1, 2))
    assert found.approach == pytest.approx(factor, rel=1e-3)
    assert found.value == pytest.approx(0.5, abs=1e-12)


def test_an_orbit_that_is_closed_from_the_start():
    found = rotation(0.25 * np.arange(1000))
    assert (found.verdict, found.fraction) == ("closed", Fraction(1, 4))
    assert found.value == pytest.approx(0.25, abs=1e-15)


def test_at_the_edge_of_a_step_nothing_is_decided():
    """The approach to a neutral cycle is not geometric."""
    edge = 0.8 / TURN
    found = rotation(arnold(0.8)(np.array([0.1]), np.array([edge]), 4000)[0])
    assert found.verdict == "undecided"


def test_lift_of_an_angle():
    turns = arnold(0.8)(np.array([0.1]), np.array([0.45]), 3000)[0]
    found = unwrapped_turns(TURN * (turns % 1.0))
    assert np.abs(found - turns).max() < 1e-10


def test_an_angle_without_lift_is_refused():
    chaotic = np.random.default_rng(4).uniform(0, TURN, 2000)
    with pytest.raises(InputError, match="has no lift"):
        unwrapped_turns(chaotic)


def test_frequency_of_a_flow():
    times = np.linspace(0, 500, 5001)
    found, error = frequency(0.3 * times + 0.05 * np.sin(np.sqrt(2) * times), times)
    assert found == pytest.approx(0.3, abs=1e-12)
    assert error < 1e-10
    with pytest.raises(InputError, match="equidistant"):
        frequency(times, times**2)


@pytest.mark.parametrize(
    ("low", "high", "fraction"),
    [(0.3, 0.35, "1/3"), (-0.1, 0.1, "0"), (3.14, 3.15, "22/7"), (-0.26, -0.24, "-1/4")],
)
def test_simplest_fraction(low, high, fraction):
    assert simplest(low, high) == Fraction(fraction)


def test_rotation_numbers_of_many_motions():
    system = from_catalogue("veselova")
    gamma = system.symbols[3:]
    starts = np.array([[0.4, 0.1, 1.0, 1.0, 0.0, -0.4], [0.0, 0.0, 1.0, 1.0, 0.0, 0.0]])
    starts[0, :3] -= (
        starts[0, 3:] * (starts[0, :3] @ starts[0, 3:]) / (starts[0, 3:] @ starts[0, 3:])
    )
    starts[0, 3:] /= np.linalg.norm(starts[0, 3:])
    made = PoincareMap(system, poincare_section(system, str(gamma[1])))
    found = rotations(made, starts, sp.atan2(gamma[2], gamma[0]), 300)
    assert found.outcome.tolist() == [0, 0]
    assert np.isfinite(found.values).all()
    assert found.errors[1] < 1e-12
