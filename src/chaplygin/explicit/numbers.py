"""Formulas evaluated in numbers: balls (python-flint) and arrays (NumPy)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

import numpy as np
import sympy as sp
from flint import acb, arb, fmpq

from ..vectors import explicit

__all__ = ["Values", "array_function", "ball", "components", "evaluated", "midpoint", "number"]

#: Numbers by the symbol that names them.
Values = Mapping[sp.Symbol, Any]


def ball(value: Any) -> Any:
    """A number as a ball: floats, integers and fractions exactly, texts as decimals.

    Parameters
    ----------
    value : float, int, Fraction, str, sympy number, mpmath number or flint.arb
    """
    if isinstance(value, arb | acb):
        return value
    if isinstance(value, Fraction):
        return arb(fmpq(value.numerator, value.denominator))
    if isinstance(value, sp.Rational):
        return arb(fmpq(int(value.p), int(value.q)))
    if isinstance(value, float | np.floating):
        # a NumPy float may be wider than a double: its two halves are exact
        high = float(value)
        return arb(high) + arb(float(value - high))
    if isinstance(value, int | np.integer):
        return arb(int(value))
    return arb(str(value))


def number(value: Any) -> float:
    """The double nearest to the middle of a ball."""
    return float(value.mid()) if isinstance(value, arb) else float(value)


def midpoint(value: Any) -> Any:
    """The middle of a ball as an exact number."""
    return value.mid()


def components(formula: Any) -> tuple[sp.Expr, ...]:
    """A scalar or vector formula as scalar formulas."""
    value = explicit(sp.sympify(formula))
    return tuple(value) if isinstance(value, sp.MatrixBase) else (value,)


def evaluated(formulas: Iterable[Any], values: Values) -> tuple[Any, ...]:
    """Scalar formulas in balls.

    Parameters
    ----------
    formulas : iterable of sympy.Expr
    values : mapping of Symbol to arb or acb

    Returns
    -------
    tuple of arb or acb
        Not finite where a formula has no value.
    """
    return tuple(program(values) for program in map(_program, formulas))


@lru_cache(maxsize=4096)
def _program(formula: sp.Expr) -> Callable[[Values], Any]:
    """A formula as a list of steps: what stands twice is computed once."""
    shared, (last,) = sp.cse([sp.sympify(formula)])

    def run(values: Values) -> Any:
        known = dict(values)
        for name, part in shared:
            known[name] = _value(part, known)
        return _value(last, known)

    return run


def _value(formula: sp.Expr, known: Mapping[Any, Any]) -> Any:
    if formula.is_Symbol:
        return known[formula]
    if formula.is_Rational:
        return arb(fmpq(int(formula.p), int(formula.q)))
    if formula.is_Float:
        return arb(float(formula))
    if formula.is_Add:
        first, *rest = (_value(term, known) for term in formula.args)
        return sum(rest, first)
    if formula.is_Mul:
        product = None
        for factor in formula.args:
            value = _value(factor, known)
            product = value if product is None else product * value
        return product
    if formula.is_Pow:
        base, exponent = _value(formula.base, known), formula.exp
        if exponent.is_Integer:
            return base ** int(exponent)
        if exponent.is_Rational and exponent.q == 2:
            return base.sqrt() ** int(exponent.p)
        return base ** _value(exponent, known)
    method = {sp.cos: "cos", sp.sin: "sin", sp.exp: "exp", sp.log: "log", sp.Abs: "__abs__"}
    return getattr(_value(formula.args[0], known), method[formula.func])()


def array_function(
    names: Sequence[sp.Symbol], formulas: Sequence[sp.Expr]
) -> Callable[..., tuple[Any, ...]]:
    """Scalar formulas as a function of arrays, common parts computed once."""
    made = sp.lambdify(tuple(names), tuple(formulas), "numpy", cse=True)

    def function(*arrays: Any) -> tuple[Any, ...]:
        return tuple(made(*arrays))

    return function
