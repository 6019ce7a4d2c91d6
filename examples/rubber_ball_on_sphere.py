"""The rubber ball on a sphere for k = ±1 and k = ±½: regular or not.

A balanced, dynamically asymmetric ball rolls on a sphere with neither slipping nor spinning (§9).
Energy and an invariant measure it has for every ratio k = a/(a + b) of the radii; with one more
integral, known for k = 1 and k = −1, it is integrable.  For k = ½ (equal radii) the equations are
Hamiltonian without a change of time; is it integrable, and for k = −½?  Measured here: sections,
how the two known integrals change, closed orbits on resonant curves, averages, exponents.

    python examples/rubber_ball_on_sphere.py
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

from chaplygin import PoincareMap, lyapunov_spectrum
from chaplygin.report.drawing.style import SERIES, STYLE, WIDTH
from flowlanes import poincare_section
from flowlanes.formulas import Formulas
from flowlanes.lyapunov.averages import Average
from flowlanes.orbits import NoOrbitError, Orbit, ReturnMap, find_periodic
from flowlanes.orbits.rotation import average
from flowlanes.system import to_components
from nonholonomic.catalogue.ball_on_sphere import rubber_ball_ratio as ball

#: J = I + mb², kg m².
J = np.array([1.0, 2.0, 2.8])
RATIOS = {"k = 1": 1.0, "k = −1": -1.0, "k = ½": 0.5, "k = −½": -0.5}
#: Periods of the closed orbits, and starts from which they are sought.
PERIODS, SOUGHT = (3, 4, 5), 12
#: A start for the exponents, θ and ψ, near the direction of the section, and how long to follow it.
START, UNTIL = (0.75, 0.3), 100_000.0

#: Relative error of a step.
TOLERANCE = 1e-15
#: Returns of each motion in the figure.
SHOWN = 600

SYSTEM = ball.rolling().with_laws(ball.ENERGY)


def returns(k: float) -> PoincareMap:
    """n₂ = 0, rising."""
    values = {"k": k} | {f"J_{i}": moment for i, moment in enumerate(J, 1)}
    return PoincareMap(SYSTEM, poincare_section(SYSTEM, "n_2"), values, TOLERANCE)


def starts(k: float, theta: np.ndarray, psi: np.ndarray) -> np.ndarray:
    """ω, n at energy ½ J from the place θ on the circle n₂ = 0 and the direction ψ across it.

    n = (sin θ, 0, cos θ), √J₂ ω₂ = cos ψ.
    """
    zero = np.zeros_like(theta)
    place = np.stack([np.sin(theta), zero, np.cos(theta)], axis=1)
    along = np.stack([np.cos(theta), zero, -np.sin(theta)], axis=1)
    speed = np.sign(k) * np.sin(psi) / np.sqrt((J * along**2).sum(axis=1))
    spin = speed[:, None] * along
    spin[:, 1] = np.cos(psi) / np.sqrt(J[1])
    return np.concatenate([spin, place], axis=1)


def angles(states: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """θ and ψ of states on the section."""
    theta = np.arctan2(states[..., 3], states[..., 5])
    return theta, np.arccos(np.sqrt(J[1]) * states[..., 1])


@dataclass(frozen=True)
class Measurements:
    """What was measured for one ratio.

    Attributes
    ----------
    points : array (starts, returns, size)
        The section.
    drifts : dict of str to float
        The greatest change of a quantity along these motions, as a share of its size.
    orbits : tuple of Orbit
        Closed orbits with three to five points.
    regular : float
        The share of starts along whose motion the weighted average of n₁² converges to 1e-6; along
        chaotic ones it does not.
    exponent : Average
        The largest Lyapunov exponent of one motion, 1/s.
    """

    points: np.ndarray
    drifts: dict[str, float]
    orbits: tuple[Orbit, ...]
    regular: float
    exponent: Average


def residue(orbit: Orbit) -> float:
    """(2 − trace)/4 of a closed orbit of a map that keeps areas: zero on a curve of such orbits."""
    return float((2 - np.trace(orbit.multipliers.matrix)) / 4)


def measure(k: float, count: int = 72, length: int = 4000, until: float = UNTIL) -> Measurements:
    """All measurements for one ratio."""
    section = returns(k)
    line = np.linspace(0.02 - np.pi, np.pi - 0.02, count)
    across = np.where(np.arange(count) % 2, np.pi / 2, np.pi / 2 + 0.43 * line)
    points = section.crossings(starts(k, line, across), length).states
    _, errors = average(points[..., 3] ** 2)
    (start,) = starts(k, *np.array(START)[:, None])
    exponents = lyapunov_spectrum(SYSTEM, start, section.parameters, t_end=until)
    return Measurements(
        points,
        drifts(section, points),
        closed_orbits(k),
        float((errors < 1e-6).mean()),
        exponents.exponents[0],
    )


def drifts(section: PoincareMap, points: np.ndarray) -> dict[str, float]:
    """How much the energy and the two quadratic integrals change."""
    laws = {"energy": ball.ENERGY, "for k = 1": ball.ON_PLANE, "for k = −1": ball.AROUND}
    values = Formulas(SYSTEM, [to_components(law.value) for law in laws.values()])(
        points, section.parameters
    )
    change = np.ptp(values, axis=1) / np.abs(values).mean(axis=1)
    return dict(zip(laws, change.max(axis=0).tolist(), strict=True))


def closed_orbits(
    k: float, periods: Sequence[int] = PERIODS, sought: int = SOUGHT
) -> tuple[Orbit, ...]:
    """Closed orbits of several points, from starts on the line ψ = π/2."""
    return_map, orbits = ReturnMap(returns(k)), []
    for period in periods:
        for theta in np.linspace(0.05, np.pi - 0.05, sought):
            (start,) = starts(k, np.array([theta]), np.array([np.pi / 2]))
            try:
                orbit = find_periodic(return_map, start, period, {"energy": 0.5})
            except NoOrbitError:
                continue
            apart = np.linalg.norm(orbit.points[1:] - orbit.points[0], axis=1).min()
            if apart > 1e-4 and not any(_same(orbit, other) for other in orbits):
                orbits.append(orbit)
    return tuple(orbits)


def _same(orbit: Orbit, other: Orbit) -> bool:
    near = abs(orbit.duration - other.duration) < 1e-5
    return near and orbit.period == other.period


def figure(measurements: dict[str, Measurements]) -> Figure:
    """The four sections."""
    drawing, axes = plt.subplots(
        2, 2, figsize=(WIDTH, 4.9), sharex=True, sharey=True, layout="constrained"
    )
    for panel, (name, one) in zip(axes.flat, measurements.items(), strict=True):
        theta, psi = angles(one.points[:, :SHOWN])
        for number, (places, directions) in enumerate(zip(theta, psi, strict=True)):
            colour = SERIES[number % len(SERIES)]
            panel.scatter(places, directions, color=colour, s=0.25, lw=0, rasterized=True)
        panel.set_title(f"${name.replace('½', r'1/2').replace('−', '-')}$", fontsize=10)
        panel.set(xlim=(-np.pi, np.pi), ylim=(0, np.pi))
        panel.set_xticks([-np.pi, 0, np.pi], [r"$-\pi$", "0", r"$\pi$"])
        panel.set_yticks([0, np.pi / 2, np.pi], ["0", r"$\pi/2$", r"$\pi$"])
    # half of the last tick label stands beyond the axes
    drawing.get_layout_engine().set(w_pad=0.08)
    for panel in axes[1]:
        panel.set_xlabel(r"position on the circle $n_2 = 0$, $\theta$ (rad)")
    for panel in axes[:, 0]:
        panel.set_ylabel(r"direction $\psi$ (rad)")
    return drawing


def report(measurements: dict[str, Measurements]) -> None:
    """The numbers."""
    print(f"J = {J.tolist()} kg m², energy 0.5 J, section n₂ = 0 rising\n")
    for name, one in measurements.items():
        print(f"{name}:")
        changes = ", ".join(f"{law} {value:.1e}" for law, value in one.drifts.items())
        print(f"  change along {one.points.shape[1]} returns: {changes}")
        print(f"  starts along which the average of n₁² converges: {100 * one.regular:.0f} %")
        kinds = [orbit.kind for orbit in one.orbits]
        count = ", ".join(f"{kinds.count(kind)} {kind}" for kind in sorted(set(kinds)))
        sizes = np.abs([residue(orbit) for orbit in one.orbits])
        print(f"  closed orbits of {PERIODS[0]} to {PERIODS[-1]} points: {count}")
        print(f"    |residue| from {sizes.min():.1e} to {sizes.max():.1e}")
        exponent = f"{one.exponent.value:.5f} ± {one.exponent.error:.5f}"
        print(f"  largest exponent from θ, ψ = {START}: {exponent} 1/s")


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the figure")
    folder = parser.parse_args(arguments).output
    measurements = {name: measure(k) for name, k in RATIOS.items()}
    report(measurements)
    with plt.rc_context(STYLE):
        folder.mkdir(parents=True, exist_ok=True)
        figure(measurements).savefig(folder / "rubber_ball_on_sphere.png", dpi=120)
    print(f"wrote {folder / 'rubber_ball_on_sphere.png'}")


if __name__ == "__main__":
    main()
