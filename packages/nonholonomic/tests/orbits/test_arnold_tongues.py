"""Tongues of the circle map, whose edges are known."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from flow.known_maps import TURN, arnold
from flowlanes.errors import InputError
from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.flow.sections.poincare_map import PoincareMap
from flowlanes.orbits.arnold_tongues import displacement, locked_interval, plateaus, staircase
from flowlanes.orbits.return_map import Circle
from nonholonomic.catalogue.bodies.unbalanced_rubber_ball_centred import torus


def test_edges_of_the_main_tongue():
    found = locked_interval(arnold(0.8), Fraction(0), (-0.3, 0.3), 1e-15)
    assert (found.low, found.high) == pytest.approx((-0.8 / TURN, 0.8 / TURN), abs=1e-14)
    assert found.slope == pytest.approx(1.0)
    assert found.open


def test_width_of_the_tongue_of_one_half():
    """K²/(4π) to leading order, relative corrections of order K²."""
    for coupling in (1e-2, 1e-3):
        found = locked_interval(arnold(coupling), Fraction(1, 2), (0.4, 0.6), 1e-15)
        assert found.width == pytest.approx(coupling**2 / (2 * TURN), rel=coupling**2)


def test_a_rotation_has_no_steps():
    found = locked_interval(arnold(0.0), Fraction(2, 5), (0.3, 0.5))
    assert not found.open
    assert found.width < 1e-14


def test_all_steps_of_a_staircase():
    maps = arnold(0.8)
    stairs = staircase(maps, np.linspace(0.01, 0.99, 120))
    assert (np.diff(stairs.rotations) > -1e-9).all()
    found = plateaus(maps, stairs, 4)
    assert [str(step.fraction) for step in found] == ["1/4", "1/3", "1/2", "2/3", "3/4"]
    for step, other in zip(found, reversed(found), strict=True):
        assert step.width == pytest.approx(other.width, rel=1e-9)
    inside = np.array([sum((step.low, step.high)) / 2 for step in found])
    wanted = [float(step.fraction) for step in found]
    assert staircase(maps, inside).rotations == pytest.approx(wanted, abs=1e-9)


def test_extrema_of_a_displacement():
    found = displacement(arnold(0.5), 0.1, Fraction(0))
    assert (found.least, found.greatest) == pytest.approx(
        (0.1 - 0.5 / TURN, 0.1 + 0.5 / TURN), abs=1e-14
    )
    assert found.where == pytest.approx((0.25, 0.75), abs=1e-7)


def test_a_bracket_without_the_step_is_refused():
    with pytest.raises(InputError, match="does not pass 1/2"):
        locked_interval(arnold(0.5), Fraction(1, 2), (0.1, 0.2))


def test_step_of_the_unbalanced_rubber_ball():
    """Around the torus F/2H = 0.95, on which a limit cycle is proven; none when balanced."""
    made = torus()
    offsets = {"kappa_1": 0.05, "kappa_2": -0.1, "kappa_3": 0.15}
    moments = {"J_1": 0.5, "J_2": 2.75, "J_3": 2.8}
    across = poincare_section(made, "beta", angle=True)

    def step(share):
        values = moments | {name: share * offset for name, offset in offsets.items()}
        maps = Circle(PoincareMap(made, across, values), "alpha", "lambda", {"beta": 0.0})
        return locked_interval(maps, Fraction(2), (0.8, 1.1))

    wide, flat = step(1.0), step(0.0)
    assert wide.low < 0.95 < wide.high
    assert wide.width == pytest.approx(0.14306, abs=1e-5)
    assert not flat.open
    assert flat.error < 1e-11
