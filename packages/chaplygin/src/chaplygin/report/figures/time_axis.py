"""Time series: axes, limits and legends."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from flowlanes.system.arrays import FloatArray

from ..drawing.dataset_access import NOTHING, times_of, title_of, unit_of, with_unit
from ..drawing.style import FAINT, WIDTH


def time_label(dataset: xr.Dataset) -> str:
    """The label of a time axis."""
    return with_unit("time  $t$", unit_of(dataset, "time"))


def time_chart(dataset: xr.Dataset, height: float, description: str) -> tuple[Figure, Axes]:
    """A figure with one plot over time."""
    figure, (axes,) = time_charts(dataset, [height], description)
    return figure, axes


def time_charts(
    dataset: xr.Dataset, heights: Sequence[float], description: str
) -> tuple[Figure, list[Axes]]:
    """A figure with plots of given heights in inches over time, stacked vertically."""
    figure = Figure(figsize=(WIDTH, sum(heights)), layout="constrained")
    figure.set_label(f"{description}: {title_of(dataset)}")
    grid = figure.subplots(len(heights), sharex=True, squeeze=False, height_ratios=heights)
    panels = list(grid[:, 0])
    panels[-1].set_xlabel(time_label(dataset))
    times = times_of(dataset)
    for axes in panels:
        if times[-1] > times[0]:
            axes.set_xlim(times[0], times[-1])
        axes.grid(axis="y", color=FAINT, linewidth=0.4)
        axes.set_axisbelow(True)
    return figure, panels


def widen(axes: Axes, values: FloatArray) -> None:
    """Set limits with a margin around the values, even if they are almost equal."""
    finite = values[np.isfinite(values)]
    if not len(finite):
        return
    low, high = float(finite.min()), float(finite.max())
    middle = max(abs(low), abs(high))
    room = max(0.06 * (high - low), 1e-3 * middle)
    if room < NOTHING:
        room = 1.0
    axes.set_ylim(low - room, high + room)


def marker(times: FloatArray) -> str:
    """The marker of a curve: a single sample must be marked, since it is not a line."""
    return "o" if len(times) == 1 else ""


def legend_above(axes: Axes, columns: int) -> None:
    """Put the legend above the plot, on the right."""
    # The common power of ten of the ticks is on the left.
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.02), ncols=columns)
