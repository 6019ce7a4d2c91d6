"""Balls that are rolled along a figure of eight by what is driven inside them.

Four robots of radius 1 m: a marble with three rotors; a marble with two rotors, whose attitude at
the start is left to the planner; a rubber ball with two rotors; and a homogeneous shell with a
pendulum.  The speeds of rotors and joints are found by direct collocation, and each motion is
integrated anew with them.  See ``nonholonomic/docs/control.md``.

Run with::

    python examples/spherical_robot.py -o pictures
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from chaplygin.geometry.view import View, rotation_matrices
from chaplygin.report.drawing.style import ALARM, FAINT, INK, QUIET, SERIES, STYLE, WIDTH
from nonholonomic.control import (
    MotionPlan,
    Rotor,
    SphericalRobot,
    controllability,
    figure_of_eight,
    motion_along,
    pendulum,
)

AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
INERTIA = (0.4, 0.5, 0.6)
FRAMES, RATE = 80, 10
VIEW = View(np.radians(-70), np.radians(32))


@dataclass(frozen=True)
class Task:
    """A robot, the size (m) and period (s) of its figure of eight, and the planner's settings."""

    title: str
    robot: SphericalRobot
    size: float
    period: float
    intervals: int = 40
    free: bool = False

    def plan(self, stages: int = 6, iterations: int = 100) -> MotionPlan:
        """The plan for a figure half as wide as long."""
        return motion_along(
            self.robot,
            figure_of_eight(self.size, self.size / 2, self.period),
            attitude=None if self.free else (1.0, 0.0, 0.0, 0.0),
            intervals=self.intervals,
            stages=stages,
            iterations=iterations,
        )


def with_rotors(count: int, contact: str = "marble") -> SphericalRobot:
    """A ball of 1 kg with rotors along its first principal axes."""
    rotors = tuple(Rotor(axis, 0.1) for axis in AXES[:count])
    return SphericalRobot(1.0, INERTIA, 1.0, rotors, contact)


def with_pendulum() -> SphericalRobot:
    """A homogeneous shell of 1 kg with a bob of 1 kg, half a radius below the centre."""
    return SphericalRobot(1.0, (0.4, 0.4, 0.4), 1.0, moving_mass=pendulum(1.0, 0.5), gravity=9.81)


TASKS = (
    Task("marble, three rotors", with_rotors(3), 4.0, 10.0, intervals=60),
    Task("marble, two rotors", with_rotors(2), 1.0, 10.0, free=True),
    Task("rubber, two rotors", with_rotors(2, "rubber"), 1.5, 10.0),
    Task("marble, pendulum", with_pendulum(), 1.5, 16.0, intervals=50),
)


def still(plans: dict[str, MotionPlan]) -> Figure:
    """Path, inputs and distance to the path of each robot."""
    figure, rows = plt.subplots(
        len(plans), 3, figsize=(WIDTH, 1.5 * len(plans)), layout="constrained", squeeze=False
    )
    for (title, plan), (left, middle, right) in zip(plans.items(), rows, strict=True):
        wanted = plan.path.places(plan.times)
        left.plot(*wanted.T, color=FAINT, lw=4)
        left.plot(*plan.states[:, 4:6].T, color=SERIES[0], lw=0.9)
        left.set(aspect="equal", xlabel="$x$ (m)", ylabel="$y$ (m)")
        left.set_title(title, fontsize=9.5, loc="left")
        fine = np.linspace(0.0, plan.path.period, 801)
        for values, name, colour in zip(plan.inputs_at(fine).T, plan.inputs, SERIES, strict=False):
            middle.plot(fine, values, color=colour, label=_label(name))
        middle.set(xlabel="$t$ (s)", ylabel="rate (rad/s)")
        # above, as the curves take all the room
        key = {"loc": "lower right", "bbox_to_anchor": (1.04, 0.97), "ncols": 3}
        middle.legend(fontsize=8, handlelength=1.0, columnspacing=0.8, **key)
        right.semilogy(plan.times[1:], np.maximum(plan.errors[1:], 1e-16), color=ALARM, lw=0.9)
        right.axhline(1e-6 * plan.path.diameter, color=QUIET, lw=0.6)
        right.set(xlabel="$t$ (s)", ylabel="error (m)", ylim=(1e-15, 1e-4))
    return figure


def _label(name: str) -> str:
    texts = {"theta_rate": r"$\dot\theta$", "phi_rate": r"$\dot\varphi$"}
    return texts.get(name, f"${name}$")


def film(plans: dict[str, MotionPlan], frames: int = FRAMES) -> tuple[Figure, FuncAnimation]:
    """The balls on their way, side by side."""
    figure, sheets = plt.subplots(1, len(plans), figsize=(6.4, 2.7), squeeze=False)
    figure.subplots_adjust(0.0, 0.0, 1.0, 1.0, 0.0, 0.0)

    def draw(number: int) -> list[object]:
        for sheet, (title, plan) in zip(sheets[0], plans.items(), strict=True):
            _frame(sheet, title, plan, number / frames)
        return []

    return figure, FuncAnimation(figure, draw, frames=frames + 1, blit=False)


def _frame(sheet: Axes, title: str, plan: MotionPlan, share: float) -> None:
    """One picture of a robot, at a share of its period."""
    sheet.clear()
    sheet.set_axis_off()
    sheet.set_aspect("equal")
    here = round(share * (len(plan.times) - 1))
    radius, state = plan.robot.radius, plan.states[here]
    turn = rotation_matrices(state[:4])
    centre = np.array([*state[4:6], radius])
    wanted = plan.path.places(np.linspace(0, plan.path.period, 400))
    span = np.abs(wanted).max(axis=0) + 1.25 * radius
    corners = np.array([[x, y, 0.0] for x in (-span[0], span[0]) for y in (-span[1], span[1])])
    flat = VIEW.project(corners)
    sheet.set(
        xlim=(flat[:, 0].min(), flat[:, 0].max()),
        ylim=(flat[:, 1].min(), flat[:, 1].max() + 1.2 * radius),
    )
    _ground(sheet, span)
    _line(sheet, _on_ground(wanted), FAINT, 3.0)
    _line(sheet, _on_ground(plan.states[: here + 1, 4:6]), SERIES[1], 1.4)
    disc = np.linspace(0, 2 * np.pi, 97)
    shadow = np.stack([np.cos(disc), np.sin(disc), 0 * disc], axis=1) * 0.8 * radius
    sheet.fill(*VIEW.project(np.add(shadow, [*state[4:6], 0.0])).T, color=INK, alpha=0.10, lw=0)
    middle = VIEW.project(centre)
    outline = middle + radius * np.stack([np.cos(disc), np.sin(disc)], axis=1)
    glass = plan.robot.moving_mass is not None
    sheet.fill(*outline.T, color="#dbe7f2", alpha=0.55 if glass else 0.92, lw=0)
    for k, axis in enumerate(np.eye(3)):
        circle = np.cos(disc)[:, None] * np.eye(3)[k - 2] + np.sin(disc)[:, None] * np.eye(3)[k - 1]
        spots = radius * circle @ turn.T
        front = VIEW.depth(spots) >= 0
        path = VIEW.project(spots + centre)
        sheet.plot(*np.where(front[:, None], path, np.nan).T, color=SERIES[k], lw=1.3)
        sheet.plot(*np.where(front[:, None], np.nan, path).T, color=SERIES[k], lw=0.5, alpha=0.35)
        pole = radius * turn @ axis
        for side in (pole, -pole):
            if VIEW.depth(side) > 0:
                sheet.plot(*VIEW.project(side + centre), "o", color=SERIES[k], ms=4)
    if plan.robot.moving_mass is not None:
        theta, phi = state[-2:]
        bob = 0.5 * np.array(
            [-np.cos(phi) * np.sin(theta), np.sin(phi), -np.cos(phi) * np.cos(theta)]
        )
        rod = VIEW.project(np.stack([centre, centre + turn @ bob]))
        sheet.plot(*rod.T, color=INK, lw=1.6)
        sheet.plot(*rod[1], "o", color=INK, ms=9)
    sheet.plot(*outline.T, color=QUIET, lw=0.8)
    sheet.text(
        0.03,
        0.96,
        f"{title},  t = {plan.times[here]:4.1f} s",
        transform=sheet.transAxes,
        va="top",
        color=INK,
        fontsize=9.5,
    )


def _ground(sheet: Axes, span: np.ndarray) -> None:
    for x in np.arange(-np.floor(span[0]), span[0]):
        _line(sheet, np.array([[x, -span[1], 0], [x, span[1], 0]]), "#e8edf1", 0.6)
    for y in np.arange(-np.floor(span[1]), span[1]):
        _line(sheet, np.array([[-span[0], y, 0], [span[0], y, 0]]), "#e8edf1", 0.6)


def _line(sheet: Axes, points: np.ndarray, colour: str, width: float) -> None:
    sheet.plot(*VIEW.project(points).T, color=colour, lw=width, solid_capstyle="round")


def _on_ground(places: np.ndarray) -> np.ndarray:
    return np.column_stack([places, np.zeros(len(places))])


def report(folder: Path) -> None:
    """The numbers, the picture and the film."""
    for task in TASKS[:3]:
        print(f"{task.title}: {controllability(task.robot)}")
    plans = {}
    for task in TASKS:
        plans[task.title] = task.plan()
        print(f"{task.title}, {task.size:g} m in {task.period:g} s: {plans[task.title]}")
    folder.mkdir(parents=True, exist_ok=True)
    with plt.rc_context(STYLE):
        still(plans).savefig(folder / "spherical_robot.png", dpi=160)
        shown = {name: plans[name] for name in ("marble, three rotors", "marble, pendulum")}
        figure, moving = film(shown)
        moving.save(folder / "spherical_robot.gif", PillowWriter(fps=RATE), dpi=75)
        plt.close(figure)
    print(f"wrote {folder / 'spherical_robot.png'} and {folder / 'spherical_robot.gif'}")


def main() -> None:
    """Read the command line and write the report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the pictures")
    report(parser.parse_args().output)


if __name__ == "__main__":
    main()
