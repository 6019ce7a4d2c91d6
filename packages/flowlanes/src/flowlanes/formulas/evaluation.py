"""Evaluation of formulas in an algebra: numbers, terms of a graph, power series, jets."""

from __future__ import annotations

import operator
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping
from functools import reduce
from typing import Generic, TypeVar

import sympy as sp

N = TypeVar("N")


class Evaluation(ABC, Generic[N]):
    """Scalar formulas as elements of an algebra; every subexpression is computed once.

    An algebra is a subclass, which defines constants, powers and functions, and also sums and
    products unless these are + and * of the elements.

    Parameters
    ----------
    values : mapping of Symbol to element
        Values of the symbols in formulas.
    definitions : mapping of Symbol to formula, optional
        Formulas of further symbols, each evaluated on first use.
    """

    def __init__(
        self,
        values: Mapping[sp.Symbol, N],
        definitions: Mapping[sp.Symbol, sp.Expr] | None = None,
    ) -> None:
        self._elements: dict[sp.Expr, N] = dict(values)
        self._definitions = dict(definitions or {})

    def __call__(self, formula: sp.Expr) -> N:
        """Element for a scalar formula."""
        return self._visit(formula)

    def define(self, steps: Iterable[tuple[sp.Symbol, sp.Expr]]) -> None:
        """Define further symbols by formulas, in order, so that long chains need no recursion."""
        for symbol, formula in steps:
            self._elements[symbol] = self._visit(formula)

    def _visit(self, formula: sp.Expr) -> N:
        element = self._elements.get(formula)
        if element is None:
            step = self._definitions.get(formula)
            element = self._rule(formula)(formula) if step is None else self._visit(step)
            self._elements[formula] = element
        return element

    def _rule(self, formula: sp.Expr) -> Callable[[sp.Expr], N]:
        """Method for a kind of formula.

        It is returned and not called, which saves one level of recursion.
        """
        if formula.is_Rational or formula.is_Float:
            return self._constant
        if formula.is_Symbol:
            return self._symbol
        if formula.is_Add:
            return self._sum
        if formula.is_Mul:
            return self._product
        return self._power if formula.is_Pow else self._function

    def _parts(self, formula: sp.Expr) -> list[N]:
        """Elements of the arguments of a formula."""
        return list(map(self._visit, formula.args))

    @abstractmethod
    def _constant(self, number: sp.Expr) -> N:
        """Element of a rational or decimal number."""

    def _symbol(self, symbol: sp.Symbol) -> N:
        """Element of a symbol without value or definition; by default an error."""
        raise KeyError(symbol)

    def _sum(self, formula: sp.Add) -> N:
        """Element of a sum, by + of the elements."""
        return reduce(operator.add, map(self._visit, formula.args))

    def _product(self, formula: sp.Mul) -> N:
        """Element of a product, by * of the elements."""
        return reduce(operator.mul, map(self._visit, formula.args))

    @abstractmethod
    def _power(self, formula: sp.Pow) -> N:
        """Element of a power."""

    @abstractmethod
    def _function(self, formula: sp.Expr) -> N:
        """Element of any other formula, such as sin x or π."""


def numerator_and_denominator(product: sp.Mul) -> tuple[list[sp.Expr], list[sp.Expr]]:
    """Factors of the numerator and of the denominator of a product."""
    divided = [
        bool(factor.is_Pow and factor.exp.is_number and factor.exp.is_negative)
        for factor in product.args
    ]
    factors = list(zip(product.args, divided, strict=True))
    return [f for f, below in factors if not below], [1 / f for f, below in factors if below]


def with_absolute_values(formula: sp.Max | sp.Min) -> sp.Expr:
    """Maximum or minimum through absolute values: max(a, b) = (a + b + |a - b|)/2."""
    sign = 1 if isinstance(formula, sp.Max) else -1
    arguments = sorted(formula.args, key=sp.default_sort_key)
    return reduce(lambda a, b: (a + b + sign * sp.Abs(a - b)) / 2, arguments)
