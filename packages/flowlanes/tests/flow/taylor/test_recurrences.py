"""Taylor coefficients by recurrences, against those of closed forms."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
import sympy as sp

from flowlanes.flow.taylor.compiled_system import compile_system
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol

x, y, c = (real_symbol(name) for name in "xyc")
ORDER = 19
FORMULAS = {
    "product": x * sp.sin(x),
    "square": (x + c) ** 2 * x,
    "quotient": 1 / (x + c),
    "root": sp.sqrt(x + c),
    "power": (x + c) ** sp.Rational(1, 3),
    "sin": sp.sin(c * x),
    "cos": sp.cos(c * x),
    "tan": sp.tan(x),
    "asin": sp.asin(x / 2),
    "acos": sp.acos(x / 2),
    "atan": sp.atan(c * x),
    "atan2": sp.atan2(sp.sin(x), x**2 + c),
    "sinh": sp.sinh(x),
    "cosh": sp.cosh(x),
    "tanh": sp.tanh(x),
    "exp": sp.exp(-(x**2)),
    "log": sp.log(x + c),
    "log of a constant times": sp.log(c) * x,
    "abs": sp.Abs(x - 2) * x,
    "sign": sp.sign(x - 2) * x,
    "constant": c**2,
}


@pytest.mark.parametrize("name", FORMULAS)
def test_series_of_a_function(name: str) -> None:
    formula, c_value, first = FORMULAS[name], 1.7, 0.3
    system = System(
        name="test",
        title="Test",
        field=((x, sp.S.One), (y, formula)),
        parameters=(Parameter(c, "c", c_value, "1"),),
    )
    series = compile_system(system).series.copy()
    series.parameters[:] = c_value
    series.state[:] = [first, 5.0]
    series.step(1e-300)
    with mpmath.workdps(60):
        function = sp.lambdify(x, formula.subs(c, sp.Rational(17, 10)), "mpmath")
        exact = mpmath.taylor(function, mpmath.mpf(first), ORDER - 1)
        expected = [5.0, *(float(a / (n + 1)) for n, a in enumerate(exact))]
    assert series.series.shape == (2, ORDER + 1)
    assert series.series[0].tolist() == [first, 1.0, *[0.0] * (ORDER - 1)]
    # against the largest of the neighbours, since single coefficients may all but vanish
    size = np.maximum.accumulate(np.abs(expected[::-1]))[::-1]
    assert np.all(np.abs(series.series[1] - expected) <= 2e-14 * size)


@pytest.mark.parametrize("limit", [1.0, -1.0])
def test_a_step_is_its_series(limit: float) -> None:
    system = System(name="test", title="Test", field=((x, y), (y, -sp.sin(x))))
    series = compile_system(system).series.copy()
    series.state[:] = [1.0, 0.5]
    before = series.state.copy()
    step = series.step(limit)
    assert step.event is None and not step.is_failure
    assert 0 < abs(step.length) < 1
    assert np.array_equal(series.state_at(0.0), before)
    assert np.array_equal(series.state_at(series.time), series.state)
    half = series.state_at(step.length / 2)
    powers = (step.length / 2) ** np.arange(series.order + 1)
    np.testing.assert_allclose(half, series.series @ powers, rtol=1e-15)


def test_a_step_into_a_singularity_leaves_the_state_alone() -> None:
    system = System(name="test", title="Test", field=((x, 1 / x),))
    series = compile_system(system).series.copy()
    series.state[:] = 0.0
    assert series.step(1.0).is_failure
    assert series.state.tolist() == [0.0]
    # what was not finite has left no trace
    series.state[:] = 1.0
    assert not series.step(0.01).is_failure
    assert series.state[0] == pytest.approx(np.sqrt(1.02), rel=1e-15)
