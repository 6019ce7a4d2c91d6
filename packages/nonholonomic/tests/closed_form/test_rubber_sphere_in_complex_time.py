"""Why no vector that stays in space is a formula in the state of the ball around a sphere, k = −1.

In complex time τ the attitude's equation has a pole wherever (ν, Jν) = 0.  Followed around one, the
vectors that stay in space make a half turn about an axis; followed around two, a turn about the
normal of both axes, of infinite order unless its angle is a part of 2π.  A vector algebraic in the
state has finitely many values, so that it is that normal, for any two of the axes: they lie in a
plane.  For k = 1, where n stays in space, they do.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

J = np.array([1.3, 2.0, 2.7])
NU, NUPRIME = np.array([0.28, 0.67, 0.69]), np.array([-1.3, 0.9, 0.5])
NU = NU / np.linalg.norm(NU)
NUPRIME = NUPRIME - NU * (NU @ NUPRIME)
PULL = NUPRIME @ NUPRIME / (NU @ (J * NU))
#: Places near poles, from which they are looked for.
NEAR = (0.3j, 1.5 + 0.4j, 3 + 0.3j, -3 + 0.3j)


def rates(values, sign):
    """ν″ = c (Jν − 2(ν, Jν)ν) with c = ν′²/(ν, Jν), and v′ = ±v×Ω for the columns v of a matrix."""
    nu, nuprime, columns = values[:3], values[3:6], values[6:].reshape(3, 3)
    square = nu @ (J * nu)
    turning = np.cross(np.sqrt(J) * nu, np.sqrt(J) * nuprime) / square
    pulled = PULL * (J * nu - 2 * square * nu)
    moved = sign * np.cross(columns.T, turning).T
    return np.concatenate([nuprime, pulled, moved.ravel()])


def followed(values, start, end, sign):
    def along(_, x):
        return (end - start) * rates(x, sign)

    return solve_ivp(along, (0, 1), values, "DOP853", rtol=1e-10, atol=1e-11).y[:, -1]


def step_to_pole(values):
    nu, nuprime = values[:3], values[3:6]
    return -(nu @ (J * nu)) / (2 * nuprime @ (J * nu))


def half_turn(near, sign):
    """The pole, and the axis of the half turn around it, at the start."""
    values = np.concatenate([NU, NUPRIME, np.eye(3).ravel()]).astype(complex)
    values, tau = followed(values, 0, near, sign), near
    while abs(step := step_to_pole(values)) > 0.05:
        step *= min(1, 0.1 / abs(step))
        values, tau = followed(values, tau, tau + step / 2, sign), tau + step / 2
    center, there = tau, values
    while abs(step := step_to_pole(there)) > 1e-6:
        step *= 0.8
        there, center = followed(there, center, center + step, sign), center + step
    before = values[6:].reshape(3, 3)
    circle = center + (tau - center) * np.exp(2j * np.pi * np.arange(13) / 12)
    for a, b in pairwise(circle):
        values = followed(values, a, b, sign)
    around = np.linalg.solve(before, values[6:].reshape(3, 3))
    assert np.allclose(around @ around, np.eye(3), atol=1e-6)
    assert np.isclose(np.trace(around), -1, atol=1e-6)
    # a half turn is 2 a⊗a − 1
    dyad = (around + np.eye(3)) / 2
    largest = np.argmax(np.abs(np.diag(dyad)))
    return center, dyad[:, largest] / np.sqrt(dyad[largest, largest])


@pytest.mark.slow
@pytest.mark.parametrize(("sign", "coplanar"), [(1, False), (-1, True)], ids=["k=-1", "k=1"])
def test_axes_of_half_turns(sign, coplanar):
    poles, axes = zip(*(half_turn(near, sign) for near in NEAR), strict=True)
    assert min(abs(a - b) for i, a in enumerate(poles) for b in poles[:i]) > 0.1
    volumes = [abs(np.linalg.det([axes[i] for i in chosen])) for chosen in ((0, 1, 2), (0, 1, 3))]
    assert all((volume < 1e-6) if coplanar else (volume > 0.1) for volume in volumes)
