"""Input and output arrays of one call of the integration loop."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from ...system.arrays import FloatArray, IntArray


@dataclass(frozen=True)
class BatchInput:
    """Input of a call.

    Attributes
    ----------
    starts : array (motions, numbers, words)
        States and deviations, in doubles.
    parameters : array (motions or 1, parameters, words)
        One row for each motion, or one for all.
    times : array (samples or 1,)
        Times of the samples; for a section the time after which a motion ends.
    samples : int
        Number of samples for each motion.
    tolerance : float
    limit : int
        Maximum number of steps of a motion.
    sample_width : int
        Number of values in a sample.
    """

    starts: FloatArray
    parameters: FloatArray
    times: FloatArray
    samples: int
    tolerance: float
    limit: int
    sample_width: int

    @property
    def motions(self) -> int:
        """Number of motions."""
        return len(self.starts)

    @property
    def stride(self) -> int:
        """Number of doubles between the parameters of one motion and those of the next."""
        return self.parameters[0].size if len(self.parameters) > 1 else 0


@dataclass(frozen=True)
class BatchOutput:
    """Output of a call.

    Attributes
    ----------
    states : array (motions, samples, numbers, words)
        NaN after the end of a motion.
    times : array (motions, samples)
        Times of crossings.
    counts : array (motions,) of int
        Number of samples of each motion.
    outcome : array (motions,) of int
    end_times : array (motions,)
        Last time reached.
    steps : array (motions,) of int
    """

    states: FloatArray
    times: FloatArray
    counts: IntArray
    outcome: IntArray
    end_times: FloatArray
    steps: IntArray

    @property
    def arrays(self) -> tuple[FloatArray | IntArray, ...]:
        """All arrays, in the order of the loop's arguments."""
        return self.states, self.times, self.counts, self.outcome, self.end_times, self.steps

    def clear(self, first: int, last: int) -> None:
        """Set the results of some motions to NaN and zero."""
        for array in self.arrays:
            array[first:last] = np.nan if array.dtype.kind == "f" else 0


def empty_output(task: BatchInput) -> BatchOutput:
    """Uninitialized memory for the results of a call."""
    motions, _, words = task.starts.shape
    counts, outcome, steps = (np.empty(motions, dtype=np.int64) for _ in range(3))
    return BatchOutput(
        np.empty((motions, task.samples, task.sample_width, words)),
        np.empty((motions, task.samples)),
        counts,
        outcome,
        np.empty(motions),
        steps,
    )


class BatchLoop(Protocol):
    """Compiled loop over motions on a device."""

    def run(self, task: BatchInput, threads: int | None) -> BatchOutput:
        """Integrate the motions, using `threads` processor threads (all if None)."""
        ...
