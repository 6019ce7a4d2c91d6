"""Quadratures along a degenerate motion, in double precision: the clock, and whatever else grows.

Along a periodic motion ∫ f dτ is its mean times τ and a Fourier series.  Along an asymptotic one it
is that of the limit on either side of a window outside of which the difference has died out, and a
polynomial on each of many panels within.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from ..genus_two.phases import halves, turned
from .theta_motion import Asymptotic, Periodic, direction_array

__all__ = ["Moment", "Quadratures", "Window", "along"]

#: The integrands at ν, ν′ (3, n): an array (m, n), the clock first.
Integrands = Callable[[Any, Any], Any]

#: |κ| beyond which e^{−|κ|} is lost in a double.
FADED = 38.0
#: A velocity so much smaller than the largest one vanishes but for rounding.
TINY = 1e-6
#: Nodes on a panel, and the phases (U, κ) that it may cover.
NODES = 24
SPAN = 0.4


class Moment(NamedTuple):
    """Where a motion is: τ = rest + turns · period, and the other quadratures up to there."""

    rest: Any
    turns: Any
    integrals: Any


@dataclass(frozen=True)
class Quadratures:
    """∫ f dτ from τ = 0 along a periodic motion.

    Attributes
    ----------
    period : float
        In τ.
    turn : float
        What the clock gains in a period.
    frequency : (float, float)
        Periods in a unit of time, as a sum of two doubles.
    means : array (m,)
        Of the integrands.
    waves : array (m, k) of complex numbers
        Fourier coefficients of the integrands, from the first harmonic on.
    """

    period: float
    turn: float
    frequency: tuple[float, float]
    means: Any
    waves: Any

    def _sums(self, tau: Any, coefficients: Any) -> Any:
        order = np.arange(1, coefficients.shape[-1] + 1)
        phases = np.exp(2j * np.pi / self.period * np.multiply.outer(order, tau))
        return 2 * (coefficients @ phases).real

    @cached_property
    def _risen(self) -> Any:
        order = np.arange(1, self.waves.shape[-1] + 1)
        return self.waves / (2j * np.pi / self.period * order)

    def up_to(self, tau: Any) -> Any:
        """The quadratures (m, n) at τ."""
        start = 2 * self._risen.real.sum(-1)[:, None]
        return np.multiply.outer(self.means, tau) + self._sums(tau, self._risen) - start

    @cached_property
    def _table(self) -> tuple[Any, Any]:
        tau = np.linspace(0.0, self.period, 4 * self.waves.shape[-1] + 65)
        return tau, self.up_to(tau)[0]

    def clock_inverted(self, times: Any) -> Any:
        """τ at which the clock stands at `times`, between 0 and its gain in a period."""
        tau, stands = self._table
        found = np.interp(times, stands, tau)
        for _ in range(4):
            rate = self.means[0] + self._sums(found, self.waves[:1])[0]
            risen = self._sums(found, self._risen[:1])[0] - 2 * self._risen[0].real.sum()
            found = found - (self.means[0] * found + risen - times) / rate
        return found

    def when(self, times: Any, offset: float = 0.0) -> Moment:
        """Where the motion is when the clock stands at `times` + `offset`."""
        part = turned(self.frequency, times, 1.0)
        turns = np.rint(times * self.frequency[0] - part)
        stands = part * self.turn + offset
        more = np.floor(stands / self.turn)
        rest = self.clock_inverted(stands - more * self.turn)
        turns = turns + more
        integrals = self.up_to(rest)[1:]
        whole = np.multiply.outer(self.means[1:] * self.period, turns)
        return Moment(rest, turns, integrals + whole)


def _periodic(motion: Periodic, integrands: Integrands, turn: Any) -> Quadratures:
    """Means and Fourier series along a periodic motion.

    Parameters
    ----------
    motion : Periodic
    integrands : callable
    turn : arb
        What the clock gains in a period.
    """
    period = float(motion.period)
    count = 64
    while True:
        tau = np.arange(count) * (period / count)
        nu, rate = direction_array(*motion.array(tau, 0.0))
        waves = np.fft.rfft(integrands(nu, rate)) / count
        size = np.abs(waves).max(-1, keepdims=True)
        # the clock and the velocities have different units
        size[1:] = np.maximum(size[1:], TINY * size[1:].max(initial=0.0))
        size[size == 0] = 1.0
        last = (np.abs(waves[:, -(count // 8) :]) / size).max()
        if last < 1e-16 or count >= 1 << 14:
            break
        count *= 2
    kept = waves[:, 1:-1]
    needed = np.nonzero((np.abs(kept) > 1e-17 * size).any(0))[0]
    kept = kept[:, : (needed[-1] + 1 if len(needed) else 1)]
    return Quadratures(period, float(turn.mid()), halves(1 / turn), waves[:, 0].real, kept)


@dataclass(frozen=True)
class Window:
    """∫ f dτ from τ = 0 along an asymptotic motion.

    Attributes
    ----------
    period : float
        In τ, of the periodic motions on either side.
    edges : array (p + 1,)
        Of the panels, in τ.
    sums : array (m, p + 1)
        The quadratures at the edges, from τ = 0.
    panels : array (NODES + 1, m, p)
        Legendre coefficients of the quadratures from the left edge of each panel.
    before, after : Quadratures
        Of the limits.
    """

    period: float
    edges: Any
    sums: Any
    panels: Any
    before: Quadratures
    after: Quadratures

    def within(self, tau: Any) -> Any:
        """The quadratures (m, n) at τ inside the window."""
        place = np.clip(np.searchsorted(self.edges, tau) - 1, 0, len(self.edges) - 2)
        low, high = self.edges[place], self.edges[place + 1]
        x = (2 * tau - low - high) / (high - low)
        found = np.polynomial.legendre.legval(x, self.panels[:, :, place], tensor=False)
        return self.sums[:, place] + found

    @cached_property
    def _table(self) -> tuple[Any, Any]:
        tau = np.linspace(self.edges[0], self.edges[-1], 16 * len(self.edges))
        return tau, self.within(tau)[0]

    def when(self, times: Any) -> Moment:
        """Where the motion is at `times`."""
        inside = np.clip(times, self.sums[0, 0], self.sums[0, -1])
        tau, stands = self._table
        found = np.interp(inside, stands, tau)
        rates = np.gradient(stands, tau)
        for _ in range(8):
            found = found - (self.within(found)[0] - inside) / np.interp(found, tau, rates)
            found = np.clip(found, self.edges[0], self.edges[-1])
        moment = Moment(found, np.zeros_like(found), self.within(found)[1:])
        for chosen, side, edge in (
            (times < self.sums[0, 0], self.before, 0),
            (times > self.sums[0, -1], self.after, -1),
        ):
            if chosen.any():
                self._continue(moment, chosen, times, side, edge)
        return moment

    def _continue(
        self, moment: Moment, chosen: Any, times: Any, side: Quadratures, edge: int
    ) -> None:
        """Put the moments beyond an edge where the limit has them, within a period of the edge."""
        start = float(self.edges[edge])
        first = np.floor(start / side.period)
        reached = side.up_to(np.array([start - first * side.period]))[:, 0]
        offset = reached + first * side.means * side.period - self.sums[:, edge]
        beyond = side.when(times[chosen], float(offset[0]))
        near = beyond.rest + first * side.period
        near = near + side.period * ((edge == -1) & (near < start))
        near = near - side.period * ((edge == 0) & (near > start))
        moment.rest[chosen] = near
        moment.turns[chosen] = beyond.turns + np.rint((beyond.rest - near) / side.period)
        moment.integrals[:, chosen] = beyond.integrals - offset[1:, None]


def _asymptotic(motion: Asymptotic, integrands: Integrands, turn: Any) -> Window:
    """Quadratures along an asymptotic motion.

    Parameters
    ----------
    motion : Asymptotic
    integrands : callable
    turn : arb
        What the clock gains in a period of the limits.
    """
    growth, offset = float(motion.growth), float(motion.offset)
    crossings = ((-FADED - offset) / growth, (FADED - offset) / growth)
    low, high = min(*crossings, 0.0), max(*crossings, 0.0)
    step = SPAN / max(abs(float(motion.speed)), abs(growth))
    before, after = (int(np.ceil(abs(end) / step)) for end in (low, high))
    edges = np.concatenate(
        [np.linspace(low, 0.0, before + 1), np.linspace(0.0, high, after + 1)[1:]]
    )
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    half = np.diff(edges) / 2
    tau = (edges[:-1] + half) + np.multiply.outer(nodes, half)
    nu, rate = direction_array(*motion.array(tau.ravel(), 0.0))
    values = integrands(nu, rate).reshape(-1, *tau.shape)
    order = np.arange(NODES)
    basis = np.polynomial.legendre.legvander(nodes, NODES - 1)
    inverse = (basis * weights[:, None]).T * (order[:, None] + 0.5)
    coefficients = np.einsum("kn,mnp->kmp", inverse, values)
    panels = np.polynomial.legendre.legint(coefficients, lbnd=-1) * half
    gains = panels.sum(0)
    # summed up outwards from τ = 0, where they vanish
    left = -np.cumsum(gains[:, :before][:, ::-1], axis=1)[:, ::-1]
    right = np.cumsum(gains[:, before:], axis=1)
    sums = np.concatenate([left, np.zeros((len(gains), 1)), right], axis=1)
    sides = [_periodic(motion.limit(side), integrands, turn) for side in (-1, 1)]
    if growth < 0:
        sides.reverse()
    return Window(float(motion.period), edges, sums, panels, sides[0], sides[1])


def along(motion: Periodic | Asymptotic, integrands: Integrands, turn: Any) -> Quadratures | Window:
    """Quadratures along any degenerate motion."""
    if isinstance(motion, Periodic):
        return _periodic(motion, integrands, turn)
    return _asymptotic(motion, integrands, turn)
