"""A mode of a contact, ready to be integrated."""

from __future__ import annotations

import copy
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import heyoka as hy
import numpy as np
import sympy as sp

from ...core.arrays import FloatArray
from ...core.system import System
from ...core.vectors import to_components
from ...flow.taylor import CompiledSystem

#: The guard of a piece that ended after the steps allowed.
PAUSE = "pause"


@dataclass(frozen=True)
class Outcome:
    """The end of one piece of a motion.

    Attributes
    ----------
    time : float
    state : array (size,)
    guard : str
        Name of the guard that ended it; empty at the end of the interval, `PAUSE` after the steps
        allowed, ``"failure"`` if the state stopped being a number.
    samples : array (n, size)
        States at the sample times that were passed.
    steps : int
    """

    time: float
    state: FloatArray
    guard: str
    samples: FloatArray
    steps: int


@dataclass(frozen=True)
class ModeIntegrator:
    """A mode of a contact, ready to be integrated.

    Attributes
    ----------
    system : System
    code : CompiledSystem
    stepper : heyoka.taylor_adaptive
        A copy of its integrator, since stepping changes it and the code is shared.
    values : array
        Values of the parameters of `system`.
    columns : mapping of str to (int, int)
        First column and number of components of each observable among the outputs of the code.
    places : mapping of str to int
        Place of each parameter in `values`, by name.
    """

    system: System
    code: CompiledSystem
    stepper: hy.taylor_adaptive
    values: FloatArray
    columns: Mapping[str, tuple[int, int]]
    places: Mapping[str, int]

    def state_of_system(self, states: FloatArray) -> FloatArray:
        """States (..., size) with all variables of the system; those of its own are 1."""
        more = len(self.system.symbols) - states.shape[-1]
        return np.concatenate([states, np.ones((*states.shape[:-1], max(more, 0)))], axis=-1)

    def outputs(self, states: FloatArray) -> dict[str, FloatArray]:
        """Observables at a state (size,) or at states (n, size), by name."""
        numbers = self._numbers(states)
        return {
            name: numbers[..., first : first + size] if size > 1 else numbers[..., first]
            for name, (first, size) in self.columns.items()
        }

    def rates(self, state: FloatArray) -> FloatArray:
        """The right-hand sides of the equations at a state (size,)."""
        stepper = copy.copy(self.stepper)
        count = min(len(self.values), len(stepper.pars))
        stepper.pars[:count] = self.values[:count]
        stepper.state[:] = state
        stepper.step(write_tc=True, max_delta_t=1e-300)
        result: FloatArray = np.array(stepper.tc[:, 1])
        return result

    def guard_values(self, state: FloatArray) -> FloatArray:
        """What the guards watch, at a state (size,), in their order."""
        return self._numbers(state)[-1 - len(self.system.guards) : -1]

    def _numbers(self, states: FloatArray) -> FloatArray:
        function = self.code.outputs
        columns = self.state_of_system(states).T[: len(self.system.symbols)]
        columns = np.ascontiguousarray(columns, dtype=float)
        values = self.values[: function.nparams]
        if columns.ndim == 2:
            values = np.tile(values[:, None], columns.shape[1])
        result: FloatArray = function(columns, pars=values).T
        return result

    def project(self, state: FloatArray) -> FloatArray:
        """The state moved onto the relations of the mode, along the shortest way."""
        point = self.state_of_system(state)
        for block in self.code.core:
            for _ in range(3):
                defect = block.residual(point, pars=self.values[: block.residual.nparams])
                if np.abs(defect).max() < 1e-16:
                    break
                slope = block.slope(point, pars=self.values[: block.slope.nparams])
                # dependent rows: the normal is tied to the attitude, and both have unit length
                point -= np.linalg.pinv(slope.reshape(block.count, -1), rcond=1e-9) @ defect
        return point[: len(state)]

    def advance(
        self,
        time: float,
        state: FloatArray,
        moments: Sequence[float],
        end: float,
        most_steps: int = 0,
    ) -> Outcome:
        """Integrate from a state to an end, or to the first guard that falls to zero.

        Parameters
        ----------
        time : float
        state : array (size,)
        moments : sequence of float
            Sample times, increasing, from `time` to `end`.
        end : float
        most_steps : int
            Number of steps after which to stop with the guard `PAUSE`; 0 for no limit.
        """
        stepper = self.stepper
        # heyoka counts the parameters up to the last one that occurs in the formulas
        count = min(len(self.values), len(stepper.pars))
        stepper.pars[:count] = self.values[:count]
        if self.code.variable_guards:
            stepper.pars[count:] = self._event_scales(state)
            if stepper.time != time or not np.array_equal(stepper.state, state):
                # heyoka is deaf for a while to an event that has just happened, but not elsewhere
                stepper.reset_cooldowns()
        stepper.time = time
        stepper.state[:] = state
        at_start = sum(t <= time for t in moments)
        grid = [time, *moments[at_start:]]
        if grid[-1] < end:
            grid.append(end)
        first = np.tile(np.asarray(state, dtype=float), (at_start, 1))
        if len(grid) == 1:
            return Outcome(time, np.array(state), "", first, 0)
        outcome, _, _, steps, _, values = stepper.propagate_grid(
            np.array(grid), max_steps=most_steps
        )
        code = int(outcome)
        guard = ""
        if code > _SUCCESS:
            guard = self.system.guards[self.code.variable_guards[-code - 1]].name
        elif code != _TIME_LIMIT:
            guard = PAUSE if code == _STEP_LIMIT else "failure"
        samples = np.concatenate([first, values[1 : len(moments) - at_start + 1]])
        if guard == "failure" and not np.isfinite(stepper.state).all():
            # the last good state is that of the last sample
            good = (grid[len(values) - 1], values[-1]) if len(values) else (time, np.array(state))
            return Outcome(float(good[0]), good[1], guard, samples, steps)
        return Outcome(float(stepper.time), np.array(stepper.state), guard, samples, steps)

    def has_step(self, state: FloatArray, values: FloatArray) -> bool:
        """Whether a step can be made from a state (size,), with these values of the parameters."""
        stepper = copy.copy(self.stepper)
        count = min(len(values), len(stepper.pars))
        stepper.pars[:count] = values[:count]
        stepper.time = 0.0
        stepper.state[:] = state
        code = int(stepper.step()[0])
        return code > _SUCCESS or code in (_SUCCESS, _TIME_LIMIT)

    def series(
        self, time: float, state: FloatArray, end: float
    ) -> Iterator[hy.continuous_output_dbl]:
        """Continuous outputs that together cover a time without an event, but for its end.

        Parameters
        ----------
        time : float
        state : array (size,)
        end : float
        """
        stepper = self.stepper
        count = min(len(self.values), len(stepper.pars))
        stepper.pars[:count] = self.values[:count]
        if self.code.variable_guards:
            stepper.pars[count:] = self._event_scales(state)
            stepper.reset_cooldowns()
        stepper.time = time
        stepper.state[:] = state
        while stepper.time < end:
            begun = stepper.time
            output = stepper.propagate_until(end, c_output=True)[4]
            if output is None or stepper.time <= begun:
                return
            yield output

    def _event_scales(self, state: FloatArray) -> list[float]:
        """Powers of two that scale large guards to one."""
        sizes = np.abs(self.guard_values(state)[list(self.code.variable_guards)])
        exponents = np.maximum(np.frexp(np.where(np.isfinite(sizes), sizes, 1.0))[1], 0)
        return list(np.ldexp(1.0, -exponents))


_TIME_LIMIT, _STEP_LIMIT, _SUCCESS = -4294967299, -4294967298, -4294967297


def with_values(mode: ModeIntegrator, values: Mapping[str, float]) -> ModeIntegrator:
    """A mode with other values of parameters, by name."""
    numbers = mode.values.copy()
    for name, value in values.items():
        if name in mode.places:
            numbers[mode.places[name]] = value
    return replace(mode, values=numbers)


def observable_columns(system: System) -> dict[str, tuple[int, int]]:
    """First column and number of components of each observable, by name."""
    columns: dict[str, tuple[int, int]] = {}
    first = 0
    for item in system.observables:
        value = to_components(item.value)
        size = len(value) if isinstance(value, sp.MatrixBase) else 1
        columns[item.name] = (first, size)
        first += size
    return columns
