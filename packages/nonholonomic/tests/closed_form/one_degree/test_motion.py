"""Motions x′² = N(x)/B(x) against motions known in elementary and elliptic functions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from flint import acb, arb, ctx

from flowlanes.errors import InputError
from nonholonomic.closed_form.one_degree import Equilibrium, QuadratureMotion, motion_chart
from nonholonomic.closed_form.one_degree.chebyshev_integrals import working_bits
from nonholonomic.closed_form.one_degree.functions import BALLS, DOUBLES
from nonholonomic.closed_form.one_degree.uniformisation import (
    Asymptotic,
    Equation,
    Heteroclinic,
    Oscillating,
)

DIGITS = 40


@pytest.fixture(autouse=True)
def precision() -> Any:
    with ctx.workprec(working_bits(DIGITS)):
        yield


def one(x: Any) -> Any:
    return arb(1)


def motion_equation(numerator: Any, denominator: Any = one, edge: Any = 10) -> Equation:
    return Equation(numerator, denominator, -arb(edge), arb(edge))


def motion_through(
    numerator: Any, x: Any, denominator: Any = one, sign: int = 1, edge: Any = 10
) -> QuadratureMotion:
    """The motion through x, with the quadratures q′ = x and q′ = x′²."""
    equation = motion_equation(numerator, denominator, edge)
    start = arb(x)
    rate = sign * equation.square(start).sqrt()
    chart = motion_chart(equation, start, rate)
    assert not isinstance(chart, Equilibrium)
    return QuadratureMotion(chart, start, rate, lambda x, rate: [x, rate * rate], units=(1.0, 1.0))


def positions(motion: QuadratureMotion, times: list[float]) -> list[float]:
    sample = motion.fast.sample(np.array(times))
    return list(motion.chart.coordinate(DOUBLES, sample.phase))


def position(motion: QuadratureMotion, time: Any) -> Any:
    return motion.chart.coordinate(BALLS, motion.sample(arb(time), DIGITS).phase)


def test_harmonic_oscillation() -> None:
    motion = motion_through(lambda x: 4 - 9 * x * x, "0.5")
    assert isinstance(motion.chart, Oscillating)
    period, gain, action = motion.advances(DIGITS)
    assert abs(period - 2 * arb.pi() / 3) < 1e-40
    assert abs(gain) < 1e-39
    assert abs(action - arb.pi() * 4 / 3) < 1e-39
    begin = (arb(3) / 4).asin()
    for time in (0, 1, 10**6, 10**12):
        exact = arb(2) / 3 * (3 * arb(time) + begin).sin()
        assert abs(position(motion, time) - exact) < 1e-25
    assert np.allclose(
        positions(motion, [0.0, 1e6]),
        [float(2 / 3 * np.sin(3 * t + np.arcsin(0.75))) for t in (0.0, 1e6)],
        atol=1e-9,
    )


def test_drift_and_periodic_part() -> None:
    motion = motion_through(lambda x: 1 - (x - 2) * (x - 2), 2)
    period, advance, energy = motion.advances(DIGITS)
    assert abs(advance / period - 2) < 1e-39
    assert abs(energy / period - arb(1) / 2) < 1e-39
    at = motion.sample(arb(7), DIGITS)
    # q = 2t + 1 − cos t, from the turning point at t = π/2
    whole = at.values[0] + at.periods * advance
    exact = 2 * (7 - arb.pi() / 2) - arb(7).cos()
    assert abs(whole - exact) < 1e-38


@pytest.mark.slow
@pytest.mark.parametrize("gap", ["1e-3", "1e-12", "1e-25"])
def test_long_periods_near_a_separatrix(gap: str) -> None:
    # x′² = (1 − x²)(1 − k²x²) between −1 and 1: the period is 4K(k)
    k = 1 - arb(gap)
    edge = (1 + 1 / k) / 2
    motion = motion_through(lambda x: (1 - x * x) * (1 - k * k * (x * x)), 0, edge=edge)
    quarter = acb(k * k).elliptic_k().real
    assert abs(motion.advances(DIGITS)[0] / (4 * quarter) - 1) < 1e-35


@pytest.mark.slow
@pytest.mark.parametrize("height", ["1e-2", "1e-8"])
def test_slow_passage_over_a_barrier(height: str) -> None:
    # x′² = ε² + x² − x⁴, slow at x = 0: with x² = y the period is elliptic too
    size = arb(height)
    motion = motion_through(lambda x: size * size + x * x - x * x * (x * x), "0.3")
    root = (1 + 4 * size * size).sqrt()
    # x′² = (x² + b)(a − x²), b = (root − 1)/2, a = (root + 1)/2: period 4K/√(a + b), k² = a/(a + b)
    quarter = acb((root + 1) / (2 * root)).elliptic_k().real
    assert abs(motion.advances(DIGITS)[0] - 4 * quarter / root.sqrt()) < 1e-30


@pytest.mark.slow
def test_there_and_back_from_a_double_root() -> None:
    # x′² = x² − x⁴: x = sech t
    begin = arb("0.8")
    motion = motion_through(lambda x: x * x - x * x * (x * x), "0.8", sign=-1)
    assert isinstance(motion.chart, Asymptotic)
    shift = (1 / begin).acosh()
    for time in (-30, -1, 0, 2, 20):
        assert abs(position(motion, time) - (arb(time) + shift).sech()) < 1e-38
    # ∫ x dt in the tail stays what it was, 2·atan e^t less its value at the turning point
    late = motion.sample(arb(1000), DIGITS)
    assert abs(late.values[0] - arb.pi() / 2) < 1e-38
    assert late.tail > 900


@pytest.mark.slow
@pytest.mark.parametrize("sign", [1, -1])
def test_from_one_double_root_to_another(sign: int) -> None:
    motion = motion_through(lambda x: (1 - x * x) * (1 - x * x), "0.25", sign=sign)
    assert isinstance(motion.chart, Heteroclinic)
    shift = arb("0.25").atanh()
    for time in (-20, 0, 3):
        exact = (shift + sign * arb(time)).tanh()
        assert abs(position(motion, time) - exact) < 1e-38


def test_steady_motions_and_their_stability() -> None:
    bottom = motion_equation(lambda x: -(x * x))
    stable = motion_chart(bottom, arb(0), arb(0))
    assert isinstance(stable, Equilibrium)
    assert stable.stable is True
    assert stable.rigidity.contains(1)
    top = motion_chart(motion_equation(lambda x: x * x - x * x * (x * x)), arb(0), arb(0))
    assert isinstance(top, Equilibrium)
    assert top.stable is False


def test_a_denominator_changes_the_clock_alone() -> None:
    slow = motion_through(lambda x: 1 - x * x, 0, lambda x: arb(4) + 0 * x)
    assert abs(slow.advances(DIGITS)[0] - 4 * arb.pi()) < 1e-39
    # dt = √(1 − x²/4) ds: the arc of an ellipse
    arc = motion_through(lambda x: 1 - x * x, 0, lambda x: 1 - x * x * arb("0.25"))
    exact = 4 * acb(arb("0.25")).elliptic_e().real
    assert abs(arc.advances(DIGITS)[0] - exact) < 1e-38


def test_start_at_either_turning_point() -> None:
    for x in (1, -1):
        motion = motion_through(lambda x: 1 - x * x, x)
        assert abs(position(motion, 1) - x * arb(1).cos()) < 1e-38


def test_roots_that_meet_threefold_are_refused() -> None:
    with pytest.raises(InputError, match="more than two roots meet"):
        motion_through(lambda x: x * x * x * (1 - x), "0.5")


def test_a_motion_without_end_is_refused() -> None:
    with pytest.raises(InputError, match="edge of its domain"):
        motion_through(lambda x: 1 + x * x, 0)
