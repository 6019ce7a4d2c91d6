"""Find the first point at which a polynomial becomes positive."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from flowlanes.system.arrays import FloatArray

#: Number of intervals in which sign changes are searched.
PARTS = 8
PLACES = np.linspace(0.0, 1.0, PARTS + 1)


def value(series: FloatArray, x: float) -> float:
    """Evaluate a polynomial (lowest order first) at a point."""
    result = 0.0
    place = float(x)
    for coefficient in series[::-1].tolist():
        result = result * place + coefficient
    return result


def first_rise(series: FloatArray, length: float) -> float | None:
    """The first x in [0, length] at which a polynomial rises above zero.

    Quadratic polynomials are solved directly.  For higher degrees the interval is divided into
    PARTS equal parts; within a part, a sign change of p is refined by Brent's method.  If p ≤ 0 at
    both ends but p′ changes from plus to minus, the maximum is located first and p is tested there.
    Two maxima within one part could be missed.

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
                # The polynomial first falls from zero: search beyond its minimum.
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
    # A root near zero needs full relative accuracy, and therefore many bisections.
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
