"""Figures of the Whipple bicycle."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

from chaplygin import Trajectory
from chaplygin.report.drawing.style import FAINT, QUIET, SERIES, WIDTH


def eigenvalue_figure(
    speeds: np.ndarray, eigenvalues: Sequence[Sequence[Any]], marks: tuple[float, float]
) -> Figure:
    """Real and imaginary parts of the eigenvalues against the speed; stable between the marks."""
    figure, axes = plt.subplots(figsize=(WIDTH, 3.6), layout="constrained")
    for i in range(4):
        real = np.array([float(values[i].real) for values in eigenvalues])
        turning = np.array([float(values[i].imag) for values in eigenvalues])
        moving = turning > 0
        axes.plot(speeds[moving], turning[moving], ".", color=FAINT, markersize=3.5)
        axes.plot(speeds[moving], real[moving], ".", color=SERIES[0], markersize=3.5)
        axes.plot(speeds[turning == 0], real[turning == 0], ".", color=SERIES[1], markersize=3.5)
    axes.axhline(0.0, color=QUIET, linewidth=0.6)
    axes.axvspan(*marks, color=SERIES[2], alpha=0.12, linewidth=0)
    axes.set(xlim=(0, 10), ylim=(-10, 10), xlabel="speed (m/s)", ylabel="eigenvalue (1/s)")
    middle = sum(marks) / 2
    axes.text(middle, 8.6, "stable", ha="center", color=SERIES[2])
    axes.text(1.3, 3.6, "weave, growth", color=SERIES[0])
    axes.text(7.9, 7.2, "weave, frequency", color=QUIET)
    axes.text(7.2, 0.5, "capsize", color=SERIES[1])
    axes.text(2.6, -8.6, "castering", color=SERIES[1])
    return figure


def column(run: Trajectory, name: str) -> np.ndarray:
    """One variable of the state along a run."""
    return run.states[:, list(map(str, run.system.symbols)).index(name)]


def run_figure(run: Trajectory) -> Figure:
    """Lean, steering angle, speed and path of a run, and how well it keeps its energy."""
    figure, axes = plt.subplots(4, 1, figsize=(WIDTH, 6.4), layout="constrained")
    energy = run.records["law_energy"]
    axes[0].plot(run.times, np.degrees(run.records["lean"]), color=SERIES[0], label="lean")
    axes[0].plot(run.times, np.degrees(column(run, "delta")), color=SERIES[1], label="steer")
    axes[0].set_ylabel("degrees")
    axes[0].legend(loc="upper right")
    axes[1].plot(run.times, run.records["speed"], color=SERIES[2])
    axes[1].set_ylabel("speed (m/s)")
    axes[2].plot(run.times, energy / energy[0] - 1, color=SERIES[5])
    axes[2].set(ylabel="energy, change", xlabel="time (s)")
    for above in axes[:2]:
        above.sharex(axes[2])
        above.tick_params(labelbottom=False)
    # seen from above: to the right of the rider is downward
    axes[3].plot(column(run, "x"), column(run, "y"), color=SERIES[0])
    axes[3].set(xlabel="rear hub, forward (m)", ylabel="to the left (m)")
    figure.align_ylabels()
    return figure
