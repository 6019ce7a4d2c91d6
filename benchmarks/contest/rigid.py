"""MuJoCo: the Chaplygin ball as a sphere on a plane with friction."""

from __future__ import annotations

import math

import numpy as np

from .bodies import Body
from .programs import Program, Run

__all__ = ["mujoco_ball"]

#: Time constant and damping of the contact, the stiffest that is stable with 2 ms steps.
_MODEL = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -9.81" integrator="RK4" cone="elliptic" impratio="100"
          solver="Newton" tolerance="1e-14" iterations="100"/>
  <default>
    <geom friction="10 0 0" condim="3" solref="0.004 1" solimp="0.9999 0.9999 0.001"/>
  </default>
  <worldbody>
    <geom type="plane" size="50 50 1"/>
    <body pos="0 0 {R}">
      <freejoint/>
      <inertial pos="0 0 0" mass="{m}" diaginertia="{I_1} {I_2} {I_3}"/>
      <geom type="sphere" size="{R}"/>
    </body>
  </worldbody>
</mujoco>
"""


def mujoco_ball(body: Body, until: float) -> Program:
    """Program whose setting is the step length in seconds; the result is in M and γ."""
    import mujoco

    numbers = {str(p.symbol): p.default for p in body.system.parameters}
    inertia = np.array([numbers[f"I_{i}"] for i in (1, 2, 3)])
    mass, radius = numbers["m"], numbers["R"]
    about_contact = inertia + mass * radius**2

    def build(step: float) -> Run:
        model = mujoco.MjModel.from_xml_string(_MODEL.format(step=step, **numbers))
        data = mujoco.MjData(model)

        def run(starts: np.ndarray) -> np.ndarray:
            ends = []
            for start in starts:
                momentum, gamma = start[:3], start[3:]
                form = np.diag(about_contact) - mass * radius**2 * np.outer(gamma, gamma)
                omega = np.linalg.solve(form, momentum)
                mujoco.mj_resetData(model, data)
                quaternion, turn = _upright(gamma)
                data.qpos[:] = 0.0, 0.0, radius, *quaternion
                data.qvel[:3] = np.cross(turn @ omega, (0.0, 0.0, radius))
                data.qvel[3:] = omega
                mujoco.mj_step(model, data, round(until / step))
                gamma, omega = _matrix(data.qpos[3:])[2], data.qvel[3:]
                spin = mass * radius**2 * (omega @ gamma)
                ends.append(np.concatenate([about_contact * omega - spin * gamma, gamma]))
            return np.array(ends)

        return run

    return Program("MuJoCo", build)


def _upright(gamma: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rotation from body to space axes that maps γ to the vertical: quaternion and matrix."""
    axis = np.cross(gamma, (0.0, 0.0, 1.0))
    half = math.acos(np.clip(gamma[2], -1, 1)) / 2
    length = math.hypot(*axis)
    vector = math.sin(half) * axis / length
    quaternion = np.array([math.cos(half), *vector])
    return quaternion, _matrix(quaternion)


def _matrix(quaternion: np.ndarray) -> np.ndarray:
    import mujoco

    flat = np.empty(9)
    mujoco.mju_quat2Mat(flat, quaternion)
    return flat.reshape(3, 3)
