"""Remark 21 by numbers: motions of the ball itself, and where no difference may be found."""

from __future__ import annotations

import numpy as np
import pytest
from flint import arb
from scipy.integrate import solve_ivp

from borisov_mamaev_2008.obstructions.unequal_periods import BALL, BETWEEN, half_period, resonance

MOMENTS = np.array([float(x) for x in BALL[0]])
LEVER = float(BALL[1])
LEVEL = sum(map(float, BETWEEN)) / 2


def motion(_, state):
    """Ṁ = M×ω, γ̇ = γ×ω with M = Iω + D γ×(ω×γ)."""
    momentum, gamma = state[:3], state[3:]
    inverse = 1 / (MOMENTS + LEVER)
    share = (gamma * inverse) @ momentum / (1 - LEVER * (gamma * inverse) @ gamma)
    omega = inverse * (momentum + LEVER * share * gamma)
    return np.concatenate([np.cross(momentum, omega), np.cross(gamma, omega)])


def start(axis):
    """γ along a body axis, (M, γ) = 0, 2H = 1 and M² = e + D, with the other signs positive."""
    gamma = np.eye(3)[axis]
    others = [i for i in range(3) if i != axis]
    J = MOMENTS[others] + LEVER
    squares = np.linalg.solve(np.array([1 / J, [1.0, 1.0]]), [1.0, LEVEL + LEVER])
    momentum = np.zeros(3)
    momentum[others] = np.sqrt(squares)
    return np.concatenate([momentum, gamma])


@pytest.mark.parametrize(("beta", "axis"), [(arb(0), 2), (arb.pi() / 2, 1)])
def test_the_ball_returns_after_the_period(beta, axis):
    """(α, β) = (0, 0) is γ = e₃, and (0, π/2) is γ = e₂."""
    half, turned = half_period(beta)
    assert turned.overlaps(2 * arb.pi())
    period = 2 * float(half)
    state = start(axis)
    found = solve_ivp(motion, (0, 1.05 * period), state, "DOP853", rtol=1e-11, atol=1e-12)
    back = solve_ivp(motion, (0, period), state, "DOP853", rtol=1e-11, atol=1e-12).y[:, -1]
    assert back == pytest.approx(state, abs=2e-3)
    # and not before: half of it turns the first component of γ about
    early = np.linalg.norm(found.y - state[:, None], axis=0)[found.t > 0.05 * period]
    times = found.t[found.t > 0.05 * period]
    assert early[times < 0.95 * period].min() > 0.05


def test_the_resonance_lies_between():
    low, high = (resonance(arb(e))[0] for e in BETWEEN)
    assert low > 0 > high
    step = 1e-4
    slope = resonance(arb(LEVEL))[1]
    steps = resonance(arb(LEVEL + step))[0] - resonance(arb(LEVEL - step))[0]
    assert float(steps) / (2 * step) == pytest.approx(float(slope), rel=1e-5)


def test_bounds_of_a_narrower_interval_lie_inside():
    wide = half_period(arb(0))[0]
    narrow = half_period(arb(0), between=("1.200744", "1.200745"))[0]
    assert wide.contains(narrow)
    assert narrow.rad() < wide.rad() / 5


def test_motions_that_are_images_of_each_other_have_equal_periods():
    """β → π − β is a symmetry; the bounds must not tell these motions apart."""
    first, second = half_period(arb(0))[0], half_period(arb.pi())[0]
    assert first.overlaps(second)
