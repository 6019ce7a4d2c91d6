"""Formulas of a System and their derivatives as numbers of any precision."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from numbers import Integral, Real
from typing import Any

import mpmath
import sympy as sp

from ..errors import InputError
from ..expressions import parse
from ..system import System

__all__ = ["Slopes", "number"]


def number(value: Any, where: str) -> Any:
    """A number of the user's with all its digits; a float means the decimal that it shows.

    Parameters
    ----------
    value : number of Python, NumPy, mpmath or SymPy, or a formula without names as text
    where : str
        What the number is, for the message.

    Raises
    ------
    InputError
        If it is no finite real number.
    """
    if isinstance(value, mpmath.mpf):
        found = +value
    elif isinstance(value, str):
        found = _evaluated(parse(value, {}, where))
    elif isinstance(value, sp.Expr) and value.is_number and value.is_real:
        found = _evaluated(value)
    elif isinstance(value, Real):
        exact = int(value) if isinstance(value, Integral) else repr(float(value))
        found = mpmath.mpf(exact)
    else:
        raise InputError(f"{where} = {value}: it must be a real number")
    if not mpmath.isfinite(found):
        raise InputError(f"{where} = {value}: it must be a finite number")
    return found


def _evaluated(formula: sp.Expr) -> Any:
    """A constant formula at the working precision."""
    return mpmath.mpmathify(sp.lambdify((), formula, "mpmath")())


class Slopes:
    """Evaluates formulas of a system together with their exact partial derivatives.

    Definitions are differentiated by the chain rule, each formula for itself, so that nothing is
    ever expanded.
    """

    def __init__(self, system: System) -> None:
        self.system = system
        self._compiled: dict[sp.Expr, _Formula] = {}

    def __call__(
        self,
        formulas: Sequence[sp.Expr],
        variables: Sequence[sp.Symbol],
        values: Mapping[sp.Symbol, Any],
    ) -> tuple[Any, Any]:
        """Values (formulas,) and derivatives (formulas, variables) at a point.

        `values` gives every state variable that takes part and every parameter.
        """
        known = dict(values)
        size = len(variables)
        slopes = {
            s: [mpmath.mpf(int(i == j)) for j in range(size)] for i, s in enumerate(variables)
        }
        for symbol, value in self.system.needed(formulas):
            known[symbol], slopes[symbol] = self._formula(value)(known, slopes, size)
        pairs = [self._formula(formula)(known, slopes, size) for formula in formulas]
        column, rows = mpmath.matrix(len(pairs), 1), mpmath.matrix(len(pairs), size)
        for i, (value, row) in enumerate(pairs):
            column[i] = value
            for j, slope in enumerate(row):
                rows[i, j] = slope
        return column, rows

    def _formula(self, formula: sp.Expr) -> _Formula:
        if formula not in self._compiled:
            self._compiled[formula] = _Formula(formula)
        return self._compiled[formula]


class _Formula:
    """One formula in named quantities, with its derivative by each of them."""

    def __init__(self, formula: sp.Expr) -> None:
        self.symbols = sorted(formula.free_symbols, key=str)
        slopes: Iterable[sp.Expr] = (sp.diff(formula, s) for s in self.symbols)
        self._function: Callable[..., Any] = sp.lambdify(
            self.symbols, [formula, *slopes], modules="mpmath", cse=True
        )

    def __call__(
        self, known: Mapping[sp.Symbol, Any], slopes: Mapping[sp.Symbol, list[Any]], size: int
    ) -> tuple[Any, list[Any]]:
        value, *partial = self._function(*(known[s] for s in self.symbols))
        row = [mpmath.mpf(0)] * size
        for symbol, share in zip(self.symbols, partial, strict=True):
            inner = slopes.get(symbol)
            if inner is not None and share != 0:
                row = [total + share * slope for total, slope in zip(row, inner, strict=True)]
        return mpmath.mpf(value), row
