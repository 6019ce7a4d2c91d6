"""Short polynomials for the smooth parts of functions, with a required accuracy."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import TypeAlias

import mpmath
from mpmath import MPContext, libmp

#: A function of an mpmath context and a number.
SmoothPart: TypeAlias = Callable[[MPContext, mpmath.mpf], mpmath.mpf]


@dataclass(frozen=True)
class Approximation:
    """A polynomial approximation on an interval.

    Attributes
    ----------
    coefficients : tuple of Fraction
        From the constant term to the highest power.
    reach : float
        Largest magnitude of the variable.
    """

    coefficients: tuple[Fraction, ...]
    reach: float


def _odd(name: str) -> SmoothPart:
    """Factor g = (f(√t)/√t − 1)/t of an odd function f(x) = x + x³ g(x²)."""

    def smooth(mp: MPContext, t: mpmath.mpf) -> mpmath.mpf:
        x = mp.sqrt(t)
        return (getattr(mp, name)(x) / x - 1) / t

    return smooth


#: Smooth parts of functions and the intervals on which they are needed, slightly widened because
#: the reduction of arguments is rounded.
PARTS: Mapping[str, tuple[SmoothPart, float, float]] = {
    # x = √t up to π/4
    "sin": (_odd("sin"), 0.0, 0.617),
    "cos": (lambda mp, t: ((mp.cos(mp.sqrt(t)) - 1) / t + mp.mpf(1) / 2) / t, 0.0, 0.617),
    # up to 1/2
    "asin": (_odd("asin"), 0.0, 0.25),
    "atan": (_odd("atan"), 0.0, 0.25),
    "sinh": (_odd("sinh"), 0.0, 0.25),
    # up to (√2 − 1)/(√2 + 1)
    "atanh": (_odd("atanh"), 0.0, 0.0295),
    # (eˣ − 1 − x)/x² up to (log 2)/2
    "exp": (lambda mp, x: mp.hyp1f1(1, 3, x) / 2, -0.347, 0.347),
}


@lru_cache
def series(name: str, bits: int) -> Approximation:
    """Shortest polynomial approximation of the smooth part of a function.

    Interpolation at Chebyshev points is as good as the best polynomial up to a small factor.

    Parameters
    ----------
    name : str
        A key of `PARTS`.
    bits : int
        The error is below 2⁻ᵇⁱᵗˢ.
    """
    smooth, first, last = PARTS[name]
    mp = MPContext()
    mp.prec = 4 * bits
    value = mp.memoize(lambda t: smooth(mp, t))
    terms = 2
    while True:
        coefficients, error = mp.chebyfit(value, [first, last], terms, error=True)
        reached = -mp.mag(error)
        if reached >= bits:
            return Approximation(tuple(map(_fraction, reversed(coefficients))), max(-first, last))
        # Only half of the predicted increase, because a degree that is too high costs time in
        # every call.
        rate = max(1, reached // terms)
        terms += max(1, (bits - reached) // (2 * rate))


@lru_cache
def parts(name: str, bits: tuple[int, ...]) -> tuple[Fraction, ...]:
    """Constant as a sum of short numbers of given lengths, and a remainder.

    Parameters
    ----------
    name : str
        ``"pi"`` or ``"ln2"``.
    bits : tuple of int
    """
    mp = MPContext()
    mp.prec = 4 * sum(bits) + 200
    remainder = _fraction(+getattr(mp, name))
    pieces = []
    for length in bits:
        piece = _nearest_short(remainder, length)
        pieces.append(piece)
        remainder -= piece
    return (*pieces, remainder)


def _nearest_short(value: Fraction, bits: int) -> Fraction:
    """Nearest number with a given number of bits."""
    mp = MPContext()
    mp.prec = bits
    return _fraction(mp.mpf(value.numerator) / value.denominator)


def _fraction(value: mpmath.mpf) -> Fraction:
    """Exact value of an mpmath number."""
    return Fraction(*libmp.to_rational(value._mpf_))
