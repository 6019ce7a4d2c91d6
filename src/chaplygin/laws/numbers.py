"""Fields of numbers in which laws are tried at a point: exact rationals, and balls.

Both offer what :class:`chaplygin.laws.functions.Fractions` offers, so that one evaluation of a law
serves its proof and its refutation.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from contextlib import AbstractContextManager
from typing import Any

import sympy as sp
from flint import arb, ctx, fmpq

from .errors import NotExactError

__all__ = ["Balls", "Rationals", "exact_root", "precise"]

#: Digits (binary) carried by balls.
PRECISION = 320


def precise() -> AbstractContextManager[None]:
    """The precision with which balls are computed, as a context."""
    made: AbstractContextManager[None] = ctx.workprec(PRECISION)
    return made


def _invented(seed: str) -> fmpq:
    """A rational number that depends on its seed alone: the value of an unspecified function."""
    generator = random.Random(seed)
    return fmpq(generator.randint(20, 60), generator.randint(20, 60))


def exact_root(value: fmpq, degree: int) -> fmpq:
    """The exact root of a rational number; NotExactError if it has none.

    Raises
    ------
    NotExactError
        If the root is irrational.
    """
    parts = []
    for part in (value.p, value.q):
        root, exact = sp.integer_nthroot(abs(int(part)), degree)
        if not exact or (part < 0 and degree % 2 == 0):
            raise NotExactError
        parts.append(int(root) * (-1 if part < 0 else 1))
    return fmpq(parts[0], parts[1])


class Rationals:
    """The rational numbers; whatever is not rational raises NotExactError."""

    exact = True
    one, zero = fmpq(1), fmpq(0)

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.values = dict(values)

    def rational(self, value: Any) -> fmpq:
        """A rational number."""
        number = sp.Rational(value)
        return fmpq(int(number.p), int(number.q))

    def generator(self, name: str) -> Any:
        """Value of a symbol at the point."""
        return self.values[name]

    def vanishes(self, element: Any) -> bool:
        """Whether a number is zero."""
        return bool(element == 0)

    def root(self, element: Any, degree: int) -> Any:
        """The positive root."""
        if element == 0 and degree > 1:
            raise ZeroDivisionError
        return exact_root(element, degree)

    def power(self, element: Any, exponents: Iterable[tuple[Any, Any]], value: Any) -> Any:
        """A power with a symbolic exponent."""
        raise NotExactError

    def as_rational(self, element: Any) -> Any:
        """The number itself."""
        return element

    def circle(self, angle: Any) -> Any:
        """Sine and cosine."""
        raise NotExactError

    def exponential(self, element: Any) -> Any:
        """The exponential."""
        raise NotExactError

    def opaque(self, name: str, arguments: Sequence[Any]) -> Any:
        """A value of an unspecified function; of a known one there is none."""
        if name in KNOWN:
            raise NotExactError
        return _invented(f"{name}{arguments}")


KNOWN = {"log", "acos", "asin", "atan", "atan2"}


class Balls:
    """Real balls (midpoint and radius); what holds for them holds for every number inside.

    To be used inside :func:`precise`.
    """

    exact = False

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.values = {name: arb(value) for name, value in values.items()}
        self.one, self.zero = arb(1), arb(0)
        self._seen: list[tuple[str, tuple[Any, ...], Any]] = []

    def rational(self, value: Any) -> Any:
        """A rational number."""
        number = sp.Rational(value)
        return arb(int(number.p)) / arb(int(number.q))

    def generator(self, name: str) -> Any:
        """Value of a symbol at the point."""
        return self.values[name]

    def vanishes(self, element: Any) -> bool:
        """Whether a ball contains zero, so that nothing can be said against it."""
        return 0 in element

    def root(self, element: Any, degree: int) -> Any:
        """The positive root."""
        if degree == 1:
            return element
        if not element > 0:
            raise ZeroDivisionError
        return element.root(degree)

    def power(self, element: Any, exponents: Iterable[tuple[Any, Any]], value: Any) -> Any:
        """A power whose exponent has the given value."""
        if not element > 0:
            raise ZeroDivisionError
        return element**value

    def as_rational(self, element: Any) -> Any:
        """Unknown for a ball."""
        return None

    def circle(self, angle: Any) -> Any:
        """Sine and cosine."""
        return angle.sin(), angle.cos()

    def exponential(self, element: Any) -> Any:
        """The exponential."""
        return element.exp()

    def opaque(self, name: str, arguments: Sequence[Any]) -> Any:
        """A function value: computed for a known function, invented for an unspecified one."""
        if name in KNOWN:
            first, *rest = arguments
            method = getattr(arb, name)
            return method(first, *rest)
        for other, places, known in self._seen:
            if other == name and all(a.overlaps(b) for a, b in zip(places, arguments, strict=True)):
                return known
        made = _invented(f"{name}{[a.str(12, radius=False) for a in arguments]}")
        self._seen.append((name, tuple(arguments), arb(made.p) / arb(made.q)))
        return self._seen[-1][2]
