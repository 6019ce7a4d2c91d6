"""Formulas in one variable as functions of balls and of divided differences alike."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

import sympy as sp
from flint import arb, fmpq

from ...errors import InputError

__all__ = ["program"]

#: Values of symbols ↦ the value of a formula.
Program = Callable[[Mapping[Any, Any]], Any]

_METHODS = {sp.cos: "cos", sp.sin: "sin", sp.exp: "exp"}


@lru_cache(maxsize=512)
def program(formula: sp.Expr) -> Program:
    """A formula made of sums, products, powers, roots, cos, sin and exp, ready to be computed.

    Parameters
    ----------
    formula : sympy.Expr
        Numbers in it are exact; a decimal means what is written.

    Returns
    -------
    callable
        From a mapping of symbols to arb, acb or :class:`Slopes` to the value.

    Raises
    ------
    InputError
        If another function occurs.
    """
    shared, (last,) = sp.cse([sp.sympify(formula)])
    steps = tuple((name, _built(part)) for name, part in shared)
    result = _built(last)

    def run(values: Mapping[Any, Any]) -> Any:
        known = dict(values)
        for name, step in steps:
            known[name] = step(known)
        return result(known)

    return run


def _built(formula: sp.Expr) -> Program:
    if formula.is_Symbol:
        return lambda known: known[formula]
    if formula.is_Rational or formula.is_Float:
        exact = sp.Rational(str(formula))
        number = fmpq(int(exact.p), int(exact.q))
        return lambda known: arb(number)
    parts = [_built(part) for part in formula.args]
    if formula.is_Add:
        return lambda known: sum((part(known) for part in parts[1:]), parts[0](known))
    if formula.is_Mul:
        return lambda known: _product([part(known) for part in parts])
    if formula.is_Pow and formula.exp.is_Rational and formula.exp.q in (1, 2):
        base, power, root = parts[0], int(formula.exp.p), formula.exp.q == 2
        return lambda known: _power(base(known).sqrt() if root else base(known), power)
    if formula.func in _METHODS:
        method = _METHODS[formula.func]
        return lambda known: getattr(parts[0](known), method)()
    raise InputError(
        f"{formula}: closed forms are computed of sums, products, roots, sin, cos and exp alone"
    )


def _product(factors: list[Any]) -> Any:
    result = factors[0]
    for factor in factors[1:]:
        result = result * factor
    return result


def _power(base: Any, exponent: int) -> Any:
    # by products, since python-flint gives no value to a power of a ball that contains zero
    result = _product([base] * abs(exponent))
    return result if exponent > 0 else 1 / result
