"""Roots and powers that are not split: what is proved with them needs no sign of a factor.

With u = c ∏ f^e a root r = u^(1/q) is ∏ f^(e // q) times a quantity whose q-th power is
c ∏ f^(e mod q).  Whatever the signs of the factors f are, such a quantity exists; for an even q
its own sign is not said.  A computation that comes to zero with these quantities as symbols, one
for each radicand, therefore holds for all signs.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sp
from flint import fmpq

from .function_field import FunctionField
from .quotient_ring import Element
from .root_field import FINENESS, power_of_zero


class FormalRoots(FunctionField):
    """Fractions in which every radicand has one root, known by its power alone."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self._formal: list[tuple[Element, tuple[sp.Expr, int], Element]] = []

    def power(
        self,
        element: Element,
        exponents: Iterable[tuple[sp.Expr, sp.Rational]],
        value: Element | None,
    ) -> Element:
        """The product of powers, without splitting the base."""
        exponents = tuple(exponents)
        if self.vanishes(element):
            raise power_of_zero(exponents)
        result = self.one
        for theta, number in exponents:
            exponent = sp.Rational(number) * (1 if theta == 1 else FINENESS)
            known = self._root_or_power(element, theta, 1 if theta != 1 else int(exponent.q))
            if theta != 1 and exponent.q != 1:
                return super().power(element, exponents, value)
            result = result * known ** int(exponent.p)
        return result

    def logarithm(self, element: Element) -> Element:
        """The logarithm of an element as a whole."""
        if self.vanishes(element):
            raise ZeroDivisionError
        return self.function_value("log", [element])

    def _root_or_power(self, element: Element, theta: sp.Expr, degree: int) -> Element:
        """The root of a degree, or the power θ/FINENESS where θ is no number."""
        if theta == 1 and degree == 1:
            return element
        for known, key, value in self._formal:
            if key == (theta, degree) and self.vanishes(known - element):
                return value
        value = self._new_root(element, degree) if theta == 1 else self._new_power(element, theta)
        self._formal.append((element, (theta, degree), value))
        return value

    def _new_power(self, element: Element, theta: sp.Expr) -> Element:
        key = ("formal power", len(self._formal))
        words = f"({element.poly})^({theta}/{FINENESS})"
        return Element(self, self._new(key, words, lambda: 1.0, positive=True), {})

    def _new_root(self, element: Element, degree: int) -> Element:
        content, parts = self.factorisation(self.reduce(element.poly))
        powers = dict(element.powers)
        for number, power in parts:
            powers[number] = powers.get(number, 0) + power
        left = tuple((n, p % degree) for n, p in powers.items() if p % degree)
        whole = {n: p // degree for n, p in powers.items() if p // degree}
        inner = self.ring.constant(content)
        for number, power in left:
            inner = inner * self.factors[number] ** power
        # of an even degree what is taken out may be the negative of the root
        even = degree % 2 == 0 and any(
            p % 2 and self.signs.of(self.factors[n]) <= 0 for n, p in whole.items()
        )
        if inner.is_constant() and content > 0 and not even:
            rational = super().power(
                Element(self, inner, {}), ((sp.S.One, sp.Rational(1, degree)),), None
            )
            return self.multiply(rational, Element(self, self.ring.constant(fmpq(1)), whole))
        symbol = self._new(
            ("formal root", len(self._formal)), f"({inner})^(1/{degree})", lambda: 1.0
        )
        self.impose(str(symbol), symbol**degree - inner)
        self._root_of[self.factor_number(symbol)] = (content, left, degree)
        return Element(self, symbol, whole)
