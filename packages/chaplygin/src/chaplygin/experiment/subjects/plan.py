"""The drawing of a mechanism in the plane, and its motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp

from flowlanes.flow.trajectory import Trajectory
from flowlanes.formulas.array_evaluation import values
from flowlanes.system.arrays import FloatArray
from nonholonomic.mechanics.lagrangian.plan import Plan


@dataclass(frozen=True, eq=False)
class PlanMotion:
    """The parts of a drawing at each of n times.

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


def plan_motion(plan: Plan, trajectory: Trajectory) -> PlanMotion:
    """The numbers of a plan along a trajectory, lifted to space."""

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
