"""A resonant torus of the Chaplygin ball: closed orbits with different periods.

At zero area constant the ball moves on tori.  The ratio of the two frequencies depends on f/(2h)
alone, f = M² and h the energy; here a level is found where it is 1/2, so that every orbit on the
torus is closed.  In the new time τ all orbits have one period; in the physical time t each has its
own.  On a resonant torus of an integrable Hamiltonian system, with action and angle variables
around it, all periods are equal (Proposition 4): in the physical time the ball is no such system.

    python examples/resonant_torus.py
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import mpmath
from flint import arb, ctx
from matplotlib.figure import Figure

from chaplygin import integrate
from chaplygin.report.drawing.style import INK, QUIET, SERIES, STYLE, WIDTH
from flowlanes.formulas import ball_function
from flowlanes.formulas.balls import components
from nonholonomic.closed_form import SeparatedSystem
from nonholonomic.closed_form.genus_two.curve import Curve
from nonholonomic.closed_form.genus_two.periods import Lattice, lattice
from nonholonomic.closed_form.genus_two.separated_motion import steps_from_torus
from nonholonomic.closed_form.genus_two_solution import GenusTwo, solve_on_torus
from nonholonomic.closed_form.separations.chaplygin_ball import chaplygin_ball

#: A long body inside a ball: kg, m.
BALL = {"m": "1", "I_1": "0.1", "I_2": "0.8", "I_3": "0.85", "R": "1"}
#: z₁ goes around once while z₂ goes around twice.
TURNS = (1, 2)
#: Digits of the closed form; points on an orbit for its period.
DIGITS, POINTS = 40, 128
PHASES = 48

with mpmath.workdps(DIGITS):
    MOMENTS = tuple(mpmath.mpf(BALL[f"I_{i}"]) for i in (1, 2, 3))
    D = mpmath.mpf(BALL["m"]) * mpmath.mpf(BALL["R"]) ** 2


def reduced_system() -> SeparatedSystem:
    """The ball without its motion in space."""
    system = chaplygin_ball()
    return replace(
        system, system=replace(system.system, reconstruction=None, observables=(), guards=())
    )


# --- the level -----------------------------------------------------------------------------


def periods(root: Any) -> Lattice:
    """Periods of y² = −8h z(z + D)(z − r)∏(z − I_i), r = f/(2h) − D, for h = 1."""
    with mpmath.workdps(DIGITS):
        roots = [arb(mpmath.nstr(x, DIGITS)) for x in (*MOMENTS, -D, root)]
    curve = Curve.of(arb(-8), [*roots, arb(0)])
    middles = ((roots[0] + roots[4]) / 2, (roots[1] + roots[2]) / 2)
    return lattice(curve, (curve.oval_of(middles[0]), curve.oval_of(middles[1])))


def rotation_number(root: Any) -> Any:
    """How often z₁ goes around while z₂ goes around once, for I₁ < r < I₂ (mpmath)."""
    with ctx.workdps(DIGITS + 10):
        lengths = periods(root)
        first, second = lengths.around_ovals(lengths.normalised_integrals((arb(0), arb(1))))
        return mpmath.mpf(abs(first / second).str(DIGITS, radius=False))


def resonance(turns: tuple[int, int] = TURNS) -> Any:
    """The root r = f/(2h) − D at which the rotation number is the ratio of `turns`."""
    with mpmath.workdps(DIGITS):
        wanted = mpmath.mpf(turns[0]) / turns[1]
        margin = (MOMENTS[1] - MOMENTS[0]) / 100
        return mpmath.findroot(
            lambda root: rotation_number(root) - wanted,
            (MOMENTS[0] + margin, MOMENTS[1] - margin),
            solver="anderson",
            tol=mpmath.mpf(10) ** (4 - 2 * DIGITS),
        )


def start(root: Any) -> list[str]:
    """M and γ with M² = 1 kg² m⁴/s² and (M, γ) = 0 on the level, γ in the plane γ₁ = 0.

    There 2h = (M, ω) = (J⁻¹M, M) + D (J⁻¹γ, M)²/(1 − D(γ, J⁻¹γ)), J = I + D, and M² = 2h(r + D).
    """
    with mpmath.workdps(DIGITS):
        inverse = [1 / (moment + D) for moment in MOMENTS]
        gamma = (mpmath.mpf(0), mpmath.mpf(4) / 5, mpmath.mpf(3) / 5)
        spread = 1 - D * sum(a * g**2 for a, g in zip(inverse, gamma, strict=True))
        # M = (cos φ, −γ₃ sin φ, γ₂ sin φ): 2h = a cos²φ + b sin²φ
        across = inverse[1] * gamma[2] ** 2 + inverse[2] * gamma[1] ** 2
        across += D * ((inverse[2] - inverse[1]) * gamma[1] * gamma[2]) ** 2 / spread
        square = (1 / (root + D) - across) / (inverse[0] - across)
        cosine, sine = mpmath.sqrt(square), mpmath.sqrt(1 - square)
        state = (cosine, -gamma[2] * sine, gamma[1] * sine, *gamma)
        return [mpmath.nstr(x, DIGITS) for x in state]


# --- the orbits ----------------------------------------------------------------------------


@dataclass(frozen=True)
class Orbit:
    """A closed orbit: its phase in turns, its state there (texts) and its period in seconds."""

    phase: float
    state: list[str]
    period: Any


@dataclass(frozen=True)
class Story:
    """The torus, its orbits, their common period in τ, and the mean of dt/dτ times it."""

    root: Any
    rotation: Any
    solution: GenusTwo
    common: Any
    mean: Any
    orbits: tuple[Orbit, ...]


def measure(count: int = PHASES) -> Story:
    """Orbits at `count` phases."""
    root = resonance()
    separable = reduced_system()
    values = {p.symbol: BALL[str(p.symbol)] for p in separable.system.parameters}
    solution = solve_on_torus(separable, values, start(root))
    with ctx.workdps(DIGITS):
        turns = solution.separated_motion.torus.turns
        # after an even number of turns around each oval the signs of γ are back as well
        common = 2 * TURNS[0] / abs(turns[0])
        orbits = tuple(_orbit(solution, arb(i) / count, common) for i in range(count))
        mean = sum((orbit.period for orbit in orbits), arb(0)) / count
        return Story(root, turns[0] / turns[1], solution, common, mean, orbits)


def _orbit(solution: GenusTwo, phase: Any, common: Any) -> Orbit:
    """∫ dt along one orbit, by the trapezoidal rule, and its beginning."""
    motion = solution.separated_motion
    torus = motion.torus
    origin = [torus.v_0[0] + phase, torus.v_0[1]]
    system = motion.separable.system
    wanted = (*components(motion.separable.clock), *system.symbols)
    arguments, steps = steps_from_torus(motion.separable, wanted)
    function = ball_function(arguments, wanted, steps)
    fixed = [motion.values[s] for s in arguments[6:]]

    def at(tau: Any) -> tuple[Any, ...]:
        direction, turning = torus.ball([v + V * tau for v, V in zip(origin, torus.V, strict=True)])
        return function(*direction, *turning, *fixed)

    samples = [at(common * i / POINTS) for i in range(POINTS)]
    period = sum((value[0] for value in samples), arb(0)) * common / POINTS
    state = [x.str(DIGITS, radius=False) for x in samples[0][1:]]
    return Orbit(float(phase), state, period)


def miss(story: Story, orbit: Orbit, period: Any) -> float:
    """How far from its beginning an orbit is after a time, by integration with 34 digits."""
    system = story.solution.separable.system
    with mpmath.workdps(DIGITS), ctx.workdps(DIGITS):
        moments = [0, mpmath.mpf(period.str(DIGITS, radius=False))]
        motion = integrate(system, orbit.state, moments, parameters=BALL, precision="quad")
    return max(abs(float(a - b)) for a, b in zip(*motion.states, strict=True))


# --- the story -----------------------------------------------------------------------------


def figure(story: Story) -> Figure:
    """Periods in t and in τ against the phase, each by its mean."""
    drawing, axes = plt.subplots(figsize=(WIDTH, 2.9), layout="constrained")
    phases = [orbit.phase for orbit in story.orbits] + [1.0]
    shares = [float(orbit.period / story.mean) for orbit in story.orbits]
    axes.axhline(1.0, color=QUIET, label=rf"in $\tau$: all {float(story.common):.4f}")
    label = rf"in $t$: mean {float(story.mean):.4f} s"
    axes.plot(phases, [*shares, shares[0]], ".-", color=SERIES[0], label=label)
    axes.set(xlabel="phase of the orbit on the torus", ylabel="period / mean", xlim=(0, 1))
    axes.legend(loc="upper right", labelcolor=INK)
    return drawing


def report(story: Story) -> None:
    """The numbers."""
    shortest = min(story.orbits, key=lambda orbit: float(orbit.period))
    longest = max(story.orbits, key=lambda orbit: float(orbit.period))
    with mpmath.workdps(DIGITS), ctx.workdps(DIGITS):
        print("A resonant torus of the Chaplygin ball, (M, γ) = 0")
        print("  " + ", ".join(f"{name} = {value}" for name, value in BALL.items()))
        print(f"  f/(2h) − D       {mpmath.nstr(story.root, 30)}")
        print(f"  rotation number  {story.rotation.str(30)}")
        print(f"  period in τ      {story.common.str(25, radius=False)}, of every orbit\n")
        print("Periods in t (s)")
        for words, orbit in (("shortest", shortest), ("longest", longest)):
            text = orbit.period.str(25, radius=False)
            closes, other = (miss(story, orbit, x.period) for x in (orbit, _other(story, orbit)))
            print(f"  {words:9} at phase {orbit.phase:.4f}: {text}")
            print(f"      integrated for its own period it misses its beginning by {closes:.1e},")
            print(f"      for the other orbit's period by {other:.1e}")
        spread = (longest.period - shortest.period) / story.mean
        print(f"\nThey differ by {float(longest.period - shortest.period):.5f} s,", end=" ")
        print(f"a part of {float(spread):.3e}")


def _other(story: Story, orbit: Orbit) -> Orbit:
    """The orbit whose period differs most."""
    return max(story.orbits, key=lambda other: abs(float(other.period - orbit.period)))


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the figure")
    folder = parser.parse_args(arguments).output
    story = measure()
    report(story)
    with plt.rc_context(STYLE):
        folder.mkdir(parents=True, exist_ok=True)
        figure(story).savefig(folder / "resonant_torus.png", dpi=160)
    print(f"wrote {folder / 'resonant_torus.png'}")


if __name__ == "__main__":
    main()
