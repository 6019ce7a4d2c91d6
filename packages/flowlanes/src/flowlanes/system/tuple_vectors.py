"""Products of vectors given as sequences of numbers, balls, polynomials or program terms.

Sums run from the first component to the last, so that floating-point results have the same bits
everywhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from operator import add, mul
from typing import Any, Protocol, TypeVar


class Ring(Protocol):
    """Numbers with addition, subtraction and multiplication."""

    def __add__(self, other: Any, /) -> Any:
        """The sum."""

    def __sub__(self, other: Any, /) -> Any:
        """The difference."""

    def __mul__(self, other: Any, /) -> Any:
        """The product."""


R = TypeVar("R", bound=Ring)


def dot(u: Sequence[R], v: Sequence[R]) -> R:
    """The scalar product Σ u_i v_i of two vectors with at least one component."""
    if len(u) != len(v):
        raise ValueError(f"vectors of {len(u)} and {len(v)} components have no scalar product")
    total: R = reduce(add, map(mul, u, v))
    return total


def cross(u: Sequence[R], v: Sequence[R]) -> list[R]:
    """The vector product of two vectors with three components."""
    return [u[i] * v[j] - u[j] * v[i] for i, j in ((1, 2), (2, 0), (0, 1))]
