"""A planted observable: how often a formula changes its sign along a motion."""

from __future__ import annotations

import numpy as np

from flowlanes.flow.motion_observable import MotionObservable, Observation
from flowlanes.scans.observables import ObservedSeries, sampled
from flowlanes.system.arrays import FloatArray


def _changes(observation: Observation, run: ObservedSeries) -> dict[str, FloatArray]:
    signs = np.sign(run.values)
    return {"value": (signs[:, 1:] * signs[:, :-1] < 0).sum(axis=1).astype(float)}


crossings = MotionObservable(
    "crossings", "changes of sign of {}", sampled, _changes, of_formula=True, samples=1024
)
