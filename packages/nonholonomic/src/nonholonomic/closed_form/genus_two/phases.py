"""Phases on the torus: grids, wave frequencies, and accurate phases at long times."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from flint import arb

from flowlanes.formulas.balls import number
from flowlanes.system.arrays import ComplexArray, FloatArray, IntArray

from ..one_degree.phase_reduction import Pair, exact_product


def phase_grid(sizes: Sequence[int]) -> FloatArray:
    """The phases 2j/n of a grid with n points per period 2, (n_1 n_2, 2), row by row."""
    lines = [2.0 * np.arange(size) / size for size in sizes]
    return np.array(np.meshgrid(*lines, indexing="ij")).reshape(2, -1).T


def wave_rates(
    first: FloatArray | IntArray, second: FloatArray | IntArray, V: Sequence[arb], v_0: FloatArray
) -> tuple[FloatArray, ComplexArray]:
    """The rate π(k, V) of every wave (k₁, k₂) along the flow, and exp(iπ(k, v₀))."""
    k_1, k_2 = np.meshgrid(first, second, indexing="ij")
    rates = np.pi * np.array(
        [number(int(k) * V[0] + int(m) * V[1]) for k, m in zip(k_1.flat, k_2.flat, strict=True)]
    ).reshape(k_1.shape)
    return rates, np.exp(1j * np.pi * (k_1 * v_0[0] + k_2 * v_0[1]))


def phase_at(rate: Pair, times: FloatArray, modulus: float) -> FloatArray:
    """rate · times modulo `modulus`, in absolute value at most `modulus`.

    Parameters
    ----------
    rate : pair of doubles
        A number as their sum.
    times : array (n,)
    modulus : float
        A power of two, so that the remainder is exact.

    Notes
    -----
    The product of two doubles is taken exactly, as a sum of two.  The error is about 1e-16 as
    long as rate · times is below 1e16.
    """
    high, low = rate
    with np.errstate(over="ignore"):
        product, error = exact_product(times, high)
    return np.fmod(product, modulus) + np.fmod(error + low * times, modulus)
