"""Integrating a System: one start, chosen times, everything the system records."""

from __future__ import annotations

import copy
import itertools
import math
import time as clock
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any, Literal

import mpmath
import numpy as np
import sympy as sp

from ..arguments import Numbers, Parameters, Start, arguments_checked
from ..core.parameters import parameter_values, require_admissible, require_finite
from ..core.system import System
from ..core.vectors import to_components
from ..errors import InputError, InterruptionError, RunError
from .cost import Pace
from .extreme_values import too_extreme
from .gauss_trajectory import collocate
from .initial_states import whole_start
from .projection import Projector, call
from .taylor import Compiled, Direction, Precision, compile_system, number_type
from .trajectory import DenseOutput, Event, Statistics, Trajectory

__all__ = ["DenseOutput", "Event", "Statistics", "Trajectory", "integrate"]

#: Residuals of the relations that are left alone, per precision.
LEFT_ALONE = {"double": 1e-15, "quad": 1e-32}

#: Tolerances that are used unless another one is given.
USUAL = {"double": 1e-15, "quad": 1e-30}

#: A guard has vanished at a singularity when this little is left of its first value.
VANISHED = 1e-5


@dataclass
class _Log:
    """What a run has produced so far."""

    times: list[Any] = field(default_factory=list)
    states: list[Any] = field(default_factory=list)
    events: list[Event] = field(default_factory=list)
    dense: list[tuple[Any, Any, Any]] = field(default_factory=list)
    steps: int = 0
    corrections: int = 0


@arguments_checked
def integrate(
    system: System,
    start: Start,
    times: Numbers,
    *,
    parameters: Parameters = None,
    tolerance: float | None = None,
    precision: Precision = "double",
    on_liftoff: Literal["stop", "warn"] = "stop",
    keep_integrals: bool = False,
    time_limit: float | None = None,
    dense: bool = False,
    progress: Callable[[float], None] | None = None,
    method: Literal["taylor", "gauss"] = "taylor",
) -> Trajectory:
    """Integrate a system from `start` through `times`.

    Parameters
    ----------
    system : System
        If it has a motion in space, that is integrated with it.
    start : sequence of numbers, or mapping of str to number or numbers
        State at ``times[0]`` in flat order, with the motion in space, as
        :func:`chaplygin.mechanics.rolling.initial_state.initial_state` gives it, or without; or by
        name (ω and γ, or the variables of the state).  The motion in space begins at zero where it
        is left out, with γ pointing upward.
    times : sequence of numbers
        At least two, all increasing or all decreasing (backward integration), in s.
    parameters : mapping of Symbol or name to number, optional
        Values that replace the system's defaults.
    tolerance, precision
        See :func:`chaplygin.flow.taylor.compile_system`; the tolerance is 1e-15 in double
        precision and 1e-30 with 34 digits unless another one is given.
    on_liftoff : ``"stop"`` or ``"warn"``
        Whether the run ends or goes on when the normal force changes sign.  Leaving the domain
        of the equations (a body lying flat, a contact on a non-convex part) always ends it.
    keep_integrals : bool
        Restore the integrals to their initial values after every step, besides the relations.
    time_limit : float, optional
        Seconds of computing after which to give up.
    dense : bool
        Keep the continuous trajectory.
    progress : callable, optional
        Called with the fraction done.
    method : ``"taylor"`` or ``"gauss"``
        Taylor series of any tolerance, or Gauss–Legendre collocation with all digits of a double
        (30 digits at precision "quad"), some ten times faster; see
        :func:`chaplygin.flow.gauss_trajectory.collocate`.  The second always holds the integrals
        and has no tolerance, time limit or continuous trajectory.

    Returns
    -------
    Trajectory
        Up to the last of `times`, or to where a guard ended it (that moment is its last sample).

    Raises
    ------
    InputError
        If times, parameters or start cannot be used.
    RunError
        If the integration fails; it carries the last good time and the trajectory so far.  An
        InterruptionError if it is interrupted.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ball = ch.from_catalogue("chaplygin-ball")
    >>> motion = ch.integrate(ball, {"omega": (1, 0, 2), "gamma": (0, 0, 1)}, [0.0, 5.0, 10.0])
    >>> motion["gamma"].shape
    (3, 3)
    >>> energy = motion["law_energy"]
    >>> bool(abs(energy - energy[0]).max() < 1e-13)
    True
    """
    if time_limit is not None and not time_limit > 0:
        raise InputError(f"time_limit = {time_limit}: it must be a positive number of seconds")
    start = whole_start(system, start, parameters)
    if method == "gauss":
        for name, asked in (
            ("tolerance", tolerance),
            ("time_limit", time_limit),
            ("dense", dense or None),
        ):
            if asked is not None:
                raise InputError(f"{name}: method 'gauss' has none; use method 'taylor'")
        return collocate(
            system,
            start,
            times,
            parameters,
            digits=16 if precision == "double" else 30,
            on_liftoff=on_liftoff,
        )
    if method != "taylor":
        raise InputError(f"method {method!r}: it must be 'taylor' or 'gauss'")
    values = _values(system, parameters)
    kind = number_type(precision)
    moments = _moments(times, kind)
    direction: Direction = "forward" if moments[0] < moments[-1] else "backward"
    if tolerance is None:
        tolerance = USUAL[precision]
    code = compile_system(system, tolerance, precision, direction)
    lifted = system.lifted() if system.motion else system
    run = _Run(lifted, len(system.symbols), code, kind, values, precision)
    run.begin(start, moments[0], keep_integrals)
    began = clock.perf_counter()
    log = _Log()
    failure = None
    ended: type[RunError] = RunError
    try:
        for done in run.walk(moments, log, on_liftoff, dense, began, time_limit):
            if progress is not None:
                progress(done)
    except _StoppedError as stop:
        failure = str(stop)
    except KeyboardInterrupt:
        if not log.times:
            raise
        failure, ended = "interrupted", InterruptionError
    if failure is not None:
        run.keep_last(log)
    seconds = clock.perf_counter() - began
    trajectory = run.finish(
        log,
        Statistics(
            steps=log.steps,
            order=code.integrator.order,
            tolerance=tolerance,
            precision=precision,
            corrections=log.corrections,
            seconds=seconds,
            from_cache=code.found,
        ),
    )
    if failure is not None:
        last = float(log.times[-1])
        raise ended(f"{system.name}: {failure}", last, trajectory)
    return trajectory


#: Why a formula has no finite value where its variables have usual sizes.
_NO_VALUE = "a formula divides by zero, or takes a root or logarithm of what has none"


class _StoppedError(Exception):
    """The integration cannot go on."""


def _values(system: System, parameters: Mapping[Any, Any] | None) -> dict[sp.Symbol, Any]:
    values: dict[sp.Symbol, Any] = parameter_values(system, parameters)
    if parameters:
        require_finite(system, values)
        require_admissible(system, {s: float(value) for s, value in values.items()}, values)
    return values


def _moments(times: Sequence[Any], kind: Any) -> list[Any]:
    moments = [kind(_text(t)) for t in times]
    if len(moments) < 2:
        raise InputError(f"{len(moments)} time(s) given: at least a first and a last are needed")
    if not all(math.isfinite(float(t)) for t in moments):
        raise InputError("times: all of them must be finite numbers")
    pairs = list(itertools.pairwise(moments))
    if not (all(s < t for s, t in pairs) or all(s > t for s, t in pairs)):
        raise InputError("times: they must be all increasing or all decreasing")
    return moments


def _text(number: Any) -> str:
    """A number as written, so that 0.1 means one tenth at any precision."""
    if isinstance(number, mpmath.mpf):
        # str would round to the digits that mpmath happens to work with
        return str(mpmath.nstr(number, 40))
    return repr(float(number)) if isinstance(number, (int, float, np.number)) else str(number)


class _Run:
    """One integration: the compiled code with a state, parameters and projections."""

    def __init__(
        self,
        system: System,
        core: int,
        code: Compiled,
        kind: Any,
        values: Mapping[sp.Symbol, Any],
        precision: Precision,
    ) -> None:
        self.system = system
        self.values = values
        self.kind = kind
        self.code = code
        # a copy, since stepping changes it and the code is shared
        self.stepper = copy.copy(code.integrator)
        numbers = [kind(_text(v)) for v in values.values()]
        self.parameters = np.array(numbers, dtype=kind)
        number = min(len(self.parameters), len(self.stepper.pars))
        self.stepper.pars[:number] = self.parameters[:number]
        self.core = core
        self.left_alone = LEFT_ALONE[precision]
        self.projectors: tuple[Projector, ...] = ()
        self.loose = _quadratures(system)
        self.carried = np.array([kind(0)] * len(self.loose), dtype=kind)
        self.remainder = self.carried.copy()
        self.first_guards: Any = ()
        self.good: tuple[Any, Any] = (kind(0), ())

    def begin(self, start: Sequence[Any], moment: Any, keep_integrals: bool) -> None:
        state = np.array([self.kind(_text(x)) for x in start], dtype=self.kind)
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
        self._carry()
        if keep_integrals:
            self.projectors = (self._with_integrals(self.stepper.state), *self.projectors[1:])
        self._require_numbers(self._whole(self.stepper.state))
        self.first_guards = self._guards(self.stepper.state)
        self._scale_events(self.stepper.state)
        for guard, value in zip(self.system.guards, self.first_guards, strict=True):
            if not float(value) > 0 and not guard.lift_off:
                raise InputError(f"start: {guard.message} ({guard.name} = {float(value):.6g})")
        self.good = (moment, self._whole(self.stepper.state))

    def _scale_events(self, state: Any) -> None:
        """Give the events their factors: powers of two, which bring large guards down to one."""
        if not self.code.watched:
            return
        first = np.array([float(x) for x in self.first_guards])
        sizes = np.abs(first)
        # a guard may be small just where the motion starts: one eighth more of each variable tells
        for i, value in enumerate(state):
            varied = np.array(state)
            varied[i] = value * 9 / 8
            change = 8 * np.abs([float(x) for x in self._guards(varied)] - first)
            sizes = np.fmax(sizes, np.where(np.isfinite(change), change, 0.0))
        exponents = np.maximum(np.frexp(sizes[list(self.code.watched)])[1], 0)
        factors = np.ldexp(1.0, -exponents)
        self.stepper.pars[len(self.parameters) :] = [self.kind(x) for x in factors]

    def _require_numbers(self, state: Any) -> None:
        """Refuse a start where something that is recorded is not a finite number."""
        values = iter(call(self.code.outputs, state, self.parameters))
        for name, width in _layout(self.system):
            for _ in range(max(width, 1)):
                value = float(next(values))
                if not math.isfinite(value):
                    raise InputError(
                        f"start: {name} is {value} there; {self._blamed(state) or _NO_VALUE}"
                    )

    def _blamed(self, state: Any) -> str:
        """The numbers that are too large or too small for the formulas, in words."""
        names = [str(s) for s in (*self.system.symbols, *self.values)]
        numbers = [float(x) for x in (*state, *self.parameters)]

        def finite(changed: Sequence[float]) -> bool:
            array = np.array([self.kind(x) for x in changed], dtype=self.kind)
            values = call(self.code.outputs, array[: len(state)], array[len(state) :])
            return all(math.isfinite(float(value)) for value in values)

        with np.errstate(all="ignore"):
            blamed = too_extreme(numbers, finite)
        if not blamed:
            return ""
        listed = ", ".join(f"{names[i]} = {numbers[i]:g}" for i in blamed)
        verb = "is" if len(blamed) == 1 else "are"
        return f"{listed} {verb} too far from 1 to compute with: choose other units or numbers"

    def _require_on_phase_space(self, state: Any) -> None:
        for projector in self.projectors:
            if not projector.blocks:
                continue
            defect = max(abs(float(x)) for x in projector.defect(state))
            scale = 1 + max(abs(float(x)) for x in state)
            if defect > 1e-9 * scale:
                raise InputError(
                    f"start: it misses the relations of the phase space by {defect:.3g}"
                )

    def _with_integrals(self, state: Any) -> Projector:
        """A projector onto the relations and the present values of the integrals together."""
        blocks = (*self.code.core, *self.code.laws)
        relations = sum(block.count for block in self.code.core)
        free = Projector(blocks, slice(0, self.core), self.parameters, self.left_alone)
        target = free.values(state)
        target[:relations] = self.kind(0)
        scale = max(1.0, *(abs(float(x)) for x in target))
        return replace(free, threshold=self.left_alone * scale, target=target)

    def project(self, state: Any) -> bool:
        return any([projector(state) for projector in self.projectors])

    def _guards(self, state: Any) -> Any:
        values = call(self.code.outputs, np.array(state), self.parameters)
        return values[len(values) - 1 - len(self.system.guards) : -1]

    def walk(
        self,
        moments: list[Any],
        log: _Log,
        on_liftoff: str,
        dense: bool,
        began: float,
        time_limit: float | None,
    ) -> Iterator[float]:
        """Step through `moments`, filling `log`; yields the fraction done now and then."""
        stepper, last = self.stepper, moments[-1]
        forward = bool(last > moments[0])
        length = float(last - moments[0])
        self._record(log, moments[0], stepper.state)
        watched = self._pressed(moments[0], log, on_liftoff)
        index, cramped, pace = 1, 0, Pace()
        while index < len(moments) and watched:
            before = stepper.time
            outcome, step = stepper.step(max_delta_t=last - before, write_tc=True)
            code = int(outcome)
            if code <= _SUCCESS and code not in (_SUCCESS, _LIMIT):
                if not log.steps:
                    raise InputError(
                        f"start: the rate of the state is no number there; {_NO_VALUE}"
                    )
                self._break_down(log, "the state stopped being a number")
                return
            log.steps += 1
            now = stepper.time
            if dense:
                series = np.array(stepper.tc)
                series[self.loose, 0] += self.carried
                log.dense.append((before, now, series))
            while index < len(moments) and (
                moments[index] <= now if forward else moments[index] >= now
            ):
                stepper.update_d_output(moments[index])
                self._record(log, moments[index], stepper.d_output)
                index += 1
            if code > _SUCCESS:
                watched = self._passed(code, now, log, on_liftoff)
            log.corrections += self.project(stepper.state)
            self._carry()
            self.good = (now, self._whole(stepper.state))
            cramped = cramped + 1 if abs(float(step)) < 1e-13 * (1 + abs(float(now))) else 0
            if cramped > 20:
                reason = "the step size collapsed (a singularity of the equations is near)"
                self._break_down(log, reason)
                return
            if log.steps % 64 == 0:
                if time_limit is None:
                    done = abs(float(now - moments[0]) / length)
                    pace.check(done, f"to follow a motion for {abs(length):g} s")
                elif clock.perf_counter() - began > time_limit:
                    raise _StoppedError(f"the time limit of {time_limit:g} s was reached")
                yield float(now - moments[0]) / length

    def _pressed(self, now: Any, log: _Log, on_liftoff: str) -> bool:
        """Look at the normal force of the start; return whether to begin at all."""
        go_on = True
        for guard, value in zip(self.system.guards, self.first_guards, strict=True):
            if guard.lift_off and not float(value) > 0:
                go_on = on_liftoff == "warn"
                pressed = replace(guard, message="the normal force is negative at the start")
                log.events.append(Event(float(now), pressed, not go_on))
        return go_on

    def _passed(self, code: int, now: Any, log: _Log, on_liftoff: str) -> bool:
        """Note that a guard was passed; return whether to go on."""
        guard = self.system.guards[self.code.watched[-code - 1 if code < 0 else code]]
        go_on = guard.lift_off and on_liftoff == "warn"
        log.events.append(Event(float(now), guard, not go_on))
        if not go_on and now != log.times[-1]:
            self._record(log, now, self.stepper.state)
        return go_on

    def _break_down(self, log: _Log, reason: str) -> None:
        """End at a singularity: in failure, unless a guard says what has happened.

        Where a shape flattens, the contact point runs away as the root of the time that is left,
        so that no step gets past the guard that vanishes there.
        """
        now, state = self.good
        guards = zip(self.system.guards, self.first_guards, self._guards(state), strict=True)
        for guard, first, value in guards:
            if not guard.lift_off and float(value) < VANISHED * float(first):
                self.keep_last(log)
                log.events.append(Event(float(now), guard, True))
                return
        raise _StoppedError(reason)

    def keep_last(self, log: _Log) -> None:
        """Make the last good state the last sample."""
        now, state = self.good
        if now != log.times[-1]:
            self._append(log, now, np.array(state))

    def _whole(self, state: Any) -> Any:
        """A copy of a state of the integrator, its quadratures put back."""
        whole = np.array(state)
        whole[self.loose] += self.carried
        return whole

    def _record(self, log: _Log, moment: Any, state: Any) -> None:
        self._append(log, moment, self._whole(state))

    def _append(self, log: _Log, moment: Any, sample: Any) -> None:
        self.project(sample)
        log.times.append(moment)
        log.states.append(sample)

    def _carry(self) -> None:
        """Take the quadratures out of the state, summing them without loss.

        The step size answers to the largest component of the state, so that a place far from
        the origin would cost the dynamics its digits.
        """
        if self.loose:
            gain = self.stepper.state[self.loose] + self.remainder
            total = self.carried + gain
            self.remainder = gain - (total - self.carried)
            self.carried = total
            self.stepper.state[self.loose] = self.kind(0)

    def finish(self, log: _Log, statistics: Statistics) -> Trajectory:
        states = np.array(log.states, dtype=self.kind)
        columns = np.ascontiguousarray(states.T)
        pars = np.repeat(self.parameters[:, None], len(states), axis=1)
        rows = call(self.code.outputs, columns, pars)
        recorded: dict[str, Any] = {}
        first = 0
        for name, width in _layout(self.system):
            block = rows[first : first + max(width, 1)]
            recorded[name] = block.T if width else block[0]
            first += max(width, 1)
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
def _layout(system: System) -> list[tuple[str, int]]:
    """Names of what is recorded, with the number of components; 0 for a scalar."""
    recorded = [
        *((item.name, item.value) for item in system.observables),
        *((f"law_{law.name}", law.value) for law in system.integrals),
    ]
    shapes = [(name, to_components(value)) for name, value in recorded]
    return [(name, len(shape) if isinstance(shape, sp.MatrixBase) else 0) for name, shape in shapes]


@lru_cache(maxsize=32)
def _quadratures(system: System) -> list[int]:
    """Columns on which neither rates nor relations nor guards depend."""
    formulas = [
        *system.rates,
        *map(to_components, system.relations),
        *(to_components(guard.value) for guard in system.guards),
    ]
    used = {s for formula in formulas for s in formula.free_symbols}
    used |= {s for _, value in system.needed(formulas) for s in value.free_symbols}
    return [i for i, symbol in enumerate(system.symbols) if symbol not in used]


def _dense(log: _Log, kind: Any) -> DenseOutput | None:
    if not log.dense:
        return None
    begins, ends, coefficients = zip(*log.dense, strict=True)
    return DenseOutput(
        np.array(begins, dtype=kind), np.array(ends, dtype=kind), np.array(coefficients)
    )


# outcomes of a heyoka step: below these lie failures, above them events
_SUCCESS = -4294967297
_LIMIT = -4294967299
