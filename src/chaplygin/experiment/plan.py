"""The plan of a mechanism: read from its file or told by its constraints, and followed in time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp

from ..core.arrays import FloatArray
from ..core.system import System
from ..flow.integrator import Trajectory
from ..formulas.evaluate import values
from ..mechanics.lagrangian.mechanism import TIME, Mechanism
from ..mechanics.lagrangian.plan import Plan, plan_of
from .file.mechanism_tables import PlanTable
from .file.models import OwnExperiment
from .file.names import Names

__all__ = ["PlanMotion", "described_plan", "plan_motion"]


@dataclass(frozen=True, eq=False)
class PlanMotion:
    """What a plan shows at each of n instants.

    Attributes
    ----------
    path : (n, 2) array
    links : (n, k, 4) array
        From (x, y) to (x, y).
    wheels, axles, blades : (n, k, 3) arrays
        Place and heading.
    points : (n, k, 2) array
    """

    path: FloatArray
    links: FloatArray
    wheels: FloatArray
    axles: FloatArray
    blades: FloatArray
    points: FloatArray


def described_plan(
    experiment: OwnExperiment, system: System, mechanism: Mechanism | None
) -> Plan | None:
    """What a file's table [plan] says is to be drawn; without one, what the constraints tell.

    Raises
    ------
    InputError
        If a formula cannot be read; the message names its place.
    """
    table = experiment.plan
    if table is None:
        return None if mechanism is None else plan_of(mechanism)
    whole = system.lifted() if system.motion else system
    everything = [
        TIME,
        *(p.symbol for p in whole.parameters),
        *whole.state,
        *(name for name, _ in whole.definitions),
    ]
    names = Names(experiment, {str(named): named for named in everything})

    def read(key: str) -> tuple[tuple[sp.Expr, ...], ...]:
        return tuple(
            tuple(names.scalar(text, "plan", key) for text in texts)
            for texts in getattr(table, key)
        )

    x, y = (names.scalar(text, "plan", "path") for text in table.path)
    others = {key: read(key) for key in PlanTable.model_fields if key != "path"}
    return Plan((x, y), **others)


def plan_motion(plan: Plan, trajectory: Trajectory) -> PlanMotion:
    """The numbers of a plan along a trajectory, which is lifted to space."""

    def along(parts: Sequence[Sequence[sp.Expr]], width: int) -> FloatArray:
        formulas = [formula for part in parts for formula in part]
        states = np.asarray(trajectory.states, dtype=np.float64)
        if not formulas:
            return np.empty((len(states), 0, width))
        numbers = values(trajectory.system, formulas, states, trajectory.parameters)
        return np.asarray(numbers, dtype=np.float64).reshape(len(states), len(parts), width)

    return PlanMotion(
        path=along([plan.path], 2)[:, 0],
        links=along(plan.links, 4),
        wheels=along(plan.wheels, 3),
        axles=along(plan.axles, 3),
        blades=along(plan.blades, 3),
        points=along(plan.points, 2),
    )
