"""Formulas as SymPy prints them, with equal subexpressions printed once.

A formula of a system is a tree with many equal parts; the printers of SymPy visit all of them.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.printing.printer import Printer
from sympy.printing.repr import ReprPrinter
from sympy.printing.str import StrPrinter


class _OncePrinter(Printer):
    """A printer that caches the text of subexpressions.

    Parts with decimal numbers are not cached: they compare equal for any precision, but print
    differently.
    """

    def __init__(self, settings: dict[str, object]) -> None:
        super().__init__(settings)
        self._texts: dict[sp.Basic, str] = {}
        self._decimals = 0

    def _print(self, expr: object, **settings: Any) -> str:
        if settings or not isinstance(expr, sp.Basic):
            return str(super()._print(expr, **settings))
        known = self._texts.get(expr)
        if known is not None:
            return known
        before = self._decimals
        self._decimals += isinstance(expr, sp.Float)
        text = str(super()._print(expr))
        if self._decimals == before:
            self._texts[expr] = text
        return text


class _ReprPrinter(_OncePrinter, ReprPrinter):
    pass


class _StrPrinter(_OncePrinter, StrPrinter):
    def _print_Exp1(self, expr: sp.Basic) -> str:
        return "exp(1)"


def exact_text(value: object) -> str:
    """The text of :func:`sympy.srepr`, with all digits and assumptions.

    Examples
    --------
    >>> exact_text(sp.Float("0.5") + sp.Integer(2) ** sp.Symbol("x"))
    "Add(Pow(Integer(2), Symbol('x')), Float('0.5', precision=53))"
    """
    return str(_ReprPrinter({}).doprint(value))


def short_text(formula: sp.Basic) -> str:
    """The text of `str`, with ``exp(1)`` for Euler's number, since E may be a name.

    Examples
    --------
    >>> short_text((sp.Symbol("x") + 1) ** 2)
    '(x + 1)**2'
    """
    return str(_StrPrinter({"order": None}).doprint(formula))
