"""Formulas of a System and their derivatives with any precision."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from numbers import Integral, Real
from typing import TypeAlias

import mpmath
import sympy as sp

from ..errors import InputError
from ..parsing import parse
from ..system.system import System
from .evaluation import Evaluation


def number(value: object, where: str) -> mpmath.mpf:
    """Number from a user with all its digits; a float is taken as its shortest decimal.

    Parameters
    ----------
    value : number of Python, NumPy, mpmath or SymPy, or a formula without names as text
    where : str
        Name of the number in the message.

    Raises
    ------
    InputError
        If it is not a finite real number.
    """
    if isinstance(value, mpmath.mpf):
        digits = +value
    elif isinstance(value, str):
        digits = Multiprecision({})(parse(value, {}, where))
    elif isinstance(value, sp.Expr) and value.is_number and value.is_real:
        digits = Multiprecision({})(value)
    elif isinstance(value, Real):
        digits = mpmath.mpf(int(value) if isinstance(value, Integral) else repr(float(value)))
    else:
        raise InputError(f"{where} = {value}: it must be a real number")
    if not mpmath.isfinite(digits):
        raise InputError(f"{where} = {value}: it must be a finite number")
    return digits


class Multiprecision(Evaluation[mpmath.mpf]):
    """Formulas as mpmath numbers at the working precision; complex where a root is complex."""

    def _constant(self, number: sp.Expr) -> mpmath.mpf:
        if number.is_Float:
            return mpmath.mpf(number._mpf_)
        return mpmath.mpf(int(number.p)) / int(number.q)

    def _sum(self, formula: sp.Add) -> mpmath.mpf:
        return mpmath.fsum(self._parts(formula))

    def _product(self, formula: sp.Mul) -> mpmath.mpf:
        return mpmath.fprod(self._parts(formula))

    def _power(self, formula: sp.Pow) -> mpmath.mpf:
        base, exponent = formula.args
        return self(base) ** (int(exponent) if exponent.is_Integer else self(exponent))

    def _function(self, formula: sp.Expr) -> mpmath.mpf:
        function = mpmath_function(formula.func, len(formula.args))
        return mpmath.mpmathify(function(*self._parts(formula)))


@lru_cache(maxsize=256)
def mpmath_function(of: Callable[..., sp.Expr], count: int) -> Callable[..., mpmath.mpf]:
    """SymPy function of `count` arguments as an mpmath function; a constant for zero arguments."""
    names = sp.symbols(f"x:{count}")
    function: Callable[..., mpmath.mpf] = sp.lambdify(names, of(*names), "mpmath")
    return function


Pair: TypeAlias = tuple[mpmath.mpf, dict[int, mpmath.mpf]]
"""A number and those of its partial derivatives that are not zero, by the index of the variable."""


def slopes(
    system: System,
    formulas: Sequence[sp.Expr],
    variables: Sequence[sp.Symbol],
    values: Mapping[sp.Symbol, mpmath.mpf],
) -> tuple[mpmath.matrix, mpmath.matrix]:
    """Formulas of a system at a point, and their partial derivatives.

    Derivatives are propagated together with the values, by the differentiation rules of every
    operation and through the definitions.  They are exact, and nothing is expanded.

    Parameters
    ----------
    system : System
    formulas : sequence of Expr
        Scalars in state, definitions and parameters.
    variables : sequence of Symbol
        State variables of the derivatives.
    values : mapping of Symbol to mpf
        Values of every parameter and of every state variable in use.

    Returns
    -------
    tuple of mpmath.matrix
        Values (formulas, 1) and derivatives (formulas, variables).
    """
    seeds: dict[sp.Symbol, Pair] = {s: (value, {}) for s, value in values.items()}
    seeds |= {s: (values[s], {i: mpmath.mpf(1)}) for i, s in enumerate(variables)}
    jets = _Jets(seeds)
    jets.define(system.required_definitions(formulas))
    column, rows = mpmath.matrix(len(formulas), 1), mpmath.matrix(len(formulas), len(variables))
    for i, formula in enumerate(formulas):
        column[i], row = jets(formula)
        for j, slope in row.items():
            rows[i, j] = slope
    return column, rows


class _Jets(Evaluation[Pair]):
    """Numbers with their partial derivatives."""

    def _rule(self, formula: sp.Expr) -> Callable[[sp.Expr], Pair]:
        return self._constant if formula.is_number else super()._rule(formula)

    def _constant(self, number: sp.Expr) -> Pair:
        return Multiprecision({})(number), {}

    def _sum(self, formula: sp.Add) -> Pair:
        terms = self._parts(formula)
        return mpmath.fsum(value for value, _ in terms), _weighted_sum(
            [mpmath.mpf(1)] * len(terms), terms
        )

    def _product(self, formula: sp.Mul) -> Pair:
        factors = self._parts(formula)
        values = [value for value, _ in factors]
        others = [mpmath.fprod((*values[:i], *values[i + 1 :])) for i in range(len(values))]
        return mpmath.fprod(values), _weighted_sum(others, factors)

    def _power(self, formula: sp.Pow) -> Pair:
        return self._function(formula)

    def _function(self, formula: sp.Expr) -> Pair:
        """Power or function; a constant exponent is part of the function."""
        exponent = formula.exp if formula.is_Pow and formula.exp.is_number else None
        parts = self._parts(formula)
        function = _with_partial_derivatives(formula.func, len(parts), exponent)
        value, *partial = function(*(value for value, _ in parts))
        return value, _weighted_sum(partial, parts)


def _weighted_sum(weights: Sequence[mpmath.mpf], parts: Sequence[Pair]) -> dict[int, mpmath.mpf]:
    """Sum of weight · derivative."""
    total: dict[int, mpmath.mpf] = {}
    for weight, (_, row) in zip(weights, parts, strict=True):
        for j, slope in row.items():
            total[j] = total.get(j, 0) + weight * slope
    return total


@lru_cache(maxsize=256)
def _with_partial_derivatives(
    of: Callable[..., sp.Expr], count: int, exponent: sp.Expr | None
) -> Callable[..., Sequence[mpmath.mpf]]:
    """SymPy function with its partial derivatives, as mpmath functions."""
    names = sp.symbols(f"x:{count}", real=True)
    if exponent is not None:
        formula = names[0] ** exponent
        partial = [sp.diff(formula, names[0]), sp.S.Zero]
    else:
        formula = of(*names)
        partial = [sp.diff(formula, name) for name in names]
    function: Callable[..., Sequence[mpmath.mpf]] = sp.lambdify(
        names, [formula, *partial], "mpmath"
    )
    return function
