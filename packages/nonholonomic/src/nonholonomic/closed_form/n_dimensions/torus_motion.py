"""A separated motion at any time, in double precision."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from flint import arb, arb_mat

from flowlanes.formulas.balls import number
from flowlanes.system.arrays import FloatArray

from ..genus_two.curve import DegenerateError
from ..genus_two.phases import phase_at
from ..one_degree.phase_reduction import Pair, pair
from .clock import Clock, WaveIntegral, Waves, waves
from .separation import SeparatedVector
from .torus import Sines, cosine_coefficients, densities, periods, sines, start_angles, start_phases

#: Initial and maximum number of steps of half a turn for the integrals of the waves.
_GRID = (128, 1024)
#: Relative size of the Fourier coefficients at half the highest waves; the omitted ones are about
#: the fourth power of it.
_LEVEL = 1e-12
#: Refinement of the grid for the mean of dt/dτ, relative to that of the map.
_FINER = 3
#: Maximum number of Newton steps for the clock.
_NEWTON = 60
#: Tolerance for passing through the start.
_SHIFT = 1e-9


@dataclass(frozen=True)
class Places:
    """Points of a motion on a torus at some times.

    Attributes
    ----------
    vector, rate : arrays (n, N)
        y and dy/dτ, N times.
    clock : array (N,)
        dt/dτ.
    """

    vector: FloatArray
    rate: FloatArray
    clock: FloatArray


@dataclass(frozen=True, eq=False)
class TorusMotion:
    """One separated motion.

    Attributes
    ----------
    means : arb_mat
        The periods over 2π.
    turns : tuple of arb
        Turns of the phases in a unit of τ.
    """

    separation: SeparatedVector
    clock: Clock
    means: arb_mat
    turns: tuple[arb, ...]
    start: FloatArray
    sines: Sines

    @classmethod
    def of(cls, separation: SeparatedVector, clock: Clock) -> TorusMotion:
        """The motion through the start of a separation.

        Raises
        ------
        DegenerateError
            If roots of the curve nearly coincide.
        ArithmeticError
            If the motion does not pass through its start.
        """
        means = periods(separation)
        column = means.inv() * arb_mat([[v] for v in separation.speeds])
        size = len(separation.ovals)
        turns = tuple(column[i, 0] / (2 * arb.pi()) for i in range(size))
        angles = start_angles(separation)
        start = np.array([number(x) for x in start_phases(separation, means, angles)])
        motion = cls(separation, clock, means, turns, start, sines(separation, means))
        motion._check()
        # at the working precision of the set-up
        _ = motion._integral, motion._pairs, motion.ends
        return motion

    def _check(self) -> None:
        """Raise an error if a motion misses its start."""
        places = self._places(self.start[None])
        for computed, given in (
            (places.vector, self.separation.vector),
            (places.rate, self.separation.rate),
        ):
            exact = np.array([number(x) for x in given])
            if np.abs(computed[:, 0] - exact).max() > _SHIFT * np.abs(exact).max():
                raise ArithmeticError("the closed form does not pass through its start")

    @cached_property
    def ends(self) -> tuple[tuple[float, float], ...]:
        """The intervals of z_1, …, z_{n−1}."""
        return tuple((number(low), number(high)) for low, high in self._ends)

    @property
    def _ends(self) -> list[tuple[arb, arb]]:
        return [self.separation.curve.ends(left) for left in self.separation.ovals]

    @cached_property
    def waves(self) -> Waves:
        """dt/dτ on the torus.

        On a grid uniform in ψ_kk, in which the integrals have fewer waves than in s.

        Raises
        ------
        DegenerateError
            If roots of the curve nearly coincide.
        """
        own, inverse = self.sines.waves, self.means.inv()
        order = np.arange(1, own.shape[2] + 1)
        steps = _GRID[0]
        while steps <= _GRID[1]:
            x = np.pi * np.arange(steps + 1) / steps
            s = self.sines.own_angles(x)
            slopes = densities(self.separation, inverse, [[arb(y) for y in row] for row in s])
            slopes = slopes / np.array([slopes[k, k] for k in range(len(s))])
            decay = np.abs(cosine_coefficients(slopes))
            if decay[:, :, steps // 2 :].max() < _LEVEL * decay.max():
                turned = np.sin(order[None, :, None] * s[:, None, :])
                psi = np.eye(len(s))[:, :, None] * s + np.einsum("ikm,kmj->ikj", own, turned)
                return waves(self.clock, self._ends, s, psi, slopes)
            steps *= 2
        raise DegenerateError

    @cached_property
    def _integral(self) -> WaveIntegral:
        velocity = [2 * arb.pi() * x for x in self.turns]
        return self.waves.integral(self.start, velocity)

    @cached_property
    def mean(self) -> arb:
        """The mean of dt/dτ by the trapezoidal rule; its error is estimated."""
        curve, ovals = self.separation.curve, self.separation.ovals
        inverse, steps = self.means.inv(), _FINER * self.sines.steps
        weights, factors = self.clock.products(self._ends)
        places = [arb.pi() * j / steps for j in range(steps + 1)]
        entries = [[[arb(0)] * len(ovals) for _ in ovals] for _ in weights]
        for k, left in enumerate(ovals):
            low, high = curve.ends(left)
            for j, s in enumerate(places):
                z = low + (high - low) * (s / 2).sin() ** 2
                share = (arb(1) if 0 < j < steps else arb(1) / 2) / steps
                root = curve.cofactor(left, s).sqrt()
                column = inverse * arb_mat([[share * z**i / root] for i in range(len(ovals))])
                for q, one in enumerate(factors):
                    g = one[k](z)
                    for i in range(len(ovals)):
                        entries[q][i][k] += g * column[i, 0]
        terms = (w * arb_mat(rows).det() for w, rows in zip(weights, entries, strict=True))
        return arb(sum(terms, arb(0)).mid())

    @cached_property
    def frequencies(self) -> tuple[arb, ...]:
        """Turns of the phases per unit of t."""
        return tuple(x / self.mean for x in self.turns)

    @cached_property
    def _pairs(self) -> tuple[Pair, ...]:
        return tuple(pair(x) for x in self.frequencies)

    def at(self, times: FloatArray) -> Places:
        """The points at the times (N,)."""
        ideal, delta = self._delays(times)
        return self._places(ideal + delta[:, None] * self._velocity)

    def tau(self, times: FloatArray) -> FloatArray:
        """τ at the times (N,)."""
        tau: FloatArray = times / number(self.mean) + self._delays(times)[1]
        return tau

    def along(self, tau: FloatArray) -> Places:
        """The points at τ (N,)."""
        return self._places(self._phases([pair(x) for x in self.turns], tau))

    @property
    def _velocity(self) -> FloatArray:
        return 2 * np.pi * np.array([number(x) for x in self.turns])

    def _phases(self, turns: Sequence[Pair], times: FloatArray) -> FloatArray:
        """Linearly growing phases (N, g)."""
        grown = np.stack([phase_at(rate, times, 2.0) for rate in turns], axis=1)
        phases: FloatArray = self.start + 2 * np.pi * grown
        return phases

    def _delays(self, times: FloatArray) -> tuple[FloatArray, FloatArray]:
        """The phases for the mean of dt/dτ, and the excess of τ over its value there."""
        mean, velocity = number(self.mean), self._velocity
        ideal = self._phases(self._pairs, times)
        tau, delta = times / mean, np.zeros_like(times)
        # With τ = t/c_0 + δ the equation t = c_0 τ + I becomes c_0 δ + I = 0, whose derivative by δ
        # is dt/dτ.  δ stays bounded, so it loses no digits at late times.
        for _ in range(_NEWTON):
            phases = ideal + delta[:, None] * velocity
            s = self.sines.angles(phases)
            rate = self.clock.rate(self._coordinates(s))
            miss = mean * delta + self._integral.at(phases, tau + delta)
            step = -miss / rate
            delta = delta + step
            if np.all(np.abs(step * np.abs(velocity).max()) < 4e-15):
                break
        return ideal, delta

    # --- from phases to the vector --------------------------------------------------------

    @cached_property
    def _numbers(self) -> _Numbers:
        return _Numbers.of(self.separation)

    def _coordinates(self, s: FloatArray) -> FloatArray:
        low = np.array([low for low, _ in self.ends])
        width = self._numbers.width
        coordinates: FloatArray = (low + width * np.sin(s / 2) ** 2).T
        return coordinates

    def _places(self, phases: FloatArray) -> Places:
        s = self.sines.angles(phases)
        z = self._coordinates(s)
        vector, rate = self._numbers.vector(s.T, z)
        return Places(vector, rate, self.clock.rate(z))


@dataclass(frozen=True)
class _Numbers:
    """Differences of roots and ends, each rounded once."""

    width: FloatArray
    #: (g, roots, 2): low − root and root − high, one of them positive, except for the coordinate's
    #: own ends.
    beyond: list[list[tuple[float, bool]]]
    #: (n, g): c_i − low or high − c_i in absolute value, and the end from which it is measured.
    poles: list[list[tuple[float, bool]]]
    #: The coordinate that ends at c_i, at its low or high end; −1 if none does.
    touching: list[tuple[int, bool]]
    #: gaps[k][l] for k > l: low of k − high of l.
    gaps: FloatArray
    scales: FloatArray
    speed: float
    product_speed: float
    leading: float

    @classmethod
    def of(cls, separation: SeparatedVector) -> _Numbers:
        curve, ovals, poles = separation.curve, separation.ovals, separation.poles
        ends = [curve.ends(left) for left in ovals]
        beyond = [
            [
                (number(ends[k][0] - root), True)
                if place < left
                else (number(root - ends[k][1]), False)
                for place, root in enumerate(curve.roots)
                if place not in (left, left + 1)
            ]
            for k, left in enumerate(ovals)
        ]
        touching, table, scales = [], [], []
        for i, c in enumerate(poles):
            row, touch = [], (-1, True)
            size = arb(1)
            for j, other in enumerate(poles):
                if j != i:
                    size /= abs(c - other)
            for k, (low, high) in enumerate(ends):
                if c.overlaps(low) or c.overlaps(high):
                    touch = (k, c.overlaps(low))
                    row.append((0.0, c.overlaps(low)))
                    size *= high - low
                elif c < low:
                    row.append((number(low - c), True))
                else:
                    row.append((number(c - high), False))
            table.append(row)
            touching.append(touch)
            scales.append(number(size.sqrt()))
        gaps = np.array(
            [
                [number(ends[max(k, j)][0] - ends[min(k, j)][1]) for j in range(len(ends))]
                for k in range(len(ends))
            ]
        )
        plain = cls(
            np.array([number(high - low) for low, high in ends]),
            beyond,
            table,
            touching,
            gaps,
            np.array(scales),
            number(separation.speed),
            number(separation.product_speed),
            number(abs(curve.leading)),
        )
        return plain._with_signs(separation)

    def _with_signs(self, separation: SeparatedVector) -> _Numbers:
        angles = np.array([[number(x)] for x in start_angles(separation)])
        low = np.array([number(separation.curve.ends(left)[0]) for left in separation.ovals])
        z = low[:, None] + self.width[:, None] * np.sin(angles / 2) ** 2
        vector, rate = self.vector(angles, z)
        signs = []
        for i, (own, turning) in enumerate(zip(separation.vector, separation.rate, strict=True)):
            # The sign of a vanishing component follows from its rate.
            agrees = (
                vector[i, 0] * number(own) > 0
                if abs(number(own)) > 1e-6
                else rate[i, 0] * number(turning) > 0
            )
            signs.append(1.0 if agrees else -1.0)
        return _Numbers(
            self.width,
            self.beyond,
            self.poles,
            self.touching,
            self.gaps,
            self.scales * np.array(signs),
            self.speed,
            self.product_speed,
            self.leading,
        )

    def vector(self, s: FloatArray, z: FloatArray) -> tuple[FloatArray, FloatArray]:
        """y and dy/dτ (n, N) at angles and coordinates (g, N)."""
        # y_i² = ∏ |c_i − z_k| / ∏ |c_i − c_j|.  Distances are sums of positive terms, the distance
        # of c_i from an end of the interval and that of z_k from this end, so there is no
        # cancellation.  Where c_i is the end itself, its factor is a sine or cosine of s/2 instead
        # of a root: y_i passes through zero with z_k at the end and changes sign.
        up, down = np.sin(s / 2), np.cos(s / 2)
        rise, fall = self.width[:, None] * up**2, self.width[:, None] * down**2
        turning = np.array([self._rate(k, rise, fall, z) for k in range(len(s))])
        change = self.width[:, None] * up * down * turning
        vectors, rates = [], []
        for i, (touch, at_low) in enumerate(self.touching):
            y = np.full(s.shape[1], self.scales[i])
            logarithmic = np.zeros(s.shape[1])
            for k, (distance, above) in enumerate(self.poles[i]):
                if k == touch:
                    continue
                # |c − z| increases with z where z > c.
                away = distance + (rise[k] if above else fall[k])
                y = y * np.sqrt(away)
                logarithmic += (change[k] if above else -change[k]) / (2 * away)
            if touch < 0:
                vectors.append(y)
                rates.append(y * logarithmic)
                continue
            factor, slope = (
                (up[touch], down[touch] / 2) if at_low else (down[touch], -up[touch] / 2)
            )
            vectors.append(y * factor)
            rates.append(y * (factor * logarithmic + slope * turning[touch]))
        return np.array(vectors), np.array(rates)

    def _rate(self, k: int, rise: FloatArray, fall: FloatArray, z: FloatArray) -> FloatArray:
        """ds_k/dτ."""
        cofactor = np.full(z.shape[1], self.leading)
        for distance, above in self.beyond[k]:
            cofactor = cofactor * (distance + (rise[k] if above else fall[k]))
        apart, product = np.ones(z.shape[1]), np.ones(z.shape[1])
        for other in range(len(z)):
            if other == k:
                continue
            high, low = max(k, other), min(k, other)
            gap = self.gaps[k, other] + rise[high] + fall[low]
            apart = apart * (gap if k > other else -gap)
            product = product * z[other]
        rate: FloatArray = np.sqrt(cofactor) * (self.speed + self.product_speed * product) / apart
        return rate
