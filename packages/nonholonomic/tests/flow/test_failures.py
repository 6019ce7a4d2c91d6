"""Runs that cannot be carried to their end keep what they have."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError, RunError
from flowlanes.flow.integrator import integrate
from flowlanes.system.system import Guard, System
from nonholonomic.catalogue import CATALOGUE, from_catalogue
from nonholonomic.starts import initial_state

x = sp.Symbol("x", real=True)


def scalar(rate: sp.Expr, **parts: object) -> System:
    return System(name="scalar", title="Scalar", field={x: rate}, **parts)


def failure(*arguments: object, **options: object) -> RunError:
    with pytest.raises(RunError) as caught:
        integrate(*arguments, **options)
    error = caught.value
    assert error.time == float(error.partial.times[-1])
    assert len(error.partial.times) == len(error.partial.states)
    assert str(error) == f"{error.reason} (the last good time is {error.time:.9g})"
    return error


@pytest.fixture(scope="module")
def ball():
    entry = CATALOGUE["chaplygin-ball"]
    system = entry.system()
    return system, initial_state(system, entry.start.omega, entry.start.gamma)


@pytest.mark.parametrize("sense", [1, -1], ids=["forward", "backward"])
@pytest.mark.parametrize("precision", ["double", "quad"])
def test_a_solution_that_runs_away(precision, sense):
    """x = 1/(1 − t) is infinite at t = 1."""
    times = [0.0, sense * 0.5, sense * 2.0]
    error = failure(scalar(sense * x**2), [1], times, precision=precision)
    assert error.reason.startswith("scalar: the step size collapsed (a singularity")
    assert 1 - 1e-11 < sense * error.time < 1
    assert [float(t) for t in error.partial.times] == [*times[:2], error.time]
    assert float(error.partial["x"][1]) == pytest.approx(2.0, rel=1e-15)
    assert error.partial.events == ()


@pytest.mark.parametrize("sense", [1, -1], ids=["forward", "backward"])
def test_a_solution_with_a_branch_point(sense):
    """x = √(1 − t) ends at t = 1, with infinite velocity."""
    error = failure(scalar(-sense / (2 * x)), [1], [0.0, sense * 0.75, sense * 2.0], dense=True)
    assert sense * error.time == pytest.approx(1.0, abs=1e-10)
    assert error.partial["x"][1] == pytest.approx(0.5, rel=1e-14)
    assert error.partial["x"][-1] < 1e-4
    assert np.all(np.isfinite(error.partial.states))
    assert error.partial.dense.span == (0.0, error.time)
    assert error.partial.dense(sense * 0.36)[0, 0] == pytest.approx(0.8, rel=1e-14)


def test_a_guard_that_vanishes_at_the_singularity_is_what_happened():
    ended = scalar(-1 / (2 * x), guards=(Guard("positive", x, "x has come to zero"),))
    motion = integrate(ended, [1], [0.0, 0.75, 2.0])
    (message,) = motion.events
    assert message.guard.message == "x has come to zero"
    assert message.is_terminal
    assert message.time == motion.times[-1] == pytest.approx(1.0, abs=1e-10)


@pytest.mark.parametrize(
    "guard",
    [
        Guard("large", x, "it grows"),
        Guard("left", 1 + 1 / x, "half of it is left"),
        Guard("contact", 1 / x, "it vanishes, but the equations hold beyond", lift_off=True),
    ],
    ids=lambda guard: guard.name,
)
def test_another_guard_is_not_blamed(guard):
    error = failure(scalar(x**2, guards=(guard,)), [1], [0.0, 2.0])
    assert error.reason.startswith("scalar: the step size collapsed")
    assert error.partial.events == ()


def test_a_field_that_is_no_number_at_the_start():
    with pytest.raises(InputError, match=r"^start: the rate of the state is no number there; "):
        integrate(scalar(sp.log(x)), [-1], [0.0, 1.0])


def test_the_time_limit(ball):
    system, start = ball
    error = failure(system, start, np.linspace(0.0, 1e7, 11), time_limit=0.05)
    assert error.reason == "chaplygin-ball: the time limit of 0.05 s was reached"
    assert 0 < error.time < 1e7
    assert error.partial.statistics.seconds < 5
    assert error.partial.statistics.steps > 0
    energy = error.partial.records["law_energy"]
    assert abs(energy[-1] - energy[0]) < 1e-13 * energy[0]


def test_within_the_time_limit_nothing_happens(ball):
    system, start = ball
    limited = integrate(system, start, [0.0, 10.0], time_limit=1000.0)
    assert limited.states.tolist() == integrate(system, start, [0.0, 10.0]).states.tolist()


def test_an_interrupt_keeps_the_partial_trajectory(ball):
    system, start = ball
    seen = []

    def interrupt(fraction: float) -> None:
        seen.append(fraction)
        if len(seen) == 3:
            raise KeyboardInterrupt

    times = np.linspace(0.0, 1000.0, 1001)
    error = failure(system, start, times, progress=interrupt, dense=True)
    assert error.reason == "chaplygin-ball: interrupted"
    assert error.time == pytest.approx(1000 * seen[-1])
    whole = integrate(system, start, times[times < error.time])
    count = len(whole.times)
    assert count > 10
    assert len(error.partial.times) == count + 1
    assert np.abs(error.partial.states[:count] - whole.states).max() < 1e-12
    assert error.partial.dense.span == (0.0, error.time)


def test_another_error_in_progress_is_not_swallowed(ball):
    system, start = ball

    def fail(fraction: float) -> None:
        raise ZeroDivisionError(fraction)

    with pytest.raises(ZeroDivisionError):
        integrate(system, start, [0.0, 100.0], progress=fail)


def test_after_a_failure_the_next_run_is_as_good_as_ever(ball):
    system, start = ball
    before = integrate(system, start, [0.0, 5.0])
    failure(system, start, [0.0, 1e7], time_limit=0.01)
    assert integrate(system, start, [0.0, 5.0]).states.tolist() == before.states.tolist()


def test_a_quantity_without_a_value_does_not_stop_a_motion():
    system = from_catalogue("special-veselova-nd")
    rest = {"p": [0.0] * 4, "gamma": [0.6, 0.0, 0.0, 0.8]}
    motion = integrate(system, rest, [0.0, 1.0])
    assert np.isnan(motion["law_quadratic1"]).all()
    assert (motion["law_energy"] == 0.0).all()
    assert (motion.states[1] == motion.states[0]).all()
    assert "undefined along this motion" in str(motion)


def test_what_cannot_be_computed_is_refused_in_a_sentence() -> None:
    with pytest.raises(InputError, match="a system without state has no motion"):
        integrate(System("o", "O", {}), (), [0.0, 1.0])
    with pytest.raises(InputError, match="a number of about 1e400"):
        integrate(scalar(sp.Integer(10) ** 400 * x), (1.0,), [0.0, 1.0])


@pytest.mark.parametrize(
    ("method", "words"), [("taylor", "Taylor series"), ("gauss", "Gauss–Legendre collocation")]
)
def test_the_integrator_names_itself(method: str, words: str) -> None:
    statistics = integrate(scalar(-x), (1.0,), [0.0, 1.0], method=method).statistics
    assert statistics.integrator == f"{words} of order {statistics.order}, {statistics.steps} steps"


def test_motions_are_read_only() -> None:
    motion = integrate(scalar(-x), (1.0,), [0.0, 1.0])
    for array in (motion.times, motion.states, *motion.records.values()):
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0.0
