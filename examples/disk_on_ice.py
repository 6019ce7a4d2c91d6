"""A disk on ice whose sharp edge holds up to a limit only.

The edge resists a slip across it with a force of at most mu N; along it the disk glides freely.
While the edge holds, this is the disk on ice of the catalogue; where the force that it needs
reaches mu N the disk slips sideways, until the slip ends or turns back.

Run with::

    python examples/disk_on_ice.py
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from matplotlib.figure import Figure

from chaplygin import Parameter, System, integrate
from chaplygin.report.drawing.style import FAINT, SERIES, STYLE, WIDTH
from flowlanes.system import Guard, real_symbol
from flowlanes.system.system import Observable
from flowlanes.system.vectors import constant, norm_squared, vectors

VALUES = {"m": 1.0, "R": 1.0, "I_1": 0.25, "I_3": 0.5, "g": 9.81}
START = {"omega": (0.3, 0.4, 6.0), "gamma": (0.8, 0.2, 0.5656854249492381), "V": -2.0}

omega, gamma, v = vectors("omega gamma v")
m, R, I_1, I_3, g, mu, way = (real_symbol(n) for n in [*VALUES, "mu", "way"])
N, f, lost = real_symbol("N"), real_symbol("f"), real_symbol("lost")

#: A slip (m/s) so small that rounding decides its sign.
FLOOR = 1e-13

_w, _n, _v = (sp.Matrix(x.symbols) for x in (omega, gamma, v))
_s = sp.sqrt(1 - _n[2] ** 2)
_along = _n.cross(sp.Matrix([0, 0, 1])) / _s
_across = _along.cross(_n)
_arm = -R * (_n - _n[2] * sp.Matrix([0, 0, 1])) / _s
_point = _v + _w.cross(_arm)
SLIP = _point.dot(_across)
_inertia = sp.diag(I_1, I_1, I_3)
ENERGY = (m * _v.dot(_v) + _w.dot(_inertia * _w)) / 2 + m * g * R * _s


@cache
def disk(holds: bool) -> System:
    """The disk while its edge holds, or while it slips the way `way` (1 or -1) across it."""
    force = N * _n + f * _across
    rates = (
        _inertia.inv() * ((_inertia * _w).cross(_w) + _arm.cross(force)),
        _n.cross(_w),
        _v.cross(_w) + force / m - g * _n,
    )

    def rate(formula: sp.Expr) -> sp.Expr:
        pairs = zip((_w, _n, _v), rates, strict=True)
        return sum(formula.diff(x) * r for xs, rs in pairs for x, r in zip(xs, rs, strict=True))

    # the contact lasts, and the edge holds or its force is at the limit
    rows = [rate(_point.dot(_n)), rate(SLIP) if holds else f + way * mu * N]
    a, b = ([row.diff(x) for x in (N, f)] for row in rows)
    free = [row.subs({N: 0, f: 0}) for row in rows]
    determinant = a[0] * b[1] - a[1] * b[0]
    margin = mu**2 * N**2 - f**2 if holds else way * SLIP + FLOOR
    return System(
        name="disk-on-ice-with-grip",
        title="Disk on ice with limited grip",
        summary="A disk on ice whose edge holds up to a limit.",
        source="§11.3",
        parameters=tuple(
            Parameter(s, f"parameter {s}", VALUES.get(str(s), 1.0))
            for s in (m, R, I_1, I_3, g, mu, way)
        ),
        definitions={
            N: (a[1] * free[1] - b[1] * free[0]) / determinant,
            f: (b[0] * free[0] - a[0] * free[1]) / determinant,
        },
        field={
            **{x: constant(list(r)) for x, r in zip((omega, gamma, v), rates, strict=True)},
            lost: -f * SLIP,
        },
        relations=(norm_squared(gamma) - 1,),
        observables=(
            Observable("normal_force", N, "normal force", "N"),
            Observable("edge_force", f, "force across the edge", "N"),
            Observable("slip", SLIP, "slip across the edge", "m/s"),
            Observable("total", ENERGY + lost, "energy with what friction took", "J"),
        ),
        guards=(
            Guard("grip", margin, "the edge slips" if holds else "the slip ends"),
            Guard("contact", N, "the disk leaves the ice"),
        ),
    )


@dataclass(frozen=True)
class Motion:
    """Samples of a motion, whether the edge holds at them, and its changes with their times."""

    samples: dict[str, np.ndarray]
    holds: np.ndarray
    changes: tuple[tuple[float, str], ...]


def start() -> dict[str, object]:
    """The start of the disk on ice of the catalogue, with the velocity of the centre."""
    w, n = np.array(START["omega"]), np.array(START["gamma"])
    along = np.cross(n, (0, 0, 1)) / np.sqrt(1 - n[2] ** 2)
    velocity = START["V"] * along + VALUES["R"] * (w @ along) * np.array([0.0, 0.0, 1.0])
    return {"omega": tuple(w), "gamma": tuple(n), "v": tuple(velocity), "lost": 0.0}


def across(normal: np.ndarray) -> np.ndarray:
    """The horizontal direction across the edge, body axes."""
    along = np.cross(normal, (0, 0, 1)) / np.sqrt(1 - normal[2] ** 2)
    direction: np.ndarray = np.cross(along, normal)
    return direction


def needed(state: dict[str, object]) -> float:
    """The force across the edge that holds it, over the normal force."""
    there = integrate(disk(True), state, [0.0, 1e-6], parameters={"mu": 1e6})
    return float(there["edge_force"][0] / there["normal_force"][0])


def motion(grip: float, until: float, samples: int = 2001) -> Motion:
    """The motion with a coefficient of grip, from the start of the catalogue."""
    times, state, now = np.linspace(0, until, samples), start(), 0.0
    holds, sign = abs(needed(state)) <= grip, -float(np.sign(needed(state)))
    pieces, marks, changes = [], [], []
    while now < until:
        values = {"mu": grip, "way": sign}
        wanted = np.concatenate([[now], times[times > now]])
        run = integrate(disk(holds), state, wanted, parameters=values)
        pieces.append(run)
        marks.append(np.full(len(run.times), holds))
        now = float(run.times[-1])
        if not run.events:
            break
        state = {name: run[name][-1] for name in ("omega", "gamma", "v", "lost")}
        if run.events[-1].guard.name == "contact":
            changes.append((now, "leaves"))
            break
        if holds:
            holds, sign = False, -float(np.sign(run["edge_force"][-1]))
            changes.append((now, "slips"))
            continue
        state["v"] = state["v"] - run["slip"][-1] * across(state["gamma"])
        need = needed(state)
        holds, sign = abs(need) <= grip, -float(np.sign(need))
        changes.append((now, "holds" if holds else "turns back"))
    names = ("normal_force", "edge_force", "slip", "total", "gamma", "omega")
    joined = {name: np.concatenate([run[name] for run in pieces]) for name in names}
    joined["time"] = np.concatenate([run.times for run in pieces])
    return Motion(joined, np.concatenate(marks), tuple(changes))


def figure(found: Motion, grip: float) -> Figure:
    """Slip across the edge, and the force over its limit; grey where the edge slips."""
    drawing, (top, low) = plt.subplots(
        2, 1, figsize=(WIDTH, 3.4), layout="constrained", sharex=True
    )
    t, x = found.samples["time"], found.samples
    ends = np.flatnonzero(np.diff(found.holds.astype(int), prepend=1, append=1))
    for first, last in zip(ends[::2], ends[1::2], strict=True):
        for axes in (top, low):
            axes.axvspan(t[first], t[min(last, len(t) - 1)], color=FAINT, alpha=0.5, lw=0)
    top.plot(t, x["slip"], color=SERIES[1])
    top.set_ylabel("slip across (m/s)")
    low.plot(t, np.abs(x["edge_force"]) / (grip * x["normal_force"]), color=SERIES[0])
    low.set(xlabel="time (s)", ylabel=r"$|f|/\mu N$")
    return drawing


def main() -> None:
    """Print the changes, and draw the figure."""
    words = argparse.ArgumentParser(description=__doc__)
    words.add_argument("-o", "--output", type=Path, default=Path(), metavar="FOLDER")
    folder = words.parse_args().output
    folder.mkdir(parents=True, exist_ok=True)
    grip, until = 0.4, 4.0
    found = motion(grip, until)
    for time, what in found.changes:
        print(f"{time:.9f} s: {what}")
    total = found.samples["total"]
    print(f"energy with what friction took: constant to {np.ptp(total) / total[0]:.1e}")
    need = motion(1e3, until).samples
    print(f"to hold always: mu = {np.abs(need['edge_force'] / need['normal_force']).max():.4f}")
    with plt.rc_context(STYLE):
        figure(found, grip).savefig(folder / "disk_on_ice.png", dpi=160)


if __name__ == "__main__":
    main()
