"""Observables of a formula along motions: means, extremes, frequencies; and survival times.

Each is evaluated for many motions at once, as in charts and ensembles.  A motion that ends early
has no value, and does not disturb the others.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
import sympy as sp

from ..arguments import Positive, arguments_checked
from ..flow.batch import BatchIntegrator, batch_integrator
from ..flow.devices.graphics import Device
from ..flow.level_projection import select_parameters
from ..formulas.array_evaluation import values
from ..orbits.rotation import average
from ..system.arrays import FloatArray, IntArray
from ..system.parameters import Parameters
from ..system.system import System

#: States of a motion that are kept at a time.
BUFFER_LENGTH = 128
#: An additional variable of the state: a formula integrated in time.
TOTAL = sp.Symbol("integral_in_time", real=True)


@arguments_checked
@dataclass(frozen=True)
class SurvivalTime:
    """The survival time of a motion: until a guard of the system or a failure ends it.

    Attributes
    ----------
    system : System
    until : float
        Time at which to stop.
    tolerance : float
        See :func:`flowlanes.flow.batch.batch_integrator`.
    device : "cpu" or "gpu"
        Where motions are computed; likewise.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> rule = flowlanes.scans.SurvivalTime(pendulum, 10.0)
    >>> rule(np.array([[1.0, 0.0]]), {})["value"].tolist()
    [10.0]
    """

    system: System
    until: Positive
    tolerance: Positive = 1e-12
    device: Device = "cpu"
    further: ClassVar[Mapping[str, str]] = {}

    @arguments_checked
    def __call__(
        self, starts: FloatArray, parameters: Parameters
    ) -> dict[str, FloatArray | IntArray]:
        """Times, outcomes and times reached, (n,) each."""
        run = batch_integrator(self.system, tolerance=self.tolerance, device=self.device).propagate(
            starts, [self.until], parameters
        )
        return {"value": run.end_times, "outcome": run.outcome, "ended": run.end_times}


@arguments_checked
@dataclass(frozen=True)
class TimeAverage:
    """The mean of a formula in time, integrated along with the motion.

    Attributes
    ----------
    system, until, tolerance, device
        See `SurvivalTime`.
    formula : sympy.Expr
        In state, definitions and parameters.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> rule = flowlanes.scans.TimeAverage(pendulum, 10.0, v**2)
    >>> rule(np.array([[1.0, 0.0]]), {})["value"].round(3).tolist()
    [0.447]
    """

    system: System
    until: Positive
    formula: sp.Expr
    tolerance: Positive = 1e-12
    device: Device = "cpu"
    further: ClassVar[Mapping[str, str]] = {}

    @arguments_checked
    def __call__(
        self, starts: FloatArray, parameters: Parameters
    ) -> dict[str, FloatArray | IntArray]:
        """Means, outcomes and times reached, (n,) each."""
        flow = batch_integrator(
            _with_total(self.system, self.formula), tolerance=self.tolerance, device=self.device
        )
        run = flow.propagate(_from_zero(starts), [self.until], parameters)
        mean = run.states[:, 0, -1] / self.until
        return {"value": mean, "outcome": run.outcome, "ended": run.end_times}


@arguments_checked
@dataclass(frozen=True)
class Maximum:
    """The greatest value of a formula among equidistant samples of a motion.

    Attributes
    ----------
    system, until, tolerance, device
        See `SurvivalTime`.
    formula : sympy.Expr
        In state, definitions and parameters.
    samples : int
        Samples after the start, which counts as well.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> rule = flowlanes.scans.Maximum(pendulum, 10.0, v**2, samples=64)
    >>> rule(np.array([[1.0, 0.0]]), {})["value"].round(3).tolist()
    [0.919]
    """

    system: System
    until: Positive
    formula: sp.Expr
    samples: int = 2048
    tolerance: Positive = 1e-12
    device: Device = "cpu"
    further: ClassVar[Mapping[str, str]] = {}

    @arguments_checked
    def __call__(
        self, starts: FloatArray, parameters: Parameters
    ) -> dict[str, FloatArray | IntArray]:
        """Values, outcomes and times reached, (n,) each."""
        flow = batch_integrator(self.system, tolerance=self.tolerance, device=self.device)
        seen = observe(flow, self.formula, starts, self.until, self.samples, parameters)
        return {"value": seen.values.max(axis=1), "outcome": seen.outcome, "ended": seen.end_times}


@arguments_checked
@dataclass(frozen=True)
class Minimum(Maximum):
    """The least value of a formula among samples of a motion; see `Maximum`.

    Parameters
    ----------
    system, until, formula, samples, tolerance, device
        See `Maximum`.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> rule = flowlanes.scans.Minimum(pendulum, 10.0, v**2, samples=64)
    >>> rule(np.array([[1.0, 0.0]]), {})["value"].round(3).tolist()
    [0.0]
    """

    def __call__(
        self, starts: FloatArray, parameters: Parameters
    ) -> dict[str, FloatArray | IntArray]:
        """Values, outcomes and times reached, (n,) each."""
        turned = Maximum(
            self.system, self.until, -self.formula, self.samples, self.tolerance, self.device
        )
        maximum = turned(starts, parameters)
        return {**maximum, "value": -maximum["value"]}


@arguments_checked
@dataclass(frozen=True)
class Frequency:
    """The frequency of an angle by a weighted average, with an error estimate.

    The rate of the angle is integrated along with the motion, so that no turn is lost.

    Attributes
    ----------
    system, until, tolerance, device
        See `SurvivalTime`.
    formula : sympy.Expr
        An angle, in radians, up to whole turns.
    samples : int
        Equidistant samples over which the average is taken.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> import sympy as sp
    >>> phi, w = sp.symbols("phi w", real=True)
    >>> rotor = flowlanes.System("rotor", "Rotor", {phi: w, w: 0})
    >>> rule = flowlanes.scans.Frequency(rotor, 100.0, phi, samples=256)
    >>> rule(np.array([[0.0, 2.0]]), {})["value"].round(6).tolist()
    [0.31831]
    """

    system: System
    until: Positive
    formula: sp.Expr
    samples: int = 4096
    tolerance: Positive = 1e-12
    device: Device = "cpu"
    further: ClassVar[Mapping[str, str]] = {"error": "difference between the halves of the motion"}

    @arguments_checked
    def __call__(
        self, starts: FloatArray, parameters: Parameters
    ) -> dict[str, FloatArray | IntArray]:
        """Values, errors, outcomes and times reached, (n,) each."""
        turns = _with_total(self.system, _rate(self.system, self.formula) / (2 * sp.pi))
        flow = batch_integrator(turns, tolerance=self.tolerance, device=self.device)
        seen = observe(flow, TOTAL, _from_zero(starts), self.until, self.samples, parameters)
        value, error = average(np.diff(seen.values, axis=1) * (self.samples / self.until))
        return {"value": value, "error": error, "outcome": seen.outcome, "ended": seen.end_times}


def _with_total(system: System, formula: sp.Expr) -> System:
    """A system that integrates a formula in time along with its motion."""
    return replace(system, field=(*system.field, (TOTAL, formula)), reconstruction=None)


def _from_zero(starts: FloatArray) -> FloatArray:
    return np.concatenate([starts, np.zeros((len(starts), 1))], axis=1)


def _rate(system: System, formula: sp.Expr) -> sp.Expr:
    """The derivative of a formula along the motion, through the definitions."""
    rates = dict(zip(system.symbols, system.rates, strict=True))
    for symbol, value in system.required_definitions([formula]):
        rates[symbol] = _changing(value, rates)
    return _changing(formula, rates)


def _changing(formula: sp.Expr, rates: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    return sp.Add(*(sp.diff(formula, s) * rates[s] for s in formula.free_symbols if s in rates))


@dataclass(frozen=True)
class ObservedSeries:
    """A formula along motions.

    Attributes
    ----------
    values : (n, samples + 1) array
        From the start on; not numbers after the end of a motion.
    outcome : (n,) array of int
        0, or why a motion ended; see ``BatchIntegrator.status_message``.
    end_times : (n,) array
        The times reached.
    """

    values: FloatArray
    outcome: IntArray
    end_times: FloatArray


def observe(
    flow: BatchIntegrator,
    formula: sp.Expr,
    starts: FloatArray,
    until: float,
    samples: int,
    parameters: Parameters,
) -> ObservedSeries:
    """A formula along motions at equidistant times; few states are kept at a time.

    Parameters
    ----------
    flow : BatchIntegrator
    formula : sympy.Expr
        In state, definitions and parameters.
    starts : (n, size) array
    until : float
        The last time.
    samples : int
        Number of times after the start.
    parameters : mapping of Symbol or name to number or (n,) array
    """
    times = np.linspace(0.0, until, samples + 1)
    states = np.array(starts, dtype=np.float64)
    outcome, ended = np.zeros(len(states), dtype=np.int64), np.zeros(len(states))
    series = np.full((len(states), samples + 1), np.nan)
    series[:, 0] = values(flow.system, [formula], states, parameters)[:, 0]
    for first in range(0, samples, BUFFER_LENGTH):
        some = slice(first + 1, min(first + BUFFER_LENGTH, samples) + 1)
        live = np.flatnonzero(outcome == 0)
        if not len(live):
            break
        chosen = select_parameters(parameters, live)
        run = flow.propagate(states[live], times[some] - times[first], chosen)
        series[live, some] = values(flow.system, [formula], run.states, chosen)[..., 0]
        outcome[live], states[live] = run.outcome, run.states[:, -1]
        ended[live] = times[first] + run.end_times
    return ObservedSeries(series, outcome, ended)
