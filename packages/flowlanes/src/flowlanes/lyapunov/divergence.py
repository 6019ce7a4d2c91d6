"""Growth of volumes along a motion: divergence, checks and invariant measures."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..arguments import Parameters
from ..flow.linearisation.tangent_space import orthonormal
from ..formulas.array_formulas import Formulas
from ..system.arrays import FloatArray
from ..system.laws import Measure, of_kind
from ..system.system import System
from .averages import Average, average
from .zero_exponents import TrivialDirections, vanishes_to_rounding

#: Number of Gauss points per interval for the mean of the divergence.
NODES = 16
#: Number of intervals processed together; it bounds memory use.
PIECE = 512


@dataclass(frozen=True)
class MotionRecord:
    """The record of a motion, interval by interval."""

    interval: float
    nodes: FloatArray
    states: FloatArray
    lengths: FloatArray
    sizes: FloatArray


@dataclass(frozen=True)
class Volume:
    """The growth of phase-space volumes along a motion, with its checks.

    Attributes
    ----------
    divergence : Average
        The mean of the divergence on the phase space, from exact derivatives by Gauss quadrature.
    balance : float
        Sum of all exponents, including trivial ones and boundary terms, minus the mean divergence:
        an error of the computation.
    measures : dict of str to float
        For each invariant measure of the system, the difference between the change of its density
        along the motion and the mean divergence.
    """

    divergence: Average
    balance: float
    measures: dict[str, float]


def divergence_average(
    system: System,
    directions: TrivialDirections,
    run: MotionRecord,
    transient: int,
    parameters: Parameters,
) -> Volume:
    """The mean divergence along the motion, and the quantities that must agree with it."""
    relations = system.scalar.relations
    _, weights = np.polynomial.legendre.leggauss(NODES)
    nodes = run.nodes[transient:]
    growth = np.empty(len(nodes))
    for first in range(0, len(nodes), PIECE):
        some = nodes[first : first + PIECE]
        rates = directions.space.divergence(
            some.reshape(-1, some.shape[-1]), parameters, relations, directions.sizes
        )
        growth[first : first + PIECE] = rates.reshape(some.shape[:2]) @ weights
    # Gauss weights on [−1, 1] are scaled to the length of the interval.
    growth *= run.interval / 2
    span = len(growth) * run.interval
    # Of the removed directions, all but the relations belong to volumes on the phase space.
    inside = [item.kind != "relation" for item in directions.trivial]
    change = float((run.sizes[-1] - run.sizes[transient])[inside].sum())
    # Liouville's formula: the logarithm of the volume of all deviations grows by ∫ div v dt. The
    # lengths of the genuine deviations and the changes of the removed ones add up to it.
    balance = float(run.lengths[transient:].sum() + change - growth.sum()) / span
    ends = run.states[[transient, -1]]
    measures = {
        name: float(growth.sum() - change) / span
        for name, change in _densities(system, ends, directions.sizes, parameters)
    }
    return Volume(average(growth, run.interval, transient * run.interval), balance, measures)


def _densities(
    system: System, ends: FloatArray, sizes: FloatArray, parameters: Parameters
) -> Iterator[tuple[str, float]]:
    """For each invariant measure, its prediction for the growth of volumes between two states."""
    moving = set(system.symbols) | {symbol for symbol, _ in system.scalar_definitions}
    relations = system.scalar.relations
    gradients = Formulas(system, relations).slopes(ends, parameters) * sizes
    _, lengths = orthonormal(gradients)
    for law in of_kind(system.scalar.laws, Measure):
        if any(condition.free_symbols & moving for condition in law.level):
            continue
        if not vanishes_to_rounding(system, law.level, ends[0], parameters, sizes):
            continue
        density = Formulas(system, [law.value])(ends, parameters)[:, 0]
        # ρ dV is invariant, so that volumes on the surface grow like |grad|/ρ, where |grad| is the
        # product of the Gram–Schmidt lengths of the gradients of the relations.
        logarithm = np.log(lengths).sum(axis=1) - np.log(np.abs(density))
        yield law.name, float(logarithm[1] - logarithm[0])
