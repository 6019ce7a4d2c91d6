"""The figure of a bifurcation diagram: regions, tori, boundaries, stability."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import matplotlib as mpl
import numpy as np
import sympy as sp
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray
from nonholonomic.closed_form.bifurcation import Boundary, Diagram, Region
from nonholonomic.closed_form.bifurcation.layout import (
    Grid,
    Heights,
    Window,
    heights,
    label_positions,
    window,
)

from ..drawing.style import COMPONENTS, FAINT, INK, QUIET, STYLE, WIDTH

#: Pale colours of regions with 1–2, 3–4 and more tori.
TONES = {2: "#e6eef5", 4: "#f6ecd2", 8: "#f3dfe2"}
#: Colour of the given motion.
MARK = "#117733"
#: Height of the plane, and of a line of the legend, in inches.
TALL, LINE = 4.3, 0.19


@arguments_checked
def draw_bifurcation_diagram(diagram: Diagram, mark: tuple[float, float] | None = None) -> Figure:
    """Draw the diagram, with a legend of its boundaries.

    Solid boundaries are stable motions, dashed ones unstable; the colours are those of the body
    axes.  Regions without motions stay white.

    Parameters
    ----------
    diagram : Diagram
    mark : (float, float), optional
        Values of the two integrals on a given motion, to be marked.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the mark is no pair of finite numbers.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> import nonholonomic
    >>> diagram = nonholonomic.closed_form.bifurcation_diagram("veselova")
    >>> figure = report.figures.bifurcation_diagram(diagram)
    >>> len(figure.axes)
    1
    """
    if mark is not None and not np.all(np.isfinite(np.asarray(mark, dtype=float))):
        raise InputError(f"mark = {mark}: it must be a pair of finite numbers")
    frame = window(diagram, mark)
    lines = heights(diagram, frame)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, TALL))
        figure.set_label(f"Bifurcation diagram: {diagram.plane.title}")
        axes = figure.add_subplot()
        axes.set(xlim=frame.across, ylim=frame.upward)
        axes.set_xlabel(_axis_label(diagram, 0))
        axes.set_ylabel(_axis_label(diagram, 1) + _less(diagram, frame))
        _fill(axes, diagram, lines)
        for boundary in diagram.boundaries:
            _line(axes, boundary, lines)
        marks = [] if mark is None else [frame.drawn_position(mark)]
        grid = Grid(diagram, frame, lines, marks)
        _label(axes, diagram, grid)
        for corner in diagram.equilibria:
            _dot(axes, frame.drawn_position(corner.place), "s", "white", INK)
        handles = [*_boundary_key(diagram), *_corner_key(diagram)]
        if mark is not None:
            _dot(axes, frame.drawn_position(mark), "*", MARK, "white", 13.0)
            star: dict[str, Any] = {"marker": "*", "color": "none", "markerfacecolor": MARK}
            star |= {"markeredgecolor": "white", "markersize": 11}
            handles.append(Line2D([], [], label="the given motion", **star))
        _key(figure, axes, handles)
    return figure


def _axis_label(diagram: Diagram, number: int) -> str:
    axis = diagram.axes[number]
    constants = [str(symbol) for symbol, _ in diagram.plane.fixed_parameters] if number == 0 else []
    text = f"{axis.meaning}  ${sp.latex(axis.symbol)}$".strip()
    unit = axis.unit.replace("^2", "$^2$").replace("^4", "$^4$")
    fixed = "".join(
        f"   at ${name} = {float(value):.4g}$"
        for name, value in ((str(s), v) for s, v in diagram.parameters.items())
        if name in constants
    )
    return f"{text}  ({unit}){fixed}" if unit else f"{text}{fixed}"


def _less(diagram: Diagram, frame: Window) -> str:
    """The line that is subtracted from the ordinates, as text."""
    if not frame.slope and not frame.offset:
        return ""
    slope, offset = (float(value) for value in (frame.slope, frame.offset))
    sign = "-" if offset < 0 else "+"
    return f"\nless $({slope:.6g}\\,{diagram.axes[0].symbol} {sign} {abs(offset):.6g})$"


def _fill(axes: Axes, diagram: Diagram, lines: Mapping[int, Heights]) -> None:
    bottom, top = axes.get_ylim()
    for region in diagram.regions:
        tone = next((t for most, t in TONES.items() if region.tori <= most), TONES[8])
        for column, rank in region.cells if region.tori else ():
            if column not in lines:
                continue
            xs, ys = lines[column]
            low = ys[:, rank - 1] if rank else np.full(len(xs), bottom)
            high = ys[:, rank] if rank < ys.shape[1] else np.full(len(xs), top)
            axes.fill_between(xs, low, high, facecolor=tone, linewidth=0.4, edgecolor=tone)


def _line(axes: Axes, boundary: Boundary, lines: Mapping[int, Heights]) -> None:
    pieces: list[FloatArray] = []
    for column, rank in boundary.arcs:
        if column in lines:
            xs, ys = lines[column]
            pieces.append(np.column_stack([xs, ys[:, rank]]))
    for piece in _connected_curves(pieces):
        axes.plot(*piece.T, **_line_style(boundary))


def _connected_curves(pieces: Sequence[FloatArray]) -> list[FloatArray]:
    """Pieces of curves joined at common ends, so that dashes continue."""
    curves: list[FloatArray] = []
    for piece in pieces:
        near = [n for n, other in enumerate(curves) if np.allclose(other[-1], piece[0], atol=1e-6)]
        if near:
            curves[near[0]] = np.concatenate([curves[near[0]], piece])
        else:
            curves.append(piece)
    return curves


def _line_style(boundary: Boundary) -> dict[str, Any]:
    colour = COMPONENTS[boundary.pole - 1] if boundary.pole else INK
    return {
        "color": colour,
        "linewidth": 1.6,
        "linestyle": "-" if boundary.stable else (0, (3.2, 1.8)),
        "solid_capstyle": "butt",
        "dash_capstyle": "butt",
    }


def _dot(
    axes: Axes, place: Sequence[Fraction | float], kind: str, face: str, edge: str, size: float = 5
) -> None:
    x, y = (float(value) for value in place)
    axes.plot([x], [y], kind, markersize=size, markerfacecolor=face, markeredgecolor=edge, zorder=5)


def _tori_text(region: Region) -> str:
    if not region.tori:
        return "no motion"
    return "1 torus" if region.tori == 1 else f"{region.tori} tori"


def _label(axes: Axes, diagram: Diagram, grid: Grid) -> None:
    empty = [region for region in diagram.regions if not region.tori]
    sentence = [region for region in diagram.regions if region.tori]
    positions = label_positions(grid, sentence, empty)
    for region in sentence:
        if region.number not in positions:
            continue
        inside, outside = positions[region.number]
        note: dict[str, Any] = {"ha": "center", "va": "center", "color": INK, "zorder": 6}
        text = f"{region.number}: {_tori_text(region)}"
        if outside is None:
            axes.text(*inside, text, **note)
        else:
            arrow = {"arrowstyle": "-", "color": INK, "linewidth": 0.6, "shrinkB": 0}
            axes.plot(*inside, "o", color=INK, markersize=2.2, zorder=6)
            axes.annotate(text, inside, outside, arrowprops=arrow, **note)
    if 0 in positions:
        axes.text(*positions[0][0], "no motion", ha="center", va="center", color=QUIET)


def _boundary_key(diagram: Diagram) -> list[Line2D]:
    handles: dict[tuple[str, int, bool], Line2D] = {}
    for boundary in diagram.boundaries:
        kind = (boundary.words, boundary.circles, boundary.stable)
        circles = "1 circle" if boundary.circles == 1 else f"{boundary.circles} circles"
        fate = "stable" if boundary.stable else "unstable"
        words = boundary.words.replace("z_1", "$z_1$").replace("z_2", "$z_2$")
        words = words.replace(" M ", " $M$ ")
        for axis in (1, 2, 3):
            words = words.replace(f"Γ_{axis}", rf"$\Gamma_{axis}$")
            words = words.replace(f"ν_{axis}", rf"$\nu_{axis}$")
        handles.setdefault(
            kind, Line2D([], [], label=f"{words}: {circles}, {fate}", **_line_style(boundary))
        )
    return [handles[kind] for kind in sorted(handles)]


def _corner_key(diagram: Diagram) -> list[Line2D]:
    if not diagram.equilibria:
        return []
    corners = sorted(diagram.equilibria, key=lambda corner: corner.axis)
    words = ", ".join(f"axis {corner.axis} {corner.words}" for corner in corners)
    style: dict[str, Any] = {"color": "none", "markerfacecolor": "white", "markeredgecolor": INK}
    return [Line2D([], [], marker="s", markersize=5, label=f"at rest: {words}", **style)]


def _key(figure: Figure, axes: Axes, handles: Sequence[Line2D]) -> None:
    """Draw the legend below the plane, one line per entry; the figure grows accordingly."""
    foot = 0.62 + LINE * len(handles)
    tall = TALL + foot - 0.5
    figure.set_size_inches(WIDTH, tall)
    left, right = 0.86 / WIDTH, 1 - 0.12 / WIDTH
    axes.set_position((left, foot / tall, right - left, 1 - (foot + 0.12) / tall))
    axes.spines[["left", "bottom"]].set_color(FAINT)
    figure.legend(
        handles=handles,
        loc="lower left",
        bbox_to_anchor=(left, 0.06 / tall),
        ncols=1,
        handlelength=2.6,
        labelspacing=0.35,
    )
