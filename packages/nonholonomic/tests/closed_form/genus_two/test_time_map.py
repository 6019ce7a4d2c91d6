import numpy as np
import pytest
from flint import arb

from closed_form.followed_states import GAMMA, OMEGA, solution, without
from flowlanes.formulas.balls import number
from nonholonomic.closed_form.separations.veselova import veselova

CLOCK = solution(veselova(), without(OMEGA, GAMMA), GAMMA).clock


def test_the_clock_and_its_inverse() -> None:
    times = np.array([0.0, 1.0, -7.5, 1e3])
    moment = CLOCK.torus_point(times)
    value, rate = CLOCK.flow.quasi(moment.v, moment.tau)
    assert CLOCK.flow.mean * moment.tau + value == pytest.approx(times, rel=1e-14, abs=1e-14)
    assert np.all(CLOCK.flow.mean + rate > 0)


def test_phases_grow_as_tau() -> None:
    moment = CLOCK.torus_point(np.array([2.5]))
    expected = CLOCK.v_0 + CLOCK.V * moment.tau[0]
    turns = (moment.v[0] - expected) / 4
    assert turns == pytest.approx(np.round(turns), abs=1e-14)


def test_the_mean_has_more_digits_than_a_double() -> None:
    assert CLOCK.mean.rad() < arb("1e-27")
    assert number(CLOCK.mean) == pytest.approx(CLOCK.flow.mean, rel=1e-15)
