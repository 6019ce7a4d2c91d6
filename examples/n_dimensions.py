"""Motions of the Veselova system in four dimensions: γ projected to planes, and its spectrum.

Three operators of inertia: moments in general position, those of a rigid body (sums of the masses
along two axes), and the products a_i a_j with which the system is integrable.  The first two have
the same integrals known for every inertia, energy and p²; a rigid body has a third one.

Run with::

    python examples/n_dimensions.py                   # numbers
    python examples/n_dimensions.py picture.png       # and the picture
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace
from itertools import combinations

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

from chaplygin import System, from_catalogue, integrate
from chaplygin.report.drawing.style import INK, SERIES, STYLE
from flowlanes.system.arrays import FloatArray

UNTIL, SAMPLES = 2000.0, 2**15
#: γ is shown for this long.
SHOWN = 250.0
GAMMA = np.array([0.2, -0.4, 0.8, -0.4])
#: Share of a line's height from which a line counts.
VISIBLE = 1e-3


@dataclass(frozen=True)
class Case:
    """An operator of inertia with its name and the system."""

    title: str
    system: System


def cases() -> tuple[Case, ...]:
    """General moments, a rigid body, and products."""
    masses, factors = (0.1, 0.4, 0.9, 1.6), (0.5, 0.8, 1.3, 2.1)
    sums = [a + b for a, b in combinations(masses, 2)]
    products = [a * b for a, b in combinations(factors, 2)]
    return (
        Case("general moments", from_catalogue("veselova-nd")),
        Case("a rigid body", from_catalogue("veselova-nd", moments=sums)),
        Case("products", from_catalogue("veselova-nd", moments=products)),
    )


def motion(system: System) -> tuple[FloatArray, FloatArray]:
    """Times, and γ along the motion."""
    gamma = GAMMA / np.linalg.norm(GAMMA)
    p = np.array([1.0, 0.7, 0.2, 0.2])
    p = p - (p @ gamma) * gamma
    times = np.linspace(0.0, UNTIL, SAMPLES)
    # without the attitude, which the equations do not need
    found = integrate(replace(system, reconstruction=None), [*p, *gamma], times)
    return times, np.asarray(found["gamma"], dtype=float)


def spectrum(times: FloatArray, values: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Angular frequencies, and amplitudes relative to the greatest, of a component."""
    window = np.blackman(len(values))
    amplitude = np.abs(np.fft.rfft((values - values.mean()) * window))
    frequency = 2 * np.pi * np.fft.rfftfreq(len(values), times[1] - times[0])
    return frequency, amplitude / amplitude.max()


def filled(amplitude: FloatArray) -> float:
    """The share of frequencies, up to the last visible one, at which something is visible."""
    visible = amplitude > VISIBLE
    return float(visible[: np.flatnonzero(visible)[-1] + 1].mean())


def picture(motions: list[tuple[Case, FloatArray, FloatArray]]) -> Figure:
    """For each case γ in two planes of the body, and the spectrum of γ₁."""
    with plt.rc_context(STYLE):
        figure, rows = plt.subplots(2, 3, figsize=(9.6, 6.0), layout="constrained")
        for column, (case, times, gamma) in enumerate(motions):
            above, below = rows[:, column]
            short = times <= SHOWN
            above.plot(gamma[short, 0], gamma[short, 3], color=SERIES[0], lw=0.4)
            above.set(
                title=case.title,
                xlabel=r"$\gamma_1$",
                ylabel=r"$\gamma_4$",
                xlim=(-1, 1),
                ylim=(-1, 1),
                xticks=(-1, 0, 1),
                yticks=(-1, 0, 1),
            )
            above.set_aspect("equal")
            frequency, amplitude = spectrum(times, gamma[:, 0])
            below.semilogy(frequency, np.maximum(amplitude, 1e-9), color=INK, lw=0.4)
            below.set(xlabel="angular frequency (rad/s)", xlim=(0, 6), ylim=(1e-8, 2))
            if column == 0:
                below.set_ylabel(r"amplitude of $\gamma_1$, relative")
        return figure


def main() -> None:
    """Print the shares of the spectrum, and save the picture."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("picture", nargs="?", help="file of the picture")
    path = parser.parse_args().picture
    motions = [(case, *motion(case.system)) for case in cases()]
    for case, times, gamma in motions:
        _, amplitude = spectrum(times, gamma[:, 0])
        print(f"{case.title}: visible at {filled(amplitude):.1%} of the frequencies")
    if path:
        picture(motions).savefig(path, dpi=150)


if __name__ == "__main__":
    main()
