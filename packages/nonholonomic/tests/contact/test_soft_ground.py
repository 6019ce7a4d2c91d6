"""A loaded ball on a stiff, damped ground with smoothed friction tends to the exact motion.

Nothing here comes from the package: Newton's and Euler's equations, a spring and a damper along the
normal, friction μN u/√(u² + ε²).  In the limit of a stiff ground and of ε → 0 this is the
body in contact with dry friction, with all its changes of mode.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from contact.situations import CASES

CASE = CASES["loaded ball"]
#: Of the ground, N/m, and as a share of critical damping.
STIFFNESS, DAMPING = 1e6, 0.7


def final_state(width: float) -> np.ndarray:
    """Position and angular velocity at the end, for friction smoothed over a speed."""
    body, given = CASE["body"], CASE["start"]
    mass, inertia, shape = body["mass"], np.array(body["inertia"]), body["shape"]
    centre, down = np.array(shape["centre"]), np.array([0.0, 0.0, -shape["radius"]])
    mu, g = CASE["contact"]["mu"], CASE["gravity"]
    damping = 2 * DAMPING * np.sqrt(STIFFNESS * mass)

    def rates(_: float, y: np.ndarray) -> np.ndarray:
        position, quaternion, velocity, omega = y[:3], y[3:7], y[7:10], y[10:]
        attitude = Rotation.from_quat(quaternion, scalar_first=True).as_matrix()
        arm = attitude @ centre + down
        slip = velocity + np.cross(attitude @ omega, arm)
        gap = position[2] + arm[2]
        normal = max(0.0, -STIFFNESS * gap - damping * slip[2]) if gap < 0 else 0.0
        tangential = -mu * normal * slip[:2] / np.sqrt(slip[:2] @ slip[:2] + width**2)
        force = np.array([*tangential, normal])
        couple = attitude.T @ np.cross(arm, force)
        w, v = quaternion[0], quaternion[1:]
        turning = 0.5 * np.array([-v @ omega, *(w * omega + np.cross(v, omega))])
        return np.concatenate(
            [
                velocity,
                turning,
                force / mass - [0.0, 0.0, g],
                (couple - np.cross(omega, inertia * omega)) / inertia,
            ]
        )

    start = [*given["position"], *given["attitude"], *given["velocity"], *given["omega"]]
    run = solve_ivp(rates, (0, CASE["until"]), start, method="LSODA", rtol=1e-8, atol=1e-10)
    return np.concatenate([run.y[:3, -1], run.y[10:, -1]])


@pytest.mark.slow
def test_the_limit_of_a_stiff_ground_is_the_motion_of_the_table() -> None:
    final = CASE["final"]
    exact = np.concatenate([final["position"], final["omega"]])
    coarse, fine = (np.abs(final_state(width) - exact).max() for width in (1e-3, 1e-4))
    assert coarse < 0.04
    assert fine < coarse / 5
