"""Numbers in a file, alone or in brackets, checked to be finite."""

from __future__ import annotations

import math
from typing import TypeAlias

from flowlanes import parsing
from flowlanes.errors import InputError

from .validation import value_text

#: A number, numbers in brackets, or rows of them.
ParameterValue: TypeAlias = float | tuple[float, ...] | tuple[tuple[float, ...], ...]


def given_numbers(value: object, expectation: str) -> float | tuple[float, ...]:
    """A number, or numbers in brackets.

    Parameters
    ----------
    value : object
        As TOML gives it.
    expectation : str
        What it must be, in words.

    Raises
    ------
    ValueError
        If it is something else; of a formula without names the message tells the decimal.
    """
    listed = value if isinstance(value, list | tuple) else [value]
    numbers = [_finite(x) for x in listed]
    finite = tuple(x for x in numbers if x is not None)
    if not finite or len(finite) < len(listed):
        raise ValueError(f"must be {expectation}, not {value_text(value)}{_decimal(value)}")
    return finite if isinstance(value, list | tuple) else finite[0]


def given_rows(value: object, expectation: str) -> ParameterValue:
    """A number, numbers in brackets, or rows of them.

    Raises
    ------
    ValueError
        If it is something else.
    """
    if isinstance(value, list | tuple) and value and isinstance(value[0], list | tuple):
        rows = tuple(given_numbers(row, expectation) for row in value)
        return tuple(row if isinstance(row, tuple) else (row,) for row in rows)
    return given_numbers(value, expectation)


def _finite(value: object) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    try:
        number = float(value)
    except OverflowError:
        return None
    return number if math.isfinite(number) else None


def _decimal(value: object) -> str:
    """A hint with the decimal value of a formula such as ``pi/2``."""
    if not isinstance(value, str):
        return ""
    try:
        number = float(parsing.parse(value, {}))
    except (InputError, OverflowError):
        return ""
    return f"; write {number!r} (formulas stand in formulas alone)"
