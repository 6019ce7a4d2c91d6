"""Crossings that are easily overlooked, and starts and places that must not mislead."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.kernel.equations import Section, poincare_section
from flowlanes.system.system import Guard, System
from nonholonomic.catalogue import from_catalogue
from nonholonomic.starts import initial_state

x, y = sp.symbols("x y", real=True)
OSCILLATOR = System("oscillator", "Oscillator", {x: y, y: -x})
ROTATION = System("rotation", "Rotation", {x: 1, y: sp.sqrt(2)})


@pytest.mark.parametrize("below", [1e-1, 1e-3, 1e-5])
@pytest.mark.parametrize("direction", [1, 0, -1])
def test_both_crossings_near_a_turning_point_are_found(below: float, direction: int) -> None:
    flow = batch_integrator(OSCILLATOR, section=Section(x - sp.Float(1 - below), direction))
    found = flow.crossings([[np.sin(0.3), np.cos(0.3)]], 40, t_end=60.0)
    half, turns = np.arccos(1 - below), 2 * np.pi * np.arange(11)
    rises, falls = (np.pi / 2 - 0.3 + sign * half + turns for sign in (-1, 1))
    wanted = {1: rises, -1: falls, 0: np.sort([*rises, *falls])}[direction]
    wanted = wanted[wanted < 60.0]
    assert found.counts[0] == len(wanted)
    # the nearer the turn, the worse a time is told by the height
    assert np.abs(found.times[0, : len(wanted)] - wanted).max() < 1e-13 / half + 2e-12


def test_no_turn_of_a_uniform_rotation_is_missed() -> None:
    flow = batch_integrator(ROTATION, section=poincare_section(ROTATION, "x", 0, 1, angle=True))
    found = flow.crossings([[0.1, 0.2]], 500)
    assert found.counts[0] == 500
    assert np.abs(found.times[0] + 0.1 - 2 * np.pi * np.arange(1, 501)).max() < 1e-11


def test_what_comes_to_rest_is_given_up() -> None:
    falling = System("falling", "Falling", {x: -x, y: 0})
    flow = batch_integrator(falling, section=Section(x + 1, 0))
    found = flow.crossings([[0.0, 0.0], [1.0, 0.0]], 3)
    assert [flow.status_message(code) for code in found.outcome] == [
        "a million steps passed without a crossing"
    ] * 2
    assert (found.steps <= 1e6).all()


def test_the_place_of_a_body_does_not_blur_its_motion() -> None:
    ball = from_catalogue("unbalanced-ball").lifted()
    begun = initial_state(from_catalogue("unbalanced-ball"), (0.7, 0.4, 1.1), (0.2, -0.3, 0.93))
    start = np.array([[float(number) for number in begun]] * 2)
    places = [i for i, symbol in enumerate(ball.symbols) if str(symbol).startswith("place")]
    start[1, places] = 1e6
    near, far = batch_integrator(ball).propagate(start, [20.0]).states[:, 0]
    dynamics = [i for i in range(len(near)) if i not in places]
    assert np.abs(near - far)[dynamics].max() < 1e-12


def test_a_large_momentum_excuses_no_wrong_normal() -> None:
    ball = from_catalogue("unbalanced-ball")
    with pytest.raises(InputError, match="start 0 misses the phase space"):
        batch_integrator(ball).propagate([[1e5, 0, 0, 0, 0, 1.001]], [1.0])


def test_more_than_memory_holds_is_refused() -> None:
    flow = batch_integrator(OSCILLATOR, section=Section(x, 1))
    with pytest.raises(InputError, match="GiB at once: ask for fewer, or stream them"):
        flow.crossings([[0.0, 1.0]], 10**11)


@pytest.mark.parametrize(
    ("guard", "time"),
    [
        (sp.Rational(9, 10) - x, np.arcsin(0.9)),
        (sp.sqrt(sp.Rational(1, 2) - x), np.pi / 6),
        (sp.log(sp.Rational(9, 10) - x) + 10, np.arcsin(0.9 - np.exp(-10))),
    ],
)
def test_no_guard_is_jumped_over(guard: sp.Expr, time: float) -> None:
    guarded = replace(OSCILLATOR, guards=(Guard("height", guard, "it is too high"),))
    for start in ([0.0, 1.0], [-0.6, 0.8]):
        flow = batch_integrator(guarded)
        found = flow.propagate([start], [100.0])
        assert flow.status_message(found.outcome[0]) == "it is too high"
        assert found.end_times[0] == pytest.approx(time - np.arcsin(start[0]), abs=1e-10)
