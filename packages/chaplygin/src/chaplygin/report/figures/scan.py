"""A number over a plane of parameters or starts, as an image."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import TypeAlias

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.colorbar import Colorbar
from matplotlib.colors import ListedColormap, LogNorm, Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ..drawing.dataset_access import readable, title_of, typeset, unit_of, with_unit, wrapped_text
from ..drawing.style import INK, QUIET, STYLE, WIDTH

#: Edges of the axes: left, right, bottom, top.
Extent: TypeAlias = tuple[float, float, float, float]

#: Perceptually uniform, and readable with any colour vision.
COLOURS = "viridis"
#: Fraction of the values beyond each end of the colour scale.
BEYOND = 0.005
#: The value that separates two kinds of motion, and its meaning, by the name of the number.
MARKS = {
    "megno": (2.0, "regular"),
    "lyapunov": (0.0, "regular"),
    "sum": (0.0, "volume kept"),
}
#: Values that span more decades than this are coloured by their logarithms.
DECADES = 3.0
#: Colours of cells without a number, one per reason; none occurs in the colour scale.
EMPTY = ("#dde1e6", "#efc3ca", "#bfc6ce", "#f7e3e6")


def chart(dataset: xr.Dataset, name: str | None = None) -> Figure:
    """Draw a chart as an image; cells without a number are pale.

    Parameters
    ----------
    dataset : xarray.Dataset
        A dataset of :func:`flowlanes.scans.scan_task.scan`.
    name : str, optional
        The variable to be drawn; by default the number of the chart.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If there is no such variable, or the dataset is no chart.
    """
    wanted = str(dataset.attrs.get("number", "")) if name is None else name
    if wanted not in dataset or dataset[wanted].ndim != 2 or "outcome" not in dataset:
        raise InputError(f"the chart of {title_of(dataset)} has no number {wanted!r} to be drawn")
    number, outcome = dataset[wanted], dataset["outcome"]
    y, x = (str(dimension) for dimension in number.dims)
    values = np.asarray(number.values, dtype=np.float64)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 4.6), layout="constrained")
        figure.set_label(f"{number.attrs.get('long_name', wanted)}: {title_of(dataset)}")
        axes = figure.add_subplot()
        title = readable(title_of(dataset))
        extent = (*_edges(dataset[x].values), *_edges(dataset[y].values))
        if np.isfinite(values).any():
            _draw_numbers(figure, axes, number, values, extent)
        else:
            title = f"{title}: {_title(number)}"
        axes.set_title(title, fontsize=10.5, loc="left", color=INK)
        patches = list(_draw_reasons(axes, outcome, values, extent))
        axes.set_xlabel(_label(dataset, x))
        axes.set_ylabel(_label(dataset, y))
        axes.spines[["top", "right"]].set_visible(True)
        if patches:
            figure.legend(handles=patches, loc="outside lower left", ncols=1)
    return figure


def _edges(places: FloatArray) -> tuple[float, float]:
    """The edges of a row of cells around equidistant points."""
    first, last = float(places[0]), float(places[-1])
    half = (last - first) / (2 * (len(places) - 1)) if len(places) > 1 else 0.5
    return first - half, last + half


def _draw_numbers(
    figure: Figure, axes: Axes, number: xr.DataArray, values: FloatArray, extent: Extent
) -> None:
    mark = MARKS.get(str(number.name))
    norm, beyond = _norm(values, None if mark is None else mark[0])
    image = axes.imshow(
        np.ma.masked_invalid(values),
        origin="lower",
        extent=extent,
        aspect="auto",
        interpolation="nearest",
        cmap=COLOURS,
        norm=norm,
    )
    bar = figure.colorbar(image, ax=axes, extend=beyond, pad=0.02)
    bar.outline.set_linewidth(0.6)
    if mark is not None:
        _mark(bar, *mark)
    bar.set_label(with_unit(_title(number), unit_of(number.to_dataset(name="value"), "value")))


def _mark(bar: Colorbar, value: float, meaning: str) -> None:
    """A line across the colour bar at a value, labelled with its meaning."""
    bar.ax.axhline(value, color="white", linewidth=2.4)
    bar.ax.axhline(value, color=INK, linewidth=1.2)
    low, high = bar.ax.get_ylim()
    ticks = [tick for tick in bar.get_ticks() if low <= tick <= high]
    # Ticks whose numbers would overlap this one are removed.
    near = 0.05 * (high - low)
    ticks = [tick for tick in ticks if abs(tick - value) > near]
    shown = [f"{tick:g}".replace("-", "\N{MINUS SIGN}") for tick in ticks]
    bar.set_ticks([*ticks, value], labels=[*shown, f"{value:g} {meaning}"])


def _title(number: xr.DataArray) -> str:
    """The meaning of the numbers."""
    return wrapped_text(str(number.attrs.get("long_name", number.name)))


def _norm(values: FloatArray, mark: float | None) -> tuple[Normalize, str]:
    """The scale of the colours, and the ends beyond which there are numbers."""
    finite = values[np.isfinite(values)]
    low, high = np.quantile(finite, [BEYOND, 1 - BEYOND])
    if low == high:
        low, high = float(finite.min()), float(finite.max())
    if mark is not None:
        low, high = min(low, mark), max(high, mark)
    if low == high:
        return Normalize(low - 0.5, high + 0.5), "neither"
    ends = (bool(finite.min() < low), bool(finite.max() > high))
    beyond = {(True, True): "both", (True, False): "min", (False, True): "max"}.get(ends, "neither")
    if low > 0 and np.log10(high / low) > DECADES:
        return LogNorm(low, high), beyond
    return Normalize(low, high), beyond


def _draw_reasons(
    axes: Axes, outcome: xr.DataArray, values: FloatArray, extent: Extent
) -> Iterator[Patch]:
    """Fill cells without a number; return legend entries with the reasons."""
    words = str(outcome.attrs["flag_meanings"]).split()
    flags = np.atleast_1d(outcome.attrs["flag_values"])
    meanings = {int(f): w.replace("_", " ") for f, w in zip(flags, words, strict=True)}
    empty = ~np.isfinite(values)
    codes = np.asarray(outcome.values)
    for code, colour in zip(np.unique(codes[empty]), itertools.cycle(EMPTY), strict=False):
        cells = empty & (codes == code)
        axes.imshow(
            np.ma.masked_where(~cells, np.zeros(cells.shape)),
            origin="lower",
            extent=extent,
            aspect="auto",
            interpolation="nearest",
            cmap=ListedColormap([colour]),
        )
        share = f"{np.count_nonzero(cells)} of {cells.size} cells"
        label = readable(f"{meanings[int(code)]} ({share})")
        yield Patch(facecolor=colour, edgecolor=QUIET, linewidth=0.5, label=label)


def _label(dataset: xr.Dataset, name: str) -> str:
    """Name, meaning and unit of an axis."""
    meaning = str(dataset[name].attrs.get("long_name", name))
    letters = typeset(name)
    shown = wrapped_text(meaning) if meaning != name else letters
    text = f"{shown}  {letters}" if letters.startswith("$") and shown != letters else shown
    return with_unit(text, unit_of(dataset, name))
