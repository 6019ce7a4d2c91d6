"""Euler's disk: how fast it comes to its end under friction and drag of the air.

The disk of eulers_disk.toml whirls with its centre of mass at rest: with the angle α between its
face and the table the contact runs round at Ω, Ω² = 4g/(a sin α), and E = (3/2) m g a sin α.
Friction of the contact that wanders over the edge takes μ_c N a Ω of it, resistance to rolling
δ N |ω|, the air under the disk πηga²/tan²α, so that at small angles

    α = (2 μ_c √(g/a) (t₁ − t))^(2/3),     √α = (2δ/3a) √(g/a) (t₁ − t),
    α³ = (2πηa/m) (t₁ − t).

Run with::

    python examples/eulers_disk.py
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from scipy.optimize import curve_fit

from chaplygin import Body, Study, initial_state, load_experiment
from chaplygin.report.drawing.style import SERIES, STYLE, WIDTH
from nonholonomic.contact import (
    AirFilm,
    ContourResistance,
    Coulomb,
    FrictionalContact,
    FrictionLaw,
    RollingResistance,
    contact_motion,
)

FILE = Path(__file__).with_name("eulers_disk.toml")
#: μ_c as in the file, δ (m), and η of air (Pa s).
CONTOUR, ROLLING, AIR = 2e-4, 2.2e-4, 1.8e-5
#: Angles (rad) between which exponents are measured.
RANGE = (0.002, 0.05)
#: The motions are followed to about this share of the first angle.
LEAST = 0.01
#: Friction that holds the edge; 0.3 does not, under resistance to rolling.
GRIP = 100.0


@dataclass(frozen=True)
class Decay:
    """The last seconds of a disk.

    Attributes
    ----------
    words : str
    times, angles : array (n,)
        Angle between face and table (rad).
    theory : float
        The end by the formula for small angles (s).
    exponent, end : float
        n and t₁ of α ∝ (t₁ − t)ⁿ, fitted to the motion.
    largest_friction : float
        Greatest ratio of friction to normal force.
    """

    words: str
    times: np.ndarray
    angles: np.ndarray
    theory: float
    exponent: float
    end: float
    largest_friction: float


def decay(
    words: str, law: FrictionLaw, power: float, grip: float = GRIP, samples: int = 3000
) -> Decay:
    """The disk of the file under a law, with the exponent that theory predicts."""
    subject = Study.from_experiment(load_experiment(FILE)).subject
    body, field = subject.contact.body, subject.contact.field
    disk = FrictionalContact(body, laws=(Coulomb(grip), law), field=field)
    start = subject.start_values
    first = np.arctan2(start["gamma"][0], start["gamma"][2])
    theory = ending(law, first, body, field.gravity)
    times = theory * (1 - np.linspace(1, LEAST ** (0.5 / power), samples) ** 2)
    state = initial_state(disk, start["omega"], start["gamma"])
    motion = contact_motion(disk, state, times)
    gamma = motion.states[:, 13:16]
    angles = np.arctan2(np.hypot(gamma[:, 0], gamma[:, 1]), gamma[:, 2])
    clear = (angles > RANGE[0]) & (angles < RANGE[1])

    def logarithm(time: np.ndarray, exponent: float, end: float, constant: float) -> np.ndarray:
        return exponent * np.log(np.maximum(end - time, 1e-12)) + constant

    guess = (power, theory * 1.001, 0.0)
    (exponent, end, _), _ = curve_fit(
        logarithm, motion.times[clear], np.log(angles[clear]), guess, maxfev=20000
    )
    values = motion
    ratio = np.linalg.norm(values["friction_force"], axis=1) / values["normal_force"]
    return Decay(words, motion.times, angles, theory, exponent, end, float(ratio.max()))


def ending(law: FrictionLaw, first: float, body: Body, gravity: float) -> float:
    """When a disk ends that starts at an angle, by the formula for small angles (s)."""
    a = body.shape.radius
    rate = np.sqrt(gravity / a)
    if isinstance(law, AirFilm):
        return float(body.mass * first**3 / (2 * np.pi * AIR * a))
    if isinstance(law, RollingResistance):
        return float(3 * a * np.sqrt(first) / (2 * ROLLING * rate))
    return float(first**1.5 / (2 * CONTOUR * rate))


def decays() -> list[Decay]:
    """The disk under each of the laws."""
    radius = Study.from_experiment(load_experiment(FILE)).subject.contact.body.shape.radius
    return [
        decay("wandering of the contact", ContourResistance(CONTOUR), 2 / 3),
        decay("resistance to rolling", RollingResistance(ROLLING), 2.0),
        decay("film of air", AirFilm(AIR, radius), 1 / 3),
    ]


def figure(found: list[Decay]) -> Figure:
    """The angle against time, and against the time that is left."""
    drawing, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 2.8), layout="constrained")
    for run, colour in zip(found, SERIES, strict=False):
        left.plot(run.times / run.end, run.angles, color=colour, label=run.words)
        right.loglog(run.end - run.times, run.angles, color=colour)
        near = (run.end - run.times < run.end / 5) & (run.angles > RANGE[0])
        place = np.flatnonzero(near)[len(np.flatnonzero(near)) // 2]
        right.annotate(
            f"{run.exponent:.3f}",
            (run.end - run.times[place], run.angles[place]),
            (8, -10),
            textcoords="offset points",
            color=colour,
        )
    left.set(xlabel=r"time over $t_1$", ylabel=r"angle $\alpha$ (rad)", ylim=(0, None))
    left.legend(fontsize=8)
    right.set(xlabel="time to the end (s)", ylabel=r"angle $\alpha$ (rad)")
    return drawing


def report(folder: Path) -> None:
    """The numbers, and the figure."""
    found = decays()
    for run in found:
        print(f"{run.words}: α ∝ (t₁ − t)^{run.exponent:.4f}")
        print(f"  end t₁ = {run.end:.5f} s; for small angles {run.theory:.5f} s")
        print(f"  followed to α = {run.angles[-1]:.3g}, t = {run.times[-1]:.6f} s")
        print(f"  friction is at most {run.largest_friction:.4f} times the normal force")
    run = Study.from_experiment(
        load_experiment(FILE, ("run.until=4.75", "run.samples=2"))
    ).trajectory()
    print(f"with μ = 0.3, by the file: {run.changes[0]}")
    with plt.rc_context(STYLE):
        folder.mkdir(parents=True, exist_ok=True)
        figure(found).savefig(folder / "eulers_disk.png", dpi=160)
    print(f"wrote {folder / 'eulers_disk.png'}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the figure")
    report(parser.parse_args().output)


if __name__ == "__main__":
    main()
