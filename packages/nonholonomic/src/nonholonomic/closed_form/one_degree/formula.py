"""Formulas in one variable, for both balls and divided differences."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

import sympy as sp

from flowlanes.formulas.straight_line_program import ENTIRE, StraightLineProgram


@lru_cache(maxsize=512)
def program(formula: sp.Expr) -> Callable[[Mapping[sp.Symbol, Any]], Any]:
    """A formula made of sums, products, powers, roots, cos, sin and exp, compiled for evaluation.

    Parameters
    ----------
    formula : sympy.Expr
        Numbers in it are exact; a decimal means what is written.

    Returns
    -------
    callable
        From a mapping of symbols to arb, acb or
        :class:`~nonholonomic.closed_form.one_degree.divided_differences.DividedDifferences` to the
        value.

    Raises
    ------
    InputError
        If another function occurs.
    """
    scalar = sp.sympify(formula)
    names = sorted(scalar.free_symbols, key=str)
    shared, parts = sp.cse([scalar])
    ready = StraightLineProgram(names, parts, tuple(shared), ENTIRE)
    return lambda values: ready.run([values[name] for name in names])[0]
