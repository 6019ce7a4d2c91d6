"""Error against time for a loaded ball that slides, sticks, rolls and slips, for several programs.

The motion is the "loaded ball" of the reference table in the tests: dry friction μ = 0.3, five
changes of the contact.  SciPy integrates the same equations of sliding with the friction smoothed
at small slip, which is the usual method.  If they are installed, MuJoCo is used with its elliptic
cone, and Drake with its convex formulation of contact (SAP).  The programs alternate; the results
are medians of processor time.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from contact.situations import CASES, situation, start
from flowlanes import lambdify
from nonholonomic.contact import CompiledContact, FrictionalContact, contact_motion
from nonholonomic.contact.equations.equations_of_motion import contact_equations
from nonholonomic.contact.friction.modes import Mode

CASE = CASES["loaded ball"]
UNTIL = CASE["until"]
TURNS = 5

#: Function that returns the final position and angular velocity, for one program and setting.
Run = Callable[[], np.ndarray]

_MODEL = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -{g}" integrator="{integrator}" cone="elliptic"
          impratio="{impratio}" solver="Newton" tolerance="1e-14" iterations="100"/>
  <default>
    <geom friction="{mu} 0 0" condim="3" solref="{stiff} 1" solimp="0.9999 0.9999 0.001"/>
  </default>
  <worldbody>
    <geom type="plane" size="50 50 1"/>
    <body>
      <freejoint/>
      <inertial pos="0 0 0" mass="{m}" fullinertia="{inertia}"/>
      <geom type="sphere" size="{R}" pos="{centre}"/>
    </body>
  </worldbody>
</mujoco>
"""


def ours(contact: FrictionalContact, state: np.ndarray) -> Run:
    """This package."""
    compiled = CompiledContact(contact)

    def run() -> np.ndarray:
        end = contact_motion(compiled, state, [0.0, UNTIL]).end_state
        return np.concatenate([end[4:7], end[10:13]])

    return run


def regularised(contact: FrictionalContact, state: np.ndarray, width: float) -> Run:
    """SciPy's LSODA with friction μN u/√(u² + width²) for the whole motion."""
    system = contact_equations(contact, Mode())
    speed = next(i for i, (n, _) in enumerate(system.definitions) if str(n) == "slip_speed")
    smooth = list(system.definitions)
    smooth[speed] = (smooth[speed][0], (smooth[speed][1] ** 2 + width**2) ** 0.5)
    rates = lambdify(replace(system, definitions=tuple(smooth), guards=(), laws=(), relations=()))

    def run() -> np.ndarray:
        result = solve_ivp(rates, (0, UNTIL), state, method="LSODA", rtol=1e-10, atol=1e-10)
        end = result.y[:, -1]
        return np.concatenate([end[4:7], end[10:13]])

    return run


def mujoco(step: float, integrator: str) -> Run:
    """MuJoCo with steps of equal length."""
    import mujoco as engine

    body, given = CASE["body"], CASE["start"]
    inertia = np.array(body["inertia"], dtype=float)
    full = np.diag(inertia) if inertia.ndim == 1 else inertia
    entries = [full[0, 0], full[1, 1], full[2, 2], full[0, 1], full[0, 2], full[1, 2]]
    shape = body["shape"]
    model = engine.MjModel.from_xml_string(
        _MODEL.format(
            step=step,
            g=CASE["gravity"],
            integrator=integrator,
            impratio=100,
            mu=CASE["contact"]["mu"],
            stiff=2 * step,
            m=body["mass"],
            inertia=" ".join(map(str, entries)),
            R=shape["radius"],
            centre=" ".join(map(str, shape["centre"])),
        )
    )
    data = engine.MjData(model)
    turn = Rotation.from_quat(given["attitude"], scalar_first=True)

    def run() -> np.ndarray:
        engine.mj_resetData(model, data)
        # the body frame of MuJoCo has principal axes only if the tensor is not diagonal
        data.qpos[:] = *given["position"], *turn.as_quat(scalar_first=True)
        data.qvel[:] = *given["velocity"], *given["omega"]
        for _ in range(round(UNTIL / step)):
            engine.mj_step(model, data)
        return np.concatenate([data.qpos[:3], data.qvel[3:6]])

    return run


def drake(step: float) -> Run:
    """Drake with steps of equal length."""
    from pydrake.geometry import HalfSpace, Sphere
    from pydrake.math import RigidTransform, RotationMatrix
    from pydrake.multibody.math import SpatialVelocity
    from pydrake.multibody.plant import (
        AddMultibodyPlantSceneGraph,
        CoulombFriction,
        DiscreteContactApproximation,
    )
    from pydrake.multibody.tree import RotationalInertia, SpatialInertia
    from pydrake.systems.analysis import Simulator
    from pydrake.systems.framework import DiagramBuilder

    body, given = CASE["body"], CASE["start"]
    inertia = np.array(body["inertia"], dtype=float)
    full = np.diag(inertia) if inertia.ndim == 1 else inertia
    moments = (full[0, 0], full[1, 1], full[2, 2], full[0, 1], full[0, 2], full[1, 2])
    about = SpatialInertia.MakeFromCentralInertia(
        body["mass"], np.zeros(3), RotationalInertia(*moments)
    )
    friction = CoulombFriction(CASE["contact"]["mu"], CASE["contact"]["mu"])
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, step)
    plant.set_discrete_contact_approximation(DiscreteContactApproximation.kSap)
    plant.mutable_gravity_field().set_gravity_vector([0, 0, -CASE["gravity"]])
    ball = plant.AddRigidBody("ball", about)
    shape = body["shape"]
    place = RigidTransform(np.array(shape["centre"], dtype=float))
    plant.RegisterCollisionGeometry(ball, place, Sphere(shape["radius"]), "ball", friction)
    plant.RegisterCollisionGeometry(
        plant.world_body(), RigidTransform(), HalfSpace(), "plane", friction
    )
    plant.Finalize()
    diagram = builder.Build()
    turn = Rotation.from_quat(given["attitude"], scalar_first=True)
    pose = RigidTransform(RotationMatrix(turn.as_matrix()), given["position"])
    velocity = SpatialVelocity(turn.apply(given["omega"]), given["velocity"])

    def run() -> np.ndarray:
        simulator = Simulator(diagram)
        context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
        plant.SetFreeBodyPose(context, ball, pose)
        plant.SetFreeBodySpatialVelocity(context, ball, velocity)
        simulator.AdvanceTo(UNTIL)
        end = plant.GetFreeBodyPose(context, ball)
        spin = plant.EvalBodySpatialVelocityInWorld(context, ball).rotational()
        return np.concatenate([end.translation(), end.rotation().matrix().T @ spin])

    return run


def main() -> None:
    """Print the table, or JSON."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    contact = situation(CASE)
    state = start(CASE, contact)
    final = CASE["final"]
    truth = np.concatenate([final["position"], final["omega"]])
    runs: dict[str, Run] = {"chaplygin": ours(contact, state)}
    for width in (1e-2, 1e-3, 1e-4):
        runs[f"SciPy LSODA, friction smoothed over {width:g} m/s"] = regularised(
            contact, state, width
        )
    try:
        for step in (1e-3, 1e-4, 1e-5):
            runs[f"MuJoCo RK4, {step:g} s"] = mujoco(step, "RK4")
        runs["MuJoCo Euler, 0.001 s"] = mujoco(1e-3, "Euler")
    except ImportError:
        print("MuJoCo is not installed", file=sys.stderr)
    try:
        for step in (1e-3, 1e-4):
            runs[f"Drake SAP, {step:g} s"] = drake(step)
    except ImportError:
        print("Drake is not installed", file=sys.stderr)
    errors = {name: float(np.abs(run() - truth).max()) for name, run in runs.items()}
    seconds: dict[str, list[float]] = {name: [] for name in runs}
    for _ in range(TURNS):
        for name, run in runs.items():
            began = time.process_time()
            run()
            seconds[name].append(time.process_time() - began)
    medians = {name: statistics.median(times) for name, times in seconds.items()}
    if options.json:
        rows = [{"program": n, "error": errors[n], "seconds": medians[n]} for n in runs]
        print(json.dumps(rows, indent=1))
        return
    print(f"loaded ball, {UNTIL:g} s, {len(CASE['events'])} changes of the contact\n")
    print(f"{'program':50} {'error':>9} {'ms':>9} {'ratio':>8}")
    for name in runs:
        ratio = medians[name] / medians["chaplygin"]
        print(f"{name:50} {errors[name]:9.1e} {1e3 * medians[name]:9.2f} {ratio:8.2f}")


if __name__ == "__main__":
    main()
