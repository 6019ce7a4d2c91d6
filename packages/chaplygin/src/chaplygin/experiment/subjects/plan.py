"""The drawing of a mechanism in the plane, and its motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp

from flowlanes.flow.trajectory import Trajectory
from flowlanes.formulas.array_evaluation import values
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System
from nonholonomic.mechanics.lagrangian.mechanism import TIME, Mechanism
from nonholonomic.mechanics.lagrangian.plan import Plan, plan_of

from ..file.mechanism_tables import PlanTable
from ..models.described_models import OwnExperiment
from ..models.names import Names


@dataclass(frozen=True, eq=False)
class PlanMotion:
    """The parts of a drawing at each of n instants.

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
    """The drawing of the table [plan], or else the one that the constraints suggest.

    Raises
    ------
    InputError
        If a formula cannot be read; the message names its place.
    """
    table = experiment.plan
    if table is None:
        return None if mechanism is None else plan_of(mechanism)
    whole = system.lifted() if system.reconstruction else system
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

    def numbers_of(parts: Sequence[Sequence[sp.Expr]], width: int) -> FloatArray:
        formulas = [formula for part in parts for formula in part]
        states = np.asarray(trajectory.states, dtype=np.float64)
        if not formulas:
            return np.empty((len(states), 0, width))
        numbers = values(trajectory.system, formulas, states, trajectory.parameters)
        return np.asarray(numbers, dtype=np.float64).reshape(len(states), len(parts), width)

    return PlanMotion(
        path=numbers_of([plan.path], 2)[:, 0],
        links=numbers_of(plan.links, 4),
        wheels=numbers_of(plan.wheels, 3),
        axles=numbers_of(plan.axles, 3),
        blades=numbers_of(plan.blades, 3),
        points=numbers_of(plan.points, 2),
    )
