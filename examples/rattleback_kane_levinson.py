"""The rattleback of Kane and Levinson: when it turns back, with and without dissipation.

T. R. Kane and D. A. Levinson, "Realistic mathematical modeling of the rattleback", International
Journal of Non-Linear Mechanics 17 (1982) 175–186.  A half-ellipsoid whose principal axes of inertia
are turned by less than one degree against its axes of symmetry is spun at 5 rad/s, slightly tilted;
it begins to rattle, stops, and turns the other way.

Conventions.  Roll α about the long axis 1 and pitch β about the short axis 2 are the first two of
the angles of successive turns about body axes 1, 2, 3 by which the paper describes the attitude, in
its equations (37) and (40)–(42); the vertical seen from the body is
(−cos α sin β, sin α, cos α cos β).  Spin is the angular velocity about the body's axis 3,
ω = (0, 0, −5) rad/s at the start.  In the paper axis 3 points down; here it points up: a
reflection in the plane of axes 2 and 3 makes one motion of the other, with the same numbers and
times.

Dissipation is a couple −σω on the body, as in equations (47)–(49) of the paper.  Equations and
conventions are taken from two published transcriptions, PyDy's reproduceKane1982.cc and the Python
package RattleBack, which agree in them; the value of σ is that of the latter's example,
σ/m = 1 cm²/s.  The paper itself was not at hand: its own σ and its figures are not compared.

Accuracy.  With double precision and with 34 digits, by the equations of a rolling body and by those
derived from the Lagrangian, all times up to 20 s agree within 4e-14 s.

    python examples/rattleback_kane_levinson.py                 a table, and the figure
    python examples/rattleback_kane_levinson.py --json          for another program
    python examples/rattleback_kane_levinson.py --precision quad    a check with 34 digits
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import sympy as sp
from scipy.optimize import brentq, minimize_scalar

import chaplygin
from chaplygin import Forces, Parameter, RollingBody, System, equations_of_motion
from flowlanes.system import dot, real_symbol, to_components
from flowlanes.system.vectors import vectors
from nonholonomic import rolling_mechanism

omega, gamma = vectors("omega gamma")
sigma = real_symbol("sigma")

TILT = "0.5"
"""Roll and pitch at the start, degrees."""
SPIN = -5
"""ω₃ at the start, rad/s."""
SIGMA = 1e-4
"""Coefficient of the dissipative couple, N m s: σ/m = 1 cm²/s."""
UNTIL = 20.0
DIGITS = 11
"""Decimals of the times that are printed: those on which double and 34 digits agree."""

STONE = RollingBody(
    chaplygin.Body(
        mass=1.0,
        inertia=((2.0e-4, -2.0e-5, 0.0), (-2.0e-5, 16.0e-4, 0.0), (0.0, 0.0, 17.0e-4)),
        # the centre of mass lies 1 cm below the centre of the ellipsoid
        shape=chaplygin.Ellipsoid((0.2, 0.03, 0.02), centre=(0.0, 0.0, 0.01)),
    ),
    field=Forces(gravity=9.81),
)


def rolling_stone() -> System:
    """The stone without dissipation, by the equations of a rolling body."""
    return replace(STONE.system("rattleback", "Rattleback"), reconstruction=None)


def damped_stone(coefficient: float) -> System:
    """The stone under the couple −σω, derived from its Lagrangian."""
    free = rolling_mechanism(STONE, "damped-rattleback")
    drag = Parameter(sigma, "coefficient of the couple −σω", coefficient, "N m s")
    return equations_of_motion(
        replace(free, forces={omega: -sigma * omega}, parameters=(*free.parameters, drag), laws=())
    )


def start(system: System) -> tuple[Any, ...]:
    """The state at the start: tilted by roll and pitch, spun about axis 3."""
    with mpmath.workdps(50):
        tilt = mpmath.mpf(TILT) * mpmath.pi / 180
        c, s = mpmath.cos(tilt), mpmath.sin(tilt)
        up, spin = (-c * s, s, c * c), (0, 0, SPIN)
        if omega not in system.state:
            return chaplygin.initial_state(system, spin, up)
        known = dict(zip((*gamma.symbols, *omega.symbols), (*up, *spin), strict=True))
        # the height of the centre of mass is of no account for the motion
        return tuple(mpmath.mpf(known.get(s, 0)) for s in system.symbols)


@dataclass(frozen=True)
class Run:
    """A motion, and the moments at which the spin changes sign.

    Attributes
    ----------
    times, spin, tilt : arrays
        Vertical component of the angular velocity (rad/s) and angle between axis 3 and the
        vertical (rad), against time (s).
    reversals : list of float
        Where the vertical component of the angular velocity changes sign.
    omega3_zeros : list of float
        Where its component along body axis 3 does.
    """

    times: Any
    spin: Any
    tilt: Any
    reversals: list[float]
    omega3_zeros: list[float]


def run(system: System, until: float, precision: str, tolerance: float | None = None) -> Run:
    """Integrate the motion and find where the spin changes sign."""
    moments = [0.0, until]
    trajectory = chaplygin.integrate(
        system, start(system), moments, precision=precision, tolerance=tolerance, dense=True
    )
    dense = replace(
        trajectory.dense,
        **{name: np.asarray(value, dtype=float) for name, value in vars(trajectory.dense).items()},
    )
    vertical = function(system, to_components(dot(omega, gamma)))
    third = function(system, omega.symbols[2])
    level = function(system, gamma.symbols[2])
    knots = np.append(dense.begins, dense.ends[-1])
    times = np.linspace(0.0, until, 4001)
    return Run(
        times,
        vertical(dense(times)),
        np.arccos(np.clip(level(dense(times)), -1.0, 1.0)),
        sign_changes(lambda t: vertical(dense(t)), knots),
        sign_changes(lambda t: third(dense(t)), knots),
    )


def function(system: System, formula: sp.Expr) -> Callable[[Any], Any]:
    """A formula of the system as a function of states (times, state)."""
    steps = list(system.required_definitions([formula]))
    values = {s: sp.Float(repr(v), 17) for s, v in system.defaults.items()}
    steps = [(s, f.xreplace(values)) for s, f in steps]
    function_of = sp.lambdify([list(system.symbols)], [formula], "numpy", cse=lambda e: (steps, e))
    return lambda states: function_of(states.T)[0]


def sign_changes(curve: Callable[[Any], Any], knots: Any, pieces: int = 4) -> list[float]:
    """Zeros of a curve at which it changes sign, as good as double precision allows.

    Between neighbouring points of a fine grid an extremum that leans towards zero is looked at
    closely, so that two zeros side by side are not overlooked.
    """
    places = np.arange((len(knots) - 1) * pieces + 1) / pieces
    grid = np.interp(places, np.arange(len(knots)), knots)
    values = curve(grid)
    size = np.abs(values)
    leaning = (size[1:-1] < size[:-2]) & (size[1:-1] < size[2:])
    extra = [
        closest(curve, grid[i], grid[i + 2])
        for i in np.flatnonzero(leaning & (values[1:-1] * values[:-2] > 0))
    ]
    grid = np.unique(np.concatenate([grid, extra]))
    values = curve(grid)
    return [
        float(brentq(lambda t: float(curve(t)[0]), grid[i], grid[i + 1], xtol=1e-15, rtol=1e-15))
        for i in np.flatnonzero(values[:-1] * values[1:] < 0)
    ]


def closest(curve: Callable[[Any], Any], low: float, high: float) -> float:
    """Where a curve that keeps its sign comes nearest to zero, or passes it."""
    sign = np.sign(float(curve(0.5 * (low + high))[0]))
    minimum = minimize_scalar(
        lambda t: sign * float(curve(t)[0]),
        bounds=(low, high),
        method="bounded",
        options={"xatol": 1e-10},
    )
    return float(minimum.x)


def record(motion: Run) -> dict[str, list[float]]:
    """The moments, with as many digits as are certain."""
    return {
        "reversals": [round(t, DIGITS) for t in motion.reversals],
        "omega3_zeros": [round(t, DIGITS) for t in motion.omega3_zeros],
    }


def table(free: Run, damped: Run) -> str:
    """The moments for a reader."""
    lines = [f"Started at ω₃ = {SPIN} rad/s, roll = pitch = {TILT}°; times in seconds", ""]
    for words, motion in (("no dissipation", free), (f"couple −σω, σ = {SIGMA:g} N m s", damped)):
        lines.append(words)
        for name, moments in (
            ("(ω, γ) changes sign at", motion.reversals),
            ("ω₃ changes sign at", motion.omega3_zeros),
        ):
            shown = [f"{t:.{DIGITS}f}" for t in moments]
            for i in range(0, max(len(shown), 1), 4):
                head = name if i == 0 else ""
                lines.append(f"  {head:<24}{'  '.join(shown[i : i + 4]) or 'never'}")
        lines.append(f"  {'spin at the end':<24}{motion.spin[-1]:.4f} rad/s")
    return "\n".join(lines)


def draw(free: Run, damped: Run, path: Path) -> None:
    """Spin and rattling against time."""
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    from chaplygin.report.drawing.style import COMPONENTS, FAINT, STYLE, WIDTH

    with rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 4.6), layout="constrained")
        upper, lower = figure.subplots(2, 1, sharex=True)
        for motion, colour, words in (
            (free, COMPONENTS[0], "no dissipation"),
            (damped, COMPONENTS[1], f"couple −σω, σ = {SIGMA:g} N m s"),
        ):
            upper.plot(motion.times, motion.spin, color=colour, label=words)
            lower.plot(motion.times, np.degrees(motion.tilt), color=colour, linewidth=0.6)
        upper.axhline(0.0, color=FAINT, linewidth=0.6, zorder=0)
        upper.set_ylabel(r"spin  $(\omega, \gamma)$  (rad/s)")
        lower.set_ylabel("tilt of axis 3  (degrees)")
        lower.set_xlabel("time (s)")
        upper.legend(loc="lower right")
        figure.savefig(path, dpi=200)


def main() -> None:
    """Read the options, run both motions, print."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--json", action="store_true", help="print JSON; no figure is written")
    parser.add_argument("--until", type=float, default=UNTIL, help="end of the runs, s")
    parser.add_argument("--precision", choices=("double", "quad"), default="double")
    parser.add_argument("--figure", type=Path, default=Path("rattleback_kane_levinson.png"))
    options = parser.parse_args()
    free = run(rolling_stone(), options.until, options.precision)
    damped = run(damped_stone(SIGMA), options.until, options.precision)
    if options.json:
        print(json.dumps({**record(free), "damped": {"sigma": SIGMA, **record(damped)}}))
        return
    print(table(free, damped))
    draw(free, damped, options.figure)
    print(f"figure: {options.figure}")


if __name__ == "__main__":
    main()
