"""A Lagrange top with the values of its integrals, and the equation of cos θ."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from flint import acb, arb

from ..one_degree.uniformisation import Equation, Uniformisation
from .elliptic import Elliptic

__all__ = ["Top"]


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

    across: Any
    axial: Any
    weight: Any
    h: Any
    s: Any
    c: Any
    upright: tuple[bool, bool]

    @property
    def equation(self) -> Equation:
        """The equation of u."""
        I, s, c = self.across, self.s, self.c

        def depth(u: Any) -> Any:
            return 2 * (self.h - self.weight * u) - s * s / self.axial

        def numerator(u: Any) -> Any:
            return depth(u) * (1 - u * u) - (c - s * u) * (c - s * u) / I

        inner: dict[tuple[bool, bool], Callable[[Any], Any]] = {
            (True, True): depth,
            (False, True): lambda u: depth(u) * (1 + u) - s * s * (1 - u) / I,
            (True, False): lambda u: depth(u) * (1 - u) - s * s * (1 + u) / I,
            (False, False): numerator,
        }
        return Equation(numerator, lambda u: I, arb(-1), arb(1), inner[self.upright], self.upright)

    def elliptic(self, chart: Uniformisation) -> Elliptic | None:
        """u as an elliptic function between the ends of its motion; None for another motion."""
        s, I = self.s, self.across
        level = 2 * self.h - s * s / self.axial
        first, second = sorted((chart.first.place, chart.second.place), key=float)
        # the sum of the roots, by the coefficients of u³ and u²
        third = (level + s * s / I) / (2 * self.weight) - first - second
        apart = self.weight > 0 and third > second
        return Elliptic(2 * self.weight / I, first, second, third) if apart else None

    def rates(self, u: Any, rate: Any) -> list[Any]:
        """φ̇, in complex balls."""
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
