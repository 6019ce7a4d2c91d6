"""The curve of a closed form over the real line: roots, ovals, motion."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray
from nonholonomic.closed_form.base.solution import ClosedForm

from ..drawing.style import COMPONENTS, FAINT, INK, QUIET, STYLE, WIDTH

#: Number of points of half an oval.
_POINTS = 300

#: Number of turns of the faster phase that are drawn.
TURNS = 9


@arguments_checked
def closed_form(title: str, form: ClosedForm) -> Figure:
    """Draw the ovals of a curve y² = ∏ (z − root) and the motion on them.

    Ovals are drawn to the same height, each in the shape of the curve.  A motion with two
    frequencies is also drawn on the square of its two phases, for some turns.

    Parameters
    ----------
    title : str
        Title of the system, for the description.
    form : ClosedForm

    Returns
    -------
    Figure

    Raises
    ------
    InputError
        If the motion has no ovals, as uniform rotations have none.

    Examples
    --------
    >>> import chaplygin as ch
    >>> import nonholonomic
    >>> from chaplygin import report
    >>> veselova = ch.from_catalogue("veselova")
    >>> solution = ch.solve(veselova, nonholonomic.CATALOGUE["veselova"].start.values)
    >>> figure = report.figures.closed_form(veselova.title, solution.form)
    >>> len(figure.axes)
    2
    """
    if not form.ovals:
        raise InputError(f"there is no curve to draw of this motion: {form.motion}")
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 1.75), layout="constrained")
        figure.set_label(f"The curve of the closed form: {title}")
        turns = frequencies_of(form)
        if turns is None:
            _curve(figure.add_subplot(), form)
        else:
            curve, torus = figure.subplots(1, 2, width_ratios=(3.6, 1.0))
            _curve(curve, form)
            _torus(torus, *turns)
    return figure


def _curve(axes: Axes, form: ClosedForm) -> None:
    """The z axis with the roots and the ovals of the motion."""
    roots = roots_of(form)
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
    axes.set_xlabel("$z$" if roots else "$u$")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.02), ncols=len(form.ovals))


def _torus(axes: Axes, first: float, second: float) -> None:
    """A straight line on the square of the two phases, its turns from light to dark."""
    speed = max(abs(first), abs(second))
    phase = np.linspace(0.0, TURNS, 400 * TURNS + 1)
    x, y = ((phase * rate / speed) % 1.0 for rate in (first, second))
    # The line is cut where it leaves the square.
    cut = (np.abs(np.diff(x)) > 0.5) | (np.abs(np.diff(y)) > 0.5)
    places = np.flatnonzero(cut) + 1
    pieces = zip(np.split(x, places), np.split(y, places), strict=True)
    for piece in pieces:
        axes.plot(*piece, color=INK, linewidth=0.6)
    axes.set_aspect("equal")
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(0.0, 1.0)
    axes.set_xticks([0.0, 1.0])
    axes.set_yticks([0.0, 1.0])
    axes.set_xlabel("turns of $z_1$", labelpad=-6)
    axes.set_ylabel("turns of $z_2$", labelpad=-4)


def frequencies_of(form: ClosedForm) -> tuple[float, float] | None:
    """The two frequencies among the constants of a closed form."""
    values = {f.symbol: float(f.value.mid()) for f in form.constants}
    if "Omega_1" not in values or "Omega_2" not in values:
        return None
    return values["Omega_1"], values["Omega_2"]


def roots_of(form: ClosedForm) -> list[float]:
    """The roots of the curve among the constants of a closed form."""
    return sorted(float(f.value.mid()) for f in form.constants if f.meaning.startswith("root"))


def _oval(
    axes: Axes, low: float, high: float, roots: Sequence[float], colour: str, number: int
) -> None:
    """One closed piece of the curve."""
    angle = np.linspace(0.0, np.pi, _POINTS)
    z: FloatArray = (low + high) / 2 - (high - low) / 2 * np.cos(angle)
    square = np.ones_like(z)
    for root in roots:
        square = square * np.abs(z - root)
    # If the ends are not roots of the curve, the piece is drawn as a circle.
    y = np.sqrt(square) if len(roots) > 1 else np.sin(angle)
    y = y / y.max()
    corners = (np.concatenate([z, z[::-1]]), np.concatenate([y, -y[::-1]]))
    axes.fill(*corners, facecolor=colour, alpha=0.14, linewidth=0.0, zorder=2)
    name = f"z_{number + 1}" if roots else "u"
    axes.plot(*corners, color=colour, linewidth=1.3, zorder=3, label=f"${name}$ moves here")
