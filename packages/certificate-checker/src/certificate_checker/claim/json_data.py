"""Typed access to the data of a certificate."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TypeVar

from .errors import CheckError

T = TypeVar("T", str, int)

_RATIONAL = re.compile(r"-?\d{1,40000}(/\d{1,40000})?")


def mapping(data: object, what: str) -> Mapping[str, object]:
    """Data that must be a mapping with names as keys."""
    if not isinstance(data, Mapping) or not all(isinstance(key, str) for key in data):
        raise CheckError(f"{what} is not a mapping")
    return data


def only(data: Mapping[str, object], what: str, *choices: str) -> None:
    """Check that a mapping has no other fields."""
    strange = sorted(set(data) - set(choices))
    if strange:
        raise CheckError(f"{what} has a field {strange[0]!r}, which is not allowed here")


def field(data: Mapping[str, object], key: str, what: str) -> object:
    """Value of a required field of a mapping."""
    if key not in data:
        raise CheckError(f"{what} lacks the field {key!r}")
    return data[key]


def as_list(data: object, what: str) -> Sequence[object]:
    """Data that must be a list."""
    if not isinstance(data, (list, tuple)):
        raise CheckError(f"{what} is not a list")
    return data


def items(data: object, size: int, what: str) -> Sequence[object]:
    """Data that must be a list of given length."""
    parts = as_list(data, what)
    if len(parts) != size:
        raise CheckError(f"{what} has {len(parts)} parts instead of {size}")
    return parts


def text(data: object, what: str) -> str:
    """Data that must be a text."""
    if not isinstance(data, str):
        raise CheckError(f"{what} is not a text")
    return data


def integer(data: object, what: str, lowest: int, highest: int) -> int:
    """Data that must be an integer within bounds."""
    if isinstance(data, bool) or not isinstance(data, int) or not lowest <= data <= highest:
        raise CheckError(f"{what} is not an integer from {lowest} to {highest}")
    return data


def rational(data: object, what: str) -> Fraction:
    """Rational number from text such as ``-3/4``, or from an integer."""
    if isinstance(data, int) and not isinstance(data, bool):
        return Fraction(data)
    if not isinstance(data, str) or _RATIONAL.fullmatch(data) is None:
        raise CheckError(f"{what} is not a rational number")
    above, _, below = data.partition("/")
    bottom = _long_integer(below or "1")
    if bottom == 0:
        raise CheckError(f"{what} divides by zero")
    return Fraction(_long_integer(above), bottom)


def _long_integer(digits: str) -> int:
    """Integer from any number of digits; int() limits their number."""
    if len(digits) < 4000:
        return int(digits)
    middle = len(digits) // 2
    head, tail = digits[:-middle], digits[-middle:]
    sign = -1 if head.startswith("-") else 1
    return _long_integer(head) * int(10**middle) + sign * _long_integer(tail)


def choice(data: object, what: str, *choices: T) -> T:
    """Data that must be one of several choices."""
    if isinstance(data, bool) or not isinstance(data, (str, int)) or data not in choices:
        raise CheckError(f"{what} is not one of {', '.join(map(str, choices))}")
    return next(value for value in choices if value == data)
