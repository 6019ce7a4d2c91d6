"""The Whipple bicycle by Kane's method in SymPy, constructed as in the test suite of SymPy.

The bicycle is described from the rear contact point upwards, with yaw, roll, pitch and steering
angle as coordinates, and the angular velocities of yaw, roll, pitch, steering and both wheels as
speeds.  The front contact point is at rest (three velocity constraints) and on the ground (one
configuration constraint).  Axes: x forward, y right, z down.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.physics.mechanics import (
    KanesMethod,
    Point,
    ReferenceFrame,
    RigidBody,
    dot,
    dynamicsymbols,
    inertia,
)

__all__ = ["NAMES", "kane_bicycle"]

#: Parameters of the bicycle, as in the benchmark paper.
NAMES = (
    *("w", "c", "lambda", "g", "R_R", "m_R", "I_Rxx", "I_Ryy"),
    *("x_B", "z_B", "m_B", "I_Bxx", "I_Byy", "I_Bzz", "I_Bxz"),
    *("x_H", "z_H", "m_H", "I_Hxx", "I_Hyy", "I_Hzz", "I_Hxz"),
    *("R_F", "m_F", "I_Fxx", "I_Fyy"),
)


def kane_bicycle() -> tuple[KanesMethod, list[RigidBody], list[Any]]:
    """Method with its kinematics and constraints, bodies and loads."""
    p = {name: sp.Symbol(name) for name in NAMES}
    tilt, g = p["lambda"], p["g"]
    yaw, roll, pitch, steer = dynamicsymbols("q1 q2 q4 q5")
    speeds = dynamicsymbols("u1:7")
    u_yaw, u_roll, u_rear, u_pitch, u_steer, u_front = speeds

    space = ReferenceFrame("N")
    heading = space.orientnew("Y", "Axis", [yaw, space.z])
    leaning = heading.orientnew("R", "Axis", [roll, heading.x])
    frame = leaning.orientnew("B", "Axis", [pitch, leaning.y])
    column = frame.orientnew("C", "Axis", [tilt, frame.y])
    fork = column.orientnew("F", "Axis", [steer, column.z])
    level = fork.orientnew("L", "Axis", [-tilt, fork.y])
    rear_wheel, front_wheel = ReferenceFrame("WR"), ReferenceFrame("WF")

    heading.set_ang_vel(space, u_yaw * heading.z)
    leaning.set_ang_vel(heading, u_roll * leaning.x)
    frame.set_ang_vel(leaning, u_pitch * frame.y)
    rear_wheel.set_ang_vel(frame, u_rear * frame.y)
    fork.set_ang_vel(frame, u_steer * fork.z)
    front_wheel.set_ang_vel(fork, u_front * fork.y)

    # distances in the tilted axes; the rear hub projected onto the column lies at reach e_1
    cl, sl = sp.cos(tilt), sp.sin(tilt)
    reach = (p["w"] + p["c"]) * cl - p["R_R"] * sl

    def tilted(x: sp.Expr, z: sp.Expr, axes: ReferenceFrame, less: sp.Expr) -> Any:
        return (x * cl - z * sl - less) * axes.x + (x * sl + z * cl) * axes.z

    rear_contact = Point("P")
    rear_hub = rear_contact.locatenew("hub_R", -p["R_R"] * leaning.z)
    rider = rear_hub.locatenew("B*", tilted(p["x_B"], p["z_B"] + p["R_R"], column, 0))
    foot = rear_hub.locatenew("S", reach * column.x)
    handle = foot.locatenew("H*", tilted(p["x_H"], p["z_H"] + p["R_R"], fork, reach))
    front_hub = foot.locatenew("hub_F", tilted(p["w"], p["R_R"] - p["R_F"], fork, reach))
    down = heading.z - dot(heading.z, fork.y) * fork.y
    front_contact = front_hub.locatenew("Q", p["R_F"] * down.normalize())

    rear_contact.set_vel(space, 0)
    rear_hub.v2pt_theory(rear_contact, space, rear_wheel)
    rider.v2pt_theory(rear_hub, space, frame)
    foot.v2pt_theory(rear_hub, space, frame)
    handle.v2pt_theory(foot, space, fork)
    front_hub.v2pt_theory(foot, space, fork)
    front_contact.v2pt_theory(front_hub, space, front_wheel)

    def inertia_of(name: str, axes: ReferenceFrame, centre: Point) -> tuple[Any, Point]:
        if name in "RF":
            xx = zz = p[f"I_{name}xx"]
            return inertia(axes, xx, p[f"I_{name}yy"], zz), centre
        xx, yy, zz, xz = (p[f"I_{name}{ij}"] for ij in ("xx", "yy", "zz", "xz"))
        return inertia(axes, xx, yy, zz, 0, 0, xz), centre

    bodies = [
        RigidBody("R", rear_hub, rear_wheel, p["m_R"], inertia_of("R", frame, rear_hub)),
        RigidBody("B", rider, frame, p["m_B"], inertia_of("B", frame, rider)),
        RigidBody("H", handle, fork, p["m_H"], inertia_of("H", level, handle)),
        RigidBody("F", front_hub, front_wheel, p["m_F"], inertia_of("F", fork, front_hub)),
    ]
    loads = [(body.masscenter, body.mass * g * heading.z) for body in bodies]
    slip = front_contact.vel(space)
    method = KanesMethod(
        space,
        q_ind=[yaw, roll, steer],
        q_dependent=[pitch],
        configuration_constraints=[dot(front_contact.pos_from(rear_contact), heading.z)],
        u_ind=[u_roll, u_rear, u_steer],
        u_dependent=[u_yaw, u_pitch, u_front],
        velocity_constraints=[dot(slip, axis) for axis in heading],
        kd_eqs=[
            yaw.diff() - u_yaw,
            roll.diff() - u_roll,
            pitch.diff() - u_pitch,
            steer.diff() - u_steer,
        ],
        bodies=bodies,
        forcelist=loads,
        constraint_solver="CRAMER",
    )
    return method, bodies, loads
