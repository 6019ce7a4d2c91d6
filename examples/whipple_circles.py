"""Hands-free circles of the Whipple bicycle: steady turning without a torque on the handlebar.

They branch off from straight running at the speed where the capsize becomes unstable.  For every
steering angle Newton's method finds speed, lean and pitch at which the nonlinear equations stand
still; the linear equations about that motion tell how fast it is lost.

    python examples/whipple_circles.py
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import mpmath
import sympy as sp
from matplotlib.figure import Figure
from whipple_bicycle import VALUES, critical_speeds, linearisation_near, model, upright

from chaplygin import linear_stability
from chaplygin.report.drawing.style import SERIES, STYLE, WIDTH
from flowlanes.flow import relative_equilibrium

DIGITS = 15
ANGLES = (1, 2, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 60)


@dataclass(frozen=True)
class Circle:
    """A hands-free circle: angles in degrees, speed of the rear wheel in m/s, radius in m."""

    steer: float
    lean: float
    speed: float
    radius: float
    growth: float


def beginning(steer: float) -> dict[str, float]:
    """A guess for a small steering angle (rad): straight running and a share of the capsize."""
    speed = critical_speeds()[1]
    modes = linearisation_near(speed, DIGITS)
    capsize = min(zip(modes.eigenvalues, modes.modes, strict=True), key=lambda pair: abs(pair[0]))[
        1
    ]
    share = {str(name): float(mpmath.re(x)) for name, x in capsize.items()}
    straight = {name: float(sp.N(value)) for name, value in upright(speed).items()}
    return {name: x + steer * share[name] / share["delta"] for name, x in straight.items()}


def circles(angles: Sequence[float] = ANGLES) -> list[Circle]:
    """Circles for growing steering angles (degrees), each the guess for the next."""
    guess = beginning(math.radians(angles[0]))
    family = []
    for angle in angles:
        guess["delta"] = math.radians(angle)
        state = relative_equilibrium(
            model(), guess, VALUES, fixed_variables=["delta"], digits=DIGITS
        )
        guess = {str(name): float(x) for name, x in state.items()}
        turning = math.hypot(*(guess[f"omega_{i}"] for i in (1, 2, 3)))
        speed = -float(VALUES["R_R"]) * guess["Omega_R"]
        values = linear_stability(model(), state, VALUES, digits=DIGITS).eigenvalues
        lean = -math.degrees(math.asin(guess["gamma_2"]))
        growth = float(max(value.real for value in values))
        family.append(Circle(angle, lean, speed, speed / turning, growth))
    return family


def figure(family: Sequence[Circle]) -> Figure:
    """Lean and radius against the speed."""
    drawing, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 2.8), layout="constrained")
    speeds = [circle.speed for circle in family]
    left.plot(speeds, [circle.lean for circle in family], ".-", color=SERIES[0], label="lean")
    left.plot(speeds, [circle.steer for circle in family], ".-", color=SERIES[1], label="steer")
    left.set(xlabel="speed (m/s)", ylabel="degrees", xlim=(0, None), ylim=(0, None))
    left.legend(loc="upper right")
    right.semilogy(speeds, [circle.radius for circle in family], ".-", color=SERIES[2])
    right.set(xlabel="speed (m/s)", ylabel="radius (m)", xlim=(0, None))
    return drawing


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the figure")
    folder = parser.parse_args().output
    solutions = circles()
    print("Hands-free circles of the Whipple bicycle\n")
    print("  steer      lean     speed      radius    growth")
    for c in solutions:
        row = f"{c.steer:6.1f}° {c.lean:8.3f}° {c.speed:7.4f} m/s {c.radius:8.3f} m"
        print(f"{row} {c.growth:7.4f} 1/s")
    with plt.rc_context(STYLE):
        folder.mkdir(parents=True, exist_ok=True)
        figure(solutions).savefig(folder / "whipple_circles.png", dpi=160)
    print(f"\nwrote {folder / 'whipple_circles.png'}")


if __name__ == "__main__":
    main()
