"""Test whether a short formula is identically zero, by expansion over a common denominator."""

from __future__ import annotations

import sympy as sp

#: Number of operations in a formula above which the expansion is not tried.
LARGEST = 1500


def vanishes(formula: sp.Expr) -> bool:
    """True if a formula is shown to be zero; False also if it is too long."""
    if sp.count_ops(formula) > LARGEST:
        return False
    if sp.expand(formula) == 0:
        return True
    return bool(sp.expand(sp.numer(sp.together(formula))) == 0)
