"""Contact modes in figures: times, colours, names, and the events between them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import xarray as xr
from matplotlib.colors import to_rgba
from matplotlib.patches import Patch

from flowlanes.system.arrays import FloatArray

from ...experiment.contact.mode_intervals import event_times, mode_intervals, sample_modes
from .dataset_access import times_of
from .style import INK


@dataclass(frozen=True)
class ModeStyle:
    """The drawing style of a contact mode.

    Attributes
    ----------
    colour : str
        Colour; colours of different kinds of motion also differ in brightness, for print in grey.
    hatch : str
        Pattern of areas; modes in which the spin is held have stripes.
    dashes : tuple
        Dash pattern of lines, in matplotlib's form.
    width : float
        Width of lines.
    """

    colour: str
    hatch: str = ""
    dashes: tuple[float, tuple[float, ...]] = (0.0, ())
    width: float = 1.3


_DASHES = (0.0, (3.0, 1.5))

# Paul Tol's muted colours, without those used for vector components.
MODE_STYLES = {
    "flight": ModeStyle("#88ccee", dashes=(0.0, (1.6, 1.0)), width=1.7),
    "sliding": ModeStyle("#aa4499"),
    "sliding without spin": ModeStyle("#aa4499", "/////", _DASHES),
    "rolling": ModeStyle("#44aa99"),
    "rolling without spin": ModeStyle("#44aa99", "/////", _DASHES),
    "rest": ModeStyle(INK),
    "sliding without rolling": ModeStyle("#882255"),
    "sliding without turning": ModeStyle("#882255", "/////", _DASHES),
    "spinning": ModeStyle("#999933", ".....", (0.0, (4.0, 1.2, 1.0, 1.2))),
}


def event_kinds(dataset: xr.Dataset) -> list[str]:
    """Descriptions of the events."""
    return [str(kind) for kind in dataset["event_kind"].values]


def present_modes(dataset: xr.Dataset) -> list[str]:
    """The modes that occur, in the order of their styles."""
    occurring = {interval.mode for interval in mode_intervals(dataset)}
    return [mode for mode in MODE_STYLES if mode in occurring]


def changes_mode(dataset: xr.Dataset) -> bool:
    """Whether the trajectory has contact modes, and more than one."""
    return "mode" in dataset and len(present_modes(dataset)) > 1


def mode_key(modes: list[str]) -> list[Patch]:
    """Labelled patches of the modes for a legend."""
    return [mode_patch(mode) for mode in modes]


def mode_patch(mode: str) -> Patch:
    """A labelled area in the colour and pattern of a mode."""
    style = MODE_STYLES[mode]
    return Patch(
        facecolor=style.colour,
        edgecolor="#ffffff",
        hatch=style.hatch,
        linewidth=0.0,
        label=mode,
    )


def mode_runs(dataset: xr.Dataset) -> Iterator[tuple[str, slice]]:
    """Consecutive samples without an event between them, with their mode."""
    modes, events = sample_modes(dataset), event_times(dataset)
    passed = np.searchsorted(events, times_of(dataset), side="right")
    changes = [
        i for i in range(1, len(modes)) if modes[i] != modes[i - 1] or passed[i] != passed[i - 1]
    ]
    for begin, end in zip([0, *changes], [*changes, len(modes)], strict=True):
        yield modes[begin], slice(begin, end)


class ModeColours:
    """The colours of a path along which the mode changes, as a function of time.

    Parameters
    ----------
    dataset : xarray.Dataset
        A dataset with `mode` and the events.
    since, until : float
        The times of the fractions 0 and 1.
    """

    def __init__(self, dataset: xr.Dataset, since: float, until: float) -> None:
        intervals = mode_intervals(dataset)
        span = (until - since) or 1.0
        self._starts = np.array([(i.begin - since) / span for i in intervals[1:]])
        self._colours = np.array([to_rgba(MODE_STYLES[i.mode].colour) for i in intervals])

    def __call__(self, shares: float | list[float]) -> FloatArray:
        """The colour (4,) at a fraction of the time, or colours (n, 4) at several."""
        place = np.searchsorted(self._starts, np.asarray(shares), side="right")
        return np.asarray(self._colours[place])

    def pieces(self, shares: FloatArray) -> FloatArray:
        """The first and last points of stretches with one colour, for points at these fractions."""
        place = np.searchsorted(self._starts, shares, side="right")
        changes = np.flatnonzero(np.diff(place))
        return np.unique(np.concatenate([[0], changes, changes + 1, [len(shares) - 1]])).astype(int)
