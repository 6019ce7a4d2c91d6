"""The loop of collocation: how a motion ends, and what its steps depend on."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from flow.small import FENCED, LOGARITHM, OSCILLATOR, RUNAWAY, starts
from flowlanes.flow import gauss as precise_module
from flowlanes.flow.gauss import gauss_integrator
from flowlanes.flow.integrator import integrate
from flowlanes.flow.kernel.equations import equations_of
from flowlanes.flow.kernel.gauss_legendre import gauss_loop
from flowlanes.flow.kernel.outcomes import COLLAPSED, NOT_A_NUMBER, STATUS_MESSAGES, STEPS
from flowlanes.flow.kernel.tableaux import Gauss, gauss
from flowlanes.flow.machine_code import jit as native
from nonholonomic.catalogue import from_catalogue

FAR = pytest.mark.parametrize("end", [3.0, 1e6])


@FAR
def test_a_singularity_is_found_and_named(end: float) -> None:
    """x = x₀/(1 − x₀ t) ends at 1/x₀, however far one wants to go."""
    first = np.array([1.0, 2.0, -1.0, 0.2])
    flow = gauss_integrator(RUNAWAY, [1.0])
    found = flow.propagate(first[:, None], [0.25, end])
    right = [COLLAPSED, COLLAPSED, 0, 0 if end < 5 else COLLAPSED]
    assert found.outcome.tolist() == right
    ends = [1, 0.5, end, end if end < 5 else 5.0]
    np.testing.assert_allclose(found.end_times, ends, rtol=1e-11)
    np.testing.assert_allclose(found.states[:, 0, 0], first / (1 - first / 4), rtol=4e-16)
    assert flow.status_message(COLLAPSED) == STATUS_MESSAGES[COLLAPSED]


@FAR
def test_a_guard_ends_the_motion_at_its_moment(end: float) -> None:
    first = [[1.0, 0.0], [0.0, -1.0], [-1.0, 0.0], [0.0, 3.0]]
    found = gauss_integrator(FENCED, first[0]).propagate(
        first, [0.2, end], {"p": 0.5, "q": [9, 9, 9, 2.0]}
    )
    left, right = len(STATUS_MESSAGES), len(STATUS_MESSAGES) + 1
    assert found.outcome.tolist() == [left, left, left, right]
    angle = np.arcsin(0.5)
    ends = [np.pi / 2 + angle, angle, 0.0, np.arcsin(2 / 3)]
    np.testing.assert_allclose(found.end_times, ends, atol=1e-11)
    assert np.isfinite(found.states[[0, 1, 3], 0]).all()
    assert np.isnan(found.states[:, 1]).all()


@pytest.mark.slow
def test_a_body_that_leaves_the_plane() -> None:
    """Against the moment at which the reference sees the normal force change its sign."""
    system = replace(from_catalogue("rattleback"), reconstruction=None, observables=())
    states = starts("rattleback", 4) * [30, 30, 30, 1, 1, 1]
    found = gauss_integrator(system, states[0]).propagate(states, [1.0])
    assert found.outcome.tolist() == [len(STATUS_MESSAGES)] * 4
    for start, ended in zip(states, found.end_times, strict=True):
        (message,) = integrate(system, start, [0.0, 1.0]).events
        assert ended == pytest.approx(message.time, rel=1e-9)


def test_a_state_that_is_no_number() -> None:
    first = [[1.0, 0.0], [2.0, 0.0], [-1.0, 0.0], [np.nan, 0.0], [0.0, 0.0]]
    found = gauss_integrator(LOGARITHM, first[0]).propagate(first, [0.25, 1.5])
    assert found.outcome.tolist() == [NOT_A_NUMBER, 0, *[NOT_A_NUMBER] * 3]
    np.testing.assert_allclose(found.end_times, [1, 1.5, 0, 0, 0], atol=1e-11)
    assert (found.steps[2:] < 100).all()
    assert np.isnan(found.states[2:]).all()


def test_the_largest_number_of_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    flow = gauss_integrator(OSCILLATOR, [1.0, 0.0])
    monkeypatch.setattr(precise_module, "MOST_STEPS", 5)
    found = flow.propagate([[1.0, 0.0], [0.0, 0.0]], [1e-3, 100.0])
    assert found.outcome.tolist() == [STEPS, 0]
    assert found.steps[0] == 5
    assert 1e-3 < found.end_times[0] < 50
    assert np.isfinite(found.states[0, 0]).all()


def test_nothing_moves_where_nothing_moves() -> None:
    """A state of rest is kept to the bit."""
    found = gauss_integrator(OSCILLATOR, [0.0, 0.0]).propagate([[0.0, 0.0]], [1e4])
    assert found.states.tolist() == [[[0.0, 0.0]]]
    assert found.outcome.tolist() == [0]


def _error(method: Gauss, refine: bool) -> float:
    """Of the oscillator after a few turns, with machine code from a table."""
    equations = equations_of(OSCILLATOR, 0, None, False)
    text, room = gauss_loop(method, equations, None, refine)
    code = native.load_code(text, lambda: (text, room), {"gauss": precise_module._SIGNATURE})
    flow = replace(gauss_integrator(OSCILLATOR, [0.0, 1.0]), code=code)
    state = flow.propagate([[0.0, 1.0]], [20.0]).states[0, 0]
    return float(np.abs(state - [np.sin(20.0), np.cos(20.0)]).max())


@pytest.mark.parametrize("refine", [False, True])
def test_a_wrong_coefficient_is_noticed(refine: bool) -> None:
    """One weight or one entry off by 1e-12 costs digits that the method has."""
    method = gauss(8)
    assert _error(method, refine) < 5e-16
    off = 1 + Fraction(1, 10**12)
    assert _error(replace(method, b=(method.b[0] * off, *method.b[1:])), refine) > 1e-14
    row: Any = (*method.a[3][:3], method.a[3][3] * off, *method.a[3][4:])
    assert _error(replace(method, a=(*method.a[:3], row, *method.a[4:])), refine) > 1e-15


def test_guesses_cost_iterations_but_change_nothing() -> None:
    """What the step before predicts is only where the iteration begins."""
    method = gauss(8)
    stale = replace(method, ahead=tuple(tuple(Fraction(0) for _ in row) for row in method.ahead))
    assert _error(stale, True) < 5e-16
