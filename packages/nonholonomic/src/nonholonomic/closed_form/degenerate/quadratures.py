"""Quadratures along a degenerate motion in double precision: the clock, and other integrals.

Along a periodic motion ∫ f dτ is its mean times τ plus a Fourier series.  Along an asymptotic one
it is that of the limit on either side of a window, outside of which the difference is negligible,
and a polynomial on each of many panels inside.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, TypeAlias

import numpy as np
from flint import arb

from flowlanes.system.arrays import BoolArray, FloatArray

from ..genus_two.phases import phase_at
from ..one_degree.angles import ComplexArray
from ..one_degree.functions import DOUBLES
from ..one_degree.phase_reduction import pair
from .theta_motion import Asymptotic, Periodic, direction

#: The integrands at ν, ν′ (3, n): an array (m, n), the clock first.
Integrands: TypeAlias = Callable[[Sequence[FloatArray], Sequence[FloatArray]], FloatArray]

#: |κ| beyond which e^{−|κ|} is negligible in doubles.
LARGEST_KAPPA = 38.0
#: Relative size below which a velocity counts as zero.
TINY = 1e-6
#: Number of nodes per panel, and the largest change of the phases (U, κ) within one.
NODES = 24
SPAN = 0.4


class Moment(NamedTuple):
    """τ = remainder + turns · period at given times, and the other quadratures up to there."""

    remainder: FloatArray
    turns: FloatArray
    integrals: FloatArray


@dataclass(frozen=True)
class PeriodicQuadratures:
    """∫ f dτ from τ = 0 along a periodic motion.

    Attributes
    ----------
    period : float
        The period in τ.
    turn : float
        The gain of the clock in a period.
    frequency : (float, float)
        Periods in a unit of time, as a sum of two doubles.
    means : array (m,)
        Mean values of the integrands.
    waves : array (m, k) of complex numbers
        Fourier coefficients of the integrands, from the first harmonic on.
    """

    period: float
    turn: float
    frequency: tuple[float, float]
    means: FloatArray
    waves: ComplexArray

    def _sums(self, tau: FloatArray, coefficients: ComplexArray) -> FloatArray:
        order = np.arange(1, coefficients.shape[-1] + 1)
        phases = np.exp(2j * np.pi / self.period * np.multiply.outer(order, tau))
        sums: FloatArray = 2 * (coefficients @ phases).real
        return sums

    @cached_property
    def _antiderivative(self) -> ComplexArray:
        """Fourier coefficients of the quadratures without their mean growth."""
        order = np.arange(1, self.waves.shape[-1] + 1)
        return self.waves / (2j * np.pi / self.period * order)

    def up_to(self, tau: FloatArray) -> FloatArray:
        """The quadratures (m, n) at τ."""
        start = 2 * self._antiderivative.real.sum(-1)[:, None]
        linear = np.multiply.outer(self.means, tau)
        values: FloatArray = linear + self._sums(tau, self._antiderivative) - start
        return values

    @cached_property
    def _table(self) -> tuple[FloatArray, FloatArray]:
        tau = np.linspace(0.0, self.period, 4 * self.waves.shape[-1] + 65)
        return tau, self.up_to(tau)[0]

    def inverse_clock(self, times: FloatArray) -> FloatArray:
        """τ at `times` between 0 and the gain of the clock in a period."""
        grid, grid_times = self._table
        tau: FloatArray = np.interp(times, grid_times, grid)
        for _ in range(4):
            rate = self.means[0] + self._sums(tau, self.waves[:1])[0]
            waves = (
                self._sums(tau, self._antiderivative[:1])[0]
                - 2 * self._antiderivative[0].real.sum()
            )
            tau = tau - (self.means[0] * tau + waves - times) / rate
        return tau

    def moment(self, times: FloatArray, offset: float = 0.0) -> Moment:
        """The motion at `times` + `offset`."""
        part = phase_at(self.frequency, times, 1.0)
        turns = np.rint(times * self.frequency[0] - part)
        clock = part * self.turn + offset
        more = np.floor(clock / self.turn)
        remainder = self.inverse_clock(clock - more * self.turn)
        turns = turns + more
        integrals = self.up_to(remainder)[1:]
        whole = np.multiply.outer(self.means[1:] * self.period, turns)
        return Moment(remainder, turns, integrals + whole)


def _periodic(motion: Periodic, integrands: Integrands, turn: arb) -> PeriodicQuadratures:
    """Means and Fourier series along a periodic motion.

    Parameters
    ----------
    motion : Periodic
    integrands : callable
    turn : arb
        The gain of the clock in a period.
    """
    period = float(motion.period)
    count = 64
    while True:
        tau = np.arange(count, dtype=float) * (period / count)
        nu, rate = direction(DOUBLES, *motion.doubles(tau, 0.0))
        # The integrands are periodic and analytic, so their Fourier coefficients fall geometrically
        # and the trapezoidal rule is accurate to the last ones computed.
        waves = np.fft.rfft(integrands(nu, rate)) / count
        size = np.abs(waves).max(-1, keepdims=True)
        # The clock and the velocities have different units.
        size[1:] = np.maximum(size[1:], TINY * size[1:].max(initial=0.0))
        size[size == 0] = 1.0
        last = (np.abs(waves[:, -(count // 8) :]) / size).max()
        if last < 1e-16 or count >= 1 << 14:
            break
        count *= 2
    harmonics = waves[:, 1:-1]
    needed = np.nonzero((np.abs(harmonics) > 1e-17 * size).any(0))[0]
    harmonics = harmonics[:, : (needed[-1] + 1 if len(needed) else 1)]
    means = waves[:, 0].real
    return PeriodicQuadratures(period, float(turn.mid()), pair(1 / turn), means, harmonics)


@dataclass(frozen=True)
class AsymptoticQuadratures:
    """∫ f dτ from τ = 0 along an asymptotic motion.

    Attributes
    ----------
    period : float
        The period in τ of the periodic motions approached at both ends.
    edges : array (p + 1,)
        Ends of the panels, in τ.
    sums : array (m, p + 1)
        The quadratures at the edges, from τ = 0.
    panels : array (NODES + 1, m, p)
        Legendre coefficients of the quadratures from the left edge of each panel.
    before, after : PeriodicQuadratures
        Quadratures along the periodic motions approached in the past and in the future.
    """

    period: float
    edges: FloatArray
    sums: FloatArray
    panels: FloatArray
    before: PeriodicQuadratures
    after: PeriodicQuadratures

    def within(self, tau: FloatArray) -> FloatArray:
        """The quadratures (m, n) at τ inside the window."""
        panel = np.clip(np.searchsorted(self.edges, tau) - 1, 0, len(self.edges) - 2)
        low, high = self.edges[panel], self.edges[panel + 1]
        x: FloatArray = (2 * tau - low - high) / (high - low)
        gains = np.polynomial.legendre.legval(x, self.panels[:, :, panel], tensor=False)
        values: FloatArray = self.sums[:, panel] + gains
        return values

    @cached_property
    def _table(self) -> tuple[FloatArray, FloatArray]:
        tau = np.linspace(self.edges[0], self.edges[-1], 16 * len(self.edges))
        return tau, self.within(tau)[0]

    def moment(self, times: FloatArray) -> Moment:
        """The motion at `times`."""
        inside = np.clip(times, self.sums[0, 0], self.sums[0, -1])
        grid, clock = self._table
        tau: FloatArray = np.interp(inside, clock, grid)
        rates = np.gradient(clock, grid)
        for _ in range(8):
            tau = tau - (self.within(tau)[0] - inside) / np.interp(tau, grid, rates)
            tau = np.clip(tau, self.edges[0], self.edges[-1])
        moment = Moment(tau, np.zeros_like(tau), self.within(tau)[1:])
        for chosen, side, edge in (
            (times < self.sums[0, 0], self.before, 0),
            (times > self.sums[0, -1], self.after, -1),
        ):
            if chosen.any():
                self._continue(moment, chosen, times, side, edge)
        return moment

    def _continue(
        self,
        moment: Moment,
        mask: BoolArray,
        times: FloatArray,
        side: PeriodicQuadratures,
        edge: int,
    ) -> None:
        """Replace the moments beyond an edge by those of the limit motion."""
        start = float(self.edges[edge])
        first = np.floor(start / side.period)
        reached = side.up_to(np.array([start - first * side.period]))[:, 0]
        offset = reached + first * side.means * side.period - self.sums[:, edge]
        beyond = side.moment(times[mask], float(offset[0]))
        near = beyond.remainder + first * side.period
        near = near + side.period * ((edge == -1) & (near < start))
        near = near - side.period * ((edge == 0) & (near > start))
        moment.remainder[mask] = near
        moment.turns[mask] = beyond.turns + np.rint((beyond.remainder - near) / side.period)
        moment.integrals[:, mask] = beyond.integrals - offset[1:, None]


def _asymptotic(motion: Asymptotic, integrands: Integrands, turn: arb) -> AsymptoticQuadratures:
    """Quadratures along an asymptotic motion.

    Parameters
    ----------
    motion : Asymptotic
    integrands : callable
    turn : arb
        The gain of the clock in a period of the limits.
    """
    growth, offset = float(motion.growth), float(motion.offset)
    crossings = ((-LARGEST_KAPPA - offset) / growth, (LARGEST_KAPPA - offset) / growth)
    low, high = min(*crossings, 0.0), max(*crossings, 0.0)
    step = SPAN / max(abs(float(motion.speed)), abs(growth))
    before, after = (int(np.ceil(abs(end) / step)) for end in (low, high))
    edges = np.concatenate(
        [np.linspace(low, 0.0, before + 1), np.linspace(0.0, high, after + 1)[1:]]
    )
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    half = np.diff(edges) / 2
    tau = (edges[:-1] + half) + np.multiply.outer(nodes, half)
    nu, rate = direction(DOUBLES, *motion.doubles(tau.ravel(), 0.0))
    values = integrands(nu, rate).reshape(-1, *tau.shape)
    order = np.arange(NODES)
    basis = np.polynomial.legendre.legvander(nodes, NODES - 1)
    # Gauss quadrature of the products with P_k, whose squares have the integral 1/(k + ½).
    inverse = (basis * weights[:, None]).T * (order[:, None] + 0.5)
    coefficients = np.einsum("kn,mnp->kmp", inverse, values)
    panels = np.polynomial.legendre.legint(coefficients, lbnd=-1) * half
    gains = panels.sum(0)
    # Summed outwards from τ = 0, where they vanish.
    left = -np.cumsum(gains[:, :before][:, ::-1], axis=1)[:, ::-1]
    right = np.cumsum(gains[:, before:], axis=1)
    sums = np.concatenate([left, np.zeros((len(gains), 1)), right], axis=1)
    sides = [_periodic(motion.limit(side), integrands, turn) for side in (-1, 1)]
    if growth < 0:
        sides.reverse()
    return AsymptoticQuadratures(float(motion.period), edges, sums, panels, sides[0], sides[1])


#: Quadratures of either kind.
Quadratures: TypeAlias = PeriodicQuadratures | AsymptoticQuadratures


def quadratures_along(
    motion: Periodic | Asymptotic, integrands: Integrands, turn: arb
) -> Quadratures:
    """The quadratures along a degenerate motion."""
    if isinstance(motion, Periodic):
        return _periodic(motion, integrands, turn)
    return _asymptotic(motion, integrands, turn)
