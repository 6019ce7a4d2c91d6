"""Rubber bodies of revolution in closed form, against integration with 34 digits."""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np
import pytest
from flint import arb, ctx

from closed_form.revolution_cases import KINDS, body, start, u
from flowlanes import lambdify
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.closed_form.base.solution import Solution
from nonholonomic.closed_form.revolution import solve_rolling
from nonholonomic.closed_form.revolution.body import body_of
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shapes import Disk, Ellipsoid
from nonholonomic.starts import initial_state

DISK = RollingBody(Body(1.0, (0.25, 0.25, 0.5), Disk(1.0)), contact="rubber", field=Forces(9.81))
EGG = CATALOGUE["rubber-body-of-revolution"].rolling()


def solved(rolling: RollingBody, state: Sequence[Any]) -> Solution:
    solution = solve_rolling(rolling, rolling.system(), state)
    assert solution is not None
    return solution


def begun(rolling: RollingBody, omega: Sequence[Any], gamma: Sequence[Any]) -> Solution:
    return solved(rolling, initial_state(rolling.system(), omega, gamma))


def error(
    solution: Solution, rolling: RollingBody, state: Sequence[Any], times: list[float]
) -> float:
    trajectory = integrate(
        rolling.system(), state, times, precision="quad", on_liftoff="warn", tolerance=1e-30
    )
    assert len(trajectory.times) == len(times)
    exact = trajectory.states.astype(float)
    size = np.maximum(1.0, np.abs(exact))
    return float((np.abs(exact - solution.states(np.array(times))) / size).max())


def agreement(solution: Solution, times: Sequence[float], digits: int = 25) -> float:
    """The greatest distance of both evaluators."""
    states = solution.states(np.array(times))
    balls = [solution.rigorous(time, digits) for time in times]
    return max(
        abs(float(ball.mid()) - value)
        for row, known in zip(states, balls, strict=True)
        for value, ball in zip(row, known, strict=True)
    )


def widest(solution: Solution, time: float, digits: int = 30) -> float:
    return max(float(ball.rad()) for ball in solution.rigorous(time, digits))


# --- kinds of motion -----------------------------------------------------------------------


def separatrix(direction: int) -> list[Any]:
    """A disk that comes to roll upright, so slowly that this is not stable."""
    with mpmath.workdps(60):
        K, x, phi = mpmath.mpf(1), mpmath.mpf("0.3"), mpmath.mpf("0.3")
        g, across, axial = mpmath.mpf("9.81"), mpmath.mpf("0.25"), mpmath.mpf("0.5")
        sine = mpmath.sqrt(1 - x * x)
        A = mpmath.sqrt(across * x * x + (axial + 1) * sine**2)
        energy = g + K * K / (2 * (axial + 1)) * (axial + 1)
        rate = mpmath.sqrt((2 * (energy - g * sine) - K * K / sine**2) / (across + 1))
        lean, spin = -direction * rate, K / A
        omega = [
            lean * mpmath.cos(phi) - spin * x / sine * mpmath.sin(phi),
            -lean * mpmath.sin(phi) - spin * x / sine * mpmath.cos(phi),
            spin,
        ]
        gamma = [sine * mpmath.sin(phi), sine * mpmath.cos(phi), x]
        return list(initial_state(DISK.system(), omega, gamma))


CASES = {
    "nods and precesses": (EGG, (1.0, 0.8, -1.0), (0.4, 0.5, 0.8)),
    "swings through the vertical": (EGG, (1.0, -1.0, 0.0), (0.3, 0.3, 0.9)),
    "over and over": (EGG, (6.0, -6.0, 0.0), (0.3, 0.3, 0.9)),
    "begins at the pole": (EGG, (1.0, -1.0, 0.0), (0.0, 0.0, 1.0)),
    "begins at the lower pole": (EGG, (0.3, -0.1, 0.0), (0.0, 0.0, -1.0)),
    "begins at rest": (EGG, (0.0, 0.0, 0.0), (0.3, 0.4, 0.5)),
    "rests at the pole": (EGG, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)),
    "upright, unstable": (DISK, (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)),
    "upright, stable": (DISK, (0.0, 0.0, 8.0), (1.0, 0.0, 0.0)),
    "near the separatrix": (DISK, (0.0, 1e-4, 1.0), (1.0, 0.0, 0.0)),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_kinds_satisfy_the_equations_in_both_evaluators(name: str) -> None:
    rolling, omega, gamma = CASES[name]
    solution = begun(rolling, omega, gamma)
    assert agreement(solution, [0.0, 1.3, -7.1, 1000.0], 20) < 2e-12
    assert rate_error(solution, 2.2) < 1e-6


def rate_error(solution: Solution, time: float, step: float = 5e-4) -> float:
    """How far a difference quotient of fourth order is from the field of the lifted system."""
    times = time + step * np.array([-2.0, -1.0, 0.0, 1.0, 2.0])
    states = solution.states(times)
    slope = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) @ states / (12 * step)
    field = lambdify(solution.system)
    parameters = np.array([float(x) for x in solution.parameters.values()])
    return float(np.abs(slope - field(time, states[2], parameters)).max())


@pytest.mark.slow
def test_words_of_kinds() -> None:
    names = ("nods and precesses", "rests at the pole", "upright, unstable", "upright, stable")
    motions = [begun(*CASES[name]).form.motion for name in names]
    assert "nods while it precesses" in motions[0]
    assert motions[1:] == [
        "equilibrium, unstable",
        "permanent rotation, unstable",
        "permanent rotation, stable",
    ]


@pytest.mark.slow
@pytest.mark.parametrize("direction", [1, -1])
def test_separatrix_is_followed_for_ever(direction: int) -> None:
    solution = solved(DISK, separatrix(direction))
    assert "asymptotic" in solution.form.motion
    assert agreement(solution, [0.0, -1.0, 8.0, -40.0], 15) < 1e-11
    assert abs(solution.states([60.0])[0, 5]) < 1e-15
    assert widest(solution, 1e6, 20) < 1e-20


@pytest.mark.slow
def test_disk_against_integration() -> None:
    state = initial_state(DISK.system(), (0.5, 1.0, 2.0), (1.0, -0.5, 0.0))
    assert error(solved(DISK, state), DISK, state, [0.0, 1.0, 20.0]) < 1e-13


@pytest.mark.slow
def test_far_times_are_as_exact_as_near_ones() -> None:
    solution = begun(*CASES["nods and precesses"])
    assert widest(solution, 10**6) < 1e-30
    assert widest(solution, 10**12) < 1e-30
    assert agreement(solution, [1e6], 20) < 2e-10
    # of the shape alone, which does not grow, hardly anything is lost
    shape = solution.states([1e6])[0, :10]
    exact = [float(ball.mid()) for ball in solution.rigorous(10**6)[:10]]
    assert np.abs(shape - exact).max() < 1e-12


@pytest.mark.slow
def test_error_bars_hold_the_integrated_state() -> None:
    state = initial_state(DISK.system(), (0.0, 0.1, 8.0), (1.0, 0.0, 0.0))
    trajectory = integrate(DISK.system(), state, [0.0, 3.0], precision="quad", tolerance=1e-32)
    balls = solved(DISK, state).rigorous(3, 20)
    with ctx.workprec(150):
        for ball, value in zip(balls, trajectory.states[-1], strict=True):
            assert abs(ball - arb(str(value))) < 1e-27


# --- refusals ------------------------------------------------------------------------------


def test_a_body_that_falls_flat_is_refused() -> None:
    with pytest.raises(InputError, match="falls flat in finite time"):
        begun(DISK, (0.0, 1.0, 0.0), (1.0, 0.0, 0.5))


def test_a_start_off_the_phase_space_is_refused() -> None:
    state = list(initial_state(DISK.system(), (0.5, 1.0, 2.0), (1.0, -0.5, 0.0)))
    state[0] += mpmath.mpf("0.01")
    with pytest.raises(InputError, match=r"misses \(omega, gamma\) = 0"):
        solved(DISK, state)


def test_a_profile_that_is_not_convex_is_refused() -> None:
    shape = ShapeOfRevolution(1 + u**4 / 2 - u**2 * 0.6)
    rolling = RollingBody(Body(1.0, (0.3, 0.3, 0.3), shape), contact="rubber", field=Forces(1.0))
    with pytest.raises(InputError, match="leaves the convex part"):
        begun(rolling, (6.0, 0.0, 1.0), (0.0, 1.0, 0.0))


def test_too_many_digits_are_refused() -> None:
    with pytest.raises(InputError, match="at most 100"):
        begun(*CASES["upright, stable"]).rigorous(1, 200)


def test_other_bodies_are_not_recognised() -> None:
    marble = RollingBody(DISK.body, contact="marble", field=Forces(9.81))
    triaxial = RollingBody(Body(1.0, (0.3, 0.4, 0.5), Ellipsoid((1.0, 1.0, 1.2))), contact="rubber")
    for rolling in (marble, triaxial):
        assert body_of(rolling, rolling.system().defaults) is None
    assert body_of(DISK, DISK.system().defaults) is not None


# --- campaign ------------------------------------------------------------------------------


@pytest.mark.campaign
@pytest.mark.parametrize("kind", KINDS)
def test_campaign(kind: str) -> None:
    rng = random.Random(kind)
    for number in range(6):
        rolling = body(kind, rng)
        state = start(rolling, rng)
        until = 1000.0 if number == 0 else 100.0
        try:
            solution = solved(rolling, state)
        except InputError as refusal:
            assert "convex" in str(refusal), (kind, number)
            continue
        assert error(solution, rolling, state, [0.0, until / 10, until]) < 1e-12, (kind, number)
