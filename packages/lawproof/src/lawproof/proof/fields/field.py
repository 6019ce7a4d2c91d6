"""The operations of a field: function fields, rational numbers and balls."""

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
        """Whether what does not vanish is certain not to."""

    @property
    def zero(self) -> FieldElement:
        """The number 0."""

    @property
    def one(self) -> FieldElement:
        """The number 1."""

    def generator(self, name: str) -> FieldElement:
        """A generator, or its value at a point."""

    def vanishes(self, element: Any) -> bool:
        """Whether an element is zero; of a ball, whether it may be."""


E = TypeVar("E", bound=FieldElement)


def dot(zero: E, first: Sequence[E], second: Sequence[E]) -> E:
    """The sum of products of elements, beginning with the zero of their field."""
    total = zero
    for a, b in zip(first, second, strict=True):
        total = total + a * b
    return total
