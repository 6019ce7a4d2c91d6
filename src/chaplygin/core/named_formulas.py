"""Formulas by name, as a law holds them: a mapping becomes pairs, a number a formula."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import sympy as sp

__all__ = ["Pairs", "repeated", "scalar_names", "with_formulas"]

Pairs: TypeAlias = tuple[tuple[Any, Any], ...]


def with_formulas(value: Any) -> Any:
    """The value with pairs for mappings, tuples for lists, SymPy's numbers for Python's.

    Examples
    --------
    >>> with_formulas({sp.Symbol("x"): 2})
    ((x, 2),)
    """
    if isinstance(value, Mapping):
        value = tuple(value.items())
    if isinstance(value, tuple | list):
        return tuple(with_formulas(item) for item in value)
    if isinstance(value, int | float) and not isinstance(value, bool):
        return sp.sympify(value)
    return value


def scalar_names(pairs: Pairs) -> list[sp.Symbol]:
    """The names of pairs (named quantity, formula), one for each scalar component."""
    names = ((name,) if isinstance(name, sp.Symbol) else name.symbols for name, _ in pairs)
    return [symbol for symbols in names for symbol in symbols]


def repeated(names: Sequence[sp.Symbol]) -> sp.Symbol | None:
    """A name that occurs more than once, or None."""
    return next((name for i, name in enumerate(names) if name in names[:i]), None)
