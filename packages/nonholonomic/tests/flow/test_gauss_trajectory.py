"""One motion with everything recorded, by collocation, beside the Taylor series."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError, RunError
from flowlanes.flow.integrator import integrate
from flowlanes.system.system import System
from nonholonomic.catalogue import from_catalogue
from nonholonomic.starts import initial_state

BODIES = {
    "chaplygin-ball": ((0.7, 0.4, 1.1), (0.2, -0.3, 0.93), 20.0),
    "rattleback": ((0.01, 0.02, -5.0), (0.0, 0.0, 1.0), 1.0),
    "heavy-disk": ((0.1, 0.2, 1.0), (0.9, 0.1, 0.4), 3.0),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", BODIES)
def test_what_is_recorded_is_what_taylor_series_give(name: str) -> None:
    system = from_catalogue(name)
    omega, gamma, end = BODIES[name]
    start = initial_state(system, omega, gamma)
    times = np.linspace(0.0, end, 9)
    taylor = integrate(system, start, times)
    gauss = integrate(system, start, times, method="gauss")
    assert gauss.system == taylor.system
    assert list(gauss.records) == list(taylor.records)
    assert np.abs(gauss.states - taylor.states).max() < 1e-12
    for quantity, values in taylor.records.items():
        assert gauss.records[quantity].shape == values.shape
        assert np.abs(gauss.records[quantity] - values).max() < 1e-10 * (1 + np.abs(values).max())


@pytest.mark.slow
def test_thirty_digits_are_those_of_the_reference() -> None:
    system = from_catalogue("veselova")
    start = initial_state(system, (0.7, 0.4, -0.0215053763440860), (0.2, -0.3, 0.93))
    times = [0.0, 5.0]
    reference = integrate(system, start, times, precision="quad", tolerance=1e-32)
    found = integrate(system, start, times, precision="quad", method="gauss")
    with mpmath.workdps(40):
        errors = [
            abs(mine - mpmath.mpf(str(theirs)))
            for mine, theirs in zip(found.states[-1], reference.states[-1], strict=True)
        ]
    assert max(errors) < 1e-28


@pytest.mark.slow
def test_backward_leads_back() -> None:
    system = from_catalogue("chaplygin-ball")
    start = initial_state(system, (0.7, 0.4, 1.1), (0.2, -0.3, 0.93))
    there = integrate(system, start, [0.0, 30.0], method="gauss").states[-1]
    back = integrate(system, there, [30.0, 0.0], method="gauss")
    assert list(back.times) == [30.0, 0.0]
    assert np.abs(back.states[-1] - np.array([float(x) for x in start])).max() < 1e-13


@pytest.mark.slow
def test_lift_off_ends_a_run_where_taylor_series_end_it() -> None:
    system = from_catalogue("marble-body")
    start = initial_state(system, (8.0, 3.0, 1.0), (0.3, 0.2, 0.93))
    times = np.linspace(0.0, 2.0, 21)
    taylor = integrate(system, start, times)
    gauss = integrate(system, start, times, method="gauss")
    assert [h.guard for h in gauss.events] == [h.guard for h in taylor.events]
    assert gauss.events[0].time == pytest.approx(taylor.events[0].time, abs=1e-11)
    assert gauss.times[-1] == gauss.events[0].time
    on = integrate(system, start, times, method="gauss", on_liftoff="warn")
    assert on.times[-1] == 2.0


def test_a_singularity_is_an_error_that_carries_the_trajectory() -> None:
    x = sp.Symbol("x", real=True)
    explosion = System("explosion", "Explosion", {x: x**2})
    with pytest.raises(RunError, match="step size collapsed") as caught:
        integrate(explosion, [1.0], [0.0, 0.5, 2.0], method="gauss")
    assert caught.value.time == pytest.approx(1.0, abs=1e-9)
    assert caught.value.partial.states[-1][0] == pytest.approx(2.0, abs=1e-14)


@pytest.mark.parametrize(
    ("asked", "sentence"),
    [
        ({"tolerance": 1e-12}, "tolerance: method 'gauss' has none"),
        ({"dense": True}, "dense: method 'gauss' has none"),
        ({"time_limit": 1.0}, "time_limit: method 'gauss' has none"),
    ],
)
def test_what_the_method_has_not_is_refused(asked: dict[str, Any], sentence: str) -> None:
    system = from_catalogue("veselova")
    with pytest.raises(InputError, match=sentence):
        integrate(system, [0.0] * 6, [0.0, 1.0], method="gauss", **asked)


def test_an_unknown_method_is_refused() -> None:
    system = from_catalogue("veselova")
    with pytest.raises(InputError, match="must be 'taylor' or 'gauss'"):
        integrate(system, [0.0] * 6, [0.0, 1.0], method="euler")
