"""A heavy rubber disk followed in closed form: its path on the plane, early and late.

The inclination θ of the disk is a periodic function of the time; one period turns the path about
the vertical by a fixed angle and displaces it by a fixed vector.  So the state at any time costs as
much as the state at the beginning.  The path is drawn for the first half minute, and for half a
minute after eleven days.

    python examples/disk_closed_form.py
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from chaplygin import Body, Disk, Forces, RollingBody, initial_state
from chaplygin.report import figures
from chaplygin.report.drawing.style import COMPONENTS, INK, STYLE, WIDTH
from nonholonomic import Solution
from nonholonomic.closed_form import revolution_diagram
from nonholonomic.closed_form.revolution import solve_rolling

#: A homogeneous disk: kg, m.
DISK = RollingBody(Body(1.0, (0.25, 0.25, 0.5), Disk(1.0)), contact="rubber", field=Forces(9.81))
OMEGA, GAMMA = (0.4, 0.8, 2.0), (1.0, -0.5, 0.0)

#: Seconds.
EARLY, LATE, LENGTH = 0.0, 1e6, 30.0


def closed_form() -> Solution:
    """The motion of the disk."""
    system = DISK.system("disk", "Rubber disk")
    solution = solve_rolling(DISK, system, initial_state(system, OMEGA, GAMMA))
    assert solution is not None
    return solution


def paths(solution: Solution) -> Figure:
    """The path of the centre of mass in two windows of time."""
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, WIDTH / 2), layout="constrained")
        for axes, begin in zip(figure.subplots(1, 2), (EARLY, LATE), strict=True):
            x, y = solution(np.linspace(begin, begin + LENGTH, 2000))["place"].T
            axes.plot(x, y, color=COMPONENTS[0])
            axes.plot(x[:1], y[:1], "o", color=INK)
            axes.set_aspect("equal", "datalim")
            axes.set_title(f"{LENGTH:g} s from t = {begin:g} s", loc="left")
            axes.set_xlabel("x (m)")
            axes.set_ylabel("y (m)")
    return figure


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the closed form, and draw the path and the bifurcation diagram."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path("disk_closed_form"))
    output = parser.parse_args(arguments).output
    solution = closed_form()
    print(solution.form.motion)
    for constant in solution.form.constants:
        print(f"{constant.meaning:40s} {constant.value.str(20, radius=False)} {constant.unit}")
    print("omega and gamma at t = 10^12 s:")
    print("  ", ", ".join(ball.str(12) for ball in solution.rigorous(10**12, 20)[:6]))
    output.mkdir(parents=True, exist_ok=True)
    paths(solution).savefig(output / "paths.svg")
    h, K = (float(constant.value) for constant in solution.form.constants[:2])
    diagram = revolution_diagram(DISK, np.linspace(0.05, 5.0, 120))
    figures.revolution_diagram(diagram, [(h, K)]).savefig(output / "diagram.svg")


if __name__ == "__main__":
    main()
