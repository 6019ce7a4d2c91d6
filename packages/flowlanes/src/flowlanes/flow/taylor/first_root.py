"""The first root of a polynomial in an interval."""

from __future__ import annotations

from functools import lru_cache
from math import comb

import numpy as np

from ...system.arrays import FloatArray

#: Interval length below which the interval is taken as a single point.
_SHORTEST = 2.0**-50


@lru_cache
def _to_bernstein(degree: int) -> FloatArray:
    """Matrix that maps power coefficients to Bernstein coefficients."""
    matrix = np.zeros((degree + 1, degree + 1))
    for j in range(degree + 1):
        for k in range(j + 1):
            matrix[j, k] = comb(j, k) / comb(degree, k)
    return matrix


def first_falling_root(coefficients: FloatArray, after: float = 0.0) -> float | None:
    """First point in (after, 1] where a polynomial decreases from positive values to zero.

    A polynomial has at most as many roots in an interval as its Bernstein coefficients have sign
    changes (Descartes' rule of signs).  Intervals with several sign changes are bisected (de
    Casteljau), which isolates simple roots; a multiple root is found when the interval has become
    a point.

    Parameters
    ----------
    coefficients : array (n,)
        Finite coefficients of the powers of x, constant first.
    after : float
        From 0 to 1.

    Returns
    -------
    float or None
        None if there is no such point.
    """
    whole = _to_bernstein(len(coefficients) - 1) @ coefficients
    pending = [(after, 1.0, _parts(whole, after)[1] if after else whole)]
    while pending:
        first, last, b = pending.pop()
        signs = np.sign(b[b != 0])
        changes = int(np.count_nonzero(signs[1:] != signs[:-1]))
        if changes == 0:
            # A root at the end is included, a root at the start is not.
            if b[-1] == 0 and np.any(signs > 0):
                return last
        elif (changes == 1 and b[0] != 0) or last - first < _SHORTEST:
            if signs[0] > 0 and b[-1] <= 0:
                return _root(coefficients, first, last)
        else:
            middle = (first + last) / 2
            left, right = _parts(b, 0.5)
            pending += [(middle, last, right), (first, middle, left)]
    return None


def _parts(b: FloatArray, x: float) -> tuple[FloatArray, FloatArray]:
    """Bernstein coefficients on both sides of a point of the interval (de Casteljau)."""
    degree = len(b) - 1
    left, right = np.empty_like(b), np.empty_like(b)
    for k in range(degree + 1):
        left[k], right[degree - k] = b[0], b[-1]
        b = (1 - x) * b[:-1] + x * b[1:]
    return left, right


def _root(coefficients: FloatArray, first: float, last: float) -> float:
    """Root between two points of opposite sign, or the nearer point if rounding hides the root."""
    # Imported only for an event, because the import takes longer than most motions.
    from scipy.optimize import brentq

    numbers = coefficients[::-1].tolist()

    def value(x: float) -> float:
        total = 0.0
        for number in numbers:
            total = total * x + number
        return total

    if not value(first) > 0:
        return first
    if not value(last) < 0:
        return last
    return float(brentq(value, first, last, xtol=1e-300, rtol=4 * np.finfo(float).eps))
