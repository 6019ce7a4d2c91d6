"""Results for many motions: states at given times, or crossings of a section."""

from __future__ import annotations

from dataclasses import dataclass

from ..system.arrays import FloatArray, IntArray
from ..system.overview import WithShortRepr


@dataclass(frozen=True, repr=False)
class BatchTrajectories(WithShortRepr):
    """Motions at given times.

    Attributes
    ----------
    states : array (motions, times, size)
        In flat order; NaN after the end of a motion.
    deviations : array (motions, times, deviations, size) or None
    outcome : array (motions,) of int
        0 if the last time was reached; see ``BatchIntegrator.status_message`` for other codes.
    end_times : array (motions,)
        Last time reached.
    steps : array (motions,) of int
        Number of attempted steps.
    rest : array (motions, times, size) or None
        With 30 digits: the next 16 digits of the states, to be added to them.
    """

    states: FloatArray
    deviations: FloatArray | None
    outcome: IntArray
    end_times: FloatArray
    steps: IntArray
    rest: FloatArray | None = None


@dataclass(frozen=True, repr=False)
class BatchCrossings(WithShortRepr):
    """Motions at their crossings of a section.

    Attributes
    ----------
    states : array (motions, count, size)
        NaN after the last crossing of each motion.
    times : array (motions, count)
    deviations : array (motions, count, deviations, size) or None
        At the time of crossing, without projection along the flow.
    counts : array (motions,) of int
        Number of crossings for each motion.
    outcome, ended, steps, rest
        As in `BatchTrajectories`; the outcome is 0 if there are `count` crossings.
    """

    states: FloatArray
    times: FloatArray
    deviations: FloatArray | None
    counts: IntArray
    outcome: IntArray
    end_times: FloatArray
    steps: IntArray
    rest: FloatArray | None = None
