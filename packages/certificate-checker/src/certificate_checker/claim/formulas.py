"""Formulas as trees.

A formula is a number, a name, a sum, a product, a power, a call of a known function, ``Rate(f)``,
or a value of an unspecified function or of one of its partial derivatives.  Numbers are exact:
``0.1`` is one tenth.  Equal formulas are the same object, so they are compared by identity.
"""

from __future__ import annotations

import weakref
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import Any

#: Known functions and their number of arguments.
FUNCTIONS = {
    **dict.fromkeys(
        ("sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh", "exp", "log"), 1
    ),
    **dict.fromkeys(("asin", "acos", "atan", "sqrt", "Abs", "sign", "Rate"), 1),
    "atan2": 2,
}

#: Names of numbers.  The number e is ``exp(1)``, so E may be a name.
CONSTANTS = ("pi",)


class Formula:
    """Node of a tree: its kind, its name or value, and its operands."""

    __slots__ = ("__weakref__", "kind", "parts", "word")

    def __init__(self, kind: str, word: Any, parts: tuple[Formula, ...]) -> None:
        self.kind, self.word, self.parts = kind, word, parts

    def __repr__(self) -> str:
        return f"{self.kind}({self.word}, {', '.join(map(repr, self.parts))})"


_ALL: weakref.WeakValueDictionary[object, Formula] = weakref.WeakValueDictionary()


def _node(kind: str, word: Any, parts: Iterable[Formula] = ()) -> Formula:
    parts = tuple(parts)
    # The dictionary holds weak references, so formulas that are no longer used are freed.
    key = (kind, word, parts)
    formula = _ALL.get(key)
    if formula is None:
        formula = Formula(kind, word, parts)
        _ALL[key] = formula
    return formula


def number(value: Fraction | int) -> Formula:
    """Rational number as a formula."""
    return _node("number", Fraction(value))


def name(word: str) -> Formula:
    """Symbol as a formula."""
    return _node("name", word)


def total(parts: Iterable[Formula]) -> Formula:
    """Sum of formulas."""
    parts = tuple(parts)
    return parts[0] if len(parts) == 1 else _node("sum", None, parts)


def product(parts: Iterable[Formula]) -> Formula:
    """Product of formulas."""
    parts = tuple(parts)
    return parts[0] if len(parts) == 1 else _node("product", None, parts)


def power(base: Formula, exponent: Formula) -> Formula:
    """Power of a formula."""
    return _node("power", None, (base, exponent))


def call(word: str, parts: Iterable[Formula]) -> Formula:
    """Value of a known function."""
    return _node("call", word, parts)


def function(word: str, orders: Iterable[int], arguments: Iterable[Formula]) -> Formula:
    """Value of a derivative of an unspecified function, with the order in each argument."""
    return _node("function", (word, tuple(orders)), arguments)


def walk(formulas: Iterable[Formula]) -> Iterator[Formula]:
    """Every node of some formulas, once."""
    waiting, seen = list(formulas), set()
    while waiting:
        node = waiting.pop()
        if node not in seen:
            seen.add(node)
            waiting.extend(node.parts)
            yield node


def names_in(formulas: Iterable[Formula]) -> set[str]:
    """Names of all symbols."""
    return {node.word for node in walk(formulas) if node.kind == "name"}


def substitution(formula: Formula, table: Mapping[str, Formula]) -> Formula:
    """Formula with symbols replaced."""
    if formula.kind == "name":
        return table.get(formula.word, formula)
    if not formula.parts:
        return formula
    return _node(formula.kind, formula.word, [substitution(part, table) for part in formula.parts])
