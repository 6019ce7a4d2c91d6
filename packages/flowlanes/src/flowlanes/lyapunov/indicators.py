"""Chaos indicators of many motions, for scans.

One or several deviations are integrated along each motion and normalised after each interval. The
logarithms of the normalising factors add up to L(t). The largest exponent is the slope of L, the
fast Lyapunov indicator is its maximum (Froeschlé, Lega, Gonczi 1997), and MEGNO compares L with
its mean (Cincotta, Simó 2000). Lengths are measured with each vector of the state divided by its
size along the motion, so that the results do not depend on the units. Exponents are computed
without the directions that integrals and the flow force to be zero; indicators use all deviations
allowed by the relations, since some of those grow linearly in time on a regular motion.

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

#: Number of intervals of a motion; deviations are normalised after each.
INTERVALS = 200
#: Initial fraction of a motion that is omitted while a deviation finds its direction.
TRANSIENT = 0.2
#: Number of batches whose means give the error, and Student's factor for 95 % confidence.
BATCHES, STUDENT = 16, 2.131
#: Logarithm of the ratio of lengths at which the shorter deviation is lost in the errors of the
#: longer one; the interval is then divided, into at most the second number of pieces.
APART, PARTED = 16.0, 64


@dataclass(frozen=True)
class TangentGrowth:
    """Growth of deviations along motions.

    Attributes
    ----------
    logarithms : (n, intervals, d) array
        Logarithms of the normalising factors of each interval; NaN after the end of a motion, and
        NaN throughout if deviations separate too fast to be resolved.
    records : (n, numbers) array
        Further numbers at the final time.
    outcome : (n,) array of int
        0, or the reason why a motion ended.
    end_times : (n,) array
        The times reached.
    """

    logarithms: FloatArray
    records: FloatArray
    outcome: IntArray
    end_times: FloatArray


def tangent(system: System) -> TangentSpace:
    """Deviations tangent to the relations."""
    relations = system.scalar.relations
    return _some(TangentSpace(system, relations, (), np.zeros((0, 0))))


def transverse_space(system: System) -> TangentSpace:
    """Deviations tangent to the relations and unconditional integrals, modulo the flow.

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
    """Two deviations."""
    return 2


def all_deviations(space: TangentSpace) -> int:
    """As many deviations as the space has dimensions."""
    return space.dimension


def no_records(graph: Graph, frames: Sequence[Vector]) -> list[Term]:
    """No further numbers."""
    return []


@dataclass(frozen=True)
class Deviations:
    """The deviations carried along motions for an indicator.

    Attributes
    ----------
    space : callable
        System ↦ space of deviations.
    number : callable
        Number of deviations, for a given space.
    unit_terms : callable
        (graph, deviations, basis) ↦ normalised deviations and the factors, orthogonal to a basis.
    record_terms : callable
        (graph, normalised deviations) ↦ further numbers of each interval.
    """

    space: Callable[[System], TangentSpace] = tangent
    number: Callable[[TangentSpace], int] = one_deviation
    unit_terms: Normalisation = orthonormal_terms
    record_terms: Record = no_records

    def __call__(
        self, observation: Observation, starts: FloatArray, parameters: Parameters
    ) -> TangentGrowth:
        """Integrate deviations along many motions.

        Intervals in which they separate too fast are divided.

        Parameters
        ----------
        observation : Observation
            The system, the length of the motions and the number of intervals.
        starts : (n, size) array
            States on the phase space in flat order.
        parameters : mapping of Symbol or name to number or (n,) array
        """
        states = np.array(starts, dtype=np.float64)
        system, until = observation.system, observation.t_end
        sizes = state_scales(
            system, states, until, parameters, observation.tolerance, observation.device
        )
        growth, shrunk = _growth(self, observation, 1, states, sizes, parameters)
        pieces = 2
        # Only motions with lost deviations are repeated, each time with twice as many pieces.
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
    """Mask of completed motions on which a deviation became too short relative to another."""
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
    """Deviations along motions, and the largest logarithmic ratio of their lengths, (n,).

    Parameters
    ----------
    pieces : int
        Number of pieces of each interval; deviations are normalised after each.
    states, sizes : (n, size) arrays
        The starts, and the units of deviations.
    """
    intervals = observation.samples
    times = np.linspace(0.0, observation.t_end, intervals * pieces + 1)[1:]
    code = _machine_code(deviations, observation.system, observation.tolerance, observation.device)
    run = code.run(states, sizes, times, parameters)
    with np.errstate(divide="ignore"):
        logarithms = np.log(run.lengths, out=run.lengths)
    # Reduce over short axes two arrays at a time: there are few deviations and pieces, many
    # motions.
    columns = np.moveaxis(logarithms, 2, 0)
    shrunk = np.maximum(reduce(np.maximum, columns), 0.0) - reduce(np.minimum, columns)
    parted = logarithms.reshape(len(states), intervals, pieces, len(columns))
    whole = reduce(np.add, np.moveaxis(parted, 2, 0))
    growth = TangentGrowth(whole, run.records[:, -1], run.outcome, run.end_times)
    return growth, shrunk.max(axis=1)


def _rate(logarithms: FloatArray, t_end: float) -> tuple[FloatArray, FloatArray]:
    """The mean rate of growth after the transient, and its error, (n,) each.

    The error is the larger of the 95 % confidence interval from the means of 16 batches and the
    apparent rate of quadratic growth.
    """
    intervals = logarithms.shape[1]
    each = (intervals - round(TRANSIENT * intervals)) // BATCHES
    last = logarithms[:, intervals - each * BATCHES :]
    batches = last.reshape(len(last), BATCHES, each).mean(axis=2) * (intervals / t_end)
    span = t_end * each * BATCHES / intervals
    spread = STUDENT * batches.std(axis=1, ddof=1) / np.sqrt(BATCHES)
    # ln t² grows by 2 ln(t_end/(t_end − span)) over the last `span`.
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
    """The mean of Y over the ends of the intervals.

    Y(t) = (2/t) ∫ (d ln|ξ|/ds) s ds = 2 (L(t) − mean of L up to t), by the trapezoidal rule
    on the intervals: with ln|ξ| = l₁ + … + l_k after k intervals, Y = (2/k) Σ (i − 1/2) l_i over
    i ≤ k.
    """
    intervals = observation.samples
    # Averaging Y over k = 1 … n gives l_i the weight (2/n) (i − 1/2) Σ_{k ≥ i} 1/k.
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
    """Deviations normalised separately, so that they can become parallel."""
    frames, lengths = zip(
        *(orthonormal_terms(graph, [deviation], basis) for deviation in deviations), strict=True
    )
    return [vector for (vector,) in frames], [length for (length,) in lengths]


def _sum_and_difference(graph: Graph, frames: Sequence[Vector]) -> list[Term]:
    """The squares |u + v|² and |u − v|²."""
    u, v = frames
    sums = [x + y for x, y in zip(u, v, strict=True)]
    differences = [x - y for x, y in zip(u, v, strict=True)]
    return [dot(graph, sums, sums), dot(graph, differences, differences)]


#: The largest Lyapunov exponent apart from that of the flow, and its error. The first fifth of the
#: motion is omitted while the deviation finds its direction.
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

#: The sum of all exponents apart from those of relations, integrals and the flow. It is zero if a
#: measure is preserved; if it is negative, the motion is attracted.
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

#: The fast Lyapunov indicator: the maximum of the logarithmic growth so far.
fast_lyapunov_indicator = MotionObservable(
    "fli",
    "fast Lyapunov indicator",
    Deviations(),
    _greatest,
    samples=INTERVALS,
    least_samples=2 * BATCHES,
)

#: The mean of MEGNO: up to about 2 on a regular motion, λ/2 times the time on a chaotic one. It
#: tends to 2, often from below, if neighbouring motions separate linearly in time, and stays 0 if
#: they keep their distance (equal frequencies, a stable equilibrium).
megno = replace(fast_lyapunov_indicator, name="megno", title="MEGNO", reduce=_mean_megno)

#: SALI: the distance of two deviations from being parallel at the final time, as the logarithm
#: (base 10) of the smaller of |u + v| and |u − v| for unit vectors (Skokos 2001). It decreases
#: linearly on chaotic motions, down to −16, the level of rounding.
smaller_alignment_index = MotionObservable(
    "sali",
    "logarithm of SALI",
    Deviations(tangent, two_deviations, _each_for_itself, _sum_and_difference),
    _alignment,
    samples=INTERVALS,
    least_samples=2 * BATCHES,
)
