"""Generalise from a few coordinates to any number of them.

Let both sides of a formula be sums over k indices, each running from 1 to n, of products of
functions, their derivatives and free rates, every index of the sum standing at one factor at least.
Their difference is a polynomial in these quantities, which are independent where functions are
unspecified.  A monomial has at most k different indices, and its coefficient comes from those terms
of the sum alone that have the same ones.  So it is the coefficient of the same monomial, with its
indices renamed, in the difference for n = k; if that vanishes identically, all of them do.
"""

from __future__ import annotations


def any_number(most: int) -> str:
    """The argument, for a formula whose terms have at most `most` different indices."""
    words = {1: "one index", 2: "two different indices", 3: "three different indices"}
    return (
        f"a term has at most {words.get(most, 'four different indices')}, so that the identity for "
        "so many coordinates is the one for any number of them"
    )
