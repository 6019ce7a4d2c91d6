"""Hands-free circles branch off from straight running where the capsize sets in."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import matplotlib
import numpy as np
import pytest

from flowlanes.flow.integrator import integrate
from flowlanes.flow.linearisation.linear_stability import relative_equilibrium

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def example() -> Iterator[ModuleType]:
    matplotlib.use("agg")
    sys.path.insert(0, str(EXAMPLES))
    try:
        import whipple_circles

        yield whipple_circles
    finally:
        sys.path.remove(str(EXAMPLES))


@pytest.mark.slow
def test_circles_begin_at_the_critical_speed(example: ModuleType):
    first, second = example.circles((1, 2))
    slower = [6.02426201538837 - circle.speed for circle in (first, second)]
    assert slower[1] / slower[0] == pytest.approx(4, rel=0.02)
    assert first.radius == pytest.approx(2 * second.radius, rel=0.02)
    assert 0 < first.growth < second.growth


@pytest.mark.slow
def test_a_circle_stays_one_in_the_nonlinear_equations(example: ModuleType):
    bicycle = replace(example.model(), reconstruction=None)
    guess = example.beginning(0.02)
    state = relative_equilibrium(
        bicycle, guess, example.VALUES, fixed_variables=["delta"], digits=15
    )
    start = [float(state[symbol]) for symbol in bicycle.symbols]
    run = integrate(bicycle, start, np.linspace(0.0, 3.0, 7))
    assert np.abs(run.states - run.states[0]).max() < 1e-11
