"""Extension of an identity from a few coordinates to any number of them.

Let both sides of a formula be sums over k indices, each running from 1 to n, of products of
functions, their derivatives and free rates, such that every index of summation occurs in at least
one factor. Their difference is a polynomial in these quantities, which are independent if the
functions are unspecified. A monomial has at most k different indices, and its coefficient comes
only from those terms of the sum that have the same indices. It therefore equals the coefficient of
the monomial with renamed indices in the difference for n = k; if that difference vanishes
identically, all coefficients do.
"""

from __future__ import annotations


def any_number(most: int) -> str:
    """The argument for a formula whose terms have at most `most` different indices."""
    words = {1: "one index", 2: "two different indices", 3: "three different indices"}
    return (
        f"a term has at most {words.get(most, 'four different indices')}, so that the identity for "
        "so many coordinates is the one for any number of them"
    )
