"""A branch of periodic orbits: period and multipliers over the varied quantity."""

from __future__ import annotations

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from flowlanes.orbits.continuation import Branch

from ..drawing.dataset_access import typeset
from ..drawing.style import FAINT, INK, QUIET, SERIES, STYLE, WIDTH

#: Symbols of the events on a branch.
MARKS = {"fold": "o", "branch": "s", "doubling": "D", "torus": "^"}


def branch(orbits: Branch, title: str) -> Figure:
    """Period and moduli of the multipliers of the orbits, with the events on the branch.

    Parameters
    ----------
    orbits : Branch
    title : str

    Returns
    -------
    matplotlib.figure.Figure
    """
    places = orbits.places
    sizes = [np.sort(np.abs(orbit.multipliers.values)) for orbit in orbits.orbits]
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 4.4), layout="constrained")
        figure.set_label(f"Periodic orbits against {orbits.parameter}: {title}")
        above, below = figure.subplots(2, sharex=True)
        above.set_title(title)
        above.plot(places, [orbit.duration for orbit in orbits.orbits], color=SERIES[0])
        above.set_ylabel("period  (s)")
        many = max(map(len, sizes))
        for number in range(many):
            column = [size[number] if number < len(size) else np.nan for size in sizes]
            below.plot(places, column, color=SERIES[number % len(SERIES)])
        below.axhline(1.0, color=QUIET, linewidth=0.6)
        below.set_ylabel("modulus of the multipliers")
        below.set_xlabel(typeset(orbits.parameter))
        for kind in dict.fromkeys(event.kind for event in orbits.events):
            events = [event for event in orbits.events if event.kind == kind]
            above.plot(
                [event.place for event in events],
                [event.orbit.duration for event in events],
                MARKS.get(kind, "o"),
                color=INK,
                markersize=4,
                label=kind,
            )
        for axes in (above, below):
            axes.grid(axis="y", color=FAINT, linewidth=0.4)
            axes.set_axisbelow(True)
        if orbits.events:
            above.legend(loc="best")
    return figure
