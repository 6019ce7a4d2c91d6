"""Which tippe tops turn over: the laws of friction, and a chart over spin and eccentricity.

A ball whose centre of mass lies the distance αR from its middle is spun about the vertical, almost
upright.  Friction at the point of contact conserves Jellett's integral J = (Iω, Rγ − c e₃) (c is
the place of the middle, seen from the centre of mass), whatever its law; couples do not.

Run with::

    python examples/tippe_top.py
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from scipy.optimize import brentq

import chaplygin as ch
from chaplygin.experiment.friction_studies.chart import contact_chart, contact_chart_task
from chaplygin.report.drawing.style import INK, QUIET, SERIES, STYLE, WIDTH
from flowlanes.flow.ensembles import compute
from flowlanes.scans import axis
from nonholonomic.contact import (
    CompiledContact,
    ContactMotion,
    ContensouErismann,
    Coulomb,
    FrictionalContact,
    FrictionLaw,
    NormalViscous,
    contact_motion,
)

#: The top of Leine and Glocker (2003): kg, kg m², m; its eccentricity α and spin (rad/s).
MASS, MOMENTS, RADIUS = 0.006, (8e-7, 8e-7, 7e-7), 0.015
ECCENTRICITY, SPIN, LEAN = 0.2, 180.0, 0.1
GRAVITY = 9.81
LAWS: dict[str, FrictionLaw] = {
    "Coulomb, at a point": Coulomb(0.3),
    "over a patch of 0.5 mm": ContensouErismann(0.3, 5e-4),
    "in proportion to slip and N": NormalViscous(0.3),
}
#: Strong friction in proportion to slip for the chart, so that the tops come to their ends soon.
CHART_LAW = NormalViscous(3.0)
CHART_TIME = 40.0
#: A top stands on its head where γ₃ < −1 + this.
ON_ITS_HEAD = 1e-3

GAMMA_3 = 15
"""Column of γ₃ in a state."""


def top(law: FrictionLaw, eccentricity: float = ECCENTRICITY) -> FrictionalContact:
    """The top on a table under a law of friction; only the place of its centre of mass varies."""
    shape = ch.Ball(RADIUS, centre=(0.0, 0.0, eccentricity * RADIUS))
    body = ch.Body(MASS, MOMENTS, shape)
    return FrictionalContact(body, laws=(law,), field=ch.Forces(gravity=GRAVITY))


def start(situation: FrictionalContact, spin: float = SPIN, lean: float = LEAN) -> tuple[Any, ...]:
    """Spun about the vertical, with the axis at a small angle to it and the centre of mass at rest.

    The touching point slips as the body turns; the centre of mass moves neither up nor sideways.
    """
    gamma = np.array([-np.sin(lean), 0.0, np.cos(lean)])
    omega = spin * gamma
    slip = np.cross(omega, np.array(situation.body.shape.centre) - RADIUS * gamma)
    return ch.initial_state(situation, omega, gamma, slip=slip - (slip @ gamma) * gamma)


def passage(contact: CompiledContact, motion: ContactMotion, level: float) -> float:
    """The time at which γ₃ first falls to a level."""
    below = np.flatnonzero(motion.states[:, GAMMA_3] < level)
    if not len(below):
        return np.nan
    early, late = motion.times[below[0] - 1], motion.times[below[0]]
    begin = motion.states[below[0] - 1]

    def height(time: float) -> float:
        if time == early:
            return float(begin[GAMMA_3]) - level
        reached = contact_motion(contact, begin, [early, time])
        return float(reached.end_state[GAMMA_3]) - level

    return float(brentq(height, early, late, xtol=1e-13))


# --- the condition -------------------------------------------------------------------------------


def jellett(spin: float, lean: float, eccentricity: float) -> float:
    """J = (Iω, Rγ − c e₃) of the start."""
    along = MOMENTS[2] * np.cos(lean) ** 2 + MOMENTS[0] * np.sin(lean) ** 2
    return spin * RADIUS * (along - eccentricity * MOMENTS[2] * np.cos(lean))


def least_jellett(eccentricity: float) -> float:
    """|J| from which on the spin on the head is stable; infinite if it never is."""
    margin = 1 + eccentricity - MOMENTS[0] / MOMENTS[2]
    if margin <= 0:
        return np.inf
    weight = MASS * GRAVITY * RADIUS**3 * MOMENTS[2] * eccentricity
    return float(np.sqrt(weight * (1 + eccentricity) ** 4 / margin))


def least_spin(eccentricity: float, lean: float = 0.0) -> float:
    """The spin (rad/s) from which on a top turns over, started with a lean."""
    return least_jellett(eccentricity) / jellett(1.0, lean, eccentricity)


# --- what the computer finds ---------------------------------------------------------------------


def end(contact: CompiledContact, spin: float, until: float = CHART_TIME) -> float:
    """γ₃ of a top, started with a spin, on average over the last fifth of its time.

    A nutation that decays slowly is averaged out.
    """
    times = np.concatenate([[0.0], np.linspace(0.8 * until, until, 200)])
    motion = contact_motion(contact, start(contact.situation, spin), times)
    return float(motion.states[1:, GAMMA_3].mean())


def chart(cells: int) -> xr.DataArray:
    """γ₃ over the last fifth of the time, for tops of several eccentricities alpha and spins."""
    study = ch.Study.from_experiment(
        ch.load_experiment(Path(__file__).with_name("tippe_tops.toml"))
    )
    start = {
        "centre_3": "radius*alpha",
        "omega_1": f"-spin*sin({LEAN})",
        "omega_3": f"spin*cos({LEAN})",
        "slip_2": f"radius*alpha*spin*sin({LEAN})",
    }
    spins, eccentricities = axis(f"spin=40:260:{cells}"), axis(f"alpha=0.1:0.4:{cells}")
    plane = contact_chart(study, "late_mean:gamma_3", spins, eccentricities, formulas=start)
    return compute(contact_chart_task(plane, "Tippe tops"))["late_mean"]


def threshold(
    eccentricity: float,
    shares: Sequence[float] = (0.92, 0.94, 0.96, 0.98),
    until: float = 2.5 * CHART_TIME,
) -> float:
    """The spin (rad/s) from which on a top stands on its head.

    Tops of a little less spin end inclined; their spin as a polynomial of 1 + γ₃ is extrapolated to
    γ₃ = −1.
    """
    contact = CompiledContact(top(CHART_LAW, eccentricity), 1e-14)
    spins = least_spin(eccentricity, LEAN) * np.array(shares)
    missing = [1 + end(contact, spin, until) for spin in spins]
    fit = np.polynomial.Polynomial.fit(missing, spins, len(spins) - 1)
    return float(fit(0.0))


# --- the story -----------------------------------------------------------------------------------


def inversions(longest: float = 30.0) -> dict[str, tuple[CompiledContact, ContactMotion]]:
    """The top of Leine and Glocker under every law, until it has come to its end."""
    motions = {}
    for (words, law), until in zip(LAWS.items(), (4.0, 16.0, 30.0), strict=True):
        times = np.arange(0.0, min(until, longest) + 1e-9, 0.005)
        contact = CompiledContact(top(law))
        motions[words] = (contact, contact_motion(contact, start(contact.situation), times))
    return motions


def figure(motions: dict[str, tuple[CompiledContact, ContactMotion]], tops: xr.DataArray) -> Figure:
    """γ₃ against time under every law; and how far tops turn over, with the condition."""
    drawing, (left, right) = plt.subplots(
        1, 2, figsize=(WIDTH, 3.1), layout="constrained", width_ratios=(1, 1.15)
    )
    for (words, (_, motion)), colour in zip(motions.items(), SERIES, strict=False):
        left.plot(motion.times, motion.states[:, GAMMA_3], color=colour, label=words)
        for event in motion.events:
            left.plot(event.time, event.after[GAMMA_3], "o", color=colour)
            left.annotate(
                "begins to roll",
                (event.time, event.after[GAMMA_3]),
                (6, 8),
                textcoords="offset points",
                color=colour,
                fontsize=8,
            )
    left.axhline(0, color=QUIET, lw=0.6)
    left.set(
        xlabel="time (s)",
        ylabel=r"height of the axis $\gamma_3$",
        xlim=(-0.1, 4),
        ylim=(-1.05, 1.05),
    )
    left.legend(loc="lower left", bbox_to_anchor=(-0.05, 0.99), fontsize=7.5)
    image = right.pcolormesh(tops.spin, tops.alpha, tops, cmap="RdYlBu", vmin=-1)
    image.set_clim(-1, 1)
    image.set_rasterized(True)
    edges = [a for a in np.linspace(*tops.alpha.values[[0, -1]], 400) if least_spin(a) < 1e3]
    right.plot([least_spin(a, LEAN) for a in edges], edges, color=INK, lw=1.4)
    right.plot(SPIN, ECCENTRICITY, "o", color=INK)
    right.set(xlim=tops.spin.values[[0, -1]], ylim=tops.alpha.values[[0, -1]])
    right.set(xlabel="spin (rad/s)", ylabel=r"eccentricity $\alpha$")
    drawing.colorbar(image, label=rf"$\gamma_3$ after {CHART_TIME:.0f} s", pad=0.02)
    return drawing


def report(folder: Path, cells: int = 24) -> None:
    """The whole story, and the figure."""
    motions = inversions()
    print("The top of Leine and Glocker (μ = 0.3), 180 rad/s")
    for words, (contact, motion) in motions.items():
        print(f"  {words}:")
        for level in (0.0, -0.9):
            print(f"    γ₃ = {level:4} at t = {passage(contact, motion, level):.9f} s")
        heights = motion.states[:, GAMMA_3]
        lowest = int(heights.argmin())
        print(f"    least γ₃ = {heights[lowest]:.6f} at t = {motion.times[lowest]:.3f} s,")
        print(f"    and {heights[-1]:.6f} at t = {motion.times[-1]:g} s")
        for event in motion.events:
            print(f"    {event}, γ₃ = {event.after[GAMMA_3]:.6f}")
            rolled = contact_motion(contact, event.after, np.linspace(0.0, 60.0, 6001))
            low, high = rolled.states[:, GAMMA_3].min(), rolled.states[:, GAMMA_3].max()
            values = rolled
            force = np.linalg.norm(values["friction_force"], axis=1) / values["normal_force"]
            print(f"    in the next 60 s of rolling γ₃ = {low:.6f} … {high:.6f},")
            print(
                f"    with friction up to {force.max():.4f} N; further changes: "
                f"{len(rolled.events)}"
            )
    print("\nLeast spin to turn over (rad/s): by theory upright, at this start, and measured")
    for eccentricity in (0.16, 0.2, 0.3):
        theory, leaning = least_spin(eccentricity), least_spin(eccentricity, LEAN)
        print(f"  α = {eccentricity}: {theory:.3f}, {leaning:.3f}, {threshold(eccentricity):.3f}")
    tops = chart(cells)
    agree, away = agreement(tops)
    print(f"\nChart of {tops.size} tops: {agree} end as the condition says,")
    print(f"  the spin of the others is within {away:.1%} of the least one")
    with plt.rc_context(STYLE):
        folder.mkdir(parents=True, exist_ok=True)
        figure(motions, tops).savefig(folder / "tippe_top.png", dpi=160)
    print(f"wrote {folder / 'tippe_top.png'}")


def agreement(tops: xr.DataArray) -> tuple[int, float]:
    """How many tops end on their heads or not as the condition says; how far off the others are."""
    least = np.array([least_spin(a, LEAN) for a in tops.alpha.values])[:, None]
    over = tops.values < -1 + ON_ITS_HEAD
    wrong = over != (tops.spin.values > least)
    distances = np.abs(np.broadcast_to(tops.spin.values / least - 1, over.shape)[wrong])
    return int((~wrong).sum()), float(distances.max(initial=0.0))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the figure")
    report(parser.parse_args().output)


if __name__ == "__main__":
    main()
