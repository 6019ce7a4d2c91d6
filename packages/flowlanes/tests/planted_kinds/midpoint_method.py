"""A planted integration method: the implicit midpoint rule with fixed steps."""

from __future__ import annotations

import itertools
import time

import numpy as np

from flowlanes.flow.integration_method import IntegrationMethod, MotionRequest
from flowlanes.flow.recorded_quantities import recorded_values
from flowlanes.flow.trajectory import Statistics, Trajectory
from flowlanes.formulas.array_formulas import Formulas
from flowlanes.system.parameters import parameter_values

#: Steps between two times that are asked for, and iterations of each.
STEPS, ITERATIONS = 64, 8


class ImplicitMidpoint(IntegrationMethod):
    """x₁ = x₀ + h v((x₀ + x₁)/2), which keeps quadratic integrals exactly."""

    name = "midpoint"

    def motion(self, request: MotionRequest) -> Trajectory:
        """The motion by fixed steps, solved by iteration."""
        began = time.perf_counter()
        system = request.system.lifted() if request.system.reconstruction else request.system
        parameters = parameter_values(system, request.parameters)
        rates = Formulas(system, system.rates)
        times = np.asarray(request.times, dtype=float)
        states = [np.array([float(x) for x in request.start])]
        for before, after in itertools.pairwise(times):
            state, h = states[-1], (after - before) / STEPS
            for _ in range(STEPS):
                end = state
                for _ in range(ITERATIONS):
                    end = state + h * rates((state + end) / 2, parameters)
                state = end
            states.append(state)
        whole = np.array(states)
        statistics = Statistics(
            method="implicit midpoint rule",
            steps=STEPS * (len(times) - 1),
            order=2,
            tolerance=float("nan"),
            precision="double",
            corrections=0,
            seconds=time.perf_counter() - began,
            from_cache=False,
        )
        doubles = {symbol: float(value) for symbol, value in parameters.items()}
        recorded = recorded_values(system, whole, doubles)
        return Trajectory(system, parameters, times, whole, recorded, (), statistics)
