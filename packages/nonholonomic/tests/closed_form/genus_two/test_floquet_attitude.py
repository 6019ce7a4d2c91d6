"""The attitude along a winding of the torus, reduced to a uniform rotation."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from flint import ctx
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from flowlanes.formulas.balls import number
from nonholonomic.closed_form.base.no_closed_form import NoClosedFormError
from nonholonomic.closed_form.genus_two.floquet_attitude import reduction
from nonholonomic.closed_form.genus_two.separated_motion import separate
from nonholonomic.closed_form.separations.rubber_sphere import of_ratio

RATE = 0.37
TIMES = np.array([0.0, 0.3, 17.0, 1000.0])


def attitude(v, tau):
    """R₁(a + λτ) R₂(b) R₃(c) with a, b, c on the torus."""
    a = 0.6 * np.sin(np.pi * v[:, 0]) + 0.2 * np.cos(np.pi * (v[:, 0] - v[:, 1]))
    b = 0.5 * np.cos(np.pi * v[:, 1]) + 0.3 * np.sin(np.pi * (v[:, 0] + v[:, 1]))
    c = 0.4 * np.cos(np.pi * v[:, 0]) * np.sin(np.pi * v[:, 1])
    turns = np.stack([a + RATE * tau, b, c], axis=1)
    # capital letters: axes that turn with the body
    return Rotation.from_euler("XYZ", turns)


def angular_velocity(V):
    """Of that attitude, body axes, by the rates of its angles."""

    def turning(v):
        first, second = np.pi * v[:, 0], np.pi * v[:, 1]
        one, two = np.pi * V[0], np.pi * V[1]
        b = 0.5 * np.cos(second) + 0.3 * np.sin(first + second)
        c = 0.4 * np.cos(first) * np.sin(second)
        da = RATE + 0.6 * one * np.cos(first) - 0.2 * (one - two) * np.sin(first - second)
        db = -0.5 * two * np.sin(second) + 0.3 * (one + two) * np.cos(first + second)
        dc = 0.4 * (two * np.cos(first) * np.cos(second) - one * np.sin(first) * np.sin(second))
        return np.array(
            [
                da * np.cos(b) * np.cos(c) + db * np.sin(c),
                -da * np.cos(b) * np.sin(c) + db * np.cos(c),
                da * np.sin(b) + dc,
            ]
        )

    return turning


def quaternions(rotations):
    return np.roll(rotations.as_quat(), 1, axis=-1)


def same_up_to_sign(found, expected, tolerance):
    sign = np.sign(np.sum(found * expected, axis=1))
    assert np.max(np.abs(found - sign[:, None] * expected)) < tolerance


@pytest.mark.parametrize("V", [(0.51, 0.58689863), (-0.7, 0.31), (0.4, -0.17)], ids=str)
def test_a_known_attitude(V):
    v_0 = np.array([0.3, -0.8])
    v = v_0 + np.outer(TIMES, V)
    expected = quaternions(attitude(v, TIMES))
    made = reduction(angular_velocity(V), V, v_0, expected[0])
    assert made.residual < 1e-12
    found = made.attitude(v, TIMES)
    same_up_to_sign(found[:3], expected[:3], 2e-13)
    same_up_to_sign(found[3:], expected[3:], 1e-11)
    assert np.allclose(found[0], expected[0], atol=1e-14)


def test_the_vector_that_stays_in_space():
    V, v_0 = (0.51, 0.83 / np.sqrt(2)), np.array([0.3, -0.8])
    v = v_0 + np.outer(TIMES, V)
    turns = attitude(v, TIMES)
    made = reduction(angular_velocity(V), V, v_0, quaternions(turns)[0])
    in_space = turns.apply(made.fixed_vector(v).T)
    assert np.allclose(np.abs(in_space), [[1, 0, 0]], atol=1e-11)
    assert np.ptp(in_space[:, 0]) < 1e-11


def test_an_angular_velocity_that_is_not_smooth_is_refused():
    with pytest.raises(NoClosedFormError, match="not resolved"):
        reduction(
            lambda v: np.array([np.sign(np.sin(np.pi * v[:, 0]))] * 3),
            (0.51, 0.3),
            np.zeros(2),
            (1.0, 0.0, 0.0, 0.0),
        )


@pytest.mark.slow
def test_the_rubber_ball_around_a_sphere():
    """No vector that stays in space is a formula in its state; here is one by its series."""
    separable = of_ratio()
    J = np.array([1.3, 2.0, 2.7])
    start = (0.9, -0.3, -1.04, 0.48, -0.64, 0.6)
    numbers = (*map(Fraction, ("1.3", "2", "2.7")), Fraction(-1))
    values = dict(zip((p.symbol for p in separable.system.parameters), numbers, strict=True))
    with ctx.workprec(200):
        torus = separate(replace(separable, level=()), values, start).torus
    V, v_0 = (np.array([number(x) for x in pair]) for pair in (torus.V, torus.v_0))

    def turning(v):
        """ω dt/dτ = e×e′/e² with e = J^(1/2) ν."""
        e, moved = (np.sqrt(J)[:, None] * x for x in torus.values(v))
        return np.cross(e, moved, axis=0) / np.sum(e * e, axis=0)

    made = reduction(turning, V, v_0, (0.5, 0.5, -0.5, 0.5))
    assert made.residual < 1e-12

    def rate(tau, q):
        x, y, z = turning((v_0 + V * tau)[None, :])[:, 0]
        generator = np.array([[0, -x, -y, -z], [x, 0, z, -y], [y, -z, 0, x], [z, y, -x, 0]])
        return generator @ q / 2

    times = np.array([0.0, 1.0, 10.0])
    whole = solve_ivp(rate, (0, 10), [0.5, 0.5, -0.5, 0.5], "DOP853", times, rtol=1e-12, atol=1e-13)
    found = made.attitude(v_0 + np.outer(times, V), times)
    assert np.max(np.abs(found - whole.y.T)) < 1e-10
