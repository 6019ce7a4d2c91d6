"""The motions of the experiment files with friction: their numbers, and a figure of each.

Run with::

    python examples/friction_figures.py                 # all
    python examples/friction_figures.py dry_rattleback  # one of them
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from scipy.spatial.transform import Rotation

from chaplygin import Study, load_experiment
from chaplygin.experiment.contact.trajectory import ContactTrajectory
from chaplygin.report.drawing.style import FAINT, INK, QUIET, SERIES, STYLE, WIDTH
from nonholonomic.contact import MODE_NAMES
from nonholonomic.contact.impact.mobility import Mobility, mobility
from nonholonomic.contact.impact.painleve import least_painleve_friction, painleve_margin

EXAMPLES = Path(__file__).parent
GRAVITY = 9.81

Picture = tuple[Figure, list[str]]
"""A figure, and lines with numbers."""


def motion(name: str, *overrides: str) -> ContactTrajectory:
    """The motion of an experiment file."""
    run = Study.from_experiment(load_experiment(EXAMPLES / f"{name}.toml", overrides)).trajectory()
    assert isinstance(run, ContactTrajectory)
    return run


def in_space(run: ContactTrajectory, name: str) -> np.ndarray:
    """A recorded vector (n, 3) in space axes."""
    turn = Rotation.from_quat(run.records["attitude"], scalar_first=True)
    turned: np.ndarray = turn.apply(run.records[name])
    return turned


def shade(axes: plt.Axes, run: ContactTrajectory, mode: str = "rolling") -> None:
    """Grey ground where the contact is in a mode."""
    there = (run.modes == MODE_NAMES.index(mode)).astype(int)
    changes = np.diff(there, prepend=0, append=0)
    ends = np.flatnonzero(changes < 0) - 1
    for first, last in zip(np.flatnonzero(changes > 0), ends, strict=True):
        axes.axvspan(run.times[first], run.times[last], color=FAINT, alpha=0.5, lw=0)


# --- billiards -----------------------------------------------------------------------------------


def parabola_error(run: ContactTrajectory) -> float:
    """Largest distance (m) of the centre from the parabola x₀ + v₀t − ½μg e t² while it slides."""
    mu = next(law.static_mu for law in run.contact.laws)
    sliding = run.times < run.changes[0].time
    times = run.times[sliding, None]
    slip, velocity = in_space(run, "slip")[0], run.records["velocity"][0]
    e = slip / np.linalg.norm(slip)
    centre = run.records["centre"]
    path = centre[0] + velocity * times - 0.5 * mu * GRAVITY * e * times**2
    return float(np.linalg.norm(path - centre[sliding], axis=1).max())


def billiard_ball() -> Picture:
    """The path of the centre: a parabola, then a straight line."""
    run = motion("billiard_ball")
    stick, slip = run.changes[0].time, float(np.linalg.norm(run.records["slip"][0]))
    closed = 2 * slip / (7 * 0.2 * GRAVITY)
    centre = run.records["centre"]
    sliding = run.times <= stick
    drawing, axes = plt.subplots(figsize=(WIDTH, 2.4), layout="constrained")
    axes.plot(*centre[sliding, :2].T, color=SERIES[1], label="slides, on a parabola")
    axes.plot(*centre[~sliding, :2].T, color=SERIES[0], label="rolls, straight on")
    axes.plot(*centre[0, :2], "o", color=INK)
    axes.plot([0, centre[sliding, 0].max() * 1.5], [0, 0], color=QUIET, lw=0.6, ls=":")
    axes.set(xlabel="$x$ (m)", ylabel="$y$ (m)", aspect="equal")
    axes.legend(loc="upper left")
    return drawing, [
        f"rolls from t = {stick:.13f} s; 2|u|/(7μg) = {closed:.13f} s",
        f"largest distance from the parabola {parabola_error(run):.1e} m",
    ]


# --- a stone -------------------------------------------------------------------------------------


def dry_rattleback() -> Picture:
    """The spin of the stone on a rough table and where it never slips."""
    run = motion("dry_rattleback")
    rough = motion("dry_rattleback", "contact.mu=inf")
    drawing, (top, low) = plt.subplots(
        2, 1, figsize=(WIDTH, 3.6), layout="constrained", sharex=True, height_ratios=(1.3, 1)
    )
    for axes in (top, low):
        shade(axes, run)
    top.plot(rough.times, rough.records["spin"], color=QUIET, label="without slip")
    top.plot(
        run.times, run.records["spin"], color=SERIES[0], label=r"$\mu = 0.3$; grey where it rolls"
    )
    top.set_ylabel("spin (rad/s)")
    top.legend()
    low.plot(run.times, np.linalg.norm(run.records["slip"], axis=1), color=SERIES[1])
    low.set(xlabel="time (s)", ylabel="slip (m/s)")
    early = [event for event in run.changes if event.time <= 0.5]
    force = np.linalg.norm(rough.records["friction_force"], axis=1)
    needed = force / rough.records["normal_force"]
    lines = [
        f"{len(early)} changes in 0.5 s, first {early[0].time:.9f} s, last {early[-1].time:.9f} s",
        f"{len(run.changes)} changes in {run.times[-1]:g} s; energy balance to {run.drift:.1e}",
        f"largest slip {np.linalg.norm(run.records['slip'], axis=1).max():.4f} m/s",
        f"without slip friction is at most {needed.max():.4f} times the normal force",
    ]
    return drawing, lines


def rising_egg() -> Picture:
    """The inclination of the egg, and its height above the table."""
    run = motion("rising_egg")
    drawing, (top, low) = plt.subplots(
        2, 1, figsize=(WIDTH, 3.4), layout="constrained", sharex=True
    )
    top.plot(run.times, run.records["gamma"][:, 2], color=SERIES[0])
    top.set_ylabel(r"height of the axis $\gamma_3$")
    gap = 1e6 * np.maximum(run.records["gap"], 0)
    low.plot(run.times, gap, color=SERIES[1])
    low.set(xlabel="time (s)", ylabel="gap (µm)")
    flights = [
        (a, b)
        for a, b in zip(run.changes, run.changes[1:], strict=False)
        if (a.kind, b.kind) == ("lift-off", "landing")
    ]
    lines = []
    for leave, land in flights:
        there = (run.times >= leave.time) & (run.times <= land.time)
        lines.append(
            f"flies from {leave.time:.9f} s (γ₃ = {leave.after[15]:.4f}) to {land.time:.9f} s, "
            f"up to {gap[there].max():.2f} µm"
        )
    first = run.states[0]
    for spin in (100, 120, 200):
        share = spin / 150
        other = motion(
            "rising_egg",
            f"start.velocity={(share * run.records['velocity'][0]).tolist()}",
            f"start.omega={(share * first[10:13]).tolist()}",
            "run.until=2.0",
            "run.samples=101",
        )
        lines.append(f"with {spin} rad/s: first change {other.changes[0]}")
    return drawing, lines


# --- bounces -------------------------------------------------------------------------------------


def superball() -> Picture:
    """The path of a ball thrown with back spin, and its spin."""
    run = motion("superball")
    first, after = run.changes[0], run.changes[0].after
    drop, e, radius, inertia = 0.775, 0.9, 0.025, 2 / 5
    v, omega = 1.0, -250.0
    held = (v + inertia * radius * omega) / (1 + inertia)
    turn = Rotation.from_quat(after[:4], scalar_first=True)
    velocity, spin = turn.apply(after[7:10]), turn.apply(after[10:13])
    end = math.sqrt(2 * drop / GRAVITY) * (1 + e) / (1 - e)
    rest = next((event for event in run.changes if event.mode != "flight"), None)
    drawing, (left, right) = plt.subplots(
        1, 2, figsize=(WIDTH, 2.7), layout="constrained", width_ratios=(1.5, 1)
    )
    centre = run.records["centre"]
    left.plot(centre[:, 0], centre[:, 2], color=SERIES[0])
    left.plot(centre[0, 0], centre[0, 2], "o", color=INK)
    left.set(xlabel="$x$ (m)", ylabel="$z$ (m)", ylim=(0, None))
    right.plot(run.times, run.records["velocity"][:, 2], color=SERIES[0])
    right.set(xlabel="time (s)", ylabel="vertical velocity (m/s)")
    lines = [
        f"first landing {first.time:.12f} s, √(2h/g) = {math.sqrt(2 * drop / GRAVITY):.12f} s",
        f"then v = {velocity[0]:.12f} m/s; held by the floor (v + κRω)/(1 + κ) = {held:.12f}",
        f"and Rω = {radius * spin[1]:.12f} m/s; perfectly elastic also along the floor, v would be "
        f"{v - 2 * (v - radius * omega) * inertia / (1 + inertia):.6f} m/s",
    ]
    if rest is not None:
        lines.append(
            f"the last of {len(run.changes)} landings at {rest.time:.7f} s, "
            f"√(2h/g)(1 + e)/(1 − e) = {end:.7f} s"
        )
    return drawing, lines


def bouncing_pebble() -> Picture:
    """Height of the centre of mass of a pebble, and its energy, under the three impact laws."""
    drawing, (top, low) = plt.subplots(
        2, 1, figsize=(WIDTH, 3.6), layout="constrained", sharex=True
    )
    lines = []
    for law, colour in zip(("stronge", "poisson", "newton"), SERIES, strict=False):
        run = motion("bouncing_pebble", f"contact.impact_law={law}")
        top.plot(run.times, run.records["centre"][:, 2], color=colour, label=law.capitalize())
        low.plot(run.times, 1e3 * run.records["energy"], color=colour)
        landings = [event for event in run.changes if event.kind == "landing"]
        stay = next((event for event in landings if event.mode != "flight"), None)
        second = f"second landing {landings[1].time:.9f} s"
        lines.append(
            f"{law}: {second}, {len(landings)} landings"
            + (f", the last at {stay.time:.7f} s" if stay else "")
            + f"; energy balance to {run.drift:.1e}"
        )
    top.set_ylabel("centre of mass (m)")
    top.legend(ncols=3)
    low.set(xlabel="time (s)", ylabel="energy (mJ)", ylim=(0, None))
    return drawing, lines


# --- friction over a patch -----------------------------------------------------------------------


def final_exponent(run: ContactTrajectory) -> float:
    """λ of |u| ∝ (t₁ − t)^λ before sliding and spinning end together at t₁."""
    slip = np.linalg.norm(run.records["slip"], axis=1)
    there = (slip > 1e-11) & (slip < 1e-7)
    left = run.changes[0].time - run.times[there]
    return float(np.polyfit(np.log(left), np.log(slip[there]), 1)[0])


def contensou_ball() -> Picture:
    """Slip and spin of a ball as they end together."""
    run = motion("contensou_ball", "run.samples=20001")
    end, patch = run.changes[0].time, 0.06
    slip = np.linalg.norm(run.records["slip"], axis=1)
    spin = patch * np.abs(run.records["spin"])
    left_time = end - run.times
    drawing, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 2.7), layout="constrained")
    for values, colour, words in ((slip, SERIES[0], "slip"), (spin, SERIES[1], r"$a\Omega$")):
        left.plot(run.times, values, color=colour, label=words)
        there = (left_time > 0) & (values > 1e-14)
        right.loglog(left_time[there], values[there], color=colour)
    left.set(xlabel="time (s)", ylabel="speed (m/s)", xlim=(0, 0.4))
    left.legend()
    right.set(xlabel="time to the end (s)", ylabel="speed (m/s)", ylim=(1e-13, None))
    expected = 14 / 5 * (0.1 / patch) ** 2
    return drawing, [
        f"both end at t = {end:.10f} s: {run.changes[0].kind}, then {run.changes[0].mode}",
        f"slip ∝ (t₁ − t)^{final_exponent(run):.4f}; (14/5)(R/a)² = {expected:.4f}",
    ]


# --- supports that fall away or turn -------------------------------------------------------------


def angle_on_dome(state: np.ndarray) -> float:
    """Angle (degrees) of the centre of the ball from the vertical."""
    return math.degrees(math.atan2(math.hypot(*state[4:6]), state[6]))


def ball_on_a_dome() -> Picture:
    """The normal force and the slip of a ball that leaves a dome, for several coefficients."""
    drawing, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 2.7), layout="constrained")
    lines = []
    for mu, colour in zip((0.1, 0.2, 0.4, 1.0), SERIES, strict=False):
        run = motion("ball_on_a_dome", f"contact.mu={mu}", "run.samples=2001")
        slips, leaves = (e for e in run.changes if e.kind in ("slip", "lift-off"))
        places = np.degrees(np.arctan2(run.records["centre"][:, 0], run.records["centre"][:, 2]))
        there = run.times <= leaves.time
        left.plot(places[there], run.records["normal_force"][there], color=colour)
        slip = np.linalg.norm(run.records["slip"], axis=1)
        right.plot(places[there], slip[there], color=colour, label=rf"$\mu = {mu}$")
        lines.append(
            f"μ = {mu}: slides from {angle_on_dome(slips.before):.4f}°, "
            f"leaves at {angle_on_dome(leaves.before):.4f}°"
        )
    left.set(xlabel="angle from the top (degrees)", ylabel="normal force (N)", ylim=(0, None))
    right.set(xlabel="angle from the top (degrees)", ylabel="slip (m/s)")
    right.legend()
    lines.append(f"rolling to its end it would leave at {math.degrees(math.acos(10 / 17)):.4f}°")
    return drawing, lines


def circling_rate(run: ContactTrajectory) -> float:
    """Rate (rad/s) at which the velocity of a ball that rolls turns round."""
    rolling = run.modes == MODE_NAMES.index("rolling")
    velocity = run.records["velocity"][rolling]
    angle = np.unwrap(np.arctan2(velocity[:, 1], velocity[:, 0]))
    return float((angle[-1] - angle[0]) / np.ptp(run.times[rolling]))


def ball_on_a_turntable() -> Picture:
    """The path of a ball on a turning table."""
    run = motion("ball_on_a_turntable")
    centre, stick = run.records["centre"], run.changes[0].time
    sliding = run.times <= stick
    drawing, axes = plt.subplots(figsize=(0.6 * WIDTH, 3.4), layout="constrained")
    axes.plot(*centre[~sliding, :2].T, color=SERIES[0], label="rolls")
    axes.plot(*centre[sliding, :2].T, color=SERIES[1], lw=2, label="slides")
    axes.plot(0, 0, "+", color=QUIET, ms=8)
    axes.plot(*centre[0, :2], "o", color=INK)
    axes.set(xlabel="$x$ (m)", ylabel="$y$ (m)", aspect="equal")
    axes.legend(loc="upper right")
    ratio = circling_rate(run) / 3.0
    held = np.linalg.norm(run.records["friction_force"][~sliding], axis=1)
    speed = np.linalg.norm(run.records["velocity"][~sliding], axis=1)
    return drawing, [
        f"rolls from t = {stick:.9f} s",
        f"then circles at {ratio:.12f} of the table's rate, 2/7 = {2 / 7:.12f}",
        f"friction / (m v Ω) = {np.mean(held / speed) / 3.0:.12f}",
    ]


def ball_in_a_turning_bowl() -> Picture:
    """The height of a ball in a turning bowl, and its path from above."""
    run = motion("ball_in_a_turning_bowl")
    centre = run.records["centre"]
    drawing, (left, right) = plt.subplots(
        1, 2, figsize=(WIDTH, 2.9), layout="constrained", width_ratios=(1.5, 1)
    )
    shade(left, run)
    left.plot(run.times, 0.3 + centre[:, 2] - 0.02, color=SERIES[0])
    left.set(xlabel="time (s); grey where it rolls", ylabel="height above the lowest place (m)")
    right.plot(*centre[:, :2].T, color=SERIES[0], lw=0.6)
    right.set(xlabel="$x$ (m)", ylabel="$y$ (m)", aspect="equal")
    kinds = ", ".join(f"{number} {kind}" for kind, number in run.kinds.items())
    height = 0.28 + centre[:, 2]
    swings = np.flatnonzero((height[1:-1] < height[:-2]) & (height[1:-1] < height[2:])) + 1
    lowest = height[swings]
    return drawing, [
        f"{len(run.changes)} changes ({kinds}), the first at {run.changes[0].time:.9f} s",
        f"lowest height in the first swing {1e3 * lowest[0]:.2f} mm, "
        f"in the last of {len(lowest)} {1e3 * lowest[-1]:.2f} mm",
    ]


# --- Painlevé ------------------------------------------------------------------------------------


def spheroid(lean: float) -> tuple[np.ndarray, np.ndarray]:
    """γ and the direction up the projection of the long axis, body axes, for the axis at a lean."""
    gamma = np.array([0.0, math.cos(lean), math.sin(lean)])
    return gamma, np.array([0.0, -math.sin(lean), math.cos(lean)])


def touching(lean: float) -> Mobility:
    """What forces at the contact do to the spheroid 5 : 1."""
    axes = np.array([0.2, 0.2, 1.0])
    gamma, _ = spheroid(lean)
    contact = -(axes**2) * gamma / np.linalg.norm(axes * gamma)
    return mobility(1.0, (axes @ axes - axes**2) / 5, contact, gamma)


def margin(lean: float, side: float, mu: float = 1.9) -> float:
    """B of the sliding spheroid: normal acceleration of the contact per normal force."""
    return painleve_margin(touching(lean), side * spheroid(lean)[1], mu)


def without_collision(lean: float = 1.1621, mu: float = 1.9) -> tuple[np.ndarray, ...]:
    """Normal impulse, and velocity of the contact along and across the table, in the impact.

    It slides 1 m/s against the lean; friction stops it, and holds it until it no longer sinks.
    """
    gamma, along = spheroid(lean)
    A = touching(lean).A
    sliding = A @ (gamma + mu * along)  # change of the velocity per impulse
    held = A @ (gamma - along * (along @ A @ gamma) / (along @ A @ along))
    stop = 1 / (along @ sliding)
    sunk = stop * (gamma @ sliding)
    end = stop - sunk / (gamma @ held)
    return np.array([0, stop, end]), np.array([-1.0, 0, 0]), np.array([0, sunk, 0])


def painleve() -> Picture:
    """B for both directions of sliding, and the motion after the impact without collision."""
    run = motion("painleve")
    event = run.changes[0]
    leans = np.linspace(0.05, math.pi / 2 - 0.01, 300)
    drawing, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 2.7), layout="constrained")
    left.axhline(0, color=QUIET, lw=0.6)
    for side, colour, words in ((-1, SERIES[1], "against the lean"), (1, SERIES[0], "along it")):
        left.plot(leans, [margin(a, side) for a in leans], color=colour, label=words)
    left.plot(1.1621, margin(1.1621, -1), "o", color=SERIES[1])
    left.set(xlabel="axis above the table (rad)", ylabel="$B$ (1/kg)")
    left.legend()
    impulses, sliding, normal = without_collision()
    right.axhline(0, color=QUIET, lw=0.6)
    right.plot(impulses, sliding, color=SERIES[1], label="along the table")
    right.plot(impulses, normal, color=SERIES[0], label="upwards")
    right.set(xlabel="impulse of the normal force (N s)", ylabel="velocity of the contact (m/s)")
    right.legend()
    slip = run.records["slip"]
    before, after = event.before, event.after
    turn = Rotation.from_quat(after[:4], scalar_first=True)
    impulse = turn.apply(event.impulse)
    lines = [
        f"B = {margin(1.1621, -1):.5f} /kg against the lean, {margin(1.1621, 1):.5f} along it",
        f"at t = {event.time:g} s: {event.kind}, then {event.mode}",
        f"impulse along and across the table {math.hypot(*impulse[:2]):.6f}, {impulse[2]:.6f} N s",
        f"energy lost {after[16] - before[16]:.6f} J",
        f"slip afterwards {np.linalg.norm(slip[0]):.1e} m/s",
    ]
    lines.append(f"least μ at this lean {least_painleve_friction(touching(1.1621)):.5f}")
    return drawing, lines


# --- all -----------------------------------------------------------------------------------------

PICTURES: dict[str, Callable[[], Picture]] = {
    function.__name__: function
    for function in (
        billiard_ball,
        dry_rattleback,
        rising_egg,
        superball,
        bouncing_pebble,
        contensou_ball,
        ball_on_a_dome,
        ball_on_a_turntable,
        ball_in_a_turning_bowl,
        painleve,
    )
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help=f"of {', '.join(PICTURES)}; all by default")
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the figures")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    for name in options.names or PICTURES:
        with plt.rc_context(STYLE):
            drawing, lines = PICTURES[name]()
            drawing.savefig(options.output / f"{name}.png", dpi=160)
        print(name, *lines, sep="\n  ")


if __name__ == "__main__":
    main()
