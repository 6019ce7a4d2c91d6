"""∫ Re (F(v) exp(iΨ)) dτ with Ψ linear in τ: a third frequency beside the phases v."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb

from flowlanes.system.arrays import ComplexArray, FloatArray, IntArray

from .phases import wave_rates
from .quadrature import Series


@dataclass(frozen=True)
class Turning:
    """The integral from τ = 0 of Re Σ F_k exp(iπ(k, v) + iωτ).

    Attributes
    ----------
    first, second : array of int
        Wave numbers of both signs.
    coefficients : array (len(first), len(second)), complex
        F_k.
    speeds : array of the same shape
        π(k, V) + ω.
    start : array of the same shape, complex
        exp(iπ(k, v₀)).
    """

    first: FloatArray | IntArray
    second: FloatArray | IntArray
    coefficients: ComplexArray
    speeds: FloatArray
    start: ComplexArray
    omega: float

    def values(self, v: FloatArray, tau: FloatArray) -> FloatArray:
        """Values at phases v (n, 2), modulo 2, and τ (n,)."""
        # Write a term with a small divisor as τ sin(x)/x.
        slow = np.abs(self.speeds) < 1e-3 * np.max(np.abs(self.speeds), initial=0.0)
        divided = np.where(slow, 0.0, self.coefficients / (1j * np.where(slow, 1.0, self.speeds)))
        waves = [
            np.exp(1j * np.pi * np.outer(v[:, axis], k))
            for axis, k in enumerate((self.first, self.second))
        ]
        there = np.exp(1j * self.omega * tau) * np.einsum("nk,nk->n", waves[0] @ divided, waves[1])
        value: FloatArray = there.real - np.sum(divided * self.start).real
        for place in zip(*np.nonzero(slow & (np.abs(self.coefficients) > 0)), strict=True):
            x = self.speeds[place] * tau
            term = self.coefficients[place] * self.start[place] * np.exp(0.5j * x)
            value = value + tau * term.real * np.sinc(x / (2 * np.pi))
        return value


def turning(
    real: Series, imaginary: Series, V: Sequence[arb], v_0: FloatArray, omega: float, phase: float
) -> Turning:
    """Integrate Re ((real + i·imaginary) exp(i(ωτ + phase))) along the flow.

    Parameters
    ----------
    V : two arb
        Velocity of the phases.
    v_0 : array (2,)
        Phases at τ = 0.
    omega : float
        ω, in radians per unit of τ.
    phase : float
        In radians.
    """
    first = np.union1d(real.first, imaginary.first)
    first = np.union1d(first, -first)
    second = np.union1d(real.second, imaginary.second)
    second = np.union1d(second, -second)
    whole = np.zeros((len(first), len(second)), dtype=complex)
    for part, factor in ((real, 1.0), (imaginary, 1j)):
        half = factor * part.coefficients / 2
        conjugate = factor * np.conj(part.coefficients) / 2
        rows, columns = np.searchsorted(first, part.first), np.searchsorted(second, part.second)
        whole[np.ix_(rows, columns)] += half
        rows, columns = np.searchsorted(first, -part.first), np.searchsorted(second, -part.second)
        whole[np.ix_(rows, columns)] += conjugate
    speeds, start = wave_rates(first, second, V, v_0)
    return Turning(first, second, whole * np.exp(1j * phase), speeds + omega, start, omega)
