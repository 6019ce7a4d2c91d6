"""Protocols for fields: function fields, rational numbers and balls."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol, Self, TypeVar


class FieldElement(Protocol):
    """An element of a field: a fraction, a rational number or a ball."""

    def __add__(self, other: Self, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self, /) -> Self: ...
    def __truediv__(self, other: Self, /) -> Self: ...
    def __neg__(self) -> Self: ...


class Field(Protocol):
    """A field in which formulas are evaluated."""

    @property
    def exact(self) -> bool:
        """True if a non-zero result is certain to be non-zero."""

    @property
    def zero(self) -> FieldElement:
        """The number 0."""

    @property
    def one(self) -> FieldElement:
        """The number 1."""

    def generator(self, name: str) -> FieldElement:
        """A generator, or its value at a point."""

    def vanishes(self, element: Any) -> bool:
        """True if an element is zero; for a ball, if it contains zero."""


E = TypeVar("E", bound=FieldElement)


def dot(zero: E, first: Sequence[E], second: Sequence[E]) -> E:
    """The inner product of two sequences of field elements."""
    total = zero
    for a, b in zip(first, second, strict=True):
        total = total + a * b
    return total
