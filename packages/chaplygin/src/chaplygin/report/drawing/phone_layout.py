"""Adapt figures to the width of a telephone."""

from __future__ import annotations

import textwrap
import warnings

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.gridspec import GridSpec
from matplotlib.legend import Legend
from matplotlib.text import Text
from matplotlib.ticker import AutoLocator

from .layout import lay_out
from .style import STYLE

NARROW = 3.65
"""Width in inches of a figure on a telephone."""

_LONG = 40
"""Number of characters in a line of a legend that is too long for a telephone."""

_LEAST = 0.85
"""Smallest width of a plot on a telephone, relative to a legend that can be made narrower."""


def make_narrow(figure: Figure) -> None:
    """Adapt a figure to the width of a telephone."""
    wide, high = figure.get_size_inches()
    if figure.get_layout_engine() is None:
        larger = min(wide / NARROW, 1.5)
        for text in figure.findobj(Text):
            text.set_fontsize(text.get_fontsize() * larger)
        if figure.legends:
            _widen_margins(figure, larger)
        for axes in figure.axes:
            if axes.axison and axes.name == "rectilinear":
                axes.locator_params(nbins=4)
                _uncut(figure, axes)
        return
    panels = [axes for axes in figure.axes if axes.axison]
    for axes in panels:
        _wrap_legend(axes)
    high *= _stack(figure, panels)
    columns = {spec.colspan.start for axes in panels if (spec := axes.get_subplotspec())}
    if len(columns) > 1 or (len(panels) == 1 and _is_long(figure, panels[0])):
        # Panels side by side, or with a long legend, would be too crowded: leave them unchanged.
        return
    figure.set_size_inches(NARROW, high)
    for key in figure.legends:
        key.set_ncols(2)
    for axes in panels:
        if axes.get_xscale() == "linear" and isinstance(
            axes.xaxis.get_major_locator(), AutoLocator
        ):
            axes.locator_params(axis="x", nbins=4)
        legend = axes.get_legend()
        if legend is not None and _share(figure, axes, legend) < 1.0:
            legend = _in_columns(axes, legend, 1 if len(legend.get_texts()) < 3 else 2)
            if _share(figure, axes, legend) < _LEAST:
                _in_columns(axes, legend, 1)


def _in_columns(axes: Axes, legend: Legend, columns: int) -> Legend:
    """Rebuild a legend wider than its axes, above them at the right end."""
    texts = [text.get_text() for text in legend.get_texts()]
    handles = [handle for handle in legend.legend_handles if handle is not None]
    anchor = legend.get_bbox_to_anchor().transformed(axes.transAxes.inverted())
    with mpl.rc_context(STYLE):
        return axes.legend(
            handles, texts, loc="lower right", bbox_to_anchor=anchor.bounds, ncols=columns
        )


def _stack(figure: Figure, panels: list[Axes]) -> float:
    """Stack panels vertically; return the added height."""
    specs = [spec for axes in panels if (spec := axes.get_subplotspec())]
    columns = {spec.colspan.start for spec in specs}
    if len(panels) < 2 or len(specs) < len(panels) or len({s.get_gridspec() for s in specs}) > 1:
        return 1.0
    if len(columns) == 1:
        return 1.0 if len(panels) < 6 else 1.3
    places = [(spec.colspan.start, spec.rowspan.start) for spec in specs]
    rows = GridSpec(len(panels), 1, figure=figure)
    for row, place in enumerate(sorted(places)):
        panels[places.index(place)].set_subplotspec(rows[row])
    return len(columns)


def _widen_margins(figure: Figure, larger: float) -> None:
    """Widen the margins of labels, and of a legend below the axes, for larger letters."""
    wide, high = figure.get_size_inches()
    (axes,) = figure.axes
    box = axes.get_position()
    left, foot = larger * box.x0 * wide, larger * box.y0 * high
    tall = high + foot - box.y0 * high
    figure.set_size_inches(wide, tall)
    axes.set_position((left / wide, foot / tall, box.x1 - left / wide, box.height * high / tall))


def _uncut(figure: Figure, axes: Axes) -> None:
    """Move the left side of axes so that their label is not cut off."""
    figure.draw_without_rendering()
    drawn = axes.get_tightbbox()
    beyond = 0.0 if drawn is None else -drawn.x0 / figure.bbox.width
    if beyond > 0.0:
        box = axes.get_position()
        axes.set_position((box.x0 + beyond, box.y0, box.width - beyond, box.height))


def _is_long(figure: Figure, axes: Axes) -> bool:
    """Whether axes have a legend that needs the width of a page."""
    legend = axes.get_legend() or next(iter(figure.legends), None)
    texts = [] if legend is None else [text.get_text() for text in legend.get_texts()]
    lines = [line for text in texts for line in text.splitlines()]
    return max(map(len, lines), default=0) > _LONG


def _wrap_legend(axes: Axes) -> None:
    """Wrap long words of a legend into lines, except those with formulas."""
    legend = axes.get_legend()
    for text in [] if legend is None else legend.get_texts():
        if "$" not in text.get_text():
            text.set_text(textwrap.fill(text.get_text(), _LONG))


def _share(figure: Figure, axes: Axes, legend: Legend) -> float:
    """The width of the axes relative to their legend, at most 1."""
    with warnings.catch_warnings():
        # A legend too wide for the figure leaves its axes no room, which is the case asked for
        # here.
        warnings.filterwarnings("ignore", message="constrained_layout not applied")
        lay_out(figure)
    room = axes.get_window_extent().width
    return min(1.0, float(room / legend.get_window_extent().width))
