"""Phases that grow linearly with time, without loss at long times."""

from __future__ import annotations

import numpy as np
from flint import arb

from ...core.arrays import FloatArray

__all__ = ["halves", "turned"]

#: Splits a double into two halves of 26 bits (Dekker).
_SPLITTER = 134217729.0


def halves(value: arb) -> tuple[float, float]:
    """A ball's middle as the sum of two doubles, about 32 digits."""
    high = float(value.mid())
    return high, float((value - arb(high)).mid())


def turned(rate: tuple[float, float], times: FloatArray, modulus: float) -> FloatArray:
    """rate · times modulo `modulus`, in absolute value at most `modulus`.

    Parameters
    ----------
    rate : (float, float)
        A number as a sum of two doubles.
    times : array (n,)
    modulus : float
        A power of two, so that the remainder is exact.

    Notes
    -----
    The product of two doubles is taken exactly, as a sum of two.  The error is about 1e-16 as
    long as rate · times is below 1e16.
    """
    high, low = rate
    product = high * times
    with np.errstate(over="ignore"):
        error = _low_part(high, times, product)
    return np.fmod(product, modulus) + np.fmod(error + low * times, modulus)


def _low_part(one: float, other: FloatArray, product: FloatArray) -> FloatArray:
    """What rounding took from a product."""
    a, b = _split(np.asarray(one)), _split(np.asarray(other))
    return ((a[0] * b[0] - product) + a[0] * b[1] + a[1] * b[0]) + a[1] * b[1]


def _split(value: FloatArray) -> tuple[FloatArray, FloatArray]:
    scaled = _SPLITTER * value
    high = scaled - (scaled - value)
    return high, value - high
