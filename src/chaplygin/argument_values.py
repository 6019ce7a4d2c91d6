"""Predicates on argument values: whether they are numbers, sequences, arrays or formulas."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from types import NoneType
from typing import Any

TEXT = (str, bytes)


def is_number(value: Any) -> bool:
    """Whether it is one real number that a float can hold."""
    if isinstance(value, (bool, *TEXT)) or is_array(value) or class_name(value) == "bool":
        return False
    return converts_to_float(value)


def is_number_or_text(value: Any) -> bool:
    """Whether it is a number, or a string that reads as one."""
    return converts_to_float(value) if isinstance(value, str) else is_number(value)


def is_array(value: Any) -> bool:
    """Whether it is an array with at least one axis."""
    return getattr(value, "ndim", 0) != 0


def converts_to_float(value: Any) -> bool:
    """Whether `float` accepts it."""
    try:
        float(value)
    except (TypeError, ValueError, OverflowError):
        return False
    return True


def class_name(value: object) -> str:
    """The name of its class."""
    return type(value).__name__


def is_integer(value: Any) -> bool:
    """Whether it is one integer."""
    return not isinstance(value, bool) and hasattr(value, "__index__") and is_number(value)


def is_collection(value: Any) -> bool:
    """Whether it is an iterable of values, neither a string nor a mapping."""
    if isinstance(value, (type, Mapping, *TEXT)):
        return False
    return hasattr(value, "__len__") if hasattr(value, "shape") else isinstance(value, Iterable)


def are_numbers(value: Any) -> bool:
    """Whether these are numbers in order."""
    if not is_collection(value) or getattr(value, "ndim", 1) != 1:
        return False
    kind = getattr(getattr(value, "dtype", None), "kind", "O")
    # an iterator is read once, by the function itself
    return kind in "iuf" or (
        kind == "O" and (iter(value) is value or all(map(is_number_or_text, value)))
    )


def is_numeric_array(value: Any) -> bool:
    """Whether it is an array that can hold numbers."""
    return getattr(getattr(value, "dtype", None), "kind", "") in ("i", "u", "f", "O")


def is_array_like(value: Any) -> bool:
    """Whether these are numbers, alone, in order, or in rows of equal lengths."""
    if is_number_or_text(value) or is_numeric_array(value):
        return True
    if not isinstance(value, list | tuple) or not all(map(is_array_like, value)):
        return False
    return len({getattr(row, "shape", ()) or length(row) for row in value}) <= 1


def length(value: Any) -> int:
    """The number of its entries; −1 if it has none."""
    return len(value) if hasattr(value, "__len__") else -1


def is_row(value: Any) -> bool:
    """Whether it is a number, or numbers in order."""
    return is_number(value) or are_numbers(value)


def is_start(value: Any) -> bool:
    """Whether it is a state: numbers in order, or by name."""
    if isinstance(value, Mapping):
        return all(
            is_number_or_text(v) or are_numbers(v) or (k == "attitude" and are_rows(v))
            for k, v in value.items()
        )
    return are_numbers(value)


def are_rows(value: Any) -> bool:
    """Whether these are numbers in rows."""
    return is_collection(value) and all(map(are_numbers, value))


def are_parameters(value: Any) -> bool:
    """Whether it maps names to numbers, or to one number for each motion."""
    if value is None:
        return True
    return isinstance(value, Mapping) and all(
        is_number_or_text(v) or are_numbers(v) for v in value.values()
    )


def is_formula(value: Any) -> bool:
    """Whether it is an expression, a matrix of these, or a number."""
    if "sympy" in sys.modules:
        import sympy as sp

        if isinstance(value, (sp.Basic, sp.MatrixBase)):
            return True
    return is_number(value)


def are_formulas(value: Any) -> bool:
    """Whether it is a formula, or formulas in nested rows of equal lengths."""
    if isinstance(value, list | tuple):
        lengths = {length(row) for row in value if isinstance(row, list | tuple)}
        return len(lengths) <= 1 and all(map(are_formulas, value))
    return is_formula(value)


def are_named_formulas(value: Any) -> bool:
    """Whether it pairs names with formulas, none of them a string."""
    pairs = pairs_of(value)
    return pairs is not None and not any(
        isinstance(part, (*TEXT, NoneType)) for pair in pairs for part in pair
    )


def pairs_of(value: Any) -> list[tuple[Any, Any]] | None:
    """A mapping or a sequence of pairs as such a sequence; None if it is neither."""
    pairs = list(value.items()) if isinstance(value, Mapping) else value
    if not isinstance(pairs, list | tuple):
        return None
    return list(pairs) if all(isinstance(p, list | tuple) and len(p) == 2 for p in pairs) else None
