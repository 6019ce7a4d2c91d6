"""Limit cycles of the unbalanced rubber ball: it has no invariant measure.

The ball rolls on a plane with neither slipping nor spinning, its centre of mass away from its
geometric centre (§10.2).  Its motions lie on tori.  An invariant measure with a smooth positive
density would make the motion on each torus conjugate to a uniform one; limit cycles exclude it,
and with them a rotation number that stays at a fraction while the torus changes.

    python examples/limit_cycles.py
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from matplotlib.figure import Figure

from chaplygin import PoincareMap, from_catalogue
from chaplygin.report.drawing.style import INK, QUIET, SERIES, STYLE, WIDTH
from flowlanes import poincare_section, rotation_number
from flowlanes.orbits import (
    Branch,
    Circle,
    Orbit,
    ReturnMap,
    Rotation,
    continue_orbit,
    enclose_limit_cycle,
    find_periodic,
    locked_interval,
    staircase,
)
from flowlanes.orbits.arnold_tongues import DevilsStaircase, Plateau, plateaus
from flowlanes.orbits.limit_cycles import Cycle
from nonholonomic.catalogue.bodies.unbalanced_rubber_ball_centred import (
    J_1,
    J_2,
    J_3,
    alpha,
    beta,
    eta,
    level,
    torus,
    xi,
)

#: Moments about the geometric centre plus mR² (kg m²), and κ = 2mR c, c its place from the centre
#: of mass: a ball of 1 kg with R = 0.5 m, as in the proof that there are limit cycles.
J, KAPPA = np.array([0.5, 2.75, 2.8]), np.array([0.05, -0.1, 0.15])
MASS, RADIUS = 1.0, 0.5
#: The unbalanced ball of the catalogue, kg and m.
EVERYDAY = {"m": 1.0, "R": 1.0, "I": (1.0, 1.5, 2.1), "c": (-0.1, 0.05, 0.2)}
#: Relative error of a step.
TOLERANCE = 1e-15
#: Turns of α in one of β for which steps of the staircase are sought, by the longest cycle.
LONGEST = 5
LONGEST_EVERYDAY = 10
#: Displacements of the centre, as shares of that above, for the widths.
SHARES = tuple(2.0**-n for n in range(8))
FRACTIONS = (Fraction(2), Fraction(3, 2), Fraction(4, 3), Fraction(5, 3))
#: F/2H of the torus whose cycles are found, and intervals of α at β = 0 around them.
LEVEL = 0.95
AROUND = (("0.62", "0.92"), ("4.12", "4.42"))


# --- the circle maps of the tori -----------------------------------------------------------


def circles(moments: np.ndarray, kappa: np.ndarray) -> Circle:
    """The maps of the circle of α after one turn of β, by F/2H, for J₁ < F/2H < J₂."""
    system = torus()
    values = {f"J_{i}": J for i, J in enumerate(moments, 1)}
    values |= {f"kappa_{i}": k for i, k in enumerate(kappa, 1)}
    returns = PoincareMap(system, poincare_section(system, "beta", angle=True), values, TOLERANCE)
    return Circle(returns, "alpha", "lambda", {"beta": 0.0})


def levels(moments: np.ndarray, count: int) -> np.ndarray:
    """F/2H between the separatrices at J₁ and J₂."""
    margin = 0.02 * (moments[1] - moments[0])
    return np.linspace(moments[0] + margin, moments[1] - margin, count)


def central(mass: float, radius: float, moments: Sequence[float], centre: Sequence[float]):
    """J and κ in the principal axes of J, from moments and place in those of the centre of mass."""
    c = np.array(centre)
    tensor = np.diag(moments) + mass * (radius**2 + c @ c) * np.eye(3) - mass * np.outer(c, c)
    values, axes = np.linalg.eigh(tensor)
    return values, 2 * mass * radius * axes.T @ c


@dataclass(frozen=True)
class Widths:
    """Steps of one fraction for balls with smaller and smaller displacements."""

    fraction: Fraction
    shares: tuple[float, ...]
    steps: tuple[Plateau, ...]

    @property
    def power(self) -> float:
        """The exponent n of width ∝ aⁿ, between the two smallest that are resolved well."""
        clear = [
            (share, step.width)
            for share, step in zip(self.shares, self.steps, strict=True)
            if step.width > 1e3 * step.error
        ]
        (a, first), (b, second) = clear[-2:]
        return float(np.log(first / second) / np.log(a / b))


def widths(
    stairs: DevilsStaircase, fraction: Fraction, shares: tuple[float, ...] = SHARES
) -> Widths:
    """How wide the step of a fraction is when the centre moves inwards."""
    below = stairs.values[stairs.rotations > float(fraction) + 0.06].max()
    above = stairs.values[stairs.rotations < float(fraction) - 0.06].min()
    return Widths(
        fraction,
        shares,
        tuple(
            locked_interval(circles(J, share * KAPPA), fraction, (below, above)) for share in shares
        ),
    )


# --- the ball itself -----------------------------------------------------------------------


@dataclass(frozen=True)
class Ball:
    """The unbalanced rubber ball of the catalogue, with the axes of J in its own."""

    values: Mapping[str, float]
    axes: np.ndarray
    J: np.ndarray
    kappa: np.ndarray

    @classmethod
    def of(cls, moments: np.ndarray, kappa: np.ndarray) -> Ball:
        """The ball with given J and κ."""
        c = kappa / (2 * MASS * RADIUS)
        about = MASS * (RADIUS**2 + c @ c) * np.eye(3) - MASS * np.outer(c, c)
        principal, axes = np.linalg.eigh(np.diag(moments) - about)
        axes[:, 2] *= np.linalg.det(axes)
        values = {"m": MASS, "R": RADIUS}
        values |= {f"I_{i}": x for i, x in enumerate(principal, 1)}
        values |= {f"c_{i}": x for i, x in enumerate(axes.T @ c, 1)}
        return cls(values, axes, moments, kappa)

    @property
    def returns(self) -> ReturnMap:
        """Where γ passes the plane across the first axis of J, upwards: β a multiple of 2π."""
        system = replace(from_catalogue("unbalanced-rubber-ball"), guards=())
        gamma = system.symbols[3:]
        height = sp.Add(*(sp.Float(a, 20) * g for a, g in zip(self.axes[0], gamma, strict=True)))
        return ReturnMap(
            PoincareMap(system, poincare_section(system, height), self.values, TOLERANCE)
        )

    def start(self, level: float, alpha: float) -> np.ndarray:
        """ω, γ on the torus F/2H = level with 2H = 1 J, at β = 0, with β and α growing.

        There γ = (0, sin α, cos α), and e₁ and e₁×γ are conjugate for both forms of the velocity.
        """
        gamma = np.array([0.0, np.sin(alpha), np.cos(alpha)])
        K = self.J - self.kappa @ gamma
        along, across = np.array([1.0, 0.0, 0.0]), np.cross([1.0, 0.0, 0.0], gamma)
        forms = np.array(
            [[(K * u) @ u, np.sum(np.cross(K * u, gamma) ** 2)] for u in (along, across)]
        ).T
        squares = np.linalg.solve(forms, [1.0, level - self.kappa @ gamma])
        omega = np.sqrt(squares[0]) * along + np.sqrt(squares[1]) * across
        if np.cross(gamma, omega)[0] < 0:
            omega -= 2 * np.sqrt(squares[1]) * across
        return np.concatenate([self.axes.T @ omega, self.axes.T @ gamma])


def cycles(ball: Ball, level: float = LEVEL, settle: int = 200) -> tuple[Orbit, Branch]:
    """The attracting limit cycle of a torus, and its branch over all tori of the same energy."""
    returns = ball.returns
    near = returns.section.iterate(ball.start(level, 2.0)[None], settle)[0]
    orbit = find_periodic(returns, near, hold={"energy": 0.5, "quadratic": level})
    return orbit, continue_orbit(returns, orbit, "quadratic", 2.0, {"energy": 0.5}, max_step=0.3)


def control(ball: Ball, level: float, period: int) -> Orbit:
    """A closed orbit next to a torus; F is free, so that the step goes to the resonant torus."""
    return find_periodic(ball.returns, ball.start(level, 2.0), period, {"energy": 0.5})


def resonance(circle: Circle, fraction: Fraction, stairs: DevilsStaircase) -> float:
    """F/2H next to the place where the rotation number is a fraction."""
    return float(np.interp(-float(fraction), -stairs.rotations, stairs.values))


def proofs(steps: int = 4000) -> list[Cycle]:
    """That there are an attracting and a repelling limit cycle, with bounds of the multipliers."""
    system = torus()
    definitions = dict(system.definitions)
    # as they stand, but each angle occurs once, so that balls stay small
    definitions[xi] = J_1 + (level - J_1) * sp.sin(beta) ** 2
    definitions[eta] = J_2 + (J_3 - J_2) * sp.sin(alpha) ** 2
    sharp = replace(system, definitions=definitions)
    values = {f"J_{i}": str(x) for i, x in enumerate(J, 1)}
    values |= {f"kappa_{i}": str(x) for i, x in enumerate(KAPPA, 1)} | {"lambda": str(LEVEL)}
    return [enclose_limit_cycle(sharp, values, ends, 2, steps=steps) for ends in AROUND]


# --- the story -----------------------------------------------------------------------------


@dataclass(frozen=True)
class Story:
    """What was found."""

    stairs: DevilsStaircase
    steps: list[Plateau]
    widths: tuple[Widths, ...]
    balanced: Plateau
    motion: Rotation
    cycle: Orbit
    branch: Branch
    controls: Mapping[str, Orbit]
    everyday: list[Plateau]
    proofs: list[Cycle]


def measure(count: int = 400, longest: int = LONGEST) -> Story:
    """Staircase, widths, limit cycles and controls."""
    full, even = circles(J, KAPPA), circles(J, 0 * KAPPA)
    stairs = staircase(full, levels(J, count), tolerance=1e-9, max_iterations=2048)
    flat = staircase(even, levels(J, count // 4), tolerance=1e-9, max_iterations=2048)
    two = resonance(even, Fraction(2), flat)
    orbit, branch = cycles(Ball.of(J, KAPPA))
    line = np.array([0.19, 0.0, 0.0])
    controls = {
        "a = 0": control(Ball.of(J, 0 * KAPPA), two, 1),
        "a along an axis of symmetry": control(Ball.of(np.array([0.5, 2.75, 2.75]), line), two, 1),
    }
    moments, kappa = central(*(EVERYDAY[name] for name in ("m", "R", "I", "c")))
    usual = circles(moments, kappa)
    usual_stairs = staircase(
        usual, levels(moments, count // 4), tolerance=1e-9, max_iterations=2048
    )

    def lift(steps: int) -> np.ndarray:
        return full(np.array([0.3]), np.array([LEVEL]), steps)[0]

    return Story(
        stairs,
        plateaus(full, stairs, longest),
        tuple(widths(flat, fraction) for fraction in FRACTIONS),
        locked_interval(even, Fraction(2), (two - 0.1, two + 0.1)),
        rotation_number(lift),
        orbit,
        branch,
        controls,
        plateaus(usual, usual_stairs, LONGEST_EVERYDAY),
        proofs(),
    )


def figure(story: Story) -> Figure:
    """The staircase, and the widths of its steps."""
    drawing = plt.figure(figsize=(WIDTH, 5.4), layout="constrained")
    top, low = drawing.add_gridspec(2, 1, height_ratios=(1.15, 1)).subplots()
    stairs = story.stairs
    top.plot(stairs.values, stairs.rotations, color=SERIES[0], lw=0.9)
    for step in story.steps:
        height, short = float(step.fraction), step.fraction.denominator < 4
        size = {"lw": 2.8} if step.width > 2e-3 else {"marker": "o", "ms": 3.6 if short else 2}
        top.plot([step.low, step.high], [height] * 2, color=SERIES[1], **size)
        place, offset = (step.high, height), (3, 3)
        text = {"fontsize": 9 if short else 6.5, "color": INK}
        top.annotate(str(step.fraction), place, offset, textcoords="offset points", **text)
    top.set(xlabel=r"torus, $F_2/2H$ (kg m$^2$)", ylabel=r"turns of $\alpha$ in one of $\beta$")
    for width, colour in zip(story.widths, SERIES, strict=False):
        shares = np.array(width.shares)
        sizes = np.array([step.width for step in width.steps])
        low.loglog(shares, sizes, "o-", color=colour)
        label = rf"  {width.fraction}: $\propto a^{{{width.power:.2f}}}$"
        side = {Fraction(4, 3): "bottom", Fraction(5, 3): "top"}.get(width.fraction, "center")
        low.text(1.0, sizes[0], label, color=colour, va=side, fontsize=9)
    noise = max(step.error for width in story.widths for step in width.steps)
    low.axhspan(noise / 100, noise, color=QUIET, alpha=0.2, lw=0)
    low.text(shares[-1], noise / 10, "errors of the edges", va="center", color=QUIET, fontsize=8)
    low.set(xlabel="displacement of the centre of mass, as a share of that above")
    low.set(ylabel="width of the step (kg m$^2$)", xlim=(0.9 * shares[-1], 2.2))
    low.set_ylim(bottom=noise / 100)
    low.set_xticks(shares, [f"{Fraction(share)}" for share in shares], minor=False)
    low.minorticks_off()
    return drawing


def report(story: Story) -> None:
    """The numbers."""
    motion, cycle = story.motion, story.cycle
    print(f"J = {J.tolist()} kg m², 2mRc = {KAPPA.tolist()} kg m²\n")
    print("Steps of the staircase: from, to, width of F/2H, error of the edges")
    for step in story.steps:
        numbers = f"{step.low:.13f}  {step.high:.13f}  {step.width:.4e}  {step.error:.0e}"
        print(f"  {step.fraction!s:4}  {numbers}")
    print("\nWidth when the centre moves inwards: exponent of a, smallest share resolved")
    for found in story.widths:
        last = [s for s, step in zip(found.shares, found.steps, strict=True) if step.open][-1]
        print(f"  {found.fraction!s:4}  {found.power:.3f}  1/{1 / last:.0f}")
    print(f"  a = 0, 2: {abs(story.balanced.width):.1e}, error {story.balanced.error:.0e}")
    print(f"\nThe torus F/2H = {LEVEL}: rotation number {motion.value:.12f}, {motion.verdict},")
    print(f"  the distance from the cycle falls by the factor {motion.approach:.6f} in each turn")
    for found in story.proofs:
        low, high = (float(x) for x in (found.multiplier.lower(), found.multiplier.upper()))
        ends = " to ".join(f"{float(x):.2f}" for x in found.interval)
        status = "proven" if found.kind != "undecided" else "not proven"
        print(f"  {status}: {found.kind}, α from {ends}, multiplier from {low:.3f} to {high:.3f}")
    _tell("attracting limit cycle of the ball itself, ω and γ", cycle)
    worst = min(story.branch.orbits, key=lambda orbit: -abs(orbit.multipliers.values[0]))
    _tell(f"most repelling one, F/2H = {worst.values['quadratic']:.4f}", worst)
    folds = [event.place for event in story.branch.events if event.kind == "fold"]
    print(f"  limit cycles begin and end at F/2H = {', '.join(f'{x:.13f}' for x in sorted(folds))}")
    for name, orbit in story.controls.items():
        _tell(name, orbit)
    print("\nThe unbalanced ball of the catalogue: steps, and widths with their errors")
    for step in story.everyday:
        print(f"  {step.fraction!s:4}  {step.low:.10f}  {step.width: .1e}  {step.error:.0e}")


def _tell(title: str, orbit: Orbit) -> None:
    (value,), (error,) = orbit.multipliers.values.real, orbit.multipliers.errors
    print(f"{title}:")
    print(f"  period {orbit.duration:.12f} s, closes to {orbit.gap:.0e}, {orbit.kind},")
    print(f"  multiplier {value:.13f} ± {error:.0e}; 1 − multiplier = {1 - value:.2e}")
    print(f"  multipliers forced to be one by: {', '.join(orbit.multipliers.trivial)}")


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the figure")
    folder = parser.parse_args(arguments).output
    story = measure()
    report(story)
    with plt.rc_context(STYLE):
        folder.mkdir(parents=True, exist_ok=True)
        figure(story).savefig(folder / "limit_cycles.png", dpi=160)
    print(f"wrote {folder / 'limit_cycles.png'}")


if __name__ == "__main__":
    main()
