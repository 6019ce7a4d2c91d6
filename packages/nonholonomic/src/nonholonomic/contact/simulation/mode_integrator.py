"""The compiled equations of one contact mode, and their integration."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial.polynomial import polyval

from flowlanes.flow.taylor.compiled_system import CompiledSystem, StateSeries
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System

#: Guard name of an integration that ended after the allowed number of steps.
PAUSE = "pause"

#: A step that changes no digit, to obtain the Taylor series at a state.
_NO_TIME = 1e-300


@dataclass(frozen=True)
class Outcome:
    """The result of integrating one piece of a motion.

    Attributes
    ----------
    time : float
    state : array (size,)
    guard : str
        Name of the guard that ended it; empty at the end of the interval, `PAUSE` after the steps
        allowed, ``"failure"`` if the state is no longer finite.
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
class StepSeries:
    """The Taylor series of one step.

    Attributes
    ----------
    begin, end : float
    coefficients : array (size, order + 1)
        Coefficients of the powers of the time since the step began.
    """

    begin: float
    end: float
    coefficients: FloatArray

    def __call__(self, times: FloatArray) -> FloatArray:
        """States (n, size) at times (n,)."""
        values: FloatArray = np.asarray(polyval(times - self.begin, self.coefficients.T).T, float)
        return values


@dataclass(frozen=True)
class ModeIntegrator:
    """The compiled equations of a contact mode, with parameter values.

    Attributes
    ----------
    system : System
    code : CompiledSystem
    stepper : StateSeries
        A copy of its series, since stepping changes it and the code is shared.
    values : array
        Values of the parameters of `system`.
    columns : mapping of str to (int, int)
        First column and number of components of each observable among the outputs of the code.
    places : mapping of str to int
        Place of each parameter in `values`, by name.
    """

    system: System
    code: CompiledSystem
    stepper: StateSeries
    values: FloatArray
    columns: Mapping[str, tuple[int, int]]
    places: Mapping[str, int]

    def state_of_system(self, states: FloatArray) -> FloatArray:
        """States (..., size) with all variables of the system; the additional ones are set to 1."""
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
        stepper = self._stepper_at(state)
        stepper.step(_NO_TIME)
        return stepper.series[:, 1].copy()

    def guard_values(self, state: FloatArray) -> FloatArray:
        """The values of the guards at a state (size,), in their order."""
        values = self._numbers(state)
        return values[len(values) - len(self.system.guards) :]

    def _numbers(self, states: FloatArray) -> FloatArray:
        columns = states.T[: len(self.system.symbols)]
        result: FloatArray = self.code.outputs(columns, self.values).T
        return result

    def project(self, state: FloatArray) -> FloatArray:
        """Project the state orthogonally onto the constraint relations of the mode.

        Gauss–Newton steps with the pseudo-inverse of the Jacobian: each one is the shortest vector
        that satisfies the linearised relations.
        """
        point = self.state_of_system(state)
        for block in self.code.core:
            for _ in range(3):
                defect = block.residual(point, self.values)
                if np.abs(defect).max() < 1e-16:
                    break
                slope = block.slope(point, self.values)
                # The rows may be dependent: the normal follows from the attitude, and both have
                # unit length.
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
        stepper = self._stepper_from(time, state)
        at_start = sum(t <= time for t in moments)
        first = np.tile(np.asarray(state, dtype=float), (at_start, 1))
        samples: list[FloatArray] = []
        ahead = iter(moments[at_start:])
        sample = next(ahead, math.inf)
        steps, guard = 0, ""
        while stepper.time < end and not guard:
            step = stepper.step(end - stepper.time)
            steps += 1
            while sample <= stepper.time and not step.is_failure:
                samples.append(stepper.state_at(sample))
                sample = next(ahead, math.inf)
            if step.is_failure:
                guard = "failure"
            elif step.event is not None:
                guard = self.system.guards[self.code.variable_guards[step.event]].name
            elif steps == most_steps and stepper.time < end:
                guard = PAUSE
        passed = np.concatenate([first, np.reshape(samples, (-1, first.shape[1]))])
        return Outcome(float(stepper.time), stepper.state.copy(), guard, passed, steps)

    def has_step(self, state: FloatArray, values: FloatArray) -> bool:
        """Whether a step from a state (size,) succeeds with these values of the parameters."""
        return not replace(self, values=values)._stepper_at(state).step(1.0).is_failure

    def series(self, time: float, state: FloatArray, end: float) -> Iterator[StepSeries]:
        """Taylor series of the steps that cover an interval without an event, except at its end.

        Parameters
        ----------
        time : float
        state : array (size,)
        end : float
        """
        stepper = self._stepper_from(time, state)
        while stepper.time < end:
            begin = stepper.time
            step = stepper.step(end - begin)
            if step.is_failure or stepper.time <= begin:
                return
            yield StepSeries(begin, stepper.time, stepper.series.copy())

    def _stepper_at(self, state: FloatArray) -> StateSeries:
        """A separate stepper at a state, at time zero."""
        stepper = self.stepper.copy()
        stepper.parameters[: len(self.values)] = self.values
        stepper.state[:] = state
        stepper.time = 0.0
        return stepper

    def _stepper_from(self, time: float, state: FloatArray) -> StateSeries:
        """The shared stepper, set to a state and a time."""
        stepper = self.stepper
        values = [*self.values.tolist(), *self._event_scales(state)]
        if stepper.time != time or not np.array_equal(stepper.state, state):
            # The cooldown after an event must not suppress events of a motion that continues
            # elsewhere.
            stepper.reset()
        stepper.parameters[:] = values
        stepper.time = time
        stepper.state[:] = state
        return stepper

    def _event_scales(self, state: FloatArray) -> list[float]:
        """Powers of two that scale large guard values to order 1."""
        sizes = np.abs(self.guard_values(state)[list(self.code.variable_guards)])
        exponents = np.maximum(np.frexp(np.where(np.isfinite(sizes), sizes, 1.0))[1], 0)
        return list(np.ldexp(1.0, -exponents))


def with_values(mode: ModeIntegrator, values: Mapping[str, float]) -> ModeIntegrator:
    """The same mode with other values of parameters, by name."""
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
        size = len(scalars(item.value))
        columns[item.name] = (first, size)
        first += size
    return columns
