"""Tori of the Veselova top and the marble ball, n = 4, whose flow is not linear, proven in balls.

    python examples/quadratic_integrals_torus.py [PICTURE]

Were the flow on an invariant torus conjugate to a linear one, in whatever time, and one orbit
closed, then all would be closed and wind around alike.  On the levels found here the orbit from
φ = (0, 0, 0) is closed with the winding numbers 4 : 3 : 2 and that from (0, 0, π) is not.  The flow
is (5) of nonholonomic/docs/quadratic-integrals.md with φ_1 for the time; a step of the Taylor
series is enclosed by balls with its remainder, and the zeros f_1, f_2 of the level are shown to
exist by the theorem of Krawczyk.  Then a section of a nearby level of the top is drawn.
"""

from __future__ import annotations

import sys
from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from flint import arb, arb_series, ctx
from matplotlib.figure import Figure
from numpy.typing import NDArray

from chaplygin import System
from chaplygin.report.drawing.style import SERIES, STYLE, WIDTH
from chaplygin.report.figures import save
from flowlanes import batch_integrator
from nonholonomic.catalogue.so_n.invariant_tori import torus_system

#: φ_1 goes around four times while φ_2 goes around three times and φ_3 twice.
WINDING = (4, 3, 2)
#: The zeros at which the orbit of the top from (0, 0, π) closes, for the picture alone.
OTHER_ZEROS = (0.67618017, 2.92315962)
#: A level for comparison.
ANOTHER_LEVEL = (0.70, 2.90)
#: Radius of the balls in which f_1 and f_2 are shown to lie.
RADIUS = 1e-10
#: Orders of the Taylor series: of the centre, of the slopes, of the other orbit.
ORDER, ORDER_OF_SLOPES, ORDER_OF_OTHER = 15, 10, 12
BITS = 128


@dataclass(frozen=True)
class Jet:
    """A series in φ_1 and its derivatives by f_1 and f_2; no derivatives stand for zeros."""

    value: arb_series
    slope: tuple[arb_series, ...] = ()

    def __add__(self, other: Jet) -> Jet:
        if not (self.slope and other.slope):
            return Jet(self.value + other.value, self.slope or other.slope)
        pairs = zip(self.slope, other.slope, strict=True)
        return Jet(self.value + other.value, tuple(a + b for a, b in pairs))

    def __sub__(self, other: Jet) -> Jet:
        return self + other.scaled(arb(-1))

    def __mul__(self, other: Jet) -> Jet:
        value = self.value * other.value
        left = tuple(a * other.value for a in self.slope)
        right = tuple(self.value * b for b in other.slope)
        if not (left and right):
            return Jet(value, left or right)
        return Jet(value, tuple(a + b for a, b in zip(left, right, strict=True)))

    def scaled(self, number: arb) -> Jet:
        """A multiple."""
        return Jet(self.value * number, tuple(a * number for a in self.slope))

    def chained(self, value: arb_series, derivative: arb_series) -> Jet:
        """A function of it, given its value and derivative."""
        return Jet(value, tuple(derivative * a for a in self.slope))

    def root(self) -> Jet:
        """Its square root."""
        value = self.value.sqrt()
        return self.chained(value, 1 / (2 * value))

    def inverse(self) -> Jet:
        """Its reciprocal."""
        value = 1 / self.value
        return self.chained(value, -(value * value))

    def cosine(self) -> Jet:
        """Its cosine."""
        return self.chained(self.value.cos(), -self.value.sin())


@dataclass(frozen=True)
class Body(ABC):
    """A rigid body with the mass tensor J = diag(c_1, …, c_4), and a level of its integrals.

    Attributes
    ----------
    name : str
    masses : tuple of Fraction
        c_1 < … < c_4, kg m².
    zeros : pair of str
        The zeros f_1, f_2 of P(λ)F_λ for which the orbit from 0 is closed, nearly.
    steps : int
        Steps for 4π of φ_1.
    """

    name: str
    masses: tuple[Fraction, Fraction, Fraction, Fraction]
    zeros: tuple[str, str]
    steps: int

    @property
    def c(self) -> list[arb]:
        """The masses as balls."""
        return [arb(x.numerator) / x.denominator for x in self.masses]

    @property
    @abstractmethod
    def ends(self) -> list[arb]:
        """The zeros of P, between which the σ_k lie."""

    @abstractmethod
    def factor(self, first: Jet, second: Jet) -> Jet:
        """β_k of two other σ."""


class Top(Body):
    """The Veselova top."""

    @property
    def ends(self) -> list[arb]:
        """The c_i."""
        return self.c

    def factor(self, first: Jet, second: Jet) -> Jet:
        """tr J − σ_l − σ_m."""
        return Jet(sum(self.c, arb(0))) - first - second


class Marble(Body):
    """The marble ball with m R² = 1 on the level k = p ∧ γ."""

    @property
    def ends(self) -> list[arb]:
        """b_i = c_i²."""
        return [x * x for x in self.c]

    def factor(self, first: Jet, second: Jet) -> Jet:
        """h(h + 1), 1/h = Σ c_i (b_i − σ_l)(b_i − σ_m)/P′(b_i)."""
        constant, linear, product = self._moments
        # as a sum of positive terms, which keeps the balls small
        shift = Jet(linear / product)
        g = ((first - shift) * (second - shift)).scaled(product)
        g = g + Jet(constant - linear * linear / product)
        return (g + Jet(arb(1))) * (g * g).inverse()

    @cached_property
    def _moments(self) -> tuple[arb, arb, arb]:
        """Σ c_i b_i^m/P′(b_i) for m = 2, 1, 0: of 1, −(σ_l + σ_m) and σ_l σ_m in 1/h."""
        b = self.ends
        sums = [arb(0), arb(0), arb(0)]
        for i, mass in enumerate(self.c):
            slope = arb(1)
            for j, other in enumerate(b):
                if j != i:
                    slope *= b[i] - other
            for m in range(3):
                sums[m] += mass * b[i] ** (2 - m) / slope
        return sums[0], sums[1], sums[2]


TOP = Top(
    "Veselova top",
    (Fraction(1, 10), Fraction(2, 5), Fraction(13, 10), Fraction(3)),
    ("0.67603241791995", "2.92419439819055"),
    400,
)
MARBLE = Marble(
    "marble ball",
    (Fraction(1, 5), Fraction(1, 2), Fraction(1), Fraction(2)),
    ("0.42138492596760", "2.31510527676958"),
    640,
)

#: φ_2 and φ_3, each with its derivatives by f_1 and f_2 if they are carried.
State = list[list[arb]]


class TorusFlow:
    """The flow on the torus with φ_1 for the time, where f_1 < P's third zero < f_2 < the fourth.

    Parameters
    ----------
    body : Body
    zeros : pair of arb
        f_1 and f_2.
    slopes : bool
        Whether derivatives by them are carried along.
    """

    def __init__(self, body: Body, zeros: Sequence[arb], slopes: bool) -> None:
        self.body = body
        self.width = 2 if slopes else 0
        units = ((arb(1), arb(0)), (arb(0), arb(1))) if slopes else ((), ())
        c = [Jet(end) for end in body.ends]
        f = [Jet(zero, unit) for zero, unit in zip(zeros, units, strict=True)]
        self.roots = [c[0], c[1], f[0], c[2], f[1], c[3]]
        if any(not low.value < high.value for low, high in pairwise(self.roots)):
            raise ArithmeticError("the zeros are not in the order that is needed")
        half = arb(1) / 2
        ends = [(self.roots[2 * k], self.roots[2 * k + 1]) for k in range(3)]
        self.middle = [(low + high).scaled(half) for low, high in ends]
        self.amplitude = [(high - low).scaled(half) for low, high in ends]

    def rate(self, x: arb_series, y: Sequence[Jet]) -> tuple[Jet, Jet]:
        """dφ_2/dφ_1 and dφ_3/dφ_1."""
        cosines = [Jet(x.cos()), *(angle.cosine() for angle in y)]
        sigma = [m - a * c for m, a, c in zip(self.middle, self.amplitude, cosines, strict=True)]
        beyond = []
        for k in range(3):
            others = [i for i in range(6) if i // 2 != k]
            distances = [
                sigma[k] - self.roots[i] if i // 2 < k else self.roots[i] - sigma[k] for i in others
            ]
            beyond.append(distances[0] * distances[1] * (distances[2] * distances[3]))
        s_1, s_2, s_3 = sigma
        beta = [self.body.factor(*pair) for pair in ((s_2, s_3), (s_1, s_3), (s_1, s_2))]
        common = beta[0] * (beyond[0] * beta[1] * beta[2]).inverse()
        gap = (s_3 - s_2).inverse()
        second = (s_3 - s_1) * gap * (beyond[1] * beta[2] * common).root()
        third = (s_2 - s_1) * gap * (beyond[2] * beta[1] * common).root()
        return second, third

    def coefficients(self, x: arb, state: State, order: int) -> list[list[list[arb]]]:
        """Taylor coefficients of the orbit through a point, or of all through a box."""
        series = [[[entry] for entry in row] for row in state]
        for length in range(1, order + 1):
            ctx.cap = length
            time = arb_series([x, 1][:length], length)
            jets = [
                Jet(arb_series(row[0], length), tuple(arb_series(a, length) for a in row[1:]))
                for row in series
            ]
            for row, jet in zip(series, self.rate(time, jets), strict=True):
                for entry, part in zip(row, (jet.value, *jet.slope), strict=True):
                    entry.append(part[length - 1] / length)
        return series

    def _box(self, x: arb, state: State, span: arb) -> State:
        """A box in which the orbit stays during a step: Picard's map takes it into itself."""

        def picard(box: State) -> State:
            slopes = [[entry[1] for entry in row] for row in self.coefficients(x + span, box, 1)]
            return [
                [a + span * b for a, b in zip(row, slope, strict=True)]
                for row, slope in zip(state, slopes, strict=True)
            ]

        box = picard(state)
        for _ in range(40):
            box = [[a + arb(0, 1e-30 + 0.1 * float(a.rad())) for a in row] for row in box]
            image = picard(box)
            if all(
                a.contains_interior(b)
                for row, inner in zip(box, image, strict=True)
                for a, b in zip(row, inner, strict=True)
            ):
                return image
            box = [
                [a.union(b) for a, b in zip(row, inner, strict=True)]
                for row, inner in zip(box, image, strict=True)
            ]
        raise ArithmeticError("no enclosure of a step was found")

    def image(self, start: Sequence[arb], turns: int, order: int) -> State:
        """φ_2 and φ_3 where φ_1 has gone from 0 to 2π `turns`, with their slopes, enclosed."""
        steps = self.body.steps * turns // 2
        step = 2 * turns * arb.pi() / steps
        span = arb(0).union(step)
        state = [[angle, *[arb(0)] * self.width] for angle in start]
        for number in range(steps):
            x = step * number
            centre = self.coefficients(x, state, order)
            box = self._box(x, state, span)
            rest = self.coefficients(x + span, box, order + 1)
            state = [
                [
                    sum((a * step**i for i, a in enumerate(near)), far[-1] * step ** (order + 1))
                    for near, far in zip(row, beyond, strict=True)
                ]
                for row, beyond in zip(centre, rest, strict=True)
            ]
        return state


def krawczyk(body: Body, centre: Sequence[arb]) -> list[arb]:
    """Balls that contain exactly one pair of zeros for which the orbit from 0 closes.

    Raises
    ------
    ArithmeticError
        If Krawczyk's operator does not take the balls into themselves.
    """
    first, second, third = WINDING
    goal = [second * arb.pi(), third * arb.pi()]
    start = [arb(0), arb(0)]
    # the orbit is symmetric: it closes after its half
    middle = TorusFlow(body, centre, slopes=False).image(start, first // 2, ORDER)
    miss = [row[0] - aim for row, aim in zip(middle, goal, strict=True)]
    around = [zero + arb(0, RADIUS) for zero in centre]
    slopes = TorusFlow(body, around, slopes=True).image(start, first // 2, ORDER_OF_SLOPES)
    (a, b), (c, d) = ([entry.mid() for entry in row[1:]] for row in slopes)
    below = a * d - b * c
    inverse = [[d / below, -b / below], [-c / below, a / below]]
    found = []
    for i in range(2):
        image = centre[i] - sum(inverse[i][j] * miss[j] for j in range(2))
        for j in range(2):
            entry = sum(inverse[i][k] * slopes[k][1 + j] for k in range(2))
            image += ((1 if i == j else 0) - entry) * arb(0, RADIUS)
        if not around[i].contains_interior(image):
            raise ArithmeticError("Krawczyk's operator leaves the balls")
        found.append(image)
    return found


def nonlinear_torus(body: Body) -> Iterator[str]:
    """The certificate, line by line."""
    ctx.prec = BITS
    first, second, third = WINDING
    level = krawczyk(body, [arb(zero).mid() for zero in body.zeros])
    yield (
        f"{body.name}, f_1 = {level[0].str(12)}, f_2 = {level[1].str(12)}: the orbit from "
        "(0, 0, 0) closes"
    )
    pi = arb.pi()
    flow = TorusFlow(body, level, slopes=False)
    end = flow.image([arb(0), pi], first // 2, ORDER_OF_OTHER)
    miss = [end[0][0] - second * pi, end[1][0] - pi - third * pi]
    yield f"that from (0, 0, π) misses by {miss[0].str(8)} and {miss[1].str(8)}"
    proven = any(not part.contains(arb(0)) for part in miss)
    yield f"not conjugate to a linear flow: {'proven' if proven else 'undecided'}"


# --- the picture ---------------------------------------------------------------------------


def section_system(zeros: Sequence[float]) -> System:
    """The flow on the torus with φ_1 for the time: φ_1 is state and clock."""
    system = torus_system([float(mass) for mass in TOP.masses], list(zeros))
    clock, *others = system.symbols
    first, *rates = system.rates
    return System(
        name="section",
        title="Flow on a torus",
        field={clock: 1, **{s: r / first for s, r in zip(others, rates, strict=True)}},
        definitions=system.definitions,
    )


def section_points(
    zeros: Sequence[float], starts: NDArray[np.float64], returns: int
) -> NDArray[np.float64]:
    """φ_2 and φ_3 after each four turns of φ_1, shape (starts, returns, 2)."""
    times = 2 * np.pi * WINDING[0] * np.arange(1, returns + 1)
    begin = np.column_stack([np.zeros(len(starts)), starts])
    motions = batch_integrator(section_system(zeros), tolerance=1e-13).propagate(begin, times)
    points: Any = motions.states[:, :, 1:]
    return np.asarray(np.mod(points, 2 * np.pi))


def draw(returns: int = 16_000) -> Figure:
    """Sections of two levels: among those with closed orbits of 4 : 3 : 2, and away from them."""
    resonant = [(float(a) + b) / 2 for a, b in zip(TOP.zeros, OTHER_ZEROS, strict=True)]
    levels = {
        f"with closed orbits, {returns:,} points each": (resonant, returns),
        "another level, 500 points each": (ANOTHER_LEVEL, 500),
    }
    grid = (np.arange(4) + 0.37) * 2 * np.pi / 4
    starts = np.array([[a, b] for a in grid for b in grid])
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(
            1, 2, figsize=(WIDTH, 0.56 * WIDTH), sharey=True, layout="constrained"
        )
        for axis, (title, (level, count)) in zip(axes, levels.items(), strict=True):
            for number, orbit in enumerate(section_points(level, starts, count)):
                axis.plot(*orbit.T, ",", color=SERIES[number % len(SERIES)], rasterized=True)
            axis.set(
                xlim=(0, 2 * np.pi), ylim=(0, 2 * np.pi), xlabel=r"$\varphi_2$ (rad)", title=title
            )
            axis.set_xticks([0, np.pi, 2 * np.pi], ["0", "π", "2π"])
            axis.set_yticks([0, np.pi, 2 * np.pi], ["0", "π", "2π"])
            axis.set_aspect("equal")
        axes[0].set_ylabel(r"$\varphi_3$ (rad)")
    return figure


def main() -> None:
    """Print the certificate and draw the section."""
    for body in (TOP, MARBLE):
        for line in nonlinear_torus(body):
            print(line)
    if sys.argv[1:]:
        save(draw(), Path(sys.argv[1]))


if __name__ == "__main__":
    main()
