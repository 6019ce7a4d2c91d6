"""Degenerate curves: separatrices and permanent rotations against integration with 34 digits."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from flowlanes.flow.integrator import integrate
from nonholonomic.closed_form.degenerate import DegenerateSolution, solve_degenerate
from nonholonomic.closed_form.degenerate.theta_motion import Asymptotic, Periodic
from nonholonomic.closed_form.genus_two.separation import SeparatedSystem
from nonholonomic.closed_form.separations.chaplygin_ball import chaplygin_ball
from nonholonomic.closed_form.separations.chaplygin_ball_area_constant import chaplygin_area
from nonholonomic.closed_form.separations.rubber_sphere import of_ratio
from nonholonomic.closed_form.separations.veselova import veselova
from nonholonomic.starts import initial_state

# I₁(I₂ − I₁)ω₁² = I₃(I₃ − I₂)ω₃² makes F = 2hI₂ when γ is across ω and Iω
SPIN = np.array([0.75, 0.5, 1.0])
MOMENTS = np.array([1.0, 2.0, 2.25])
ACROSS = np.cross(SPIN, MOMENTS * SPIN)
#: The same for J = I + D of the ball, D = ½.
BALL = (0.5, 0.5, 1.5, 1.75, 1.0)


def solved(
    separable: SeparatedSystem, parameters: Any, omega: Any, gamma: Any
) -> tuple[DegenerateSolution, tuple[Any, ...], dict[Any, float]]:
    system = separable.system
    values = dict(zip(system.defaults, parameters, strict=True))
    start = initial_state(system, omega, gamma, parameters=values)
    found = solve_degenerate(separable, values, start)
    assert isinstance(found, DegenerateSolution)
    return found, start, values


def slips(
    separable: SeparatedSystem, parameters: Any, omega: Any, gamma: Any, times: list[float]
) -> np.ndarray[Any, Any]:
    """How far the closed form is from integration, at every time."""
    found, start, values = solved(separable, parameters, omega, gamma)
    run = integrate(separable.system, start, times, parameters=values, precision="quad")
    distance: np.ndarray[Any, Any] = np.abs(found.states(times) - run.states.astype(float)).max(1)
    return distance


@pytest.mark.slow
def test_separatrix_of_veselova() -> None:
    found, _, _ = solved(veselova(), MOMENTS, SPIN, ACROSS)
    assert isinstance(found.motion, Asymptotic)
    times = [0.0, 0.5, 3.0, 20.0, 60.0]
    assert np.all(slips(veselova(), MOMENTS, SPIN, ACROSS, times) < 1e-12)


def test_separatrix_backwards() -> None:
    times = [0.0, -3.0, -20.0]
    assert np.all(slips(veselova(), MOMENTS, SPIN, ACROSS, times) < 1e-12)


@pytest.mark.slow
def test_separatrix_of_the_chaplygin_ball_with_its_path() -> None:
    # the 34 digits of the integration are used up at t = 60: it leaves the separatrix as e^{0.55t}
    times = [0.0, 3.0, 20.0, 60.0]
    assert np.all(slips(chaplygin_ball(), BALL, SPIN, ACROSS, times) < 1e-12)


@pytest.mark.parametrize("across", [0.3, -1.25, 0.0009765625])
def test_separatrix_begun_at_a_focal_point(across: float) -> None:
    # both variables are at the double root there, for every angular velocity
    times = [0.0, 1.0, 7.0, 25.0]
    assert np.all(slips(veselova(), MOMENTS, (0.5, across, -1.0), (2, 0, 1), times) < 1e-12)


def test_what_dies_out_keeps_its_relative_accuracy() -> None:
    found, _, _ = solved(veselova(), MOMENTS, SPIN, ACROSS)
    assert isinstance(found.motion, Asymptotic)
    period = float(found.turn.mid())
    times = np.array([200.0, 200.0 + period, 200.0 + 10 * period])
    states = found.states(times)
    fading = 2 * np.pi * float(abs(found.motion.growth / found.motion.speed).mid())
    size = np.abs(states[:, 4])
    assert 0 < size[0] < 1e-12
    assert np.log(size[0] / size[1]) == pytest.approx(fading, rel=1e-9)
    assert np.log(size[0] / size[2]) == pytest.approx(10 * fading, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("omega", "gamma"),
    [((0.3, 0, 0), (0, 0.6, 0.8)), ((0, 0, 0.5), (0.6, 0.8, 0)), ((0, 0.5, 0), (0, 0, 1))],
    ids=["first", "third", "second"],
)
def test_permanent_rotations(omega: Any, gamma: Any) -> None:
    times = [0.0, 1.0, 10.0, 30.0]
    found, _, _ = solved(veselova(), (1.0, 1.5, 2.0), omega, gamma)
    assert isinstance(found.motion, Periodic)
    assert np.all(slips(veselova(), (1.0, 1.5, 2.0), omega, gamma, times) < 1e-13)
    ball = (1.0, *(0.5, 1.0, 1.4), 1.0)
    assert np.all(slips(chaplygin_ball(), ball, omega, gamma, times) < 1e-12)
    assert np.all(slips(chaplygin_area(), ball, omega, gamma, times) < 1e-12)


@pytest.mark.slow
def test_moments_in_any_order() -> None:
    times = [0.0, 3.0, 20.0]
    turned = ([2, 0, 1], [1, 2, 0])
    for order in turned:
        moments, spin, across = MOMENTS[order], SPIN[order], ACROSS[order]
        assert np.all(slips(veselova(), moments, spin, across, times) < 1e-12)


def test_rubber_ball_around_a_sphere() -> None:
    separable = of_ratio()
    system = separable.system
    values = dict(system.defaults)
    start = (0.7, 0.0, 0.0, 0.0, 0.6, 0.8)
    found = solve_degenerate(separable, values, start)
    assert isinstance(found, DegenerateSolution)
    times = [0.0, 1.0, 10.0, 60.0]
    run = integrate(system, start, times, parameters=values, precision="quad")
    assert np.abs(found.states(times) - run.states.astype(float)).max() < 1e-12


def test_other_motions_are_not_degenerate() -> None:
    system = veselova().system
    start = initial_state(system, (0.3, -0.2, 0.0), (0.2, 0.3, 0.9))
    assert solve_degenerate(veselova(), system.defaults, start) is None


def test_form_tells_curve_and_frequencies() -> None:
    found, _, _ = solved(veselova(), MOMENTS, SPIN, ACROSS)
    assert "asymptotic" in found.form.motion
    figures = {figure.symbol: figure.value for figure in found.form.constants}
    assert figures["e"].contains(2)
    (low, middle), (again, high) = found.form.ovals
    assert (low, middle, again, high) == (1.0, 2.0, 2.0, 2.25)


@pytest.mark.slow
def test_error_bounds_contain_the_integrated_state() -> None:
    found, start, values = solved(veselova(), (1.0, 1.5, 2.0), (0.5, 0, 0), (0, 0.6, 0.8))
    run = integrate(veselova().system, start, [0.0, 1.0], parameters=values, precision="quad")
    balls = found.rigorous(1.0, 15)
    for ball, wanted in zip(balls, run.states[1], strict=True):
        assert ball.rad() < 1e-14
        assert abs(ball - float(wanted)) < 1e-15
