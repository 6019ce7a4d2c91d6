"""Fields of numbers in which laws are tried at a point: exact rationals, and balls.

Both offer what :class:`chaplygin.proof.fields.function_field.FunctionField` offers, so that one
evaluation of a law serves its proof and its refutation.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from contextlib import AbstractContextManager
from typing import Any

import sympy as sp
from flint import arb, ctx, fmpq

from .errors import NotExactError

__all__ = ["Balls", "Rationals", "ball_precision", "exact_root"]

#: Digits (binary) carried by balls.
PRECISION = 320


def ball_precision() -> AbstractContextManager[None]:
    """The precision with which balls are computed, as a context."""
    made: AbstractContextManager[None] = ctx.workprec(PRECISION)
    return made


def _invented(seed: str) -> fmpq:
    """A rational number that depends on its seed alone: the value of an unspecified function."""
    generator = random.Random(seed)
    return fmpq(generator.choice((-1, 1)) * generator.randint(20, 60), generator.randint(20, 60))


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

    def pi(self) -> Any:
        """The number π."""
        raise NotExactError

    def known(self, name: str, arguments: Sequence[Any]) -> Any:
        """A value of a function such as the logarithm, which is not rational."""
        raise NotExactError

    def unspecified(self, function: str, orders: Sequence[int], arguments: Sequence[Any]) -> Any:
        """A value of an unspecified function, or of one of its partial derivatives."""
        return _invented(f"{function}{tuple(orders)}{arguments}")

    def same(self, first: Sequence[Any], second: Sequence[Any]) -> bool:
        """Whether a function has one value at two places."""
        return list(first) == list(second)


class Balls:
    """Real balls (midpoint and radius); what holds for them holds for every number inside.

    To be used inside :func:`precise`.
    """

    exact = False

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.values = {name: arb(value) for name, value in values.items()}
        self.one, self.zero = arb(1), arb(0)
        self._seen: list[tuple[tuple[str, tuple[int, ...]], tuple[Any, ...], Any]] = []

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

    def pi(self) -> Any:
        """The number π."""
        return arb.pi()

    def known(self, name: str, arguments: Sequence[Any]) -> Any:
        """A value of a function such as the logarithm; ZeroDivisionError where it has none."""
        first, *rest = arguments
        value = getattr(arb, name)(first, *rest)
        if not value.is_finite():
            raise ZeroDivisionError
        return value

    def unspecified(self, function: str, orders: Sequence[int], arguments: Sequence[Any]) -> Any:
        """A value of an unspecified function, or of one of its partial derivatives."""
        key = (function, tuple(orders))
        for other, places, value in self._seen:
            if other == key and self.same(places, arguments):
                return value
        made = _invented(f"{key}{[a.str(12, radius=False) for a in arguments]}")
        self._seen.append((key, tuple(arguments), arb(made.p) / arb(made.q)))
        return self._seen[-1][2]

    def same(self, first: Sequence[Any], second: Sequence[Any]) -> bool:
        """Whether a function may be given one value at two places.

        Places whose balls overlap are the same, or a function can have one value at both.
        """
        return all(a.overlaps(b) for a, b in zip(first, second, strict=True))
