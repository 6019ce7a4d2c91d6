"""The state of any system over time."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby, pairwise
from typing import NamedTuple

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.printing.formula import latex
from flowlanes.system.arrays import FloatArray
from flowlanes.system.vectors import Vector, real_symbol

from ..drawing.dataset_access import require_all, times_of, title_of, unit_of, values_of, with_unit
from ..drawing.style import COMPONENTS, FAINT, SERIES, STYLE, WIDTH
from .time_axis import marker, time_label, widen

_TALL = 5
"""Maximum number of panels in one column; more are set in two."""

_ROW = 5
"""Maximum number of entries in a row of a legend."""

_PAGE = 8.6
"""Maximum total height of the panels in inches, to fit on a page."""


PAIR = 2
"""Letters of an index that names row and column."""


class Curve(NamedTuple):
    """A component: its index (such as 12), its LaTeX label, and its values."""

    entry: str
    label: str
    values: FloatArray


@arguments_checked
def state(dataset: xr.Dataset, names: Sequence[str]) -> Figure:
    r"""r"Variables of the state over time, one panel each, on at most one page.

    Vectors are drawn by their components; consecutive scalars with the same letter and unit, such
    as k₁₂ and k₁₃, share a panel.  Skew matrices with more entries than there are colours have a
    panel per row.

    Parameters
    ----------
    dataset : xarray.Dataset
    names : sequence of str
        The variables, from top to bottom.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If there are no variables, or the dataset lacks one.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> figure = report.figures.state(dataset, ["M", "gamma"])
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['$\\mathbf{M}$  (kg m$^{2}$/s)', '$\\boldsymbol{\\gamma}$']
    """
    if not names:
        raise InputError("the figure state needs at least one variable")
    require_all(dataset, "state", names)
    groups = [
        (group, curves)
        for _, same in groupby(names, lambda name: _kind(dataset, name))
        for group in [list(same)]
        for curves in _rows_of(dataset, group)
    ]
    times = times_of(dataset)
    with mpl.rc_context(STYLE):
        # Rows of a matrix have wide legends.
        apart = any(one is other for (one, _), (other, _) in pairwise(groups))
        columns = 1 if len(groups) <= _TALL or apart else 2
        rows = -(-len(groups) // columns)
        height = min(1.35, _PAGE / rows)
        figure = Figure(figsize=(WIDTH, 0.5 + height * rows), layout="constrained")
        figure.set_label(f"The state against time: {title_of(dataset)}")
        # down the first column, then down the second
        panels = figure.subplots(rows, columns, squeeze=False).T.ravel()
        for axes, (group, curves) in zip(panels, groups, strict=False):
            _panel(axes, dataset, group, curves)
            if times[-1] > times[0]:
                axes.set_xlim(times[0], times[-1])
            axes.tick_params(labelbottom=False)
        for axes in panels[len(groups) :]:
            axes.set_axis_off()
        for last in (*panels[rows - 1 : len(groups) : rows], panels[len(groups) - 1]):
            last.set_xlabel(time_label(dataset))
            last.tick_params(labelbottom=True)
        figure.align_ylabels(list(panels))
    return figure


def _kind(dataset: xr.Dataset, name: str) -> tuple[str, str]:
    """Letter and unit shared by the scalars of one panel; unique for vectors."""
    if dataset[name].ndim > 1:
        return name, ""
    letter, bar, _ = name.partition("_")
    return f"{letter}{bar}", unit_of(dataset, name)


def _rows_of(dataset: xr.Dataset, group: Sequence[str]) -> list[list[Curve]]:
    """The curves of one panel; if there are too many entries with two indices, a panel per row."""
    curves = [curve for name in group for curve in _curves(dataset, name)]
    if len(curves) <= len(SERIES) or any(len(curve.entry) != PAIR for curve in curves):
        return [curves]
    return [list(row) for _, row in groupby(curves, lambda curve: curve.entry[0])]


def _panel(axes: Axes, dataset: xr.Dataset, group: Sequence[str], curves: Sequence[Curve]) -> None:
    """The curves of one panel, with a legend if there are several."""
    times = times_of(dataset)
    colours = COMPONENTS if len(curves) <= len(COMPONENTS) else SERIES
    for number, (_, label, values) in enumerate(curves):
        colour = colours[number % len(colours)]
        axes.plot(times, values, color=colour, marker=marker(times), label=f"${label}$")
    axes.grid(axis="y", color=FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    axes.set_ylabel(with_unit(f"${_symbol(dataset, group)}$", unit_of(dataset, group[0])))
    widen(axes, np.concatenate([curve.values for curve in curves]))
    if len(curves) > 1 or any(len(curve.entry) == PAIR for curve in curves):
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=min(len(curves), _ROW))


def _curves(dataset: xr.Dataset, name: str) -> list[Curve]:
    """Each component."""
    values = values_of(dataset, name)
    if values.ndim == 1:
        return [Curve("", latex(real_symbol(name)), values)]
    dim = next(str(d) for d in dataset[name].dims if d != "time")
    indices = dataset[dim].values if dim in dataset.coords else range(1, values.shape[1] + 1)
    return [
        Curve(str(index), latex(real_symbol(f"{name}_{index}")), column)
        for index, column in zip(indices, values.T, strict=True)
    ]


def _symbol(dataset: xr.Dataset, group: Sequence[str]) -> str:
    """The axis label: a vector, a scalar, or the common letter of scalars."""
    name = group[0]
    if dataset[name].ndim > 1:
        return latex(Vector(name))
    return latex(real_symbol(name if len(group) == 1 else name.partition("_")[0]))
