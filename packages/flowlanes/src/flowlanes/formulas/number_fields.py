"""Number fields in which laws are tested at a point: exact rationals, and balls.

Both have the operations of a field of rational functions, so the same evaluation of a law is used
for its proof and its refutation.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from contextlib import AbstractContextManager
from types import MappingProxyType
from typing import Any, NoReturn, TypeAlias

import sympy as sp
from flint import arb, ctx, fmpq

from .errors import NotExactError

#: Element of the field in use; no static type covers the arithmetic of all fields.
Element: TypeAlias = Any

#: Largest numerator or denominator of the exponent of a rational number.
LARGEST_EXPONENT = 10_000

#: Precision of balls in bits.
PRECISION = 320


def ball_precision() -> AbstractContextManager[None]:
    """Context with the precision of balls."""
    context: AbstractContextManager[None] = ctx.workprec(PRECISION)
    return context


def _arbitrary_number(seed: str) -> fmpq:
    """Rational number determined by its seed: the value of an unspecified function."""
    generator = random.Random(seed)
    return fmpq(generator.choice((-1, 1)) * generator.randint(20, 60), generator.randint(20, 60))


def exact_root(value: fmpq, degree: int) -> fmpq:
    """Exact root of a rational number; NotExactError if it is irrational.

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
    """Rational numbers; irrational values raise NotExactError."""

    exact = True
    one, zero = fmpq(1), fmpq(0)
    #: Number of parts into which angles are divided; at a point a division has no advantage.
    angle_parts: Mapping[sp.Expr, int] = MappingProxyType({})

    def __init__(self, values: Mapping[str, Element]) -> None:
        self.values: dict[str, fmpq] = dict(values)

    def rational(self, value: sp.Rational) -> fmpq:
        """Rational number as an element."""
        number = sp.Rational(value)
        return fmpq(int(number.p), int(number.q))

    def generator(self, name: str) -> fmpq:
        """Value of a symbol at the point."""
        return self.values[name]

    def vanishes(self, element: Element) -> bool:
        """True if a number is zero."""
        return bool(element == 0)

    def root(self, element: fmpq, degree: int) -> fmpq:
        """Positive root."""
        if degree > 1 and element <= 0:
            raise ZeroDivisionError
        return exact_root(element, degree)

    def power(
        self, element: fmpq, exponents: Iterable[tuple[sp.Expr, sp.Rational]], value: fmpq
    ) -> NoReturn:
        """Power with a symbolic exponent."""
        raise NotExactError

    def as_rational(self, element: fmpq) -> fmpq:
        """The number itself; NotExactError if it is too large for an exponent."""
        if max(abs(element.p), element.q) > LARGEST_EXPONENT:
            raise NotExactError
        return element

    def circle(self, angle: fmpq) -> NoReturn:
        """Sine and cosine."""
        raise NotExactError

    def exponential(self, element: fmpq) -> NoReturn:
        """The exponential."""
        raise NotExactError

    def logarithm(self, element: fmpq) -> NoReturn:
        """The logarithm."""
        raise NotExactError

    def pi(self) -> NoReturn:
        """The number π."""
        raise NotExactError

    def function_value(self, name: str, arguments: Sequence[fmpq]) -> NoReturn:
        """A value of a function such as the logarithm, which is irrational."""
        raise NotExactError

    def unspecified_value(
        self, function: str, orders: Sequence[int], arguments: Sequence[fmpq]
    ) -> fmpq:
        """Value of an unspecified function, or of one of its partial derivatives."""
        return _arbitrary_number(f"{function}{tuple(orders)}{arguments}")

    def same(self, first: Sequence[fmpq], second: Sequence[fmpq]) -> bool:
        """True if the arguments of a function coincide at two points."""
        return list(first) == list(second)


class Balls:
    """Real balls (midpoint and radius); a statement about a ball is valid for every number in it.

    They are used inside :func:`ball_precision`.
    """

    exact = False
    angle_parts: Mapping[sp.Expr, int] = MappingProxyType({})

    def __init__(self, values: Mapping[str, Element]) -> None:
        self.values = {name: arb(value) for name, value in values.items()}
        self.one, self.zero = arb(1), arb(0)
        self._values: list[tuple[tuple[str, tuple[int, ...]], tuple[arb, ...], arb]] = []

    def rational(self, value: sp.Rational) -> arb:
        """A rational number."""
        number = sp.Rational(value)
        return arb(int(number.p)) / arb(int(number.q))

    def generator(self, name: str) -> arb:
        """Value of a symbol at the point."""
        return self.values[name]

    def vanishes(self, element: Element) -> bool:
        """True if a ball contains zero, so that it refutes nothing."""
        return 0 in element

    def root(self, element: arb, degree: int) -> arb:
        """Positive root."""
        if degree == 1:
            return element
        if not element > 0:
            raise ZeroDivisionError
        return element.root(degree)

    def power(
        self, element: arb, exponents: Iterable[tuple[sp.Expr, sp.Rational]], value: arb
    ) -> arb:
        """Power whose exponent has the given value."""
        if not element > 0:
            raise ZeroDivisionError
        return element**value

    def as_rational(self, element: arb) -> None:
        """None, because a ball may contain several rational numbers."""
        return None

    def circle(self, angle: arb) -> tuple[arb, arb]:
        """Sine and cosine."""
        return angle.sin(), angle.cos()

    def exponential(self, element: arb) -> arb:
        """The exponential."""
        return element.exp()

    def logarithm(self, element: arb) -> arb:
        """Logarithm; ZeroDivisionError if it is undefined."""
        return self.function_value("log", [element])

    def pi(self) -> arb:
        """The number π."""
        return arb.pi()

    def function_value(self, name: str, arguments: Sequence[arb]) -> arb:
        """Value of a function such as the arctangent; ZeroDivisionError if it is undefined."""
        value: arb = getattr(arb, name)(*arguments)
        if not value.is_finite():
            raise ZeroDivisionError
        return value

    def unspecified_value(
        self, function: str, orders: Sequence[int], arguments: Sequence[arb]
    ) -> arb:
        """Value of an unspecified function, or of one of its partial derivatives."""
        key = (function, tuple(orders))
        for other, points, value in self._values:
            if other == key and self.same(points, arguments):
                return value
        number = _arbitrary_number(f"{key}{[a.str(12, radius=False) for a in arguments]}")
        self._values.append((key, tuple(arguments), arb(number.p) / arb(number.q)))
        return self._values[-1][2]

    def same(self, first: Sequence[arb], second: Sequence[arb]) -> bool:
        """True if the arguments of a function may coincide at two points.

        If the balls of the arguments overlap, they may coincide; otherwise the values are
        independent.
        """
        return all(a.overlaps(b) for a, b in zip(first, second, strict=True))
