"""The bifurcation diagram of a rubber body of revolution: energy over linear integral."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from nonholonomic.closed_form.revolution.diagram import Diagram

from ..drawing.style import ALARM, COMPONENTS, INK, QUIET, STYLE, WIDTH

#: Shades of the regions by the number of motions with the same integrals.
SHADES = ("#ffffff", "#e6edf4", "#c3d3e4", "#9db6d1", "#7899bd")


@arguments_checked
def draw_revolution_diagram(
    diagram: Diagram, marks: Sequence[tuple[float, float]] = (), unit: str = "J"
) -> Figure:
    """Curves of permanent rotations and the number of motions between them.

    Parameters
    ----------
    diagram : Diagram
    marks : sequence of (h, K), optional
        Motions to be marked.
    unit : str
        Unit of the energy.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the diagram has a single column.
    """
    if len(diagram.columns) < 2:
        raise InputError("diagram: it has one value of K; a figure needs two or more")
    spins = np.array([column.K for column in diagram.columns])
    energies = np.concatenate([curve[:, 0] for curve in diagram.curves])
    low, high = float(energies.min()), float(energies.max())
    high = high + 0.15 * (high - low)
    edges = np.concatenate([spins[:1], (spins[1:] + spins[:-1]) / 2, spins[-1:]])
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 0.62 * WIDTH), layout="constrained")
        axes = figure.subplots()
        for column, left, right in zip(diagram.columns, edges[:-1], edges[1:], strict=True):
            levels = [float(equilibrium.h) for equilibrium in column.rests]
            bands = zip(levels, [*levels[1:], high], column.counts[1:], strict=True)
            for bottom, top, count in bands:
                shade = SHADES[min(count, len(SHADES) - 1)]
                axes.fill_between([left, right], bottom, top, color=shade, linewidth=0, zorder=0)
        for stable in (True, False):
            style = "-" if stable else (0, (4, 2))
            label: str | None = f"{'stable' if stable else 'unstable'} permanent rotation"
            colour = COMPONENTS[0] if stable else ALARM
            for curve, kind in zip(diagram.curves, diagram.stable, strict=True):
                if kind == stable:
                    axes.plot(
                        curve[:, 1],
                        curve[:, 0],
                        color=colour,
                        linestyle=style,
                        label=label,
                    )
                    label = None
        for energy, spin in marks:
            axes.plot([abs(spin)], [energy], marker="o", color=INK, markersize=5, zorder=3)
        axes.set_xlim(float(spins[0]), float(spins[-1]))
        axes.set_ylim(low - 0.02 * (high - low), high)
        axes.set_xlabel(r"integral $|K|$ of (5.1)")
        axes.set_ylabel(f"energy $h$ ({unit})")
        axes.set_title("Permanent rotations and the number of motions", color=INK, loc="left")
        axes.tick_params(color=QUIET)
        axes.legend(loc="lower right")
    return figure
