"""Chaos indicators of many motions, for scans.

One deviation, or several, is carried along each motion and made of length one after each interval.
The logarithms of the lengths lost add up to L(t): the largest exponent is the slope of L, the fast
Lyapunov indicator its greatest value (Froeschlé, Lega, Gonczi 1997), and MEGNO compares it with its
mean (Cincotta, Simó 2000).  Lengths are measured with each vector of the state divided by its size
along the motion, so that the numbers are the same in all units.  Exponents are taken of what
integrals and the flow do not force to be zero; indicators of all deviations that the relations
allow, among which those of a regular motion part evenly with time.

Examples
--------
>>> import flowlanes
>>> import numpy as np
>>> import sympy as sp
>>> x, v = sp.symbols("x v", real=True)
>>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
>>> sorted(megno(pendulum, t_end=20.0)(np.array([[1.0, 0.0]]), {}))
['ended', 'outcome', 'value']
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, reduce

import numpy as np

from ..errors import InputError
from ..flow.devices.graphics import Device
from ..flow.kernel.projection_terms import dot
from ..flow.level_projection import select_parameters
from ..flow.linearisation.deviation_growth import (
    DeviationGrowth,
    Normalisation,
    Record,
    Vector,
    deviation_growth,
    orthonormal_terms,
)
from ..flow.linearisation.state_scales import state_scales
from ..flow.linearisation.tangent_space import TangentSpace
from ..flow.motion_observable import MotionObservable, Observation
from ..formulas.graph import Graph, Term
from ..system.arrays import BoolArray, FloatArray, IntArray
from ..system.parameters import Parameters
from ..system.system import System

#: Intervals of a motion, after each of which deviations are made of length one.
INTERVALS = 200
#: Part of a motion left out at the beginning, where a deviation finds its direction.
TRANSIENT = 0.2
#: Batches whose means give the error, and Student's factor for 95 % of them.
BATCHES, STUDENT = 16, 2.131
#: Logarithm of the share of others to which a deviation may shrink in an interval before it is
#: lost in the error of these; the interval is parted then, into so many pieces at most.
APART, PARTED = 16.0, 64


@dataclass(frozen=True)
class TangentGrowth:
    """Deviations along motions.

    Attributes
    ----------
    logarithms : (n, intervals, d) array
        Of the lengths lost in each interval; not numbers after the end of a motion, and all of
        them if deviations part too fast to be resolved.
    records : (n, numbers) array
        Further numbers at the end.
    outcome : (n,) array of int
        0, or why a motion ended.
    end_times : (n,) array
        The times reached.
    """

    logarithms: FloatArray
    records: FloatArray
    outcome: IntArray
    end_times: FloatArray


def tangent(system: System) -> TangentSpace:
    """Deviations tangent to the relations: all that are possible."""
    relations = system.scalar.relations
    return _some(TangentSpace(system, relations, (), np.zeros((0, 0))))


def transverse_space(system: System) -> TangentSpace:
    """Those tangent to the integrals that hold everywhere as well, modulo the flow.

    The omitted directions have the exponent zero in any case.
    """
    integrals = tuple(law.value for law in system.scalar.integrals if not law.level)
    free = tangent(system)
    conditions = (*free.conditions, *integrals)
    return _some(TangentSpace(system, conditions, (system.rates,), np.eye(1)))


def _some(space: TangentSpace) -> TangentSpace:
    if space.dimension < 1:
        raise InputError(
            f"{space.system.name}: neighbours cannot part: relations, integrals and the direction "
            "of motion leave no deviation"
        )
    return space


def one_deviation(space: TangentSpace) -> int:
    """A single deviation."""
    return 1


def two_deviations(space: TangentSpace) -> int:
    """A pair."""
    return 2


def all_deviations(space: TangentSpace) -> int:
    """As many deviations as there are."""
    return space.dimension


def no_records(graph: Graph, frames: Sequence[Vector]) -> list[Term]:
    """No further numbers."""
    return []


@dataclass(frozen=True)
class Deviations:
    """The deviations that an indicator carries along motions.

    Attributes
    ----------
    space : callable
        System ↦ the deviations that count.
    number : callable
        Of deviations carried along a motion, in that space.
    unit_terms : callable
        (graph, deviations, basis) ↦ deviations of length one and the lengths lost, without the
        span of a basis.
    record_terms : callable
        (graph, deviations of length one) ↦ further numbers of each interval.
    """

    space: Callable[[System], TangentSpace] = tangent
    number: Callable[[TangentSpace], int] = one_deviation
    unit_terms: Normalisation = orthonormal_terms
    record_terms: Record = no_records

    def __call__(
        self, observation: Observation, starts: FloatArray, parameters: Parameters
    ) -> TangentGrowth:
        """Deviations along many motions.

        Where they part too fast, an interval is parted.

        Parameters
        ----------
        observation : Observation
            The system, the length of the motions, and the number of intervals.
        starts : (n, size) array
            In flat order, on the phase space.
        parameters : mapping of Symbol or name to number or (n,) array
        """
        states = np.array(starts, dtype=np.float64)
        system, until = observation.system, observation.t_end
        sizes = state_scales(
            system, states, until, parameters, observation.tolerance, observation.device
        )
        growth, shrunk = _growth(self, observation, 1, states, sizes, parameters)
        pieces = 2
        while pieces <= PARTED and len(
            lost := np.flatnonzero(_has_short_deviations(growth, shrunk))
        ):
            chosen = select_parameters(parameters, lost)
            again, shrunk[lost] = _growth(
                self, observation, pieces, states[lost], sizes[lost], chosen
            )
            for known, new in zip(vars(growth).values(), vars(again).values(), strict=True):
                known[lost] = new
            pieces *= 2
        growth.logarithms[_has_short_deviations(growth, shrunk)] = np.nan
        return growth


def _has_short_deviations(growth: TangentGrowth, shrunk: FloatArray) -> BoolArray:
    """Complete motions with deviations too short beside others."""
    result: BoolArray = (growth.outcome == 0) & ~(shrunk <= APART)
    return result


@lru_cache(maxsize=16)
def _machine_code(
    deviations: Deviations, system: System, tolerance: float, device: Device
) -> DeviationGrowth:
    space = deviations.space(system)
    return deviation_growth(
        space,
        deviations.number(space),
        deviations.unit_terms,
        deviations.record_terms,
        tolerance=tolerance,
        device=device,
    )


def _growth(
    deviations: Deviations,
    observation: Observation,
    pieces: int,
    states: FloatArray,
    sizes: FloatArray,
    parameters: Parameters,
) -> tuple[TangentGrowth, FloatArray]:
    """Deviations along motions, and by what share the shortest of an interval have shrunk.

    Parameters
    ----------
    pieces : int
        Of each interval; deviations are made of length one after each.
    states, sizes : (n, size) arrays
        The starts, and by what deviations are measured.
    """
    intervals = observation.samples
    times = np.linspace(0.0, observation.t_end, intervals * pieces + 1)[1:]
    code = _machine_code(deviations, observation.system, observation.tolerance, observation.device)
    run = code.run(states, sizes, times, parameters)
    with np.errstate(divide="ignore"):
        logarithms = np.log(run.lengths, out=run.lengths)
    # of two at a time: there are few deviations and pieces, and many motions
    columns = np.moveaxis(logarithms, 2, 0)
    shrunk = np.maximum(reduce(np.maximum, columns), 0.0) - reduce(np.minimum, columns)
    parted = logarithms.reshape(len(states), intervals, pieces, len(columns))
    whole = reduce(np.add, np.moveaxis(parted, 2, 0))
    growth = TangentGrowth(whole, run.records[:, -1], run.outcome, run.end_times)
    return growth, shrunk.max(axis=1)


def _rate(logarithms: FloatArray, t_end: float) -> tuple[FloatArray, FloatArray]:
    """The mean rate of growth without the beginning, and its error, (n,) each.

    The error is the larger of the 95 % interval from the means of 16 batches, and of what growth
    with the square of the time would show.
    """
    intervals = logarithms.shape[1]
    each = (intervals - round(TRANSIENT * intervals)) // BATCHES
    last = logarithms[:, intervals - each * BATCHES :]
    batches = last.reshape(len(last), BATCHES, each).mean(axis=2) * (intervals / t_end)
    span = t_end * each * BATCHES / intervals
    spread = STUDENT * batches.std(axis=1, ddof=1) / np.sqrt(BATCHES)
    unseen = 2.0 * np.log(t_end / (t_end - span)) / span
    return batches.mean(axis=1), np.maximum(spread, unseen)


def _largest(observation: Observation, growth: TangentGrowth) -> dict[str, FloatArray]:
    value, error = _rate(growth.logarithms[:, :, 0], observation.t_end)
    return {"value": value, "error": error}


def _total(observation: Observation, growth: TangentGrowth) -> dict[str, FloatArray]:
    value, error = _rate(growth.logarithms.sum(axis=2), observation.t_end)
    return {"value": value, "error": error}


def _greatest(observation: Observation, growth: TangentGrowth) -> dict[str, FloatArray]:
    return {"value": np.cumsum(growth.logarithms[:, :, 0], axis=1).max(axis=1)}


def _mean_megno(observation: Observation, growth: TangentGrowth) -> dict[str, FloatArray]:
    """The mean of Y at the ends of the intervals.

    Y(t) = (2/t) ∫ (d ln|ξ|/ds) s ds = 2 (L(t) − the mean of L until t), by the trapezoidal rule
    over the intervals.  With ln|ξ| = l₁ + … + lₖ after k of them, Y = (2/k) Σ (i − 1/2) lᵢ over
    i ≤ k.
    """
    intervals = observation.samples
    count = np.arange(1, intervals + 1)
    harmonic = np.cumsum(1.0 / count[::-1])[::-1]
    weights = (2.0 / intervals) * (count - 0.5) * harmonic
    return {"value": (growth.logarithms[:, :, 0] * weights).sum(axis=1)}


def _alignment(observation: Observation, growth: TangentGrowth) -> dict[str, FloatArray]:
    apart = np.sqrt(growth.records.min(axis=1))
    return {"value": np.log10(np.maximum(apart, np.finfo(float).eps))}


def _each_for_itself(
    graph: Graph, deviations: Sequence[Vector], basis: Sequence[Vector]
) -> tuple[list[list[Term]], list[Term]]:
    """Deviations of length one that can become parallel."""
    frames, lengths = zip(
        *(orthonormal_terms(graph, [deviation], basis) for deviation in deviations), strict=True
    )
    return [vector for (vector,) in frames], [length for (length,) in lengths]


def _sum_and_difference(graph: Graph, frames: Sequence[Vector]) -> list[Term]:
    """The squares of |u + v| and |u − v|."""
    u, v = frames
    sums = [x + y for x, y in zip(u, v, strict=True)]
    differences = [x - y for x, y in zip(u, v, strict=True)]
    return [dot(graph, sums, sums), dot(graph, differences, differences)]


#: The largest Lyapunov exponent but for that of the flow, and its error.  The first fifth of the
#: motion is left out: there the deviation finds its direction.
maximal_exponent = MotionObservable(
    "lyapunov",
    "largest Lyapunov exponent",
    Deviations(transverse_space),
    _largest,
    unit="1/s",
    samples=INTERVALS,
    least_samples=2 * BATCHES,
    extra_columns={"error": "error of the largest exponent"},
)

#: The sum of all exponents that relations, integrals and the flow leave.  It is zero if a measure
#: is preserved; if it is negative, the motion is attracted.
exponent_sum = MotionObservable(
    "sum",
    "sum of Lyapunov exponents",
    Deviations(transverse_space, all_deviations),
    _total,
    unit="1/s",
    samples=INTERVALS,
    least_samples=2 * BATCHES,
    extra_columns={"error": "error of the sum of exponents"},
)

#: The fast Lyapunov indicator: the greatest logarithm of the growth so far.
fast_lyapunov_indicator = MotionObservable(
    "fli",
    "fast Lyapunov indicator",
    Deviations(),
    _greatest,
    samples=INTERVALS,
    least_samples=2 * BATCHES,
)

#: The mean of MEGNO: up to about 2 on a regular motion, λ/2 times the time on a chaotic one.  It
#: tends to 2, often from below, where neighbours part in proportion to the time, and stays 0 if
#: they keep their distance (equal frequencies, a stable equilibrium).
megno = replace(fast_lyapunov_indicator, name="megno", title="MEGNO", reduce=_mean_megno)

#: SALI: how far two deviations are from being parallel at the end, as the logarithm (base 10) of
#: the smaller of |u + v| and |u − v| of two deviations of length one (Skokos 2001).  It falls
#: evenly on chaotic motions, to −16 where rounding ends it.
smaller_alignment_index = MotionObservable(
    "sali",
    "logarithm of SALI",
    Deviations(tangent, two_deviations, _each_for_itself, _sum_and_difference),
    _alignment,
    samples=INTERVALS,
    least_samples=2 * BATCHES,
)
