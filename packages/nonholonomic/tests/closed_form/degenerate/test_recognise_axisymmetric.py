"""Two equal moments, three, and uniform motions against integration with 34 digits."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from flint import arb, ctx

from flowlanes.flow.integrator import integrate
from flowlanes.formulas.balls import exact
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form.base.solution import Solution
from nonholonomic.closed_form.degenerate.recognise_axisymmetric import (
    chaplygin_of_revolution,
    equal_pair,
    veselova_of_revolution,
)
from nonholonomic.closed_form.one_degree.solution import QuadratureSolution
from nonholonomic.closed_form.one_degree.uniform import UniformSolution
from nonholonomic.starts import initial_state

GAMMA = (0.48, 0.6, 0.64)
TIMES = [0.0, 1.0, 10.0, 40.0]
LONG = [0.0, 1000.0]

VESELOVA = {
    "third": ((1.0, 1.0, 1.7), GAMMA),
    "second": ((1.0, 1.7, 1.0), GAMMA),
    "first, flat": ((0.6, 1.0, 1.0), GAMMA),
    "axis passes the vertical": ((1.0, 1.0, 1.7), (0.0, 0.0, 1.0)),
}
BALL = {
    "third": ((1.0, 1.0, 1.7), (0.3, -0.5, 0.7), GAMMA),
    "second, long": ((1.0, 0.4, 1.0), (0.3, -0.5, 0.7), GAMMA),
    "first": ((1.7, 1.0, 1.0), (0.3, -0.5, 0.7), GAMMA),
    "begun upright": ((1.0, 1.0, 1.7), (0.3, -0.5, 0.7), (0.0, 0.0, 1.0)),
    "zero area": ((1.0, 1.0, 0.5), (0.6, 0.4, -0.6), (0.0, 0.6, 0.8)),
}
UNIFORM = {
    "rest": ((1.0, 1.2, 1.7), (0.0, 0.0, 0.0), GAMMA),
    "three equal moments": ((1.0, 1.0, 1.0), (0.3, -0.5, 0.7), GAMMA),
    "upright": ((1.0, 1.2, 1.7), (0.0, 0.0, 0.7), (0.0, 0.0, 1.0)),
    "about a principal axis": ((1.0, 1.2, 1.7), (0.0, 0.0, 0.7), (0.6, 0.8, 0.0)),
    "about the axis of symmetry": ((1.0, 1.0, 1.7), (0.0, 0.0, 0.7), (0.0, 0.6, 0.8)),
}


def case(
    name: str, moments: Any, omega: Any, gamma: Any
) -> tuple[Solution | None, tuple[Any, ...], dict[Any, Any]]:
    system = from_catalogue(name)
    values: dict[Any, Any] = {
        symbol: dict(zip(("I_1", "I_2", "I_3"), moments, strict=True)).get(str(symbol), number)
        for symbol, number in system.defaults.items()
    }
    start = initial_state(system, omega, gamma, heading=0.4, parameters=values)
    numbers = {symbol: exact(value) for symbol, value in values.items()}
    balls = [exact(moment) for moment in moments]
    with ctx.workprec(420):
        inertia = [arb(x.numerator) / x.denominator for x in balls]
    if name == "veselova":
        return veselova_of_revolution(system, numbers, start, inertia), start, values
    one = arb(1)
    return chaplygin_of_revolution(system, numbers, start, inertia, one, one), start, values


def agrees(
    name: str,
    moments: Any,
    omega: Any,
    gamma: Any,
    kind: type[Solution],
    times: list[float] = TIMES,
) -> None:
    found, start, values = case(name, moments, omega, gamma)
    assert type(found) is kind
    run = integrate(from_catalogue(name), start, times, parameters=values, precision="quad")
    wanted = run.states.astype(float)
    assert np.abs(found.states(np.array(times)) - wanted).max() < 1e-12
    balls = found.rigorous(times[-1], 20)
    for ball, number in zip(balls, wanted[-1], strict=True):
        assert ball.rad() < 1e-18
        assert abs(ball - float(number)) < 1e-15 * (1 + abs(float(number)))


def across(omega: Any, gamma: Any) -> Any:
    normal = np.array(gamma) / np.linalg.norm(gamma)
    return tuple(np.array(omega) - normal * (normal @ np.array(omega)))


@pytest.mark.parametrize("name", VESELOVA)
def test_veselova(name: str) -> None:
    moments, gamma = VESELOVA[name]
    omega = (0.3, -0.5, 0.0) if gamma[2] == 1 else across((0.3, -0.5, 0.7), gamma)
    kind = UniformSolution if gamma[2] == 1 else QuadratureSolution
    agrees("veselova", moments, omega, gamma, kind)


def test_veselova_with_its_axis_passing_the_vertical() -> None:
    agrees("veselova", (1.0, 1.0, 1.7), (0.5, 0.0, 0.0), (0.0, 0.6, 0.8), UniformSolution)


@pytest.mark.slow
@pytest.mark.parametrize("name", BALL)
def test_chaplygin_ball(name: str) -> None:
    agrees("chaplygin-ball", *BALL[name], QuadratureSolution)


@pytest.mark.parametrize("name", UNIFORM)
def test_uniform_motions(name: str) -> None:
    agrees("chaplygin-ball", *UNIFORM[name], UniformSolution)


def test_three_equal_moments_of_veselova() -> None:
    agrees("veselova", (1.0, 1.0, 1.0), across((0.3, -0.5, 0.7), GAMMA), GAMMA, UniformSolution)


@pytest.mark.slow
@pytest.mark.parametrize("name", BALL)
def test_chaplygin_ball_for_long(name: str) -> None:
    agrees("chaplygin-ball", *BALL[name], QuadratureSolution, LONG)


@pytest.mark.slow
def test_veselova_for_long() -> None:
    moments, gamma = VESELOVA["third"]
    agrees("veselova", moments, across((0.3, -0.5, 0.7), gamma), gamma, QuadratureSolution, LONG)


def test_different_moments_are_left_alone() -> None:
    found, _, _ = case("chaplygin-ball", (1.0, 1.2, 1.7), (0.3, -0.5, 0.7), GAMMA)
    assert found is None


def test_moments_are_equal_only_when_they_are() -> None:
    with ctx.workprec(300):
        one, near, other = arb(1), 1 + arb("1e-30"), arb(2)
        assert equal_pair([one, one, other]) == 2
        assert equal_pair([one, other, one]) == 1
        assert equal_pair([other, one, one]) == 0
        assert equal_pair([one, near, other]) is None


def test_far_away_in_time() -> None:
    # the error of a double at t = 1e6 is 1e-10 in the time itself
    found, _, _ = case("chaplygin-ball", *BALL["third"])
    assert isinstance(found, QuadratureSolution)
    far = found.states(np.array([1e6]))[0]
    balls = found.rigorous(10**6, 20)
    for ball, number in zip(balls[:10], far[:10], strict=True):
        assert abs(ball - float(number)) < 1e-10
