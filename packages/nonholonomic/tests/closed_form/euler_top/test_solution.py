"""The free rigid body in closed form."""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from flowlanes import lambdify
from flowlanes.errors import InputError
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form import solve
from nonholonomic.closed_form.base.solution import Solution

MOMENTS = {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1}
UPRIGHT = (0, 0, 1, 1, 0, 0, 0)


def solved(
    momentum: Sequence[Any], moments: dict[str, float] = MOMENTS, rest: Sequence[Any] = UPRIGHT
) -> Solution:
    system = from_catalogue("free-body", **moments)
    return solve(system, [*momentum, *rest])


def separatrix() -> list[mpmath.mpf]:
    """A momentum with 2hI₂ = M², to fifty digits: M₁²(1/I₁ − 1/I₂) = M₃²(1/I₂ − 1/I₃)."""
    with mpmath.workdps(60):
        first, second, third = (mpmath.mpf(repr(x)) for x in MOMENTS.values())
        ratio = (1 / first - 1 / second) / (1 / second - 1 / third)
        return [mpmath.mpf("0.3"), mpmath.mpf("0.4"), mpmath.mpf("0.3") * mpmath.sqrt(ratio)]


#: Momentum, moments, and words of the kind of motion.
CASES: dict[str, tuple[Sequence[Any], dict[str, float], str]] = {
    "circles the greatest": ((0.3, 0.2, -1.1), MOMENTS, "greatest"),
    "circles the least": ((1.3, -0.2, 0.4), MOMENTS, "least"),
    "other order": ((0.1, 1.2, 0.4), {"I_1": 2.1, "I_2": 1.0, "I_3": 1.5}, "least"),
    "at a turning point": ((0, 0.5, 1.1), MOMENTS, "greatest"),
    "near an axis": ((1e-9, 1e-5, 1.0), MOMENTS, "greatest"),
    "near the middle axis": ((1e-7, 1.0, 1e-6), MOMENTS, "circles"),
    "moments nearly equal": ((0.4, 0.5, 0.6), {"I_1": 1.0, "I_2": 1.0001, "I_3": 1.5}, "circles"),
    "separatrix": (separatrix(), MOMENTS, "separatrix"),
    "rotation about the middle": ((0, 2, 0), MOMENTS, "middle moment, unstable"),
    "rotation about the least": ((-2, 0, 0), MOMENTS, "least moment, stable"),
    "two equal moments": ((0.3, 0.2, -1.1), {"I_1": 1.0, "I_2": 1.0, "I_3": 1.7}, "precession"),
    "two others": ((0.3, 0.2, -1.1), {"I_1": 0.9, "I_2": 1.7, "I_3": 1.7}, "precession"),
    "three equal moments": ((0.3, 0.2, -1.1), {"I_1": 1.0, "I_2": 1.0, "I_3": 1.0}, "permanent"),
    "rest": ((0, 0, 0), MOMENTS, "at rest"),
}


SLOW = ("separatrix", "near the middle axis")


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.slow) if n in SLOW else n for n in CASES]
)
def test_both_evaluators_and_the_equations_agree(name: str) -> None:
    momentum, moments, words = CASES[name]
    solution = solved(momentum, moments)
    assert words in solution.form.motion
    begin = [float(x) for x in (*momentum, *UPRIGHT)]
    assert np.abs(solution.states([0.0])[0] - begin).max() < 1e-14
    times = [1.3, -7.1, 1000.0]
    for time, row in zip(times, solution.states(np.array(times)), strict=True):
        for ball, value in zip(solution.rigorous(time, 20), row, strict=True):
            assert abs(float(ball.mid()) - value) < 1e-13
            assert float(ball.rad()) < 1e-20
    step = 2e-3
    states = solution.states(2.2 + step * np.array([-2.0, -1.0, 0.0, 1.0, 2.0]))
    slope = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) @ states / (12 * step)
    parameters = np.array([float(x) for x in solution.parameters.values()])
    field = lambdify(solution.system)(2.2, states[2], parameters)
    assert np.abs(slope - field).max() < 1e-9


def followed(moments: np.ndarray, momentum: np.ndarray, time: float) -> np.ndarray:
    """M in the body and the attitude matrix, by Euler's equations."""

    def field(_: float, y: np.ndarray) -> np.ndarray:
        omega = y[:3] / moments
        a, b, c = omega
        hat = np.array([[0, -c, b], [c, 0, -a], [-b, a, 0]])
        return np.concatenate([np.cross(y[:3], omega), (y[3:].reshape(3, 3) @ hat).ravel()])

    start = np.concatenate([momentum, np.eye(3).ravel()])
    kept: np.ndarray = solve_ivp(field, (0, time), start, "DOP853", rtol=1e-13, atol=1e-14).y[:, -1]
    return kept


@pytest.mark.slow
def test_random_bodies_against_an_integration_of_the_attitude_matrix() -> None:
    rng = np.random.default_rng(5)
    for _ in range(20):
        parts = rng.uniform(0.2, 1.5, 3)
        moments = parts.sum() - parts
        momentum = rng.normal(size=3) * rng.uniform(0.1, 4)
        solution = solved(momentum.tolist(), dict(zip(MOMENTS, moments.tolist(), strict=True)))
        state = solution.states([10.0])[0]
        expected = followed(moments, momentum, 10.0)
        w, x, y, z = state[6:]
        turn = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        )
        assert np.abs(state[:3] - expected[:3]).max() < 1e-11
        assert np.abs(turn - expected[3:].reshape(3, 3)).max() < 1e-11
        assert np.abs(turn[2] - state[3:6]).max() < 1e-14


def test_the_components_of_the_momentum_are_elliptic_functions() -> None:
    """M₁, M₂, M₃ are amplitudes times cn, sn and dn, which mpmath computes by itself."""
    solution = solved((0, 0.5, 1.1))
    form = solution.form
    with mpmath.workdps(40):
        inverse = [1 / mpmath.mpf(repr(x)) for x in MOMENTS.values()]
        M2, M3 = mpmath.mpf("0.5"), mpmath.mpf("1.1")
        # at the start M₁ = 0: dn is least there, and M₂ is greatest in size
        square = M2**2 + M3**2
        ratio = (M2**2 * inverse[1] + M3**2 * inverse[2]) / square
        high = (ratio - inverse[0]) / (inverse[2] - inverse[0])
        low = (ratio - inverse[1]) / (inverse[2] - inverse[1])
        low, high = sorted((low, high))
        modulus = (high - low) / high
        pace = mpmath.sqrt(square * high * (inverse[0] - inverse[2]) * (inverse[1] - inverse[2]))
        assert abs(float(form["k^2"].value) - modulus) < 1e-15
        assert abs(float(form["w"].value) - pace) < 1e-15
        quarter = mpmath.ellipk(modulus)
        assert abs(float(form["T"].value) - 4 * quarter / pace) < 1e-14
        for time in (0, 1, 1000):
            argument = pace * time + quarter
            exact = mpmath.sqrt(square * high) * mpmath.ellipfun("dn", argument, m=modulus)
            ball = solution.rigorous(time, 30)[2]
            assert abs(mpmath.mpf(str(ball.mid().str(35, radius=False))) - exact) < 1e-30


@pytest.mark.slow
def test_a_motion_on_the_separatrix_goes_from_one_rotation_to_the_opposite_one() -> None:
    solution = solved(separatrix())
    length = float(mpmath.sqrt(sum(x * x for x in separatrix())))
    states = solution.states([-300.0, 300.0])
    assert states[:, 1] == pytest.approx([length, -length], rel=1e-15) or states[
        :, 1
    ] == pytest.approx([-length, length], rel=1e-15)
    assert np.abs(states[:, [0, 2]]).max() < 1e-15
    # far away in time the body rotates uniformly
    assert max(float(ball.rad()) for ball in solution.rigorous(10**6, 20)) < 1e-18


def test_a_direction_is_carried_without_attitude_too() -> None:
    system = from_catalogue("free-body")
    gamma = [2 / 7, 3 / 7, 6 / 7]
    alone = solve(system, [0.3, 0.2, -1.1, *gamma])
    with_attitude = solve(system, {"omega": [0.3, 0.2 / 1.5, -1.1 / 2.1], "gamma": gamma})
    assert len(alone.system.symbols) == 6
    assert np.abs(alone.states([5.0])[0] - with_attitude.states([5.0])[0, :6]).max() < 1e-14


def test_large_times_keep_all_digits() -> None:
    solution = solved((0.3, 0.2, -1.1))
    state = solution.states([1e9])[0]
    exact = [float(x) for x in solution.rigorous(10**9, 20)]
    assert state == pytest.approx(exact, abs=1e-13)


def test_a_start_off_the_phase_space_is_refused() -> None:
    with pytest.raises(InputError, match=r"\|gamma\| = 1"):
        solved((0.3, 0.2, -1.1), rest=(0, 0, 2, 1, 0, 0, 0))
    with pytest.raises(InputError, match="gamma = the vertical of the attitude"):
        solved((0.3, 0.2, -1.1), rest=(1, 0, 0, 1, 0, 0, 0))


@pytest.mark.slow
def test_the_motion_is_recognised_by_its_equations() -> None:
    """Chaplygin's ball with three equal moments is none, though its letters are the same."""
    ball = from_catalogue("chaplygin-ball", I_1=1.0, I_2=1.0, I_3=1.0)
    form = solve(ball, {"omega": [0.3, 0.4, 0.5], "gamma": [0, 0, 1]}).form
    assert form.title != "Free rigid body"


@pytest.mark.campaign
def test_campaign() -> None:
    rng = random.Random(7)
    for number in range(200):
        parts = [rng.uniform(0.01, 3) for _ in range(3)]
        moments = {name: sum(parts) - x for name, x in zip(MOMENTS, parts, strict=True)}
        momentum = [rng.choice([1, 1, 1e-3, 1e-6]) * rng.uniform(-1, 1) for _ in range(3)]
        solution = solved(momentum, moments)
        expected = followed(np.array(list(moments.values())), np.array(momentum), 30.0)
        assert np.abs(solution.states([30.0])[0, :3] - expected[:3]).max() < 1e-11, number
