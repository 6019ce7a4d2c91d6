"""Strange attractors of bodies that roll without friction.

Energy is kept and nothing rubs, yet volumes need not be: a body that rolls without slipping may
have no invariant measure, and then its motions may be drawn to a chaotic set within one level of
the energy.  The equations are reversible, so that the mirror image of each attractor, with all
velocities reversed, is a set that repels.  Here is a rattleback: Lyapunov exponents with errors,
their sum beside the mean of the divergence, the Kaplan–Yorke dimension, and a section.

The contact is taken to hold, whatever the sign of the force in it.

    python examples/strange_attractors.py
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from chaplygin import Body, Ellipsoid, Forces, RollingBody, RunError, System, lyapunov_spectrum
from chaplygin.report.drawing.style import FAINT, INK, QUIET, SERIES, STYLE, WIDTH
from flowlanes import batch_integrator, poincare_section, reversing_symmetries, sample_level
from flowlanes.flow import project_to_level
from flowlanes.formulas import Formulas
from flowlanes.lyapunov import Spectrum
from flowlanes.lyapunov.record import remarks
from flowlanes.orbits import Reversor

GRAVITY = Forces(9.81)


def rattleback() -> System:
    """An ellipsoid of 12 by 8 by 8 cm, 1 kg, turned by half a radian against its inertia."""
    shape = Ellipsoid((0.06, 0.04, 0.04), turn=0.5, centre=(0.0, 0.0, 0.03))
    return _free(Body(1.0, (2e-4, 6e-4, 7e-4), shape), "rattleback", "Rattleback")


def _free(body: Body, name: str, title: str) -> System:
    """The reduced system of a heavy body, its contact not watched."""
    return replace(
        RollingBody(body, field=GRAVITY).system(name, title), reconstruction=None, guards=()
    )


@dataclass(frozen=True)
class Case:
    """A body at one energy (J), and how long it is left alone before anything is measured (s)."""

    build: Callable[[], System]
    energy: float
    settle: float


@dataclass(frozen=True)
class Attractor:
    """What was found of one case.

    Attributes
    ----------
    spectrum : Spectrum
    reversors : tuple of Reversor
        Those that hold.
    points : (n, 6) array
        M and γ where γ₁ passes zero upwards.
    """

    case: Case
    spectrum: Spectrum
    reversors: tuple[Reversor, ...]
    points: np.ndarray


def state_on_attractor(system: System, case: Case, pieces: int = 20) -> np.ndarray:
    """A state on the level of the energy, drawn at random and followed for a while."""
    level = Formulas(system, [system.relations[0], system.integrals[0].value])
    flow = batch_integrator(system, tolerance=1e-12)
    states = sample_level(system, 1, {"energy": case.energy}, seed=1)
    for _ in range(pieces):
        states = flow.propagate(states, [case.settle / pieces]).states[:, -1]
        states, _ = project_to_level(level, states, [0.0, case.energy])
    return states[0]


def section_points(system: System, state: np.ndarray, count: int, each: int = 200) -> np.ndarray:
    """States where γ₁ rises through zero along one motion, on the level of the energy."""
    level = Formulas(system, [system.relations[0], system.integrals[0].value])
    energy = level(state[None])[0, 1]
    flow = batch_integrator(system, tolerance=1e-12, section=poincare_section(system, "gamma_1"))
    points, states = [], state[None]
    for _ in range(count // each):
        crossed = flow.crossings(states, each)
        if crossed.outcome[0]:
            raise RunError(
                flow.status_message(int(crossed.outcome[0])), float(crossed.end_times[0])
            )
        points.append(crossed.states[0])
        states, _ = project_to_level(level, points[-1][-1:], [0.0, energy])
    return np.concatenate(points)


def attractor_of(case: Case, until: float, count: int) -> Attractor:
    """Spectrum and section of one case."""
    system = case.build()
    state = state_on_attractor(system, case)
    spectrum = lyapunov_spectrum(system, state, t_end=until)
    holding = tuple(r for r in reversing_symmetries(system) if r.holds(spectrum.parameters))
    return Attractor(case, spectrum, holding, section_points(system, state, count))


#: The stone with 7.6 times the energy of its rest.
CASES = [Case(rattleback, 0.75, 100.0)]


# --- pictures ------------------------------------------------------------------------------


def _running(axes: Axes, spectrum: Spectrum) -> None:
    axes.axhline(0, color=FAINT, lw=0.8)
    shown = spectrum.running
    for number, (item, colour) in enumerate(zip(spectrum.exponents, SERIES, strict=False), 1):
        axes.plot(spectrum.times, shown[:, number - 1], color=colour, lw=0.9)
        axes.axhspan(
            item.value - item.error, item.value + item.error, color=colour, alpha=0.13, lw=0
        )
        axes.annotate(
            rf"$\lambda_{number}$",
            (1.0, item.value),
            xycoords=("axes fraction", "data"),
            xytext=(4, 0),
            textcoords="offset points",
            va="center",
            color=colour,
        )
    # the values of the first instants are part of the picture
    low, high = np.nanmin(shown), np.nanmax(shown)
    axes.set_ylim(low - 0.06 * (high - low), high + 0.06 * (high - low))
    axes.set_xlim(0, spectrum.t_end)
    axes.set_xlabel("time (s)")
    axes.set_ylabel("exponent (1/s)")


def _section(figure: Figure, axes: Axes, attractor: Attractor) -> None:
    """Vertical momentum and momentum about the third axis; the mirror image in grey."""
    M, gamma = attractor.points[:, :3], attractor.points[:, 3:]
    vertical = (M * gamma).sum(axis=1)
    axes.plot(-1e3 * vertical, -1e3 * M[:, 2], ",", color=FAINT, zorder=1)
    shown = axes.scatter(
        1e3 * vertical, 1e3 * M[:, 2], c=gamma[:, 1], s=0.7, lw=0, cmap="viridis", zorder=2
    )
    shown.set_rasterized(True)
    axes.set_xlabel(r"$(\mathbf{M}, \gamma)$ ($10^{-3}$ kg m$^2$/s)")
    axes.set_ylabel(r"$M_3$ ($10^{-3}$ kg m$^2$/s)")
    bar = figure.colorbar(shown, ax=axes, pad=0.03, aspect=30)
    bar.set_label(r"$\gamma_2$")
    bar.outline.set_visible(False)


def draw_all(attractors: list[Attractor]) -> Figure:
    """Sections above, the way the exponents settle below."""
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(
            2,
            len(attractors),
            figsize=(WIDTH, 5.0),
            squeeze=False,
            height_ratios=(1.5, 1.0),
            layout="constrained",
        )
        # letters keep their distance from the edge
        figure.get_layout_engine().set(w_pad=0.12, h_pad=0.08)
        for (above, below), each in zip(axes.T, attractors, strict=True):
            _section(figure, above, each)
            _running(below, each.spectrum)
            system = each.spectrum.system
            above.set_title(f"{system.title}, {each.case.energy:g} J", color=INK, fontsize=10)
            note = "grey: the reversed\nmotion, on what repels"
            above.text(0.98, 0.03, note, transform=above.transAxes, color=QUIET, ha="right")
    return figure


def main() -> None:
    """Print what was measured, and draw it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--until", type=float, default=1000.0, help="seconds of motion measured")
    parser.add_argument("--points", type=int, default=20_000, help="points of each section")
    parser.add_argument("-o", "--output", type=Path, default=Path("docs/pictures"))
    options = parser.parse_args()
    attractors = [attractor_of(case, options.until, options.points) for case in CASES]
    for each in attractors:
        print(summary(each))
    with plt.rc_context(STYLE):
        draw_all(attractors).savefig(options.output / "strange_attractors.png", dpi=200)


def summary(attractor: Attractor) -> str:
    """What was measured of a case, in lines."""
    result = attractor.spectrum
    lines = [f"{result.system.title}, energy {attractor.case.energy:g} J, {result.t_end:g} s"]
    lines += [
        f"  λ{number} = {item.value:.3f} ± {item.error:.3f} /s"
        for number, item in enumerate(result.exponents, 1)
    ]
    divergence = result.volume.divergence
    lines += [
        f"  sum = {result.total.value:.3f} ± {result.total.error:.3f} /s, "
        f"mean divergence {divergence.value:.3f} /s",
        f"  removed: {', '.join(item.name for item, _ in result.trivial)}",
    ]
    lines += [f"  {text}" for text in remarks(result, attractor.reversors)]
    return "\n".join(lines)


if __name__ == "__main__":
    main()
