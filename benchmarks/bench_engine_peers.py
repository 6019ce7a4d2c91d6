"""flowlanes, heyoka, SciPy and numba on four textbook systems, at equal error.

The systems are Lorenz, Hénon and Heiles, three bodies in a plane near the figure eight, and the
double pendulum.  As in ``engine.py``, the tolerance or number of steps of every program is chosen
for some random starts, so that the median error of a motion attains the target; errors and times
are measured for other starts, against motions with 34 digits.  The programs alternate; the results
are medians of the processor time of a motion, and their ratios to that of flowlanes.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
import sympy as sp
from contest import compiled, interpreted, ours, taylor
from contest.bodies import Body
from contest.programs import Program, Result, Trial, contest

from flowlanes import System

#: Seeds of the starts for the choice of settings, for errors and for times.
REHEARSED, SCORED, TIMED = 1, 2, 3


@dataclass(frozen=True)
class Textbook(Body):
    """System with starts that are uniform in a box about a state."""

    centre: np.ndarray = field(kw_only=True)
    width: np.ndarray = field(kw_only=True)

    def starts(self, seed: int, count: int) -> np.ndarray:
        """Random states of the box."""
        dice = np.random.default_rng([seed, *self.name.encode()])
        return np.asarray(self.centre + self.width * dice.uniform(-1, 1, (count, self.size)))


def lorenz() -> System:
    x, y, z = sp.symbols("x y z", real=True)
    rates = {x: 10 * (y - x), y: x * (28 - z) - y, z: x * y - sp.Rational(8, 3) * z}
    return System("lorenz", "Lorenz", rates)


def henon_heiles() -> System:
    x, y, u, v = sp.symbols("x y u v", real=True)
    rates = {x: u, y: v, u: -x - 2 * x * y, v: -y - x**2 + y**2}
    return System("henon-heiles", "Hénon and Heiles", rates)


def three_bodies() -> System:
    r = [sp.Matrix(sp.symbols(f"x_{i} y_{i}", real=True)) for i in range(3)]
    v = [sp.Matrix(sp.symbols(f"u_{i} v_{i}", real=True)) for i in range(3)]
    rates: dict[sp.Symbol, sp.Expr] = {}
    for i in range(3):
        rates |= dict(zip(r[i], v[i], strict=True))
    for i in range(3):
        others = [r[j] - r[i] for j in range(3) if j != i]
        pull = sum((d / d.dot(d) ** sp.Rational(3, 2) for d in others), sp.zeros(2, 1))
        rates |= dict(zip(v[i], pull, strict=True))
    return System("three-bodies", "Three bodies in a plane", rates)


def double_pendulum() -> System:
    a, b, p, q, s, c = sp.symbols("a b p q s c", real=True)
    first, second = -(q**2) * s - 2 * sp.sin(a), p**2 * s - sp.sin(b)
    rates = {
        a: p,
        b: q,
        p: (first - c * second) / (2 - c**2),
        q: (2 * second - c * first) / (2 - c**2),
    }
    steps = {s: sp.sin(a - b), c: sp.cos(a - b)}
    return System("double-pendulum", "Double pendulum", rates, definitions=steps)


def bodies() -> Iterator[Textbook]:
    """The four systems, with starts and durations."""
    x, y, u, v = 0.97000436, -0.24308753, 0.93240737 / 2, 0.86473146 / 2
    eight = (x, y, -x, -y, 0, 0, u, v, u, v, -2 * u, -2 * v)
    for system, span, centre, width in (
        (lorenz(), 5.0, (0, 0, 25), (10, 10, 10)),
        (henon_heiles(), 50.0, (0, 0, 0, 0), 0.25),
        (three_bodies(), 6.0, eight, 0.01),
        (double_pendulum(), 10.0, (0, 0, 0, 0), (1, 1, 0.5, 0.5)),
    ):
        yield Textbook(
            system.name, system, span, span, span, centre=np.array(centre), width=np.array(width)
        )


def programs(body: Body) -> list[Program]:
    """Programs to be compared."""
    return [
        ours.ensemble(body, body.span),
        taylor.batch(body, body.span),
        taylor.batch(body, body.span, fast_math=True),
        interpreted.scipy_method(body, body.span, "DOP853"),
        compiled.numba_adaptive(body, body.span),
        compiled.numba_fixed(body, body.span),
    ]


def measure(body: Body, target: float, states: int, many: int, turns: int) -> dict[str, Result]:
    """Results of all programs for one system."""
    rehearsed, scored = body.starts(REHEARSED, states), body.starts(SCORED, states)
    trial = Trial(
        rehearsed,
        body.ends(rehearsed, body.span),
        scored,
        body.ends(scored, body.span),
        body.starts(TIMED, many),
    )
    return contest(programs(body), trial, target, turns)


def main() -> None:
    """Print a table for each system."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--target", type=float, default=1e-10, help="median error of a motion")
    # full batches, because an unused lane could end the batch early
    parser.add_argument("--states", type=int, default=16)
    parser.add_argument("--many", type=int, default=512)
    parser.add_argument("--turns", type=int, default=5)
    options = parser.parse_args()
    for body in bodies():
        results = measure(body, options.target, options.states, options.many, options.turns)
        own = results[ours.NAME].core
        print(f"{body.name}, t = {body.span:g}")
        for label, found in results.items():
            name = "flowlanes" if label == ours.NAME else label
            if found.setting is None:
                print(f"  {name:32} does not reach the target")
                continue
            print(
                f"  {name:32} {1e6 * found.core:10.1f} µs  {found.core / own:8.2f}"
                f"  error {found.error:.1e} (worst {found.worst:.1e})",
                flush=True,
            )


if __name__ == "__main__":
    main()
