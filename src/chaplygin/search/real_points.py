"""Whether a level has real points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

if TYPE_CHECKING:
    from .phase_space import Stage

__all__ = ["has_real_points"]

_TRIES = 24
_RESIDUAL = 1e-8


def has_real_points(made: Stage) -> bool:
    """Whether a real point of the level is found at the default parameters.

    Newton's method, from several random starts; the level counts as empty when all fail.
    """
    from scipy.optimize import least_squares

    defaults = made.system.defaults
    numbers = {s: sp.Float(defaults[s]) for s in made.free}
    numbers |= {s: sp.N(value.xreplace(numbers)) for s, value in made.substitutions}
    formulas = list(made.relations)
    for symbol, value in reversed(made.system.needed(formulas)):
        formulas = [f.xreplace({symbol: value}) for f in formulas]
    residual = sp.lambdify(made.system.symbols, [f.xreplace(numbers) for f in formulas], "numpy")

    def function(x: Any) -> Any:
        with np.errstate(all="ignore"):
            return np.asarray(residual(*x), dtype=float)

    rng = np.random.default_rng(0)
    for _ in range(_TRIES):
        start = rng.normal(size=len(made.system.symbols))
        # roots and logarithms may have no value there, but where all is positive
        for chosen in (start, np.abs(start)):
            try:
                reached = least_squares(function, chosen)
            except ValueError:
                continue
            if np.abs(reached.fun).max() < _RESIDUAL:
                return True
    return False
