"""Observables along motions: means, extremes, frequencies and survival times of formulas.

Each is evaluated for many motions at once, as in charts and ensembles. A motion that ends early
has no value and does not affect the others.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import sympy as sp

from ..errors import InputError
from ..flow.batch import BatchIntegrator, batch_integrator
from ..flow.batch_results import BatchTrajectories
from ..flow.level_projection import select_parameters
from ..flow.motion_observable import MotionObservable, Observation
from ..formulas.array_evaluation import values
from ..orbits.rotation import average
from ..system.arrays import FloatArray, IntArray
from ..system.parameters import Parameters
from ..system.system import System
from .grid import directions

#: Number of states of each motion kept in memory at a time.
BUFFER_LENGTH = 128
#: Additional state variable: the time integral of a formula.
TOTAL = sp.Symbol("integral_in_time", real=True)


@dataclass(frozen=True)
class ObservedSeries:
    """Values of a formula along motions.

    Attributes
    ----------
    values : (n, samples + 1) array
        Values from the start on; NaN after the end of a motion.
    outcome : (n,) array of int
        0, or the reason why a motion ended; see ``BatchIntegrator.status_message``.
    end_times : (n,) array
        The times reached.
    """

    values: FloatArray
    outcome: IntArray
    end_times: FloatArray


def to_the_end(
    observation: Observation, starts: FloatArray, parameters: Parameters
) -> BatchTrajectories:
    """The final states of motions."""
    return _flow(observation, observation.system).propagate(starts, [observation.t_end], parameters)


def with_integral(
    observation: Observation, starts: FloatArray, parameters: Parameters
) -> BatchTrajectories:
    """The final states, with the time integral of the formula as the last variable."""
    flow = _flow(observation, _with_total(observation.system, _formula(observation)))
    return flow.propagate(_from_zero(starts), [observation.t_end], parameters)


def sampled(observation: Observation, starts: FloatArray, parameters: Parameters) -> ObservedSeries:
    """The formula sampled at equidistant times."""
    flow, formula = _flow(observation, observation.system), _formula(observation)
    return observe(flow, formula, starts, observation.t_end, observation.samples, parameters)


def turns_sampled(
    observation: Observation, starts: FloatArray, parameters: Parameters
) -> ObservedSeries:
    """The accumulated turns of an angle at equidistant times.

    The rate of the angle is integrated along with the motion, so that no turn is missed.
    """
    rate = _rate(observation.system, _formula(observation)) / (2 * sp.pi)
    flow = _flow(observation, _with_total(observation.system, rate))
    until, samples = observation.t_end, observation.samples
    return observe(flow, TOTAL, _from_zero(starts), until, samples, parameters)


def _flow(observation: Observation, system: System) -> BatchIntegrator:
    return batch_integrator(system, tolerance=observation.tolerance, device=observation.device)


def _formula(observation: Observation) -> sp.Expr:
    if observation.formula is None:
        raise InputError(f"{observation.observable.name}: a formula is needed")
    return observation.formula


def _end_times(observation: Observation, run: BatchTrajectories) -> dict[str, FloatArray]:
    return {"value": run.end_times}


def _mean(observation: Observation, run: BatchTrajectories) -> dict[str, FloatArray]:
    return {"value": run.states[:, 0, -1] / observation.t_end}


def _greatest(observation: Observation, run: ObservedSeries) -> dict[str, FloatArray]:
    return {"value": run.values.max(axis=1)}


def _least(observation: Observation, run: ObservedSeries) -> dict[str, FloatArray]:
    return {"value": run.values.min(axis=1)}


def _mean_rate(observation: Observation, run: ObservedSeries) -> dict[str, FloatArray]:
    rates = np.diff(run.values, axis=1) * (observation.samples / observation.t_end)
    value, error = average(rates)
    return {"value": value, "error": error}


def _require_angle(system: System, text: str, value: sp.Expr, unit: str) -> None:
    """Raise InputError if a formula is certainly not an angle."""
    varying = value.free_symbols - set(system.defaults)
    if unit not in ("rad", "1", "unknown"):
        wrong = f"it is measured in {unit}"
    elif varying <= directions(system) and value.is_polynomial(*varying):
        wrong = "it stays within bounds and makes no turns"
    else:
        return
    raise InputError(f"{text}: {wrong}; an angle is needed, such as atan2(y, x)")


#: The survival time of a motion: until a guard of the system or a failure ends it.
survival_time = MotionObservable(
    "duration", "time until the motion ends", to_the_end, _end_times, "s"
)

#: The time average of a formula, integrated along with the motion.
time_average = MotionObservable(
    "mean", "mean of {}", with_integral, _mean, unit="{}", of_formula=True
)

#: The maximum of a formula over equidistant samples of a motion, including its start.
maximum = MotionObservable(
    "highest", "highest value of {}", sampled, _greatest, unit="{}", of_formula=True, samples=2048
)

#: The minimum of a formula over equidistant samples of a motion.
minimum = replace(maximum, name="lowest", title="lowest value of {}", reduce=_least)

#: The frequency of an angle by a weighted average, with an error estimate.
frequency = MotionObservable(
    "frequency",
    "frequency of {}",
    turns_sampled,
    _mean_rate,
    unit="1/s",
    of_formula=True,
    samples=4096,
    extra_columns={"error": "difference between the halves of the motion"},
    require=_require_angle,
)


def _with_total(system: System, formula: sp.Expr) -> System:
    """A system that integrates a formula in time along with its motion."""
    return replace(system, field=(*system.field, (TOTAL, formula)), reconstruction=None)


def _from_zero(starts: FloatArray) -> FloatArray:
    return np.concatenate([starts, np.zeros((len(starts), 1))], axis=1)


def _rate(system: System, formula: sp.Expr) -> sp.Expr:
    """The time derivative of a formula along the motion, through its definitions."""
    # Chain rule in the order of the definitions: ḟ = Σ ∂f/∂s ṡ over state and definitions.
    rates = dict(zip(system.symbols, system.rates, strict=True))
    for symbol, value in system.required_definitions([formula]):
        rates[symbol] = _changing(value, rates)
    return _changing(formula, rates)


def _changing(formula: sp.Expr, rates: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    return sp.Add(*(sp.diff(formula, s) * rates[s] for s in formula.free_symbols if s in rates))


def observe(
    flow: BatchIntegrator,
    formula: sp.Expr,
    starts: FloatArray,
    t_end: float,
    samples: int,
    parameters: Parameters,
) -> ObservedSeries:
    """A formula along motions at equidistant times, with few states in memory at a time.

    Parameters
    ----------
    flow : BatchIntegrator
    formula : sympy.Expr
        In state, definitions and parameters.
    starts : (n, size) array
    t_end : float
        The final time.
    samples : int
        Number of times after the start.
    parameters : mapping of Symbol or name to number or (n,) array
    """
    times = np.linspace(0.0, t_end, samples + 1)
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
