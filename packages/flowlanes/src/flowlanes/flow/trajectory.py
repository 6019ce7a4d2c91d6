"""Results of an integration: states, recorded quantities, events, dense output."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import numpy.typing as npt
import sympy as sp

from ..arguments import arguments_checked
from ..errors import InputError
from ..formulas.array_evaluation import overflows
from ..system.arrays import BoolArray, FloatArray
from ..system.laws import Integral
from ..system.overview import Overview, WithOverview
from ..system.system import Guard, System
from .motion import SystemMotion, read_only
from .recorded_quantities import recorded_quantities
from .sampled_motion import SampledMotion, sampled
from .taylor.working_numbers import WorkingArray, WorkingNumber

#: Drift of a quantity that is undefined along the motion, such as 0/0 at rest.
NO_VALUE = "undefined along this motion"

#: Drift of a quantity that is too large for double precision.
TOO_LARGE = "too large for double precision"


def _doubles(array: WorkingArray) -> FloatArray:
    """Numbers of any precision as doubles, infinite if too large."""
    with np.errstate(over="ignore"):
        return np.asarray(array).astype(float)


@dataclass(frozen=True)
class Event:
    """Violated guard, with its time.

    Parameters
    ----------
    time : float
        Time in s.
    guard : Guard
    is_terminal : bool
        True if the motion ends there.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> h, v = sp.symbols("h v", real=True)
    >>> ground = flowlanes.system.Guard("ground", h, "the stone hits the ground")
    >>> stone = flowlanes.System("stone", "Stone", {h: v, v: -1}, guards=(ground,))
    >>> motion = flowlanes.integrate(stone, {"h": 2.0, "v": 0.0}, [0.0, 10.0])
    >>> round(float(motion.events[0].time), 9), motion.events[0].is_terminal
    (2.0, True)
    """

    time: float
    guard: Guard
    is_terminal: bool

    def __str__(self) -> str:
        end = "the run ends there" if self.is_terminal else "the run continues"
        return f"t = {self.time:.17g}: {self.guard.message}; {end}"


@dataclass(frozen=True)
class Statistics:
    """Method, cost and accuracy of an integration.

    Attributes
    ----------
    method : str
        Name of the method, such as ``"Taylor series"``, as given by the integrator.
    steps, order : int
        Zero for a closed form, which has no steps.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    precision : str
        ``"double"`` or ``"quad"``.
    corrections : int
        Number of projections onto the phase space.
    seconds : float
        Computing time.
    from_cache : bool
        True if the machine code was read from the cache.
    """

    method: str
    steps: int
    order: int
    tolerance: float
    precision: str
    corrections: int
    seconds: float
    from_cache: bool

    @property
    def integrator(self) -> str:
        """Method with its order and number of steps."""
        if not self.steps:
            return self.method
        return f"{self.method} of order {self.order}, {self.steps} steps"


@dataclass(frozen=True)
class DenseOutput:
    """Continuous trajectory: the Taylor polynomials of all steps.

    A call with times inside `span` gives states of the shape (times, state).

    Attributes
    ----------
    begins, ends : array (steps,)
        Start and end times of the steps.
    coefficients : array (steps, state, order + 1)
        Coefficients of the powers of the time since the start of the step.
    """

    begins: WorkingArray
    ends: WorkingArray
    coefficients: WorkingArray

    @property
    def span(self) -> tuple[float, float]:
        """Both ends of the interval of time, in the direction of integration."""
        return float(self.begins[0]), float(self.ends[-1])

    def __call__(self, times: npt.ArrayLike) -> WorkingArray:
        """States (times, state) at `times`; InputError outside the computed interval."""
        moments = np.atleast_1d(np.asarray(times, dtype=float))
        low, high = sorted(self.span)
        if np.any(moments < low) or np.any(moments > high):
            raise InputError(f"time outside the computed interval from {low:g} to {high:g}")
        sign = 1.0 if self.ends[0] > self.begins[0] else -1.0
        begins = sign * self.begins.astype(float)
        index = np.clip(np.searchsorted(begins, sign * moments, side="right") - 1, 0, None)
        step = moments - self.begins[index]
        value: WorkingArray = self.coefficients[index, :, -1]
        for order in range(self.coefficients.shape[2] - 2, -1, -1):
            value = value * step[:, None] + self.coefficients[index, :, order]
        return value


def require_pieces(pieces: int) -> None:
    """Raise InputError unless the number of pieces of an interval is positive."""
    if pieces < 1:
        raise InputError(f"pieces = {pieces}: there must be one at least")


@dataclass(frozen=True, repr=False, eq=False)
class Trajectory(SystemMotion, WithOverview):
    """States and observables of a system along one motion; its arrays are read-only.

    If the continuous trajectory was kept, a call with times gives the states there.

    Attributes
    ----------
    system : System
        Lifted to space if it has a motion in space.
    parameters : mapping of Symbol to number
    times : array (n,)
        Times in s.
    states : array (n, size)
        In the flat order of ``system.symbols``; 34-digit numbers at precision "quad".
    records : mapping of str to array
        Observables by name, (n,) or (n, components), and ``law_<name>`` for every integral.
    events : tuple of Event
        Violated guards in the order of time.
    statistics : Statistics
    dense : DenseOutput or None
        Continuous trajectory, if it was kept.
    warnings : tuple of str
        One sentence for every recorded quantity that is too large at some samples.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> energy = flowlanes.Integral("energy", v**2 / 2 + x**4 / 4)
    >>> quartic = flowlanes.System("quartic", "Quartic", {x: v, v: -(x**3)}, laws=(energy,))
    >>> motion = flowlanes.integrate(quartic, {"x": 1.0, "v": 0.5}, [0.0, 5.0, 10.0])
    >>> motion.states.shape, motion["x"].shape, motion["law_energy"].shape
    ((3, 2), (3,), (3,))
    """

    system: System
    parameters: Mapping[sp.Symbol, WorkingNumber]
    times: WorkingArray
    states: WorkingArray
    records: Mapping[str, WorkingArray]
    events: tuple[Event, ...]
    statistics: Statistics
    dense: DenseOutput | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "times", read_only(self.times))
        object.__setattr__(self, "states", read_only(self.states))
        records = {name: read_only(record) for name, record in self.records.items()}
        object.__setattr__(self, "records", records)

    def __call__(self, times: npt.ArrayLike) -> SampledMotion:
        """States at other times; see :meth:`Motion.__call__`."""
        if self.dense is None:
            raise InputError(
                f"{self.system.name}: this trajectory is known at its samples alone; integrate "
                "with dense=True for the motion between them"
            )
        return sampled(self.system, self.parameters, times, self.dense)

    def facts(self) -> dict[str, object]:
        """Events, warnings, and information on the computation."""
        done = self.statistics
        return {
            "events": "\n".join(map(str, self.events)),
            "warnings": "\n".join(self.warnings),
            "tolerance": done.tolerance,
            "precision": done.precision,
            "integrator": done.integrator,
        }

    def overview(self) -> Overview:
        """System, interval of time, drift of the integrals, events and cost."""
        first, last = float(self.times[0]), float(self.times[-1])
        done = self.statistics
        cost = f"{done.steps:,} of order {done.order} in {done.seconds:.3g} s"
        return Overview(
            f"{self.system.title}: t = {first:.9g} to {last:.9g}, {len(self.times):,} samples",
            (
                ("state", ", ".join(map(str, self.system.state))),
                ("recorded", ", ".join(name for name in self.records if name[:4] != "law_")),
                *((f"drift of {law.name}", self._drift(law.name)) for law in self._integrals()),
                *(("event", str(event)) for event in self.events),
                *(("warning", warning) for warning in self.warnings),
                ("steps", cost),
                ("tolerance", f"{done.tolerance:.3g}, {done.precision} precision"),
            ),
        )

    @cached_property
    def overflows(self) -> Mapping[str, BoolArray]:
        """Samples (n,) at which recorded quantities overflow, by name.

        The state is finite there; names as in `records`.
        """
        found: dict[str, BoolArray] = {}
        for quantity in recorded_quantities(self.system):
            if quantity.name not in self.records:
                continue
            record = _doubles(self.records[quantity.name]).reshape(len(self.times), -1)
            places = np.flatnonzero(~np.isfinite(record).all(axis=1))
            if not len(places):
                continue
            states = _doubles(self.states[places])
            parameters = {s: float(value) for s, value in self.parameters.items()}
            large = overflows(self.system, quantity.formulas, states, parameters)
            large &= np.isfinite(states).all(axis=1)
            if large.any():
                found[quantity.name] = np.isin(np.arange(len(self.times)), places[large])
        return found

    @property
    def warnings(self) -> tuple[str, ...]:
        """One sentence for each recorded quantity that is too large at some samples."""
        return tuple(
            f"{name.removeprefix('law_')} is recorded as inf or nan at {places.sum():,} of "
            f"{len(places):,} samples, first at t = {float(self.times[places][0]):.9g}: a number "
            "in its formula is larger than 1.8e308, the largest in double precision"
            for name, places in self.overflows.items()
        )

    def _integrals(self) -> list[Integral]:
        return [law for law in self.system.integrals if f"law_{law.name}" in self.records]

    def _drift(self, name: str) -> str:
        values = self.records[f"law_{name}"]
        if f"law_{name}" in self.overflows:
            return TOO_LARGE
        change = float(max(abs(value - values[0]) for value in values))
        return NO_VALUE if math.isnan(change) else f"{change:.1e}"

    @arguments_checked
    def subsample(self, pieces: int) -> Trajectory:
        """Every `pieces`-th sample, and the last one."""
        require_pieces(pieces)
        last = len(self.times) - 1
        indices = [*range(0, last, pieces), last]
        return replace(
            self,
            times=self.times[indices],
            states=self.states[indices],
            records={name: values[indices] for name, values in self.records.items()},
        )
