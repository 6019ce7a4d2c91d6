"""Numbers that come of watching a formula, where they are known in closed form."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import sympy as sp

from flowlanes.flow.batch import batch_integrator
from flowlanes.scans.observables import (
    frequency,
    maximum,
    minimum,
    observe,
    survival_time,
    time_average,
)
from flowlanes.system.system import Guard, Parameter, System

x, y, c = sp.symbols("x y c", real=True)

CIRCLE = System(
    name="circle",
    title="Circle",
    field={x: -c * y, y: c * x},
    parameters=(Parameter(c, "angular velocity", 1.0),),
)
STARTS = np.array([[1.0, 0.0], [2.0, 0.0], [3.0, 0.0]])
RATES = {c: np.array([1.0, 2.0, 0.5])}


def test_means() -> None:
    found = time_average(CIRCLE, 10.0, x**2)(STARTS, RATES)
    rates = RATES[c]
    exact = STARTS[:, 0] ** 2 * (0.5 + np.sin(20.0 * rates) / (40.0 * rates))
    assert np.abs(found["value"] - exact).max() < 1e-11


def test_extremes() -> None:
    for rule, sign in ((maximum, 1.0), (minimum, -1.0)):
        found = rule(CIRCLE, 20.0, x + 1)(STARTS, RATES)["value"]
        assert np.abs(found - (1.0 + sign * STARTS[:, 0])).max() < 1e-3


def test_frequencies() -> None:
    found = frequency(CIRCLE, 100.0, sp.atan2(y, x))(STARTS, RATES)
    assert np.abs(found["value"] - RATES[c] / (2 * np.pi)).max() < 1e-11
    assert np.all(found["error"] < 1e-11)
    # turns are counted between samples too
    rare = frequency(CIRCLE, 100.0, sp.atan2(y, x), 20)(STARTS, RATES)["value"]
    assert np.abs(rare - found["value"]).max() < 1e-11


def test_a_frequency_through_definitions() -> None:
    angle = sp.Symbol("angle", real=True)
    made = replace(CIRCLE, definitions={angle: sp.atan2(y, x) * 3 * c})
    found = frequency(made, 100.0, angle)(STARTS, RATES)["value"]
    assert np.abs(found - 3 * RATES[c] ** 2 / (2 * np.pi)).max() < 1e-11


def test_durations() -> None:
    half = System(
        name="half",
        title="Half",
        field={x: -c * y, y: c * x},
        parameters=CIRCLE.parameters,
        guards=(Guard("left", x + 1, "x has fallen to -1"),),
    )
    starts = STARTS - [[0.5, 0.0]]
    found = survival_time(half, 4.0)(starts, RATES)
    assert found["value"][0] == 4.0
    assert (
        np.abs(found["value"] - [4.0, *np.arccos(-1.0 / starts[1:, 0]) / RATES[c][1:]]).max() < 1e-9
    )
    assert (found["outcome"] != 0).tolist() == [False, True, True]


def test_few_states_at_a_time_are_the_same_as_all() -> None:
    flow = batch_integrator(CIRCLE, tolerance=1e-12)
    seen = observe(flow, x, STARTS, 30.0, 300, RATES).values
    times = np.linspace(0.0, 30.0, 301)
    assert np.abs(seen - STARTS[:, :1] * np.cos(RATES[c][:, None] * times)).max() < 1e-9
