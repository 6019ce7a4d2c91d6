"""The points of a section in a plane, or in space with its projections."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import combinations
from typing import Any

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize, to_rgba_array
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray, IntArray

from ..drawing.dataset_access import readable, title_of, typeset, unit_of, with_unit
from ..drawing.style import FAINT, QUIET, SERIES, STYLE, WIDTH

#: Maximum number of drawn points, unless there are more motions than that.
MOST = 120_000
#: Colours of starts, which have no order.
KINDS = (*SERIES, "#882255", "#e07b39", "#4477aa", "#5c5c5c")
#: Colours of the return number, without yellow, which is too pale on white.
COLOURS = mpl.colormaps["viridis"].with_extremes(bad=FAINT)
PALEST = 0.92
#: Number of layers into which a single motion is drawn.
LAYERS = 40
#: Elevation and azimuth of the view in degrees: the vertical axes are on the outside.
VIEWS = ((22.0, 32.0), (22.0, -58.0))
#: A word in a formula.
_NAME = re.compile(r"[A-Za-z]+(_\w+)?")


def draw_section(dataset: xr.Dataset, names: Sequence[str]) -> Figure:
    """The points of a section by two or three of its coordinates.

    The points of several motions are coloured by start, with a dozen colours in turn; those of a
    single motion go from dark to light with the return number.

    Parameters
    ----------
    dataset : xarray.Dataset
        A dataset with dimensions ``run`` and ``section_point``.
    names : sequence of str
        Two or three variables with just these dimensions; a component of a vector is written as
        ``M_1``.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If there are not two or three names, or the dataset lacks one of them, or has no point.
    """
    if len(names) not in (2, 3):
        raise InputError(f"a section is drawn by two or three coordinates, not {len(names)}")
    runs, count = dataset.sizes["run"], dataset.sizes["section_point"]
    numbers = _drawn_returns(runs, count)
    columns = [_column(dataset.isel(section_point=numbers), name) for name in names]
    run, place = np.nonzero(np.isfinite(np.stack(columns)).all(axis=0))
    if not run.size:
        raise InputError(f"the section of {title_of(dataset)} has no point to draw")
    points = [column[run, place] for column in columns]
    number = numbers[place]
    if runs == 1:
        colours = COLOURS(number / max(count - 1, 1) * PALEST)
    else:
        colours = to_rgba_array(KINDS)[run % len(KINDS)]
    # Starts alternate, so that none completely covers another.
    order = np.argsort(number, kind="stable")
    points, colours = [p[order] for p in points], colours[order]
    labels = [_label(dataset, name) for name in names]
    look = {"c": colours, "s": _size(len(run)), "linewidths": 0.0}
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 4.6 if len(names) == 2 else 6.1))
        figure.set_label(f"Section: {title_of(dataset)}")
        if len(names) == 2:
            axes = figure.add_axes((0.125, 0.12, 0.74, 0.8))
            _plane(axes, points, labels, look)
        else:
            # Later points of one motion are drawn on top, so that its end is visible.
            layers = np.array_split(np.arange(len(run)), LAYERS if runs == 1 else 1)
            _space(figure, points, labels, look, layers)
        _key(figure, runs, count)
        drawn = "" if len(numbers) == count else f"; {len(run):,} drawn"
        where = _NAME.sub(lambda name: typeset(name[0]), str(dataset.attrs.get("section", "")))
        title = f"{readable(title_of(dataset))}: {where}".removesuffix(": ")
        figure.text(0.02, 0.975, title, va="top", fontsize=10)
        there = int(np.minimum(dataset["points"].values, count).sum())
        words = f"{there:,} points{drawn}"
        figure.text(0.98, 0.975, words, ha="right", va="top", color=QUIET)
    return figure


def _drawn_returns(runs: int, count: int) -> IntArray:
    """Return numbers to draw, a random selection if there are too many."""
    drawn = max(1, min(count, MOST // runs))
    if drawn == count:
        return np.arange(count)
    return np.sort(np.random.default_rng(0).choice(count, drawn, replace=False))


def _column(dataset: xr.Dataset, name: str) -> FloatArray:
    """A coordinate of all points, (runs, points)."""
    if name in dataset and dataset[name].ndim == 2:
        variable = dataset[name]
    else:
        vector, _, index = name.rpartition("_")
        if vector not in dataset or dataset[vector].ndim != 3 or not index.isdecimal():
            raise InputError(f"the section of {title_of(dataset)} has no coordinate {name}")
        (dim,) = set(map(str, dataset[vector].dims)) - {"run", "section_point"}
        place = int(index) - 1
        if not 0 <= place < dataset.sizes[dim]:
            raise InputError(f"the section of {title_of(dataset)} has no coordinate {name}")
        variable = dataset[vector].isel({dim: place})
    return np.asarray(variable.transpose("run", "section_point").values, dtype=np.float64)


def _label(dataset: xr.Dataset, name: str) -> str:
    vector, _, index = name.rpartition("_")
    if name in dataset:
        shown, units = str(dataset[name].attrs.get("label", name)), unit_of(dataset, name)
    else:
        shown, units = f"{vector}_{index}", unit_of(dataset, vector)
    return with_unit(typeset(shown), units)


def _size(count: int) -> float:
    """Area of a dot in square points: many are small."""
    return float(np.clip(2e4 / count, 0.25, 5.0))


def _plane(
    axes: Axes, points: Sequence[FloatArray], labels: Sequence[str], look: dict[str, Any]
) -> None:
    axes.scatter(*points, rasterized=True, **look)
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])
    for axis, values, label in zip((axes.xaxis, axes.yaxis), points, labels, strict=True):
        if "(rad)" in label and np.ptp(values) > np.pi:
            low = -np.pi if values.min() < 0.0 else 0.0
            if low <= values.min() and values.max() <= low + 2 * np.pi:
                names = ("$-π$", "$-π/2$", "0", "$π/2$", "$π$", "$3π/2$", "$2π$")
                first = 0 if low else 2
                axis.set_ticks(low + np.arange(5) * np.pi / 2, names[first : first + 5])


def _space(
    figure: Figure,
    points: Sequence[FloatArray],
    labels: Sequence[str],
    look: dict[str, Any],
    layers: Sequence[IntArray | slice],
) -> None:
    """Two views above three projections; within a layer, near points hide far ones."""
    for i, (height, turn) in enumerate(VIEWS):
        view: Any = figure.add_axes((0.045 + 0.38 * i, 0.4, 0.4, 0.56), projection="3d")
        view.patch.set_visible(False)
        view.computed_zorder = False
        for layer, part in enumerate(layers):
            shown = [values[part] for values in points]
            colours = look | {"c": look["c"][part]}
            view.scatter(*shown, depthshade=False, rasterized=True, zorder=layer, **colours)
        view.view_init(elev=height, azim=turn)
        view.set_box_aspect((1, 1, 1), zoom=1.0)
        for axis, name in zip((view.xaxis, view.yaxis, view.zaxis), labels, strict=True):
            axis.set_label_text(name)
            axis.set_pane_color((1.0, 1.0, 1.0, 0.0))
            axis.set_major_locator(mpl.ticker.MaxNLocator(4))
            axis.line.set_color(QUIET)
            axis._axinfo["grid"].update(color=FAINT, linewidth=0.4)
            axis.labelpad = -4
        view.zaxis.set_rotate_label(False)
        view.zaxis.label.set_rotation(90)
        view.tick_params(pad=-1, labelsize=7)
    small = look | {"s": 0.6 * look["s"]}
    for i, (a, b) in enumerate(combinations(range(3), 2)):
        axes = figure.add_axes((0.09 + 0.305 * i, 0.085, 0.205, 0.27))
        _plane(axes, (points[a], points[b]), (labels[a], labels[b]), small)
        axes.tick_params(labelsize=7)
        axes.locator_params(nbins=4)


def _key(figure: Figure, runs: int, count: int) -> None:
    """Draw the legend of the colours: starts, or the return number."""
    if 1 < runs <= len(KINDS):
        dots = [
            Line2D([], [], linestyle="", marker="o", markersize=4, color=c) for c in KINDS[:runs]
        ]
        figure.legend(
            dots,
            [str(number) for number in range(1, runs + 1)],
            title="start",
            title_fontsize=9,
            loc="upper left",
            bbox_to_anchor=(0.895, 0.9),
            handlelength=0.8,
            fontsize=8,
        )
    elif runs > 1:
        words = f"{runs} starts,\n{len(KINDS)} colours\nby turns"
        figure.text(0.9, 0.89, words, va="top", fontsize=8, color=QUIET)
    elif count > 1:
        colours = mpl.colors.ListedColormap(COLOURS(np.linspace(0.0, PALEST, 256)))
        place = figure.add_axes((0.92, 0.44, 0.014, 0.4))
        bar = figure.colorbar(ScalarMappable(Normalize(1, count), colours), cax=place)
        # Above and not beside the bar, where the tick labels may have any length.
        bar.ax.set_title("number of\nthe return", fontsize=8, color=QUIET)
        bar.ax.tick_params(labelsize=7)
        bar.locator = mpl.ticker.MaxNLocator(5, integer=True)
        bar.update_ticks()
