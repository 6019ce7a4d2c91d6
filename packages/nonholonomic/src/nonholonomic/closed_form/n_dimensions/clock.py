"""The physical time of a separated motion: t as a function of τ, and its inverse.

dt/dτ is a product of functions of one coordinate each, or a sum of a few such products.  Its
Fourier coefficients on the torus of the phases are therefore determinants of one-dimensional
integrals:

    c_m = det ‖(1/2π) ∮ g(z_k) (dψ_ik/ds_k) exp(−i Σ_j m_j ψ_jk(s)) ds‖,

because the volume element of the torus is det(dψ_ik/ds_k) ds_1 … ds_{n−1}.  They are real, as g is
even in s and ψ odd.  So t = c_0 τ + Σ c_m (sin(m, φ) − sin(m, φ_0))/(m, dφ/dτ), and τ follows by
Newton's method.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb

from flowlanes.errors import InputError
from flowlanes.formulas.balls import number
from flowlanes.system.arrays import ComplexArray, FloatArray, IntArray

#: Waves with coefficients below this fraction of the mean are omitted.
_LEVEL = 2e-16
#: Maximum number of waves.
MOST = 300_000
#: Waves slower than this fraction of the fastest one are near a resonance.
_SLOW = 1e-2
#: Number of values in one block.
_BLOCK = 4_000_000

#: A function of one coordinate, in balls.
Factor = Callable[[arb], arb]


class Clock(ABC):
    """dt/dτ as a function of the coordinates z (g, N)."""

    @abstractmethod
    def rate(self, z: FloatArray) -> FloatArray:
        """dt/dτ."""

    @abstractmethod
    def products(
        self, ends: Sequence[tuple[arb, arb]]
    ) -> tuple[Sequence[arb], Sequence[Sequence[Factor]]]:
        """Weights, and for each the functions of z_1, …, z_g whose product it multiplies."""


@dataclass(frozen=True)
class ProductClock(Clock):
    """dt/dτ = scale √(∏ z_k)."""

    scale: arb

    def rate(self, z: FloatArray) -> FloatArray:
        """dt/dτ."""
        rate: FloatArray = number(self.scale) * np.sqrt(np.prod(z, axis=0))
        return rate

    def products(
        self, ends: Sequence[tuple[arb, arb]]
    ) -> tuple[Sequence[arb], Sequence[Sequence[Factor]]]:
        """One product of roots."""
        return [self.scale], [[arb.sqrt for _ in ends]]


@dataclass(frozen=True)
class RootClock(Clock):
    """dt/dτ = (total − Σ z_k)^(−1/2)."""

    total: arb

    def rate(self, z: FloatArray) -> FloatArray:
        """dt/dτ."""
        rate: FloatArray = 1 / np.sqrt(number(self.total) - np.sum(z, axis=0))
        return rate

    def products(
        self, ends: Sequence[tuple[arb, arb]]
    ) -> tuple[Sequence[arb], Sequence[Sequence[Factor]]]:
        """x^(−1/2) = π^(−1/2) ∫ exp(−x s²) ds, by the trapezoidal rule to 24 digits."""
        least = self.total - sum((high for _, high in ends), arb(0))
        most = self.total - sum((low for low, _ in ends), arb(0))
        # Truncation leaves out exp(−7.6²) ≈ 8e-26.  The trapezoidal rule with step h has the
        # relative error 2 exp(−π²/h²x) ≤ 2 exp(−π²/0.41²) ≈ 6e-26 for this integrand.  As x = least
        # + Σ (high − z_k), all factors are at most one.
        step = 0.41 / most.sqrt()
        count = int(np.ceil(number(7.6 / least.sqrt() / step)))
        squares = [(step * i) ** 2 for i in range(count + 1)]
        weights = [2 * step / arb.pi().sqrt() * (-least * x).exp() for x in squares]
        weights[0] /= 2
        return weights, [[_decay(x, high) for _, high in ends] for x in squares]


def _decay(square: arb, high: arb) -> Factor:
    return lambda z: (square * (z - high)).exp()


@dataclass(frozen=True)
class Waves:
    """A function on the torus, Σ c_m cos(m, φ), and its integral along a motion.

    Attributes
    ----------
    mean : float
        c_0.
    orders : int array (K, g)
        m ≠ 0, of each pair ±m one.
    heights : array (K,)
        2 c_m.
    """

    mean: float
    orders: IntArray
    heights: FloatArray

    def value(self, phases: FloatArray) -> FloatArray:
        """The function at phases (n, g)."""
        return self.mean + self._sum(phases, self.orders, self.heights).real

    def integral(self, start: FloatArray, velocity: Sequence[arb]) -> WaveIntegral:
        """The integral of the function minus its mean along φ = start + velocity τ."""
        rough = self.orders @ np.array([number(x) for x in velocity])
        slow = np.abs(rough) < _SLOW * np.abs(rough).max(initial=0.0)
        exact = np.array(
            [
                number(sum((int(m) * v for m, v in zip(row, velocity, strict=True)), arb(0)))
                for row in self.orders[slow]
            ]
        )
        fast = Waves(self.mean, self.orders[~slow], self.heights[~slow] / rough[~slow])
        begin = float(fast._sum(start[None], fast.orders, fast.heights).imag[0])
        return WaveIntegral(fast, begin, exact, self.orders[slow] @ start, self.heights[slow])

    def _sum(self, phases: FloatArray, orders: IntArray, heights: FloatArray) -> ComplexArray:
        """Σ heights exp i(m, φ)."""
        largest = int(np.abs(orders).max(initial=0))
        # Exponentials of the multiples of each phase are tabulated and multiplied, one complex
        # exponential per phase and multiple instead of one per wave.
        powers = np.arange(-largest, largest + 1)
        total = np.zeros(len(phases), dtype=complex)
        block = max(1, _BLOCK // max(1, len(orders)))
        for first in range(0, len(phases), block):
            part = phases[first : first + block]
            wave = np.ones((len(part), len(orders)), dtype=complex)
            for k in range(phases.shape[1]):
                table = np.exp(1j * part[:, k, None] * powers)
                wave *= table[:, orders[:, k] + largest]
            total[first : first + block] = wave @ heights
        return total


@dataclass(frozen=True)
class WaveIntegral:
    """∫ Σ c_m cos(m, φ) dτ over m ≠ 0, from 0 to τ.

    Attributes
    ----------
    fast : Waves
        2c_m/(m, dφ/dτ) of all waves but the slow ones.
    begin : float
        Their sum at the start.
    rates, places, heights : arrays (K,)
        (m, dφ/dτ), (m, φ) at the start and 2c_m of the slow waves, near resonances.
    """

    fast: Waves
    begin: float
    rates: FloatArray
    places: FloatArray
    heights: FloatArray

    def at(self, phases: FloatArray, tau: FloatArray) -> FloatArray:
        """The integral at phases (n, g) that belong to the times τ (n,)."""
        fast = self.fast
        quick = fast._sum(phases, fast.orders, fast.heights).imag - self.begin
        half = tau[:, None] * self.rates / 2
        # (sin(x + 2h) − sin x)/rate = τ cos(x + h) sin h/h, valid also for rate 0
        slow = np.cos(self.places + half) * np.sinc(half / np.pi) @ self.heights
        total: FloatArray = quick + tau * slow
        return total


def waves(
    clock: Clock,
    ends: Sequence[tuple[arb, arb]],
    s: FloatArray,
    psi: FloatArray,
    slopes: FloatArray,
) -> Waves:
    """The Fourier coefficients of dt/dτ.

    Parameters
    ----------
    clock : Clock
    ends : sequence of (low, high)
        The intervals of the coordinates.
    s : array (g, N + 1)
        The angles at which ψ_kk = πj/N, j = 0, …, N.
    psi, slopes : arrays (g, g, N + 1)
        ψ_ik and dψ_ik/dψ_kk there.

    Raises
    ------
    InputError
        If more than `MOST` waves would be needed.
    """
    size = len(ends)
    steps = psi.shape[2] - 1
    rule = np.full(steps + 1, 1.0 / steps)
    rule[[0, -1]] /= 2
    balls, products = clock.products(ends)
    weights = np.array([number(x) for x in balls])
    kernels = []
    for k, (low, high) in enumerate(ends):
        z = [low + (high - low) * (arb(x) / 2).sin() ** 2 for x in s[k]]
        factors = np.array([[number(one[k](x)) for x in z] for one in products])
        # (N + 1, terms, i)
        kernels.append(np.einsum("qj,ij,j->jqi", factors, slopes[:, k], rule))

    def coefficients(orders: IntArray) -> FloatArray:
        found = np.empty(len(orders))
        block = max(1, _BLOCK // ((steps + 1) * size))
        for first in range(0, len(orders), block):
            part = orders[first : first + block].astype(float)
            matrices = np.empty((len(part), len(weights), size, size))
            for k in range(size):
                angle = np.cos(part @ psi[:, k])
                flat = kernels[k].reshape(steps + 1, -1)
                matrices[:, :, :, k] = (angle @ flat).reshape(len(part), len(weights), size)
            # The determinant of the integrands integrates column by column, as column k depends on
            # s_k alone.
            found[first : first + block] = np.linalg.det(matrices) @ weights
        return found

    zero = np.zeros((1, size), dtype=int)
    mean = float(coefficients(zero)[0])
    orders, heights = _noticeable_waves(coefficients, size, _LEVEL * abs(mean))
    return Waves(mean, orders, 2 * heights)


def _noticeable_waves(
    coefficients: Callable[[IntArray], FloatArray], size: int, level: float
) -> tuple[IntArray, FloatArray]:
    """All waves with significant coefficients, starting from the longest."""
    zero = (0,) * size
    seen = {zero}
    # A coefficient may vanish by accident, so the search extends one step beyond the significant
    # ones.
    front: dict[tuple[int, ...], bool] = {zero: True}
    kept = [np.zeros((0, size), dtype=int)]
    heights = [np.zeros(0)]
    count = 0
    while front:
        candidates: dict[tuple[int, ...], bool] = {}
        for wave, noticeable in front.items():
            for near in _neighbours(wave):
                if near not in seen:
                    candidates[near] = candidates.get(near, False) or noticeable
        if not candidates:
            break
        seen |= set(candidates)
        orders = np.array(list(candidates))
        values = coefficients(orders)
        large = np.abs(values) > level
        count += int(large.sum())
        if count > MOST:
            raise InputError(
                f"the time of this motion needs more than {MOST} waves on the torus of {size} "
                "phases; roots of its curve lie too near to each other"
            )
        kept.append(orders[large])
        heights.append(values[large])
        front = {
            wave: bool(big)
            for (wave, by_noticeable), big in zip(candidates.items(), large, strict=True)
            if big or by_noticeable
        }
    return np.concatenate(kept), np.concatenate(heights)


def _neighbours(wave: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
    """Neighbouring waves; of each pair ±m the one whose first number is positive."""
    for k in range(len(wave)):
        for step in (-1, 1):
            near = (*wave[:k], wave[k] + step, *wave[k + 1 :])
            first = next((x for x in near if x), 0)
            yield near if first >= 0 else tuple(-x for x in near)
