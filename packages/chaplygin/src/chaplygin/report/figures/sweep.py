"""A quantity along the motions of a sweep, one curve for each parameter value."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from flowlanes.system.arrays import FloatArray

from ..drawing.dataset_access import title_of, typeset, unit_of, with_unit
from ..drawing.style import FAINT, SERIES, STYLE, WIDTH
from .time_axis import time_label

#: Maximum number of motions with their own colour and legend entry.
FEW = 6
#: Maximum number of curves; if there are more, evenly chosen ones are drawn.
MOST = 200
#: Yellow is omitted, as too pale on white.
COLOURS = mpl.colormaps["viridis"]
PALEST = 0.92
#: Largest fraction of samples at which a curve may turn: ten samples per oscillation.
TURNS = 0.2


def sweep(dataset: xr.Dataset, parameters: Sequence[str], quantity: str) -> Figure:
    """A quantity over time for every motion of a sweep; sparse samples stay points.

    Parameters
    ----------
    dataset : xarray.Dataset
        A dataset with dimensions ``run`` and ``time``.
    parameters : sequence of str
        The varied parameters; colours show the first.
    quantity : str
        A scalar, or a component such as ``M_1``.

    Returns
    -------
    matplotlib.figure.Figure
    """
    name, values = _curves(dataset, quantity)
    times = np.asarray(dataset["time"].values, dtype=float)
    shades = np.asarray(dataset[parameters[0]].values, dtype=float)
    joined = are_close_enough(values)
    chosen = np.unique(np.linspace(0, len(values) - 1, min(len(values), MOST)).round().astype(int))
    few = len(values) <= FEW
    scale = Normalize(float(shades.min()), float(shades.max()))
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 3.6), layout="constrained")
        figure.set_label(f"{quantity} for each value of {', '.join(parameters)}")
        axes = figure.add_subplot(title=title_of(dataset))
        for number in chosen:
            text = ", ".join(
                f"{typeset(p)} = {float(dataset[p].values[number]):g}" for p in parameters
            )
            colour = (
                SERIES[number % len(SERIES)] if few else COLOURS(PALEST * scale(shades[number]))
            )
            axes.plot(
                times,
                values[number],
                color=colour,
                label=text if few else None,
                linestyle="-" if joined else "",
                marker="" if joined else ".",
                markersize=4,
            )
        axes.grid(axis="y", color=FAINT, linewidth=0.4)
        axes.set_axisbelow(True)
        axes.set_xlabel(time_label(dataset))
        axes.set_ylabel(with_unit(typeset(quantity), unit_of(dataset, name)))
        axes.margins(x=0)
        if few:
            figure.legend(loc="outside lower center", ncols=3)
        else:
            shown = mpl.colors.ListedColormap(COLOURS(np.linspace(0, PALEST, 256)))
            label = with_unit(typeset(parameters[0]), unit_of(dataset, parameters[0]))
            figure.colorbar(ScalarMappable(scale, shown), ax=axes, label=label, pad=0.02)
    return figure


def are_close_enough(values: FloatArray) -> bool:
    """Whether lines between samples (motions, times) represent the motions, and not a zigzag."""
    steps = np.diff(values, axis=1)
    turns = (steps[:, 1:] * steps[:, :-1] < 0).mean(axis=1) if values.shape[1] > 2 else np.zeros(1)
    return bool((turns <= TURNS).all())


def _curves(dataset: xr.Dataset, quantity: str) -> tuple[str, FloatArray]:
    """The variable that a quantity belongs to, and its values (motions, times)."""
    for name in (quantity, f"law_{quantity}"):
        if name in dataset:
            return name, np.asarray(dataset[name].values, dtype=float)
    name, _, index = quantity.rpartition("_")
    axis = next(str(d) for d in dataset[name].dims if d not in ("run", "time"))
    labels = dataset[axis].values if axis in dataset.coords else range(1, dataset.sizes[axis] + 1)
    place = list(map(str, labels)).index(index)
    return name, np.asarray(dataset[name].isel({axis: place}).values, dtype=float)
