"""Reduction of large phases to one period without losing digits.

A period known to forty digits is stored as the sum of two doubles, and its multiples are subtracted
in exact products, so the remainder of a time t is as accurate as t itself.  The error of a reduced
phase does not grow with the number of periods, until that number times 2⁻¹⁰⁶ is noticeable.
"""

from __future__ import annotations

import numpy as np
from flint import arb

from flowlanes.system.arrays import FloatArray

#: A number as the sum of two doubles.
Pair = tuple[float, float]

#: Veltkamp's constant 2²⁷ + 1.
_SPLIT = 134217729.0


def pair(ball: arb) -> Pair:
    """The midpoint of a ball as two doubles."""
    high = float(ball.mid())
    return high, float((ball - high).mid())


def exact_product(a: FloatArray, b: float) -> tuple[FloatArray, FloatArray]:
    """Exact product a·b as a sum of two doubles (Dekker's algorithm)."""
    p = a * b
    a_high = _SPLIT * a - (_SPLIT * a - a)
    b_high = _SPLIT * b - (_SPLIT * b - b)
    a_low, b_low = a - a_high, b - b_high
    return p, ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low


def reduced_phase(times: FloatArray, offset: Pair, period: Pair) -> tuple[FloatArray, FloatArray]:
    """Integers n and remainders with t + offset = n·period + remainder.

    Parameters
    ----------
    times : array (n,)
    offset, period : pairs of doubles
    """
    count = np.rint((times + offset[0]) / period[0])
    whole, remainder = exact_product(count, period[0])
    # At late times t and n·period are within a factor of two of each other, so their difference is
    # exact (Sterbenz); smaller parts are subtracted afterwards.
    return count, ((times - whole) + offset[0]) - remainder - count * period[1] + offset[1]


def fraction(counts: FloatArray, share: Pair) -> FloatArray:
    """counts·share minus the nearest integer."""
    whole, remainder = exact_product(counts, share[0])
    return (whole - np.rint(whole)) + remainder + counts * share[1]
