"""Choices of signs that contradict each other."""

from __future__ import annotations

from .quotient_ring import Poly


def contradict(first: Poly, second: Poly) -> bool:
    """Whether two polynomials cannot both be positive, seen from their terms.

    So it is where a sum of positive multiples of them has no terms but even powers with negative
    factors, as with x and -x - 1.
    """
    mine, others = first.to_dict(), second.to_dict()
    for exponents, number in mine.items():
        other = others.get(exponents)
        if other is None or not number / other < 0:
            continue
        rest = first - second * (number / other)
        if all(c < 0 and not any(n % 2 for n in e) for e, c in rest.to_dict().items()):
            return True
    return False
