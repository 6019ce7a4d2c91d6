"""The drift of the first integrals over time."""

from __future__ import annotations

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError, nearest
from flowlanes.system.arrays import FloatArray

from ..drawing.dataset_access import NOTHING, readable, times_of, title_of, values_of
from ..drawing.style import QUIET, SERIES, STYLE
from .time_axis import legend_above, marker, time_chart

_DOTS = 400
"""Approximate number of dots of a drift."""


@arguments_checked
def drift(dataset: xr.Dataset) -> Figure:
    """Relative drift of each integral over time, on a logarithmic scale.

    Dots are samples (some hundreds of them), lines the largest drift so far. Samples that agree
    with the first one to the last bit lie on the line marked 0 at the foot.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs at least one variable `law_<name>`.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset has nothing that is conserved.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> figure = report.figures.drift(dataset)
    >>> [axes.get_xlabel() for axes in figure.axes]
    ['time  $t$  (s)']
    """
    names = conserved_variables(dataset)
    if not names:
        raise InputError(
            f"the figure drift needs an integral, and the trajectory of {title_of(dataset)} has "
            "none"
        )
    times = times_of(dataset)
    drifts = {name: relative_drift(dataset, name) for name in names}
    positive = np.concatenate(
        [values[(values > 0.0) & np.isfinite(values)] for values in drifts.values()]
    )
    smallest = float(positive.min()) if len(positive) else 1e-16
    floor = 1e-17 if smallest > 1e-17 else 10.0 ** (np.floor(np.log10(smallest)) - 1.0)
    with mpl.rc_context(STYLE):
        labels = {name: _law_label(dataset, name) for name in names}
        columns = 2 if max(map(len, labels.values())) < 50 else 1
        rows = -(-len(names) // columns)
        figure, axes = time_chart(dataset, 2.7 + 0.19 * rows, "Drift of the first integrals")
        axes.set_yscale("log")
        every = max(1, len(times) // _DOTS)
        for number, (name, values) in enumerate(drifts.items()):
            colour = SERIES[number % len(SERIES)]
            # a gap where there is no value
            shown = np.where(np.isfinite(values), np.fmax(values, floor), np.nan)
            axes.plot(
                times[::every],
                shown[::every],
                ".",
                color=colour,
                markersize=2.2,
                alpha=0.5,
                markeredgewidth=0.0,
                zorder=2,
            )
            axes.plot(
                times,
                np.where(np.isnan(shown), np.nan, np.fmax.accumulate(shown)),
                color=colour,
                label=labels[name],
                linewidth=1.3,
                linestyle="-" if number < len(SERIES) else (0, (4, 1.5)),
                marker=marker(times),
                zorder=3,
            )
        largest = float(positive.max()) if len(positive) else floor
        axes.set_ylim(floor / 2.5, max(10.0 * largest, 100.0 * floor))
        axes.axhline(floor, color=QUIET, linewidth=0.6, zorder=1)
        _mark_floor(axes, floor)
        axes.set_ylabel("relative drift")
        legend_above(axes, columns)
    return figure


@arguments_checked
def relative_drift(dataset: xr.Dataset, name: str) -> FloatArray:
    """The change of a conserved quantity relative to its first value.

    A quantity that starts at zero up to rounding has no scale; its absolute drift is given.
    Trajectories of 34 digits are evaluated with all of them.

    Parameters
    ----------
    dataset : xarray.Dataset
    name : str
        Variable with the values of the quantity, and `<name>_low` with their low parts, if any.

    Returns
    -------
    (n,) array
        |F(t) - F(0)| / |F(0)|, or |F(t) - F(0)|.

    Raises
    ------
    InputError
        If the dataset has no such variable.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> float(abs(report.figures.relative_drift(dataset, "energy")).max()) < 1e-12
    True
    """
    if name not in dataset:
        raise InputError(f"the dataset has no variable {name!r}{nearest(name, map(str, dataset))}")
    values = values_of(dataset, name)
    scale = 1.0 if _starts_at_zero(values) else abs(float(values[0]))
    # Values recorded as infinite have no drift.
    with np.errstate(over="ignore", invalid="ignore"):
        change = values - values[0]
        if f"{name}_low" in dataset:
            low = values_of(dataset, f"{name}_low")
            change = change + (low - low[0])
        return np.asarray(np.abs(change) / scale, dtype=np.float64)


def _starts_at_zero(values: FloatArray) -> bool:
    """Whether the first value is zero up to rounding.

    A small absolute value is not enough: the squared momentum of a coin is 1e-10 in SI units.
    """
    first = abs(float(values[0]))
    change = np.max(np.abs(values - values[0]), initial=0.0, where=np.isfinite(values))
    return first == 0.0 or bool(first < NOTHING and change > 1e-6 * first)


def conserved_variables(dataset: xr.Dataset) -> list[str]:
    """Variables that should stay constant, the energy first.

    A recorded energy that is not an integral is not included.
    """
    laws = sorted(
        str(name)
        for name in dataset.data_vars
        if str(name).startswith("law_") and not str(name).endswith("_low")
    )
    return sorted(laws, key=lambda name: name != "law_energy")


def drifts(dataset: xr.Dataset) -> bool:
    """Whether any quantity that should stay constant changes by at least one bit."""
    return any(
        bool(np.any(relative_drift(dataset, name) > 0.0)) for name in conserved_variables(dataset)
    )


def _law_label(dataset: xr.Dataset, name: str) -> str:
    meaning = str(dataset[name].attrs.get("long_name", "")) or name.removeprefix("law_")
    absolute = _starts_at_zero(values_of(dataset, name))
    return readable(meaning) + ("  (absolute)" if absolute else "")


def _mark_floor(axes: Axes, floor: float) -> None:
    """Ticks at powers of ten above the floor, and a tick 0 at the floor."""
    low, high = np.log10(floor), np.log10(axes.get_ylim()[1])
    step = max(1, int(np.ceil((high - low) / 7)))
    powers = np.arange(np.ceil(low) + step, high + 1e-9, step)
    axes.set_yticks([floor, *10.0**powers], ["0", *(f"$10^{{{int(power)}}}$" for power in powers)])
    axes.set_yticks([], minor=True)
