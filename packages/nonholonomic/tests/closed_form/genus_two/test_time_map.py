import numpy as np
import pytest
from flint import arb

from closed_form.followed_states import GAMMA, OMEGA, solution, without
from flowlanes.formulas.balls import number
from nonholonomic.closed_form.separations.veselova import veselova


@pytest.fixture(scope="module")
def clock():
    return solution(veselova(), without(OMEGA, GAMMA), GAMMA).clock


def test_the_clock_and_its_inverse(clock) -> None:
    times = np.array([0.0, 1.0, -7.5, 1e3])
    moment = clock.torus_point(times)
    value, rate = clock.flow.quasi(moment.v, moment.tau)
    assert clock.flow.mean * moment.tau + value == pytest.approx(times, rel=1e-14, abs=1e-14)
    assert np.all(clock.flow.mean + rate > 0)


def test_phases_grow_as_tau(clock) -> None:
    moment = clock.torus_point(np.array([2.5]))
    expected = clock.v_0 + clock.V * moment.tau[0]
    turns = (moment.v[0] - expected) / 4
    assert turns == pytest.approx(np.round(turns), abs=1e-14)


def test_the_mean_has_more_digits_than_a_double(clock) -> None:
    assert clock.mean.rad() < arb("1e-27")
    assert number(clock.mean) == pytest.approx(clock.flow.mean, rel=1e-15)
