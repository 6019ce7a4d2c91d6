"""Sections of the Chaplygin ball with rotors, in Bruns' field, and with both.

All motions of a panel have the energy and the area constant of examples/combinations/ball_on_plane.
With rotors or with the field alone every motion stays on curves of the section γ₃ = 0; with both
most of them scatter.

    python examples/combinations_sections.py -o docs/pictures
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

from chaplygin import PoincareMap, from_catalogue
from chaplygin.report.drawing.style import SERIES, STYLE, WIDTH
from flowlanes import poincare_section, sample_level
from flowlanes.system.arrays import FloatArray

NUMBERS = {"m": 0.8, "R": 1.0, "I_1": 1.0, "I_2": 1.6, "I_3": 2.3}
ROTORS = {"k_1": 0.6, "k_2": 0.4, "k_3": -0.8}
CASES = {
    "rotors": ("chaplygin-ball-gyrostat", {**NUMBERS, **ROTORS}),
    "Bruns' field": ("chaplygin-ball-bruns", {**NUMBERS, "K": 3.0}),
    "both": ("chaplygin-ball-gyrostat-bruns", {**NUMBERS, **ROTORS, "K": 3.0}),
}
LEVEL = {"energy": 6.0, "area": 1.0}
STARTS, RETURNS, SEED = 14, 400, 3


def points(name: str, numbers: dict[str, float]) -> FloatArray:
    """φ, M₃ of the returns, shape (starts, returns, 2); (γ₁, γ₂) = (sin φ, cos φ)."""
    system = from_catalogue(name, **numbers)
    starts = sample_level(system, STARTS, LEVEL, seed=SEED)
    section = PoincareMap(system, poincare_section(system, "gamma_3"))
    states = section.crossings(starts, RETURNS).states
    return np.stack([np.arctan2(states[..., 3], states[..., 4]), states[..., 2]], axis=-1)


def figure() -> Figure:
    """The three sections."""
    drawing, axes = plt.subplots(1, 3, figsize=(WIDTH, 3.0), sharey=True, layout="constrained")
    for panel, (title, (name, numbers)) in zip(axes, CASES.items(), strict=True):
        for number, one in enumerate(points(name, numbers)):
            colour = SERIES[number % len(SERIES)]
            panel.scatter(*one.T, color=colour, s=0.6, lw=0, rasterized=True)
        panel.set_title(title, fontsize=10)
        panel.set(xlim=(-np.pi, np.pi), xlabel=r"$\varphi$ (rad)")
        panel.set_xticks([-np.pi, 0, np.pi], [r"$-\pi$", "0", r"$\pi$"])
    axes[0].set_ylabel(r"$M_3$ (kg m$^2$/s)")
    return drawing


def main(arguments: Sequence[str] | None = None) -> None:
    """Draw the figure."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the figure")
    folder = parser.parse_args(arguments).output
    with plt.rc_context(STYLE):
        folder.mkdir(parents=True, exist_ok=True)
        figure().savefig(folder / "combinations_sections.png", dpi=120)
    print(f"wrote {folder / 'combinations_sections.png'}")


if __name__ == "__main__":
    main()
