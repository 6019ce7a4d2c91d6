"""The Lagrange top in closed form."""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from flint import acb, arb, ctx

from flowlanes import lambdify
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.closed_form.base.solution import Solution
from nonholonomic.closed_form.lagrange.solution import TopFrame, solve_top
from nonholonomic.closed_form.one_degree.solution import QuadratureSolution

TOP = CATALOGUE["lagrange-top"].system()


def solved(state: Sequence[Any], system: Any = TOP) -> Solution:
    solution = solve_top(system, state)
    assert solution is not None
    return solution


def random_state(rng: random.Random) -> list[Fraction]:
    """M, and Γ as a rational point of the sphere."""
    p, q = (Fraction(rng.randint(-20, 20), 7) for _ in range(2))
    size = 1 + p * p + q * q
    momentum = [Fraction(rng.randint(-30, 30), 10) for _ in range(3)]
    return [*momentum, 2 * p / size, 2 * q / size, (size - 2) / size]


CASES: dict[str, Sequence[Any]] = {
    "nods": (0.4, -0.2, 1.5, Fraction(2, 7), Fraction(3, 7), Fraction(6, 7)),
    "without spin": (0.4, -0.2, 0.0, Fraction(2, 7), Fraction(3, 7), Fraction(6, 7)),
    "plane pendulum": (0.3, -0.2, 0.0, Fraction(2, 7), Fraction(3, 7), Fraction(6, 7)),
    "through the upper pole": (0.5, 0.1, 1.5, 0, 0, 1),
    "through the lower pole": (0.5, 0.1, 1.5, 0, 0, -1),
    "over and over": (9, 1, 0, 0, 0, 1),
    "sleeps": (0, 0, 3, 0, 0, 1),
    "hangs": (0, 0, 3, 0, 0, -1),
}


@pytest.mark.parametrize("name", CASES)
def test_both_evaluators_and_the_equations_agree(name: str) -> None:
    solution = solved(CASES[name])
    times = [0.0, 1.3, -7.1, 1000.0]
    for time, row in zip(times, solution.states(np.array(times)), strict=True):
        for ball, value in zip(solution.rigorous(time, 20), row, strict=True):
            assert abs(float(ball.mid()) - value) < 1e-12
            assert float(ball.rad()) < 1e-20
    begin = [float(x) for x in CASES[name]]
    assert np.abs(solution.states([0.0])[0] - begin).max() < 1e-15
    step = 2e-3
    states = solution.states(2.2 + step * np.array([-2.0, -1.0, 0.0, 1.0, 2.0]))
    slope = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) @ states / (12 * step)
    parameters = np.array([float(x) for x in solution.parameters.values()])
    field = lambdify(solution.system)(2.2, states[2], parameters)
    assert np.abs(slope - field).max() < 1e-7


@pytest.mark.slow
def test_against_integration() -> None:
    rng = random.Random(3)
    for _ in range(3):
        state = random_state(rng)
        numbers = [str(x.numerator / x.denominator) for x in state]
        exact = [Fraction(x) for x in numbers]
        times = [0.0, 1.0, 30.0]
        trajectory = integrate(TOP, [float(x) for x in numbers], times, precision="quad")
        found = solved(exact).states(np.array(times))
        assert np.abs(trajectory.states.astype(float) - found).max() < 1e-12


def sn_squared(modulus: arb, w: arb, time: arb) -> arb:
    """sn²(wt, k) by theta functions: sn = (θ₃/θ₂)(θ₁(v)/θ₄(v)), v = wt/2K."""
    quarter, other = (acb(m).elliptic_k().real for m in (modulus, 1 - modulus))
    tau = acb(0, other / quarter)
    _, second, third, _ = acb.modular_theta(acb(0), tau)
    v = w * time / (2 * quarter)
    first, _, _, fourth = acb.modular_theta(acb(v - v.mid().floor()), tau)
    sine = (third * first / (second * fourth)).real
    return sine * sine


def test_nutation_is_the_elliptic_function() -> None:
    solution = solved(CASES["nods"])
    assert isinstance(solution, QuadratureSolution)
    assert isinstance(solution.frame, TopFrame)
    with ctx.workprec(200):
        motion = solution.motion
        elliptic = solution.frame.top.elliptic_parameters(motion.chart)
        assert elliptic is not None
        modulus, w = elliptic
        period = motion.advances(40)[0]
        assert abs(2 * acb(modulus).elliptic_k().real / w - period) < 1e-40
        low, high = sorted((motion.chart.first.x, motion.chart.second.x), key=float)
        # the phase is zero at the upper root, half a period after the lower one
        begin = motion.integrals(40).value(0, motion.start_phase)
        for time in (0, 5, 1000):
            u = solution.rigorous(time, 30)[5]
            exact = low + (high - low) * sn_squared(modulus, w, time + begin - period / 2)
            assert abs(exact - u) < 1e-30


def test_sleeping_top_is_stable_when_it_is_fast() -> None:
    # s² > 4 I₁P
    assert "unstable" in solved((0, 0, 0.1, 0, 0, 1)).form.motion
    assert "unstable" not in solved((0, 0, 30, 0, 0, 1)).form.motion
    assert "unstable" not in solved((0, 0, 0.1, 0, 0, -1)).form.motion


@pytest.mark.slow
def test_slow_sleeping_top_is_left_and_approached_for_ever() -> None:
    values = {str(p.symbol): p.default for p in TOP.parameters}
    with mpmath.workdps(60):
        across, weight = (mpmath.mpf(repr(values[name])) for name in ("I_1", "P"))
        s, u, sine = mpmath.mpf(1) / 10, mpmath.mpf(7) / 25, mpmath.mpf(24) / 25
        # on the energy of the sleeping top, with c = s: I₁u̇² = (1 − u)²(2P(1 + u) − s²/I₁)
        rate = (1 - u) * mpmath.sqrt((2 * weight * (1 + u) - s * s / across) / across)
        state = [s * (1 - u) / sine, across * rate / sine, s, sine, 0, u]
    solution = solved(state)
    assert "asymptotic" in solution.form.motion
    assert abs(solution.states([500.0])[0, 5] - 1) < 1e-15
    assert max(float(ball.rad()) for ball in solution.rigorous(10**6, 20)) < 1e-18
    for time in (-3.0, 0.0, 2.0, 500.0):
        for ball, value in zip(
            solution.rigorous(time, 20), solution.states([time])[0], strict=True
        ):
            assert abs(float(ball.mid()) - value) < 1e-12


def test_a_vertical_that_is_not_a_unit_vector_is_refused() -> None:
    with pytest.raises(InputError, match=r"\|Gamma\| is 2"):
        solved((0, 0, 1, 0, 0, 2))


def test_other_systems_are_left_alone() -> None:
    assert solve_top(CATALOGUE["chaplygin-ball"].system(), (0,) * 6) is None


@pytest.mark.campaign
def test_campaign() -> None:
    rng = random.Random(7)
    for number in range(100):
        state = [float(x) for x in random_state(rng)]
        times = [0.0, 100.0, 1000.0]
        trajectory = integrate(TOP, state, times, precision="quad")
        found = solved(state).states(np.array(times))
        assert np.abs(trajectory.states.astype(float) - found).max() < 1e-12, number
