"""Decide numerically whether a level has real points."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import sympy as sp

from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System

_TRIES = 24
_RESIDUAL = 1e-8


def has_real_points(
    system: System,
    relations: Sequence[sp.Expr],
    free: Sequence[sp.Symbol],
    substitutions: Sequence[tuple[sp.Symbol, sp.Expr]],
) -> bool:
    """True if a real point of a level is found at the default parameters.

    Newton's method is tried from several random starts; the level counts as empty if all fail.

    Parameters
    ----------
    relations : sequence of sympy.Expr
        Expressions that vanish on the level.
    free : sequence of Symbol
        Parameters with their default values.
    substitutions : sequence of (Symbol, sympy.Expr)
        Parameters given by formulas in these.
    """
    from scipy.optimize import least_squares

    defaults = system.defaults
    numbers = {s: sp.Float(defaults[s]) for s in free}
    numbers |= {s: sp.N(value.xreplace(numbers)) for s, value in substitutions}
    formulas = [system.expand(relation).xreplace(numbers) for relation in relations]
    residual = sp.lambdify(system.symbols, formulas, "numpy")

    def function(x: FloatArray) -> FloatArray:
        with np.errstate(all="ignore"):
            return np.asarray(residual(*x), dtype=float)

    rng = np.random.default_rng(0)
    for _ in range(_TRIES):
        start = rng.normal(size=len(system.symbols))
        # Roots and logarithms may be undefined at some starts, but not where all variables are
        # positive.
        for chosen in (start, np.abs(start)):
            try:
                reached = least_squares(function, chosen)
            except ValueError:
                continue
            if np.abs(reached.fun).max() < _RESIDUAL:
                return True
    return False
