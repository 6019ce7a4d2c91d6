"""Fields for the residuals of a certificate, without reduction by the level.

The checker compares the residuals of a certificate with the law at points off the level.
Numerators are therefore not reduced; only the relations of roots and circles are used, which hold
everywhere.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

import sympy as sp

from .formal_roots import FormalRoots
from .function_field import FunctionField
from .quotient_ring import Element, Poly
from .root_field import Key

T = TypeVar("T")


@dataclass(frozen=True)
class Meaning:
    """The meaning of an auxiliary symbol.

    Attributes
    ----------
    kind : str
        ``"root"``, ``"formal root"``, ``"power"``, ``"sin"``, ``"cos"``, ``"pi"``, ``"known"`` or
        ``"function"``.
    of : tuple of Element
        The radicand, base or arguments.
    name : str
        Name of the function.
    number : int
        Degree of a root.
    orders : tuple of int
        Order of the derivative of an unspecified function in each argument.
    exponent : sympy.Expr, optional
        Exponent of a symbolic power; the generator is the base to a quarter of it.
    whole : tuple of (polynomial, int)
        Factors taken out of a formal root.
    """

    kind: str
    of: tuple[Element, ...] = ()
    name: str = ""
    number: int = 0
    orders: tuple[int, ...] = ()
    exponent: sp.Expr | None = None
    whole: tuple[tuple[Poly, int], ...] = ()

    def agrees(self, other: Meaning) -> bool:
        """True if it is the same function, regardless of the arguments."""
        mine = (self.kind, self.name, self.number, self.orders, self.exponent, len(self.of))
        theirs = (other.kind, other.name, other.number, other.orders, other.exponent)
        return mine == (*theirs, len(other.of))


class UnreducedField(FunctionField):
    """Fractions modulo the relations of roots and circles, with the meaning of each symbol."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        #: Meaning of each auxiliary symbol, in order of creation.
        self.record: dict[str, Meaning] = {}
        self._pending: list[Meaning] = []

    def _with_meaning(self, meaning: Meaning, task: Callable[[], T]) -> T:
        self._pending.append(meaning)
        try:
            return task()
        finally:
            self._pending.pop()

    def _new(
        self, key: Key, meaning: str, value: Callable[[], float], positive: bool = False
    ) -> Poly:
        fresh = key not in self._auxiliary
        symbol = super()._new(key, meaning, value, positive)
        if fresh:
            self.record[str(symbol)] = self._meaning_of(key)
        return symbol

    def _meaning_of(self, key: Key) -> Meaning:
        kind = key[0]
        pending = self._pending[-1] if self._pending else Meaning("")
        if kind == "pi":
            return Meaning("pi")
        if kind in ("sin", "cos"):
            return Meaning(kind, pending.of)
        if kind == "root":
            return Meaning("root", (pending.of[0],), number=key[2])
        if kind == "power":
            return Meaning("power", (pending.of[0],), exponent=key[2])
        return pending

    def circle(self, angle: Element) -> tuple[Element, Element]:
        """Sine and cosine of an angle."""
        return self._with_meaning(
            Meaning("", (angle,)), lambda: super(UnreducedField, self).circle(angle)
        )

    def function_value(self, name: str, arguments: Sequence[Element]) -> Element:
        """A value of a known function of which only derivatives are used."""
        return self._with_meaning(
            Meaning("known", tuple(arguments), name),
            lambda: super(UnreducedField, self).function_value(name, arguments),
        )

    def unspecified_value(
        self, function: str, orders: Sequence[int], arguments: Sequence[Element]
    ) -> Element:
        """A value of an unspecified function."""
        meaning = Meaning("function", tuple(arguments), function, orders=tuple(orders))
        return self._with_meaning(
            meaning,
            lambda: super(UnreducedField, self).unspecified_value(function, orders, arguments),
        )

    def _root(self, base: Poly, degree: int) -> Element:
        return self._with_meaning(
            Meaning("", (Element(self, base, {}),)),
            lambda: super(UnreducedField, self)._root(base, degree),
        )

    def _one_power(self, base: Poly, theta: sp.Expr, exponent: sp.Rational) -> Element:
        return self._with_meaning(
            Meaning("", (Element(self, base, {}),)),
            lambda: super(UnreducedField, self)._one_power(base, theta, exponent),
        )


class UnreducedFormal(UnreducedField, FormalRoots):
    """An unreduced field with formal roots."""

    def _new_root(self, element: Element, degree: int) -> Element:
        content, parts = self.factorisation(self.reduce(element.poly))
        powers = dict(element.powers)
        for number, power in parts:
            powers[number] = powers.get(number, 0) + power
        inner = self.ring.constant(content)
        for number, power in powers.items():
            inner = inner * self.factors[number] ** (power % degree)
        whole = tuple((self.factors[n], p // degree) for n, p in powers.items() if p // degree)
        meaning = Meaning("formal root", (Element(self, inner, {}),), number=degree, whole=whole)
        return self._with_meaning(
            meaning, lambda: super(UnreducedFormal, self)._new_root(element, degree)
        )

    def _meaning_of(self, key: Key) -> Meaning:
        if key[0] == "formal root":
            return next(m for m in reversed(self._pending) if m.kind == "formal root")
        return super()._meaning_of(key)
