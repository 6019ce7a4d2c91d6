"""A Lagrange top with the values of its integrals, and the equation of cos θ."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

from flint import acb, arb

from flowlanes.formulas.relative_zero import vanishes

from ..one_degree.divided_differences import Argument, Formula
from ..one_degree.uniformisation import Equation, Uniformisation

Vector: TypeAlias = Sequence[arb]


@dataclass(frozen=True)
class Top:
    """A top with the values of its integrals; balls.

    Attributes
    ----------
    across, axial, weight : arb
        I₁, I₃ and P.
    h, s, c : arb
        Energy, M₃ and (M, Γ).
    upright : two bools
        Whether the axis can point down, and up: whether c cannot be told from −s, and from s.
    """

    across: arb
    axial: arb
    weight: arb
    h: arb
    s: arb
    c: arb
    upright: tuple[bool, bool]

    @property
    def equation(self) -> Equation:
        """The equation of u."""
        I, s, c = self.across, self.s, self.c

        def depth(u: Argument) -> Argument:
            return 2 * (self.h - self.weight * u) - s * s / self.axial

        def numerator(u: Argument) -> Argument:
            return depth(u) * (1 - u * u) - (c - s * u) * (c - s * u) / I

        def inner_down(u: Argument) -> Argument:
            return depth(u) * (1 - u) - s * s * (1 + u) / I

        def inner_up(u: Argument) -> Argument:
            return depth(u) * (1 + u) - s * s * (1 - u) / I

        def denominator(u: Argument) -> arb:
            return I

        inner: dict[tuple[bool, bool], Formula] = {
            (True, True): depth,
            (False, True): inner_up,
            (True, False): inner_down,
            (False, False): numerator,
        }
        return Equation(numerator, denominator, arb(-1), arb(1), inner[self.upright], self.upright)

    def elliptic_parameters(self, chart: Uniformisation) -> tuple[arb, arb] | None:
        """k² and w in u = u₁ + (u₂ − u₁) sn²(wt, k); None if u has only two finite roots.

        With roots u₁ < u₂ < u₃ and the leading coefficient λ of u̇², w = ½√(λ(u₃ − u₁)) and
        k² = (u₂ − u₁)/(u₃ − u₁).
        """
        s, I = self.s, self.across
        level = 2 * self.h - s * s / self.axial
        first, second = sorted((chart.first.x, chart.second.x), key=float)
        # The sum of the roots, from the coefficients of u³ and u².
        third = (level + s * s / I) / (2 * self.weight) - first - second
        if not (self.weight > 0 and third > second):
            return None
        frequency = (2 * self.weight / I * (third - first)).sqrt() / 2
        return (second - first) / (third - first), frequency

    def rates(self, u: acb, rate: acb) -> list[acb]:
        """φ̇."""
        I, s, c = self.across, self.s, self.c
        steady = (1 / self.axial - 1 / I) * s
        down, up = self.upright
        if down and up:
            return [acb(steady)]
        if up:
            return [steady + s / (I * (1 + u))]
        if down:
            return [steady + s / (I * (1 - u))]
        return [steady + (s - c * u) / (I * (1 - u * u))]


def level_of(numbers: Vector, momentum: Vector, vertical: Vector) -> Top:
    """The top with I₁, I₃ and P at a state on the phase space."""
    across, axial, weight = numbers
    first, second, s = momentum
    energy = (first * first + second * second) / (2 * across) + s * s / (2 * axial)
    c = sum((a * b for a, b in zip(momentum, vertical, strict=True)), arb(0))
    size = sum((abs(x) for x in momentum), arb(0))
    if vanishes(s, size) or size.is_zero():
        s = arb(0)
    down, up = (vanishes(c - value, size) or size.is_zero() for value in (-s, s))
    c = s if up else -s if down else c
    return Top(across, axial, weight, energy + weight * vertical[2], s, c, (down, up))
