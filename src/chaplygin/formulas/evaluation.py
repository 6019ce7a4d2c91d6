"""The evaluation of formulas in an algebra: numbers, terms, power series or anything like them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from typing import Generic, TypeVar

import sympy as sp

N = TypeVar("N")


class Evaluation(ABC, Generic[N]):
    """Scalar formulas as elements of an algebra, every part of them computed once.

    An algebra is a subclass: it says what constants, sums, products, powers and functions are.

    Parameters
    ----------
    values : mapping of Symbol to element
        Of the symbols that formulas may contain.
    definitions : mapping of Symbol to formula, optional
        Further symbols, each evaluated when a formula first needs it.
    """

    def __init__(
        self,
        values: Mapping[sp.Symbol, N],
        definitions: Mapping[sp.Symbol, sp.Expr] | None = None,
    ) -> None:
        self._elements: dict[sp.Expr, N] = dict(values)
        self._definitions = dict(definitions or {})

    def __call__(self, formula: sp.Expr) -> N:
        """The element that a scalar formula stands for."""
        element = self._elements.get(formula)
        if element is None:
            element = self._elements[formula] = self._element(formula)
        return element

    def define(self, steps: Iterable[tuple[sp.Symbol, sp.Expr]]) -> None:
        """Give further symbols the values of formulas, in order: long chains need no recursion."""
        for symbol, formula in steps:
            self._elements[symbol] = self(formula)

    def _element(self, formula: sp.Expr) -> N:
        if formula in self._definitions:
            return self(self._definitions[formula])
        if formula.is_Rational or formula.is_Float:
            return self._constant(formula)
        if formula.is_Symbol:
            return self._unknown(formula)
        if formula.is_Add:
            return self._sum([self(term) for term in formula.args])
        if formula.is_Mul:
            return self._product([self(factor) for factor in formula.args])
        if formula.is_Pow:
            return self._power(formula)
        return self._function(formula)

    @abstractmethod
    def _constant(self, number: sp.Expr) -> N:
        """A rational or decimal number."""

    def _unknown(self, symbol: sp.Symbol) -> N:
        """Complain of a symbol that has neither a value nor a definition."""
        raise KeyError(symbol)

    @abstractmethod
    def _sum(self, terms: Sequence[N]) -> N:
        """The sum of at least two elements."""

    @abstractmethod
    def _product(self, factors: Sequence[N]) -> N:
        """The product of at least two elements."""

    @abstractmethod
    def _power(self, formula: sp.Expr) -> N:
        """The value of a power."""

    @abstractmethod
    def _function(self, formula: sp.Expr) -> N:
        """The value of any other formula, such as sin x or π."""
