"""The intervals between mode changes of a motion with friction, from its dataset."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import xarray as xr

from flowlanes.system.arrays import FloatArray


@dataclass(frozen=True)
class ModeInterval:
    """A time interval in which the mode does not change."""

    mode: str
    begin: float
    end: float


def mode_names(dataset: xr.Dataset) -> list[str]:
    """The mode names by their flag values."""
    return [word.replace("_", " ") for word in str(dataset["mode"].attrs["flag_meanings"]).split()]


def sample_modes(dataset: xr.Dataset) -> list[str]:
    """Contact mode at each sample of a dataset."""
    names = mode_names(dataset)
    return [names[flag] for flag in dataset["mode"].values]


def event_times(dataset: xr.Dataset) -> FloatArray:
    """Times of the events, (m,)."""
    return np.asarray(dataset["event_time"].values, dtype=np.float64)


def mode_intervals(dataset: xr.Dataset) -> list[ModeInterval]:
    """The intervals between mode changes, from the first sample to the last.

    Their ends are the times of the events, not those of samples.
    """
    times, events = np.asarray(dataset["time"].values, dtype=np.float64), event_times(dataset)
    names, flags = mode_names(dataset), dataset["event_mode"].values
    before = np.flatnonzero(times < events[0]) if len(events) else np.arange(len(times))
    first = [sample_modes(dataset)[0]] if len(before) else []
    modes = [*first, *(names[flag] for flag in flags)]
    ends = [*([float(times[0])] if first else []), *events, float(times[-1])]
    intervals: list[ModeInterval] = []
    for mode, begin, end in zip(modes, ends[:-1], ends[1:], strict=True):
        if end <= begin:
            continue
        if intervals and intervals[-1].mode == mode:
            intervals[-1] = ModeInterval(mode, intervals[-1].begin, end)
        else:
            intervals.append(ModeInterval(mode, begin, end))
    return intervals
