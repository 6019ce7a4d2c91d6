"""Jacobi's four theta functions with their derivatives, for a real nome: balls and arrays.

With q = exp(−πy), y > 0,

    θ₁ = 2 Σ (−1)ⁿ q^{(n+½)²} sin (2n+1)ζ,      θ₃ = 1 + 2 Σ q^{n²} cos 2nζ,

θ₂(ζ) = θ₁(ζ + ½π), θ₄(ζ) = θ₃(ζ + ½π).  For y < 1 the same functions are taken as sums of
Gaussians, √y θ₃ = Σ exp(−(ζ − nπ)²/(πy)) over all integers n, in which nothing cancels and which
needs few terms where the first series needs many.  A motion is a ratio of theta functions, so the
common factor √y is left out there.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from flint import acb, arb, ctx

__all__ = ["Thetas"]

Pair = tuple[Any, Any]

#: For each function: multiples of ½π by which its centres are moved, and whether signs alternate.
_CENTRES = {1: (1, True), 2: (0, True), 3: (0, False), 4: (1, False)}
#: Terms to either side that double precision needs, y ≥ 1 or y < 1 and |ζ| ≤ ½π.
_TERMS = 5


@dataclass(frozen=True)
class Thetas:
    """The theta functions of one nome, all times √y when y < 1.

    Attributes
    ----------
    y : arb
        Positive; the period ratio is iy.
    """

    y: Any

    @cached_property
    def gaussian(self) -> bool:
        """Whether the sums of Gaussians are used."""
        return bool(self.y.mid() < 1)

    def value(self, index: int, zeta: Any) -> Any:
        """θ_index(ζ), a ball."""
        return self.pair(index, zeta)[0]

    def pair(self, index: int, zeta: Any) -> Pair:
        """θ_index and its derivative at an arb or acb, as balls."""
        pi = arb.pi()
        turns = _nearest(zeta / pi)
        rest = zeta - turns * pi
        value, slope = self._gaussians(index, rest) if self.gaussian else self._waves(index, rest)
        flips = _CENTRES[index][1] and turns % 2
        return (-value, -slope) if flips else (value, slope)

    def _waves(self, index: int, zeta: Any) -> Pair:
        odd = _CENTRES[index][1]
        pi = arb.pi()
        shifted = zeta + (pi / 2 if index in (2, 4) else 0)
        height = _height(zeta)
        value, slope = (0 * zeta, 0 * zeta) if odd else (0 * zeta + 1, 0 * zeta)
        n = 0 if odd else 1
        while True:
            place = 2 * n + 1 if odd else 2 * n
            weight = 2 * (-pi * self.y * place**2 / 4).exp()
            bound = place * weight * (place * height).exp()
            ratio = (-pi * self.y * (place + 1)).exp() * (2 * height).exp() * (place + 2) / place
            if ratio < 0.5 and bound < arb(2) ** (-ctx.prec - 8):
                return _widened(value, 2 * bound), _widened(slope, 2 * bound)
            angle = place * shifted
            if odd:
                signed = weight * (-1) ** n
                value, slope = value + signed * angle.sin(), slope + place * signed * angle.cos()
            else:
                value, slope = value + weight * angle.cos(), slope - place * weight * angle.sin()
            n += 1

    def _gaussians(self, index: int, zeta: Any) -> Pair:
        moved, alternating = _CENTRES[index]
        pi = arb.pi()
        height, width = _height(zeta), _width(zeta)
        value, slope = 0 * zeta, 0 * zeta
        n = 0
        while True:
            # the two centres number n and −n−1 (moved), or n and −n
            for k in {n, -n - moved}:
                from_centre = zeta - (2 * k + moved) * pi / 2
                sign = -1 if alternating and k % 2 else 1
                term = sign * (-from_centre * from_centre / (pi * self.y)).exp()
                value, slope = value + term, slope - 2 * from_centre / (pi * self.y) * term
            n += 1
            distance = (2 * n + moved) * pi / 2 - width
            if not distance > 1:
                continue
            reach = distance + height + 4
            bound = (
                reach
                * ((height * height - distance * distance) / (pi * self.y)).exp()
                * 4
                / (pi * self.y)
            )
            ratio = (-(2 * distance + pi) / self.y).exp() * (reach + pi) / reach
            if ratio < 0.5 and bound < arb(2) ** (-ctx.prec - 8):
                # two terms a step, and the terms left out at most double the first ones
                return _widened(value, 4 * bound), _widened(slope, 4 * bound)

    @cached_property
    def _ratio(self) -> float:
        return float(self.y.mid())

    def array(self, index: int, zeta: Any) -> Pair:
        """θ_index and its derivative at an array of real numbers, in double precision."""
        moved, alternating = _CENTRES[index]
        turns = np.rint(zeta / np.pi)
        rest = (zeta - turns * np.pi)[..., None]
        n = np.arange(-_TERMS, _TERMS + 1)
        y = self._ratio
        if self.gaussian:
            from_centre = rest - (2 * n + moved) * np.pi / 2
            terms = np.exp(-(from_centre**2) / (np.pi * y))
            terms = terms * (-1.0) ** n if alternating else terms
            value, slope = terms.sum(-1), (-2 / (np.pi * y) * from_centre * terms).sum(-1)
        else:
            place = 2 * n + 1 if alternating else 2 * n
            weight = np.exp(-np.pi * y * place**2 / 4)
            if index in (1, 4):
                weight = weight * (-1.0) ** n
            wave = (np.sin, np.cos, 1) if index == 1 else (np.cos, np.sin, -1)
            value = (weight * wave[0](place * rest)).sum(-1)
            slope = (wave[2] * weight * place * wave[1](place * rest)).sum(-1)
        sign = np.where(turns % 2 == 1, -1.0, 1.0) if alternating else 1.0
        return sign * value, sign * slope


def _nearest(ball: Any) -> int:
    """An integer near the real part."""
    real = ball.real if isinstance(ball, acb) else ball
    return round(float(real.mid()))


def _height(zeta: Any) -> Any:
    return zeta.imag.abs_upper() if isinstance(zeta, acb) else arb(0)


def _width(zeta: Any) -> Any:
    return (zeta.real if isinstance(zeta, acb) else zeta).abs_upper()


def _widened(ball: Any, radius: Any) -> Any:
    doubt = arb(0, radius.upper())
    return ball + acb(doubt, doubt) if isinstance(ball, acb) else ball + doubt
