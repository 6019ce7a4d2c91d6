"""Costs of other methods: evaluations of the rates, and sums, at equal median error.

Motions of ``engine.py`` are integrated with equal steps in NumPy.  For each method the result is
the smallest number of evaluations per second of motion for which the median error of 24 starts is
at most the target, interpolated between the tested numbers in logarithms.  Prince's methods need
the package ``extensisq``, and are omitted without it.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any

import numpy as np
import sympy as sp
from contest.bodies import BODIES, Body
from contest.generated import defined, field_text, operations
from scipy.integrate import DOP853

Rates = Callable[..., tuple[Any, ...]]
RATES = (30, 40, 50, 60, 75, 90, 110, 130, 160, 200)


@dataclass(frozen=True)
class RungeKutta:
    """Explicit Runge–Kutta method with its table."""

    name: str
    a: np.ndarray
    b: np.ndarray

    @property
    def evaluations(self) -> int:
        """Number of evaluations of the rates in a step."""
        return len(self.b)

    @property
    def sums(self) -> float:
        """Number of multiplications and additions per variable and evaluation."""
        return float(np.count_nonzero(self.a) + np.count_nonzero(self.b)) / len(self.b)

    def ends(self, rates: Rates, states: np.ndarray, until: float, steps: int) -> np.ndarray:
        """States at the final time."""
        h = until / steps
        for _ in range(steps):
            slopes: list[np.ndarray] = []
            for row in self.a:
                terms = [w * k for w, k in zip(row, slopes, strict=False) if w]
                slopes.append(np.array(rates(*(states + h * sum(terms, 0 * states)))))
            states = states + h * sum(w * k for w, k in zip(self.b, slopes, strict=True) if w)
        return states


@dataclass(frozen=True)
class Adams:
    """Predictor of one order and corrector of the next, with the rates evaluated after both."""

    order: int
    evaluations: int = 2

    @property
    def name(self) -> str:
        """Name of the method."""
        return f"Adams, order {self.order} and {self.order + 1}"

    @property
    def sums(self) -> float:
        """Number of multiplications and additions per variable and evaluation."""
        return self.order + 0.5

    def ends(self, rates: Rates, states: np.ndarray, until: float, steps: int) -> np.ndarray:
        """States at the final time; the steps before the start are computed by a finer method."""
        h = until / steps
        predictor, corrector = _weights(self.order, 0), _weights(self.order + 1, 1)
        before, slopes = states, [np.array(rates(*states))]
        for _ in range(self.order - 1):
            before = _DORMAND_PRINCE.ends(rates, before, -h, 2)
            slopes.append(np.array(rates(*before)))
        for _ in range(steps):
            ahead = states + h * sum(w * k for w, k in zip(predictor, slopes, strict=True))
            new = [np.array(rates(*ahead)), *slopes]
            states = states + h * sum(w * k for w, k in zip(corrector, new, strict=True))
            slopes = [np.array(rates(*states)), *slopes[:-1]]
        return states


def _weights(count: int, first: int) -> list[float]:
    """Integrals over [0, 1] of the Lagrange basis polynomials of the nodes first, first − 1, …"""
    x = sp.Symbol("x")
    nodes = [first - i for i in range(count)]
    cardinal = (sp.prod([(x - z) / sp.Rational(y - z) for z in nodes if z != y]) for y in nodes)
    return [float(sp.integrate(sp.expand(p), (x, 0, 1))) for p in cardinal]


_DORMAND_PRINCE = RungeKutta("Dormand and Prince, order 8", DOP853.A[:12, :12], DOP853.B)


def methods() -> Iterator[RungeKutta | Adams]:
    """Methods to be compared."""
    yield _DORMAND_PRINCE
    if find_spec("extensisq"):
        from extensisq import Pr8, Pr9

        for order, table in ((8, Pr8), (9, Pr9)):
            count = table.n_stages
            yield RungeKutta(f"Prince, order {order}", table.A[:count], table.B[:count])
    for order in (8, 10, 12):
        yield Adams(order)


@dataclass(frozen=True)
class Race:
    """Body with starts and exact final states."""

    body: Body
    rates: Rates
    starts: np.ndarray
    right: np.ndarray

    def error(self, method: RungeKutta | Adams, steps: int) -> float:
        """Median error of a method with equal steps."""
        with np.errstate(all="ignore"):
            ends = method.ends(self.rates, self.starts.T, self.body.span, steps).T
        apart = np.abs(ends - self.right).max(axis=1) / np.abs(self.right).max(axis=1)
        return float(np.median(apart))

    def evaluations(self, method: RungeKutta | Adams, target: float) -> float:
        """Evaluations per second of motion for a median error; NaN outside the tested numbers."""
        before: tuple[float, float] | None = None
        for rate in RATES:
            steps = round(self.body.span * rate / method.evaluations)
            here = steps * method.evaluations / self.body.span, self.error(method, steps)
            if here[1] <= target:
                if before is None or not math.isfinite(before[1]):
                    return here[0]
                (x, e), (y, f) = before, here
                share = (math.log(e) - math.log(target)) / (math.log(e) - math.log(f))
                return math.exp(math.log(x) + share * (math.log(y) - math.log(x)))
            before = here
        return math.nan


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--target", type=float, default=1e-10, help="median error")
    target = parser.parse_args().target
    for name, body in BODIES.items():
        rates = defined(field_text(body), {"sqrt": np.sqrt})["field"]
        starts = body.starts(1, 24)
        race = Race(body, rates, starts, body.ends(starts, body.span))
        own = sum(operations(body).values())
        print(f"{name}: {own} operations in the rates, {body.size} variables")
        for method in methods():
            count = race.evaluations(method, target)
            work = count * (own + method.sums * body.size)
            print(
                f"  {method.name:28} {count:6.1f} evaluations a second, "
                f"{method.sums:4.1f} sums a variable, {work / 1000:5.1f} thousand operations"
            )


if __name__ == "__main__":
    main()
