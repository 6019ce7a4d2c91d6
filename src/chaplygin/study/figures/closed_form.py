"""The curve of a closed form over the real line, its roots and the ovals of the motion."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...explicit.solution import ClosedForm
from ..drawing import FloatArray
from .style import COMPONENTS, FAINT, INK, QUIET, STYLE, WIDTH

__all__ = ["closed_form"]

#: Points with which half an oval is drawn.
_POINTS = 300


def closed_form(title: str, form: ClosedForm) -> Figure:
    """The real ovals of a curve y² = ∏ (z − root) with those on which the motion lives filled.

    Ovals are drawn to the same height, each in the shape that the curve has there.

    Parameters
    ----------
    title : str
        Of the system, for the description.
    form : ClosedForm
    """
    roots = roots_of(form)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 1.7), layout="constrained")
        figure.set_label(f"The curve of the closed form: {title}")
        axes = figure.add_subplot()
        ends = [*roots, *(end for oval in form.ovals for end in oval)]
        low, high = min(ends), max(ends)
        room = 0.06 * (high - low) or 1.0
        axes.axhline(0.0, color=QUIET, linewidth=0.6, zorder=1)
        for number, (left, right) in enumerate(form.ovals):
            _oval(axes, left, right, roots, COMPONENTS[number % len(COMPONENTS)], number)
        axes.plot(roots, np.zeros(len(roots)), "o", color=INK, markersize=3.5, zorder=4)
        axes.set_xlim(low - room, high + room)
        axes.set_ylim(-1.25, 1.25)
        axes.set_yticks([])
        axes.spines["left"].set_visible(False)
        axes.grid(axis="x", color=FAINT, linewidth=0.4)
        axes.set_axisbelow(True)
        axes.set_xlabel("$z$")
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.02), ncols=max(1, len(form.ovals)))
    return figure


def roots_of(form: ClosedForm) -> list[float]:
    """The roots of the curve among the figures of a closed form."""
    return sorted(float(f.value.mid()) for f in form.figures if f.meaning == "branch point")


def _oval(
    axes: Axes, low: float, high: float, roots: Sequence[float], colour: str, number: int
) -> None:
    """One closed piece of the curve."""
    angle = np.linspace(0.0, np.pi, _POINTS)
    z: FloatArray = (low + high) / 2 - (high - low) / 2 * np.cos(angle)
    square = np.ones_like(z)
    for root in roots:
        square = square * np.abs(z - root)
    # where the ends are no roots of the curve, the piece is a circle on paper
    y = np.sqrt(square) if len(roots) > 1 else np.sin(angle)
    y = y / y.max()
    corners = (np.concatenate([z, z[::-1]]), np.concatenate([y, -y[::-1]]))
    axes.fill(*corners, facecolor=colour, alpha=0.14, linewidth=0.0, zorder=2)
    label = f"$z_{number + 1}$ moves here"
    axes.plot(*corners, color=colour, linewidth=1.3, zorder=3, label=label)
