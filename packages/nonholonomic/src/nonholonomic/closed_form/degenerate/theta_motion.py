"""The unit vector of a motion on an elliptic curve, as ratios of theta functions.

Both kinds of motion have ν = N/|N|.  When one variable stays at the double root e, the other gives

    N_i = c_i θ_i(v),        v = v₀ + Ωτ,

a motion of one frequency, with N_i = 0 when e is the pole e_i.  When e closes the gap between the
two variables, with e = z(s) and U = v₁ + v₂,

    N_i = c_i (e^{−κ} θ_i(U − s) ± e^{κ} θ_i(U + s)),       N_e = c_e θ₁(U),

U and κ linear in τ (the minus sign belongs to θ₁): this runs from one periodic motion to another.
It holds because σ(v − v₁)σ(v − v₂) is a combination of σ(v − s)σ(v + s − U) and σ(v + s)σ(v − s −
U), evaluated at v = ±s and at the half-periods.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np
from flint import arb

from flowlanes.system.arrays import FloatArray
from flowlanes.system.tuple_vectors import dot

from ..one_degree.functions import BALLS, DOUBLES, B, Functions, N
from .jacobi_theta import Thetas

#: N and N′, or ν and ν′.
Pair: TypeAlias = tuple[list[N], list[N]]


class Numerators(ABC):
    """N and N′ as functions of τ, both up to one common factor.

    N′ is the derivative along the flow that defines ν′, which may differ from that of τ.
    """

    @property
    @abstractmethod
    def period(self) -> arb:
        """The period in τ of all theta functions."""

    @abstractmethod
    def balls(self, tau: B) -> Pair[B]:
        """N and N′ at τ."""

    @abstractmethod
    def doubles(self, tau: FloatArray, turns: FloatArray | float) -> Pair[FloatArray]:
        """N and N′ at the times τ + turns · period, in double precision."""


@dataclass(frozen=True)
class Periodic(Numerators):
    """A motion with one frequency.

    Attributes
    ----------
    thetas : Thetas
    indices : three int
        Which theta function belongs to which component.
    amplitudes : three arb
        c_i, with signs; zero for a component that vanishes.
    phase, speed : arb
        v₀ and Ω.
    turn : arb
        dv for the flow along which N′ is taken.
    """

    thetas: Thetas
    indices: tuple[int, ...]
    amplitudes: tuple[arb, ...]
    phase: arb
    speed: arb
    turn: arb

    @property
    def period(self) -> arb:
        """The time τ in which U grows by 2π."""
        return 2 * arb.pi() / abs(self.speed)

    def balls(self, tau: B) -> Pair[B]:
        """N and N′ at τ."""
        return self._values(BALLS, tau)

    def doubles(self, tau: FloatArray, turns: FloatArray | float) -> Pair[FloatArray]:
        """N and N′ in double precision."""
        return self._values(DOUBLES, tau)

    def _values(self, F: Functions[N], tau: N) -> Pair[N]:
        v, turn = F.number(self.phase) + F.number(self.speed) * tau, F.number(self.turn)
        values, slopes = [], []
        for amplitude, index in zip(self.amplitudes, self.indices, strict=True):
            c, (value, slope) = F.number(amplitude), self.thetas.pair(index, v)
            values.append(c * value)
            slopes.append(c * turn * slope)
        return values, slopes


@dataclass(frozen=True)
class Asymptotic(Numerators):
    """A motion from one periodic motion to another.

    Attributes
    ----------
    thetas : Thetas
    shift : arb
        s, between 0 and ½π.
    indices : three int
        Which theta function belongs to which component; 0 for the one that dies out.
    amplitudes : three arb
        c_i, with signs.
    phase, speed : arb
        U = phase + speed · τ.
    offset, growth : arb
        κ = offset + growth · τ.
    turn : (arb, arb)
        dU and dκ for the flow along which N′ is taken.
    """

    thetas: Thetas
    shift: arb
    indices: tuple[int, ...]
    amplitudes: tuple[arb, ...]
    phase: arb
    speed: arb
    offset: arb
    growth: arb
    turn: tuple[arb, arb]

    @property
    def period(self) -> arb:
        """The time τ in which U grows by 2π."""
        return 2 * arb.pi() / abs(self.speed)

    def balls(self, tau: B) -> Pair[B]:
        """N and N′ at τ."""
        U, kappa = self.phase + self.speed * tau, self.offset + self.growth * tau
        # The common factor keeps the larger exponential at one.
        after = kappa.real.mid() > 0
        small = (-2 * kappa if after else 2 * kappa).exp()
        middle = (-kappa if after else kappa).exp()
        one = 0 * small + 1
        return self.combination(BALLS, U, *((small, one) if after else (one, small)), middle)

    def combination(self, F: Functions[N], U: N, down: N, up: N, middle: N) -> Pair[N]:
        """N and N′ with given factors of θ(U − s), θ(U + s) and of the decaying component."""
        pair, s = self.thetas.pair, F.number(self.shift)
        speed, growth = (F.number(x) for x in self.turn)
        values, slopes = [], []
        for amplitude, index in zip(self.amplitudes, self.indices, strict=True):
            if index == 0:
                value, slope = pair(1, U)
                value, slope = middle * value, middle * speed * slope
            else:
                sign = -1 if index == 1 else 1
                (one, one_slope), (two, two_slope) = pair(index, U - s), pair(index, U + s)
                value = down * one + sign * up * two
                slope = down * (speed * one_slope - growth * one)
                slope = slope + sign * up * (speed * two_slope + growth * two)
            values.append(F.number(amplitude) * value)
            slopes.append(F.number(amplitude) * slope)
        return values, slopes

    def doubles(self, tau: FloatArray, turns: FloatArray | float) -> Pair[FloatArray]:
        """N and N′ in double precision."""
        growth = float(self.growth)
        U = float(self.phase) + float(self.speed) * tau
        kappa = float(self.offset) + growth * tau + growth * float(self.period) * turns
        return self.with_phases(U, kappa)

    def with_phases(self, U: FloatArray, kappa: FloatArray) -> Pair[FloatArray]:
        """N and N′ for given U and κ (arrays)."""
        size = np.abs(kappa)
        down, up, middle = np.exp(-kappa - size), np.exp(kappa - size), np.exp(-size)
        return self.combination(DOUBLES, U, down, up, middle)

    def limit(self, side: int) -> Periodic:
        """The periodic motion approached as κ → ∞ (`side` 1) or −∞ (−1)."""
        amplitudes = tuple(
            arb(0) if index == 0 else (-c if index == 1 and side > 0 else c)
            for c, index in zip(self.amplitudes, self.indices, strict=True)
        )
        indices = tuple(index or 1 for index in self.indices)
        phase = self.phase + side * self.shift
        return Periodic(self.thetas, indices, amplitudes, phase, self.speed, self.turn[0])

    def with_start(self, phase: arb, offset: arb, signs: Sequence[int] = (1, 1, 1)) -> Asymptotic:
        """The motion with other phases at τ = 0 and with reflected components."""
        reflected = tuple(sign * c for sign, c in zip(signs, self.amplitudes, strict=True))
        return replace(self, phase=phase, offset=offset, amplitudes=reflected)


def direction(F: Functions[N], values: Sequence[N], slopes: Sequence[N]) -> Pair[N]:
    """ν and ν′ from N and N′; as balls not finite where the square root of N² may meet its cut."""
    length = F.sqrt(dot(values, values))
    nu = [n / length for n in values]
    along = dot(nu, slopes)
    return nu, [(d - v * along) / length for v, d in zip(nu, slopes, strict=True)]
