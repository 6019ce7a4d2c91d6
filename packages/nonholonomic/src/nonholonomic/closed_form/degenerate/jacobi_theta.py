"""Jacobi's four theta functions with derivatives, for a real nome: balls and arrays.

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
from typing import TypeAlias

import numpy as np
from flint import acb, arb, ctx

from flowlanes.system.arrays import FloatArray

from ..one_degree.functions import B, N

#: A function value and its derivative.
Pair: TypeAlias = tuple[N, N]

#: For each function: shift of its centres in multiples of ½π, and whether signs alternate.
_CENTRES = {1: (1, True), 2: (0, True), 3: (0, False), 4: (1, False)}
#: Number of terms on either side for double precision, for y ≥ 1 or y < 1 and |ζ| ≤ ½π.
_TERMS = 5


@dataclass(frozen=True)
class Thetas:
    """The theta functions of one nome, all times √y if y < 1.

    Attributes
    ----------
    y : arb
        Positive; the period ratio is iy.
    """

    y: arb

    @cached_property
    def gaussian(self) -> bool:
        """Whether the sums of Gaussians are used."""
        return self.y.mid() < 1

    def value(self, index: int, zeta: B) -> B:
        """θ_index(ζ)."""
        return self.pair(index, zeta)[0]

    def pair(self, index: int, zeta: N) -> Pair[N]:
        """θ_index and its derivative at ζ; in doubles for an array."""
        if isinstance(zeta, np.ndarray):
            return self._doubles(index, zeta)
        pi = arb.pi()
        turns = _nearest(zeta / pi)
        reduced = zeta - turns * pi
        series = self._gaussians if self.gaussian else self._waves
        value, slope = series(index, reduced)
        flips = _CENTRES[index][1] and turns % 2
        return (-value, -slope) if flips else (value, slope)

    def _waves(self, index: int, zeta: B) -> Pair[B]:
        odd = _CENTRES[index][1]
        pi = arb.pi()
        shifted = zeta + (pi / 2 if index in (2, 4) else 0)
        height = _height(zeta)
        value, slope = (0 * zeta, 0 * zeta) if odd else (0 * zeta + 1, 0 * zeta)
        n = 0 if odd else 1
        while True:
            order = 2 * n + 1 if odd else 2 * n
            weight = 2 * (-pi * self.y * order**2 / 4).exp()
            bound = order * weight * (order * height).exp()
            ratio = (-pi * self.y * (order + 1)).exp() * (2 * height).exp() * (order + 2) / order
            if ratio < 0.5 and bound < arb(2) ** (-ctx.prec - 8):
                return _with_error(value, 2 * bound), _with_error(slope, 2 * bound)
            angle = order * shifted
            if odd:
                signed = weight * (-1) ** n
                value, slope = value + signed * angle.sin(), slope + order * signed * angle.cos()
            else:
                value, slope = value + weight * angle.cos(), slope - order * weight * angle.sin()
            n += 1

    def _gaussians(self, index: int, zeta: B) -> Pair[B]:
        moved, alternating = _CENTRES[index]
        pi = arb.pi()
        height, width = _height(zeta), _width(zeta)
        value, slope = 0 * zeta, 0 * zeta
        n = 0
        while True:
            # the two centres with numbers n and −n−1 (shifted), or n and −n
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
                # Two terms per step; the omitted terms at most double the first ones.
                return _with_error(value, 4 * bound), _with_error(slope, 4 * bound)

    @cached_property
    def _ratio(self) -> float:
        return float(self.y.mid())

    def _doubles(self, index: int, zeta: FloatArray) -> Pair[FloatArray]:
        moved, alternating = _CENTRES[index]
        turns = np.rint(zeta / np.pi)
        reduced = (zeta - turns * np.pi)[..., None]
        n = np.arange(-_TERMS, _TERMS + 1)
        y = self._ratio
        if self.gaussian:
            from_centre = reduced - (2 * n + moved) * np.pi / 2
            terms = np.exp(-(from_centre**2) / (np.pi * y))
            terms = terms * (-1.0) ** n if alternating else terms
            value, slope = terms.sum(-1), (-2 / (np.pi * y) * from_centre * terms).sum(-1)
        else:
            order = 2 * n + 1 if alternating else 2 * n
            weight = np.exp(-np.pi * y * order**2 / 4)
            if index in (1, 4):
                weight = weight * (-1.0) ** n
            wave = (np.sin, np.cos, 1) if index == 1 else (np.cos, np.sin, -1)
            value = (weight * wave[0](order * reduced)).sum(-1)
            slope = (wave[2] * weight * order * wave[1](order * reduced)).sum(-1)
        sign = np.where(turns % 2 == 1, -1.0, 1.0) if alternating else 1.0
        return sign * value, sign * slope


def _nearest(ball: arb | acb) -> int:
    """An integer close to the real part."""
    return round(float(ball.real.mid()))


def _height(zeta: arb | acb) -> arb:
    return zeta.imag.abs_upper()


def _width(zeta: arb | acb) -> arb:
    return zeta.real.abs_upper()


def _with_error(ball: B, radius: arb) -> B:
    doubt = arb(0, radius.upper())
    return ball + acb(doubt, doubt) if isinstance(ball, acb) else ball + doubt
