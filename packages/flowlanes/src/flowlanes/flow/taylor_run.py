"""One integration by Taylor series, step by step, with events, projections and samples."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache

import mpmath
import numpy as np
import sympy as sp

from ..errors import InputError
from ..system.system import System
from ..system.tolerance import Precision
from .cost import Pace
from .recorded_quantities import columns_by_name, recorded_quantities
from .sign_branches import RunningSigns
from .taylor.compiled_system import CompiledSystem
from .taylor.projection import Projector
from .taylor.working_numbers import WorkingArray, WorkingNumber
from .trajectory import DenseOutput, Event, Statistics, Trajectory
from .validation import overflow_reason

#: Residuals of the relations below which a state is not projected, per precision.
LEFT_ALONE = {"double": 1e-15, "quad": 1e-32}

#: Fraction of its initial value below which a guard is taken as zero at a singularity.
VANISHING = 1e-5


@dataclass
class RunLog:
    """Samples, events and polynomials of a motion up to the current time."""

    times: list[WorkingNumber] = field(default_factory=list)
    states: list[WorkingArray] = field(default_factory=list)
    events: list[Event] = field(default_factory=list)
    dense: list[tuple[WorkingNumber, WorkingNumber, WorkingArray]] = field(default_factory=list)
    steps: int = 0
    corrections: int = 0


#: Explanation of a formula without a finite value whose variables have ordinary sizes.
NO_VALUE = (
    "a formula divides by zero, or takes a root or logarithm of what has none, or the numbers of "
    "the system differ too much in size"
)


class StoppedError(Exception):
    """Raised if the integration cannot continue."""


def decimal_text(number: float | mpmath.mpf) -> str:
    """Number as decimal text, so that 0.1 is one tenth at any precision."""
    if isinstance(number, mpmath.mpf):
        # str would round to the current mpmath precision.
        return str(mpmath.nstr(number, 40))
    return repr(float(number)) if isinstance(number, (int, float, np.number)) else str(number)


class TaylorRun:
    """One integration: the compiled code with a state, parameters and projections."""

    def __init__(
        self,
        system: System,
        core: int,
        code: CompiledSystem,
        kind: type[WorkingNumber],
        values: Mapping[sp.Symbol, WorkingNumber],
        precision: Precision,
    ) -> None:
        self.system = system
        self.values = values
        self.kind = kind
        self.code = code
        # A copy, because steps change it and the code is shared.
        self.stepper = code.series.copy()
        numbers = [kind(decimal_text(v)) for v in values.values()]
        self.parameters = np.array(numbers, dtype=kind)
        number = min(len(self.parameters), len(self.stepper.parameters))
        self.stepper.parameters[:number] = self.parameters[:number]
        self.core = core
        self.left_alone = LEFT_ALONE[precision]
        self.projectors: tuple[Projector, ...] = ()
        self.quadratures = _quadratures(system)
        self.sums = np.array([kind(0)] * len(self.quadratures), dtype=kind)
        self.remainder = self.sums.copy()
        self.signs = RunningSigns(code.signed, self.parameters, self.stepper.parameters)
        self.first_guards: WorkingArray = np.empty(0)
        self.good: tuple[WorkingNumber, WorkingArray] = (kind(0), np.empty(0))

    def begin(
        self, start: Sequence[WorkingNumber], moment: WorkingNumber, keep_integrals: bool
    ) -> None:
        """Set the integrator to a start; InputError if the start is not valid."""
        state = np.array([self.kind(decimal_text(x)) for x in start], dtype=self.kind)
        if not all(math.isfinite(float(x)) for x in state):
            raise InputError("start: all of its numbers must be finite")
        core, lift = slice(0, self.core), slice(self.core, None)
        self.projectors = (
            Projector(self.code.core, core, self.parameters, self.left_alone),
            Projector(self.code.lift, lift, self.parameters, self.left_alone),
        )
        self._require_on_phase_space(state)
        self.stepper.state[:] = state
        self.stepper.time = moment
        self.project(self.stepper.state)
        self._extract_quadratures()
        if keep_integrals:
            self.projectors = (self._with_integrals(self.stepper.state), *self.projectors[1:])
        self._require_numbers(self._with_quadratures(self.stepper.state))
        self.first_guards = self._guards(self.stepper.state)
        self.signs.set(self.stepper.state)
        self._scale_events(self.stepper.state)
        for guard, value in zip(self.system.guards, self.first_guards, strict=True):
            if not float(value) > 0 and not guard.lift_off:
                raise InputError(f"start: {guard.message} ({guard.name} = {float(value):.6g})")
        self.good = (moment, self._with_quadratures(self.stepper.state))

    def _scale_events(self, state: WorkingArray) -> None:
        """Set the scale factors of the events: powers of two that reduce large guards."""
        if not self.code.variable_guards:
            return
        first = np.array([float(x) for x in self._guards(state)])
        sizes = np.abs(first)
        # A guard may be small exactly at the start, so its size is taken where each variable is
        # larger by an eighth.
        for i, value in enumerate(state):
            varied = np.array(state)
            varied[i] = value * 9 / 8
            change = 8 * np.abs([float(x) for x in self._guards(varied)] - first)
            sizes = np.fmax(sizes, np.where(np.isfinite(change), change, 0.0))
        own = [i for i in self.code.variable_guards if i < len(sizes)]
        factors = np.ones(len(self.code.variable_guards))
        factors[: len(own)] = np.ldexp(1.0, -np.maximum(np.frexp(sizes[own])[1], 0))
        first_factor = len(self.parameters) + self.signs.count
        self.stepper.parameters[first_factor:] = [self.kind(x) for x in factors]

    def _require_numbers(self, state: WorkingArray) -> None:
        """Raise an error for a start at which a recorded quantity is not finite.

        If the motion itself can continue, as at rest where a quotient of momenta is constant, the
        quantity is undefined there and is recorded as NaN.
        """
        values = iter(self.code.outputs(state, self.parameters))
        for quantity in recorded_quantities(self.system):
            for _ in quantity.formulas:
                value = float(next(values))
                if not math.isfinite(value):
                    extremes = self._extreme_numbers(state, self._has_values)
                    if extremes:
                        raise InputError(f"start: {extremes} ({quantity.name} would be {value})")
                    if self._has_step(state, self.parameters):
                        return
                    raise InputError(f"start: {quantity.name} is {value} there; {NO_VALUE}")

    def _extreme_numbers(
        self, state: WorkingArray, possible: Callable[[WorkingArray, WorkingArray], bool]
    ) -> str:
        """Names of the numbers of state and parameters that make a value impossible."""
        names = [str(s) for s in (*self.system.symbols, *self.values)]
        numbers = [float(x) for x in (*state, *self.parameters)]

        def finite(values: Sequence[float]) -> bool:
            array = np.array([self.kind(x) for x in values], dtype=self.kind)
            return possible(array[: len(state)], array[len(state) :])

        return overflow_reason(names, numbers, finite)

    def _has_values(self, state: WorkingArray, parameters: WorkingArray) -> bool:
        """True if all recorded quantities are finite there."""
        values = self.code.outputs(state, parameters)
        return all(math.isfinite(float(value)) for value in values)

    def _has_step(self, state: WorkingArray, parameters: WorkingArray) -> bool:
        """True if a step is possible from there."""
        stepper = self.stepper.copy()
        stepper.time = self.kind(0)
        stepper.state[:] = state
        stepper.parameters[: len(parameters)] = parameters[: len(stepper.parameters)]
        return not stepper.step(self.kind(1)).is_failure

    def _require_on_phase_space(self, state: WorkingArray) -> None:
        for projector in self.projectors:
            if not projector.blocks:
                continue
            defect = max(abs(float(x)) for x in projector.defect(state))
            scale = 1 + max(abs(float(x)) for x in state)
            if defect > 1e-9 * scale:
                raise InputError(
                    f"start: it misses the relations of the phase space by {defect:.3g}"
                )

    def _with_integrals(self, state: WorkingArray) -> Projector:
        """Projection onto the relations and the current values of the integrals."""
        blocks = (*self.code.core, *self.code.laws())
        relations = sum(block.count for block in self.code.core)
        free = Projector(blocks, slice(0, self.core), self.parameters, self.left_alone)
        target = free.values(state)
        target[:relations] = self.kind(0)
        scale = max(1.0, *(abs(float(x)) for x in target))
        return replace(free, threshold=self.left_alone * scale, target=target)

    def project(self, state: WorkingArray) -> bool:
        """Project a state in place; True if it was changed."""
        return any([projector(state) for projector in self.projectors])

    def _guards(self, state: WorkingArray) -> WorkingArray:
        values = self.code.outputs(np.array(state), self.parameters)
        return values[len(values) - len(self.system.guards) :]

    def walk(
        self,
        moments: Sequence[WorkingNumber],
        log: RunLog,
        on_liftoff: str,
        dense: bool,
        began: float,
        time_limit: float | None,
    ) -> Iterator[float]:
        """Integrate through `moments` and fill `log`.

        The completed fraction is yielded repeatedly.
        """
        stepper, last = self.stepper, moments[-1]
        forward = bool(last > moments[0])
        length = float(last - moments[0])
        self._record(log, moments[0], stepper.state)
        watched = self._is_pressed(moments[0], log, on_liftoff)
        index, cramped, pace = 1, 0, Pace()
        while index < len(moments) and watched:
            before = stepper.time
            step = stepper.step(last - before)
            if step.is_failure:
                if not log.steps:
                    reason = self._extreme_numbers(self.good[1], self._has_step) or NO_VALUE
                    raise InputError(f"start: the rate of the state is no number there; {reason}")
                self._break_down(log, "the state stopped being a number")
                return
            log.steps += 1
            now = stepper.time
            if dense:
                series = np.array(stepper.series)
                series[self.quadratures, 0] += self.sums
                log.dense.append((before, now, series))
            while index < len(moments) and (
                moments[index] <= now if forward else moments[index] >= now
            ):
                self._record(log, moments[index], stepper.state_at(moments[index]))
                index += 1
            changing = self._sign_of(step.event)
            if changing is not None:
                self.signs.turn(changing)
            elif step.event is not None:
                watched = self._record_event(step.event, now, log, on_liftoff)
            wrong = self.signs.wrong(stepper.state, changing)
            if wrong:
                raise StoppedError(wrong)
            log.corrections += self.project(stepper.state)
            self._extract_quadratures()
            self.good = (now, self._with_quadratures(stepper.state))
            cramped = cramped + 1 if abs(step.length) < 1e-13 * (1 + abs(float(now))) else 0
            if cramped > 20:
                reason = "the step size collapsed (a singularity of the equations is near)"
                self._break_down(log, reason)
                return
            if log.steps % 64 == 0:
                if time_limit is None:
                    done = abs(float(now - moments[0]) / length)
                    pace.check(done, f"to follow a motion for {abs(length):g} s")
                elif clock.perf_counter() - began > time_limit:
                    raise StoppedError(f"the time limit of {time_limit:g} s was reached")
                yield float(now - moments[0]) / length

    def _sign_of(self, event: int | None) -> int | None:
        """Index of the sign that is reversed by an event, or None."""
        own = -1 if event is None else self.code.variable_guards[event] - len(self.first_guards)
        return own if own >= 0 else None

    def _is_pressed(self, now: WorkingNumber, log: RunLog, on_liftoff: str) -> bool:
        """Record a negative normal force at the start; True if the motion continues."""
        go_on = True
        for guard, value in zip(self.system.guards, self.first_guards, strict=True):
            if guard.lift_off and not float(value) > 0:
                go_on = on_liftoff == "warn"
                pressed = replace(guard, message="the normal force is negative at the start")
                log.events.append(Event(float(now), pressed, not go_on))
        return go_on

    def _record_event(self, event: int, now: WorkingNumber, log: RunLog, on_liftoff: str) -> bool:
        """Record a violated guard; True if the motion continues."""
        guard = self.system.guards[self.code.variable_guards[event]]
        go_on = guard.lift_off and on_liftoff == "warn"
        log.events.append(Event(float(now), guard, not go_on))
        if not go_on and now != log.times[-1]:
            self._record(log, now, self.stepper.state)
        return go_on

    def _break_down(self, log: RunLog, reason: str) -> None:
        """End at a singularity: as a failure, unless it is explained by a guard.

        Where a variable diverges like the square root of the remaining time, no step reaches the
        guard that vanishes there.
        """
        now, state = self.good
        guards = zip(self.system.guards, self.first_guards, self._guards(state), strict=True)
        for guard, first, value in guards:
            if not guard.lift_off and float(value) < VANISHING * float(first):
                self.keep_last(log)
                log.events.append(Event(float(now), guard, True))
                return
        raise StoppedError(reason)

    def keep_last(self, log: RunLog) -> None:
        """Record the last valid state as the last sample."""
        now, state = self.good
        if now != log.times[-1]:
            self._append(log, now, np.array(state))

    def _with_quadratures(self, state: WorkingArray) -> WorkingArray:
        """Copy of the state of the integrator together with its quadratures."""
        complete = np.array(state)
        complete[self.quadratures] += self.sums
        return complete

    def _record(self, log: RunLog, moment: WorkingNumber, state: WorkingArray) -> None:
        self._append(log, moment, self._with_quadratures(state))

    def _append(self, log: RunLog, moment: WorkingNumber, sample: WorkingArray) -> None:
        self.project(sample)
        log.times.append(moment)
        log.states.append(sample)

    def _extract_quadratures(self) -> None:
        """Move the quadratures out of the state, and sum them without loss.

        The step size depends on the largest component of the state, so a position far from the
        origin would reduce the accuracy of the dynamics.
        """
        if self.quadratures:
            gain = self.stepper.state[self.quadratures] + self.remainder
            total = self.sums + gain
            self.remainder = gain - (total - self.sums)
            self.sums = total
            self.stepper.state[self.quadratures] = self.kind(0)

    def finish(self, log: RunLog, statistics: Statistics) -> Trajectory:
        """Trajectory built from the log."""
        states = np.array(log.states, dtype=self.kind)
        recorded = columns_by_name(self.system, self.code.outputs(states.T, self.parameters))
        return Trajectory(
            self.system,
            self.values,
            np.array(log.times, dtype=self.kind),
            states,
            recorded,
            tuple(log.events),
            statistics,
            _dense(log, self.kind),
        )


@lru_cache(maxsize=32)
def _quadratures(system: System) -> list[int]:
    """Indices of the variables on which no rate, relation or guard depends."""
    formulas = [
        *system.rates,
        *system.scalar.relations,
        *(guard.value for guard in system.scalar.guards),
    ]
    used = {s for formula in formulas for s in formula.free_symbols}
    used |= {s for _, value in system.required_definitions(formulas) for s in value.free_symbols}
    return [i for i, symbol in enumerate(system.symbols) if symbol not in used]


def _dense(log: RunLog, kind: type[WorkingNumber]) -> DenseOutput | None:
    if not log.dense:
        return None
    begins, ends, coefficients = zip(*log.dense, strict=True)
    return DenseOutput(
        np.array(begins, dtype=kind), np.array(ends, dtype=kind), np.array(coefficients)
    )
