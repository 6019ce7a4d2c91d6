"""Events of a motion by steps of its Taylor series."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from flowlanes.flow.taylor.compiled_system import compile_system
from flowlanes.system.system import Guard, System
from flowlanes.system.vectors import real_symbol

x, v = (real_symbol(name) for name in "xv")


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("limit", [math.inf, 0.05])
def test_every_fall_through_zero_is_an_event_once(sense: int, limit: float) -> None:
    """x = cos t falls through zero at t = ±(π/2 + 2πn), whatever the steps."""
    system = System(
        name="oscillator",
        title="Oscillator",
        field=((x, v), (v, -x)),
        guards=(Guard("zero", x, "x is zero"), Guard("far", sp.Integer(3) + x, "x is far")),
    )
    code = compile_system(system, direction="forward" if sense > 0 else "backward")
    series = code.series.copy()
    series.state[:] = [1.0, 0.0]
    series.parameters[:] = 1.0
    times = []
    while abs(series.time) < 100:
        step = series.step(sense * min(limit, 100 - abs(series.time)))
        if step.event is not None:
            assert step.event == 0
            times.append(sense * series.time)
    expected = [math.pi / 2 + 2 * math.pi * n for n in range(16)]
    assert times == pytest.approx(expected, abs=1e-12)
