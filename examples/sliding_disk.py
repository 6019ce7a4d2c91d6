"""A disk that slides and spins on its face: both end together, at a ratio of its own.

A curling stone, a puck, a coin on a table.  The contact is the whole face, so that this is no body
that touches at a point; its friction is that of a round patch of radius a under uniform pressure.
With k = v/(aΩ), the functions F and M of the pressure and I = β m a²,

    dv/dt = −μg F(k),     d(aΩ)/dt = −(μg/β) M(k).

Run with::

    python examples/sliding_disk.py
"""

from __future__ import annotations

import argparse
import math
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from chaplygin.report.drawing.style import QUIET, SERIES, STYLE, WIDTH
from nonholonomic.contact.pressure import CoupledFriction, Ring, Uniform

#: ln of the speed at which a motion is taken to have ended, relative to its start.
REST = -40.0
#: β of a homogeneous disk.
DISK = 0.5


@dataclass(frozen=True)
class Slide:
    """The motion of a disk from a start with v² + (aΩ)² = s², in units with μg = a = 1.

    Attributes
    ----------
    v, spin : array (n,)
        Velocity, and aΩ.
    times : array (n,)
    ratio : float
        Of v and aΩ at the end.
    duration, distance : float
        Until both end.
    """

    v: np.ndarray
    spin: np.ndarray
    times: np.ndarray
    ratio: float
    duration: float
    distance: float


def slide(v: float, spin: float, pressure: CoupledFriction, beta: float = DISK) -> Slide:
    """A disk from v and aΩ, both positive, to its end.

    The logarithm σ of s = √(v² + (aΩ)²) serves as time, so that the end is far away, and the angle
    arctan(v/(aΩ)) as place.
    """

    def rates(sigma: float, state: np.ndarray) -> list[float]:
        angle, s = state[0], math.exp(sigma)
        sine, cosine = math.sin(angle), math.cos(angle)
        k = sine / cosine if cosine > 0 else math.inf
        force, couple = float(pressure.force(k)), float(pressure.couple(k)) / beta
        loss = force * sine + couple * cosine  # −ds/dt
        turn = force * cosine - couple * sine  # −s dφ/dt
        return [turn / loss, -s / loss, -s * s * sine / loss]

    first = math.log(math.hypot(v, spin))
    sigmas = np.linspace(first, first + REST, 801)
    run = solve_ivp(
        rates,
        (first, first + REST),
        [math.atan2(v, spin), 0.0, 0.0],
        method="DOP853",
        t_eval=sigmas,
        rtol=1e-13,
        atol=1e-14,
    )
    angles, times, places = run.y
    s = np.exp(run.t)
    return Slide(
        s * np.sin(angles),
        s * np.cos(angles),
        times,
        math.tan(angles[-1]),
        float(times[-1]),
        float(places[-1]),
    )


def limiting_ratio(pressure: CoupledFriction, beta: float) -> float:
    """v/(aΩ) at the end: the k with F(k) = k M(k)/β; 0 if spin alone is left, inf if sliding is."""

    def excess(k: float) -> float:
        return float(pressure.force(k)) - k * float(pressure.couple(k)) / beta

    if excess(1e-9) > 0:
        return 0.0
    if excess(1e6) < 0:
        return math.inf
    return float(brentq(excess, 1e-9, 1e6, xtol=1e-15, rtol=1e-14))


def figure() -> Figure:
    """Velocity against spin for many starts; and the limiting ratio against the inertia."""
    drawing, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 2.9), layout="constrained")
    for i, angle in enumerate(np.radians([2, 10, 20, 33.146, 50, 65, 80, 88])):
        run = slide(math.sin(angle), math.cos(angle), Uniform())
        left.plot(run.spin, run.v, color=SERIES[0], lw=1.8 if i == 3 else 0.9)
    left.text(0.46, 0.94, r"$v^2 + a^2\Omega^2 = 1$ at the start", color=QUIET, fontsize=8)
    left.text(0.52, 0.28, "0.6530", color=SERIES[0])
    left.set(
        xlabel=r"$a\Omega$",
        ylabel=r"$v$",
        aspect="equal",
        xlim=(0, 1.02),
        ylim=(0, 1.02),
    )
    betas = np.linspace(0.252, 0.66, 200)
    right.plot(betas, [limiting_ratio(Uniform(), b) for b in betas], color=SERIES[0])
    right.plot(DISK, limiting_ratio(Uniform(), DISK), "o", color=SERIES[0])
    rings = np.linspace(0.505, 1.6, 200)
    right.plot(rings, [limiting_ratio(Ring(), b) for b in rings], color=SERIES[1])
    right.plot(1, limiting_ratio(Ring(), 1.0), "o", color=SERIES[1])
    right.text(0.53, 0.72, "disk", color=SERIES[0])
    right.text(1.03, 1.05, "hoop", color=SERIES[1])
    right.text(0.70, 0.15, "uniform pressure", color=SERIES[0], fontsize=8)
    right.text(0.62, 1.6, "pressure on the rim", color=SERIES[1], fontsize=8)
    right.axhline(1, color=QUIET, lw=0.5)
    right.set(xlabel=r"$\beta = I/ma^2$", ylabel=r"$v/(a\Omega)$ at the end", ylim=(0, 3))
    return drawing


def report(folder: Path) -> None:
    """The numbers, and the figure."""
    print("Homogeneous disk, uniform pressure: v/(aΩ) at the end")
    print(f"  by F(k) = k M(k)/β: {limiting_ratio(Uniform(), DISK):.10f}")
    for v, spin in ((1.0, 1.0), (1.0, 0.05), (0.05, 1.0)):
        run = slide(v, spin, Uniform())
        print(
            f"  from v = {v}, aΩ = {spin}: {run.ratio:.10f}, at rest after {run.duration:.8f}, "
            f"distance {run.distance:.9f}"
        )
    print("Other inertias I = β m a²")
    for beta in (0.2, 0.3, 0.4, 0.6, 0.7):
        print(f"  β = {beta}: {limiting_ratio(Uniform(), beta):.6g}")
    print(f"Hoop on its rim: {limiting_ratio(Ring(), 1.0):.10f}")
    stone = limiting_ratio(Ring(), DISK + 0.05), limiting_ratio(Ring(), DISK - 0.05)
    print(f"Pressure on the rim, β = 0.55, 0.45: {stone[0]:.6g}, {stone[1]:.6g}")
    with plt.rc_context(STYLE):
        folder.mkdir(parents=True, exist_ok=True)
        figure().savefig(folder / "sliding_disk.png", dpi=160)
    print(f"wrote {folder / 'sliding_disk.png'}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the figure")
    report(parser.parse_args().output)


if __name__ == "__main__":
    main()
