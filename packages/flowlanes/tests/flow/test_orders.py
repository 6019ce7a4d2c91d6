"""The order of every method: how fast its errors fall when steps become shorter.

The motion is that of the elliptic functions, x = sn t, y = cn t, z = dn t, which mpmath knows to
any number of digits.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.gauss import gauss_integrator
from flowlanes.flow.kernel.dop853_coefficients import explicit_table
from flowlanes.flow.kernel.tableaux import explicit, gauss
from flowlanes.system.laws import Integral
from flowlanes.system.system import System

DIGITS = 90
MODULUS = 0.5
END = 2.0

x, y, z = sp.symbols("x y z", real=True)
ELLIPTIC = System(
    name="elliptic",
    title="Elliptic functions",
    field={x: y * z, y: -x * z, z: -sp.Rational(1, 4) * x * y},
    laws=(Integral("circle", x**2 + y**2, "a circle"),),
)


@lru_cache
def right(time: float) -> Any:
    """The motion at a time, to all digits."""
    with mpmath.workdps(DIGITS):
        k = mpmath.mpf(MODULUS) ** 2
        return np.array([mpmath.ellipfun(name, time, m=k) for name in ("sn", "cn", "dn")])


def _rates(states: Any) -> Any:
    """Of one state or of several (…, 3)."""
    u, v, w = np.moveaxis(states, -1, 0)
    return np.stack([v * w, -u * w, -u * v / 4], axis=-1)


def _numbers(values: Sequence[Any]) -> Any:
    return np.array([mpmath.mpf(v.numerator) / v.denominator for v in values])


def slope(errors: Sequence[Any], steps: Sequence[Any]) -> float:
    """Of the logarithm of the error against that of the step."""
    with mpmath.workdps(30):
        logs = [[float(mpmath.log(v)) for v in values] for values in (errors, steps)]
    return float(np.polyfit(logs[1], logs[0], 1)[0])


def _largest(values: Any) -> Any:
    return max(map(abs, values))


# --- the tables, with all digits --------------------------------------------------------------


def _stages(table: Any, state: Any, step: Any) -> Any:
    """Rates at the stages of an explicit method."""
    rates = []
    for row in table.a:
        weights = _numbers(row)
        moved = sum((w * r for w, r in zip(weights, rates, strict=True)), np.zeros(3, object))
        rates.append(_rates(state + step * moved))
    return np.array(rates)


def _motion(advance: Callable[[Any, Any], Any], steps: int) -> Any:
    """The error at the end of a motion with equal steps."""
    state = np.array([mpmath.mpf(0), mpmath.mpf(1), mpmath.mpf(1)])
    for _ in range(steps):
        state = advance(state, mpmath.mpf(END) / steps)
    return _largest(state - right(END))


def test_order_of_the_explicit_method() -> None:
    table = explicit_table()
    counts = (8, 12, 16)
    with mpmath.workdps(DIGITS):
        weights = _numbers(table.b)
        errors = [_motion(lambda s, h: s + h * (weights @ _stages(table, s, h)), n) for n in counts]
    assert slope(errors, [1 / n for n in counts]) == pytest.approx(8, abs=0.15)


@pytest.mark.parametrize(("name", "order"), [("e3", 3), ("e5", 5)])
def test_order_of_the_estimates(name: str, order: int) -> None:
    """In one step they fall with one power more than the order of their method."""
    table, steps = explicit_table(), (0.1, 0.05, 0.025)
    with mpmath.workdps(DIGITS):
        weights = _numbers(getattr(table, name))
        start = right(0.3)
        errors = [
            _largest(step * (weights @ _stages(table, start, mpmath.mpf(step)))) for step in steps
        ]
    assert slope(errors, steps) == pytest.approx(order + 1, abs=0.15)


def test_doubles_of_the_table_are_the_polished_ones() -> None:
    """Two sources, one method."""
    short, full = explicit(), explicit_table()
    for name in ("b", "e3", "e5"):
        first, second = (np.array(getattr(t, name), dtype=float) for t in (short, full))
        np.testing.assert_allclose(first, second, rtol=1e-14, atol=1e-16)


def _collocated(stages: int) -> Callable[[Any, Any], Any]:
    """A step of a Gauss–Legendre method, solved by iteration."""
    method = gauss(stages)
    a, b = np.array([_numbers(row) for row in method.a]), _numbers(method.b)

    def advance(state: Any, step: Any) -> Any:
        rates = np.array([_rates(state)] * stages)
        while True:
            fresh = _rates(state + step * (a @ rates))
            change = _largest((fresh - rates).ravel())
            rates = fresh
            if change < mpmath.mpf(10) ** -62:
                return state + step * (b @ rates)

    return advance


@pytest.mark.slow
@pytest.mark.parametrize(
    ("stages", "counts"), [(1, (16, 24, 32)), (2, (8, 12, 16)), (4, (6, 9, 12)), (8, (3, 4, 6))]
)
def test_order_of_collocation(stages: int, counts: tuple[int, ...]) -> None:
    """Twice the number of stages."""
    with mpmath.workdps(DIGITS):
        errors = [_motion(_collocated(stages), n) for n in counts]
    assert slope(errors, [1 / n for n in counts]) == pytest.approx(2 * stages, rel=0.06)


@pytest.mark.slow
def test_order_of_collocation_with_sixteen_stages() -> None:
    """The error of two long steps against one: 2³² times less."""
    with mpmath.workdps(DIGITS):
        errors = [_motion(_collocated(16), n) for n in (2, 3)]
    assert slope(errors, [1 / 2, 1 / 3]) == pytest.approx(32, rel=0.06)


# --- machine code -----------------------------------------------------------------------------


def test_order_of_the_march() -> None:
    """Its steps follow the tolerance; errors fall with the eighth power of their mean length.

    The motion is that of an oscillator, for which the first term of the error stands alone even
    where steps are long.
    """
    oscillator = System(name="oscillator", title="Oscillator", field={x: y, y: -x})
    until = 100.0
    errors, steps = [], []
    for tolerance in 10.0 ** -np.arange(6, 13):
        found = batch_integrator(oscillator, tolerance=tolerance).propagate([[0.0, 1.0]], [until])
        errors.append(abs(found.states[0, -1, 0] - np.sin(until)))
        steps.append(until / found.steps[0])
    assert slope(errors, steps) == pytest.approx(8, abs=0.15)


@pytest.mark.parametrize(("precision", "allowed"), [("double", 4e-16), ("quad", 1e-29)])
def test_precise_motions_reach_their_digits(precision: Any, allowed: float) -> None:
    start, until = [0.0, 1.0, 1.0], 20.0
    found = gauss_integrator(ELLIPTIC, start, precision=precision).propagate([start], [until])
    with mpmath.workdps(DIGITS):
        both = zip(found.states[0, -1], found.rest[0, -1], strict=True)
        state = np.array([mpmath.mpf(float(p)) + mpmath.mpf(float(q)) for p, q in both])
        assert _largest(state - right(until)) < allowed
