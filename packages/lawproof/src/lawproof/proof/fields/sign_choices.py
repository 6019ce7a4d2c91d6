"""Detection of contradictory sign choices."""

from __future__ import annotations

from .quotient_ring import Poly


def contradict(first: Poly, second: Poly) -> bool:
    """True if the terms of two polynomials show that both cannot be positive.

    This is so if a positive combination of them has only even powers with negative coefficients,
    as with x and −x − 1.
    """
    mine, others = first.to_dict(), second.to_dict()
    for exponents, number in mine.items():
        other = others.get(exponents)
        if other is None or not number / other < 0:
            continue
        # number/other < 0, so this is first plus a positive multiple of second.
        rest = first - second * (number / other)
        if all(c < 0 and not any(n % 2 for n in e) for e, c in rest.to_dict().items()):
            return True
    return False
