"""The first point at which a polynomial becomes positive."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from flowlanes.system.arrays import FloatArray

#: Parts in which a stretch is searched for changes of sign.
PARTS = 8
PLACES = np.linspace(0.0, 1.0, PARTS + 1)


def value(series: FloatArray, x: float) -> float:
    """A polynomial, lowest order first, at one place."""
    result = 0.0
    place = float(x)
    for coefficient in series[::-1].tolist():
        result = result * place + coefficient
    return result


def first_rise(series: FloatArray, length: float) -> float | None:
    """The first x in [0, length] at which a polynomial that is not positive before becomes so.

    Parameters
    ----------
    series : (n,) array
        Coefficients, lowest order first.  A value at 0 that is positive by rounding counts as 0.
    length : float
        May be infinite for a polynomial of at most second degree.
    """
    if not series[3:].any():
        return _first_rise_of_a_quadratic(series, length)
    order = np.arange(len(series))
    terms = series * length**order
    if -terms[0] > np.abs(terms[1:]).sum():
        return None
    x = length * PLACES
    derivative = series[1:] * order[1:]
    powers = PLACES[:, None] ** order
    g, slope = powers @ terms, powers[:, :-1] @ (terms[1:] * order[1:])
    g[0] = min(g[0], 0.0)
    noise = 1e-15 * np.abs(g).max()
    for left in range(PARTS):
        right = left + 1
        end = x[right]
        if g[right] <= 0 and slope[left] > 0 > slope[right]:
            end = _root(lambda s: -value(derivative, s), x[left], end)
        if g[right] > 0 or value(series, end) > noise:
            if g[left] == 0 and slope[left] >= 0:
                return float(x[left])
            begin = x[left]
            if g[left] == 0:
                # It falls from zero first: search behind its minimum.
                begin = _root(lambda s: value(derivative, s), begin, end)
            return _root(lambda s: value(series, s), begin, end)
    return None


def _root(function: Callable[[float], float], left: float, right: float) -> float:
    """The root of a function that is negative on the left and positive on the right."""
    from scipy.optimize import brentq

    if function(left) >= 0:
        return left
    if function(right) <= 0:
        return right
    # A root near zero is wanted to its own digits: many halvings.
    accuracy = 4 * np.finfo(float).eps
    return float(brentq(function, left, right, xtol=1e-300, rtol=accuracy, maxiter=10_000))


def _first_rise_of_a_quadratic(series: FloatArray, length: float) -> float | None:
    constant, slope, half = (*series[:3].tolist(), 0.0, 0.0)[:3]
    constant = min(constant, 0.0)
    root: float | None
    if constant == 0 and (slope > 0 or (slope == 0 and half > 0)):
        root = 0.0
    elif half == 0:
        root = -constant / slope if slope > 0 else None
    else:
        discriminant = slope * slope - 4 * half * constant
        if discriminant < 0:
            return None
        wide = slope + np.copysign(np.sqrt(discriminant), slope)
        roots = [wide / (-2 * half), *([-2 * constant / wide] if wide else [])]
        rising = [x for x in roots if x > 0 and slope + 2 * half * x >= 0]
        root = min(rising, default=None)
    return None if root is None or root > length else float(root)
