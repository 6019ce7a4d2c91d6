"""Formulas of a System and their derivatives as numbers of any precision."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from numbers import Integral, Real
from typing import Any, TypeAlias

import mpmath
import sympy as sp

from ..core.system import System
from ..errors import InputError
from ..parsing import parse

__all__ = ["number", "slopes"]


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
    if formula.is_Rational:
        return mpmath.mpf(int(formula.p)) / int(formula.q)
    if formula.is_Float:
        return mpmath.mpf(formula._mpf_)
    return mpmath.mpmathify(sp.lambdify((), formula, "mpmath")())


Pair: TypeAlias = tuple[Any, dict[int, Any]]
"""A number and those of its partial derivatives that are not zero, by the index of the variable."""


def slopes(
    system: System,
    formulas: Sequence[sp.Expr],
    variables: Sequence[sp.Symbol],
    values: Mapping[sp.Symbol, Any],
) -> tuple[Any, Any]:
    """Formulas of a system at a point, and their partial derivatives.

    Derivatives are carried along with the values, by the rules of differentiation for every single
    operation and through the definitions: they are exact, and nothing is ever expanded.

    Parameters
    ----------
    system : System
    formulas : sequence of Expr
        Scalars in state, definitions and parameters.
    variables : sequence of Symbol
        State variables by which to differentiate.
    values : mapping of Symbol to mpf
        Every state variable that takes part and every parameter.

    Returns
    -------
    tuple of mpmath.matrix
        Values (formulas, 1) and derivatives (formulas, variables).
    """
    known: dict[sp.Expr, Pair] = {s: (value, {}) for s, value in values.items()}
    for i, s in enumerate(variables):
        known[s] = (values[s], {i: mpmath.mpf(1)})
    for symbol, formula in system.needed(formulas):
        known[symbol] = _visit(formula, known)
    column, rows = mpmath.matrix(len(formulas), 1), mpmath.matrix(len(formulas), len(variables))
    for i, formula in enumerate(formulas):
        column[i], row = _visit(formula, known)
        for j, slope in row.items():
            rows[i, j] = slope
    return column, rows


def _visit(node: sp.Expr, known: dict[sp.Expr, Pair]) -> Pair:
    if node not in known:
        known[node] = _evaluated_pair(node, known)
    return known[node]


def _evaluated_pair(node: sp.Expr, known: dict[sp.Expr, Pair]) -> Pair:
    if node.is_number:
        return _evaluated(node), {}
    parts = [_visit(arg, known) for arg in node.args]
    if node.is_Add:
        return mpmath.fsum(value for value, _ in parts), _combined(
            [mpmath.mpf(1)] * len(parts), parts
        )
    if node.is_Mul:
        return mpmath.fprod(value for value, _ in parts), _combined(_cofactors(parts), parts)
    value, *partial = _function(node.func, node.args)(*(value for value, _ in parts))
    return value, _combined(partial, parts)


def _cofactors(parts: Sequence[Pair]) -> list[Any]:
    """For each factor of a product the product of the others."""
    values = [value for value, _ in parts]
    return [mpmath.fprod((*values[:i], *values[i + 1 :])) for i in range(len(values))]


def _combined(weights: Sequence[Any], parts: Sequence[Pair]) -> dict[int, Any]:
    """Σ weight · derivative."""
    total: dict[int, Any] = {}
    for weight, (_, row) in zip(weights, parts, strict=True):
        for j, slope in row.items():
            total[j] = total.get(j, 0) + weight * slope
    return total


def _function(kind: Any, arguments: Sequence[sp.Expr]) -> Callable[..., Sequence[Any]]:
    """A power or function with its derivatives; a constant exponent is part of the function."""
    exponent = arguments[1] if kind is sp.Pow and arguments[1].is_number else None
    return _compiled(kind, len(arguments), exponent)


@lru_cache(maxsize=256)
def _compiled(kind: Any, count: int, exponent: sp.Expr | None) -> Callable[..., Sequence[Any]]:
    names = sp.symbols(f"x:{count}", real=True)
    if exponent is not None:
        formula = names[0] ** exponent
        partial = [sp.diff(formula, names[0]), sp.S.Zero]
    else:
        formula = kind(*names)
        partial = [sp.diff(formula, name) for name in names]
    made: Callable[..., Sequence[Any]] = sp.lambdify(names, [formula, *partial], "mpmath")
    return made
