"""Formal roots: proofs that use no sign of a factor under a root.

With u = c ∏ f^e, a root r = u^(1/q) is ∏ f^(e // q) times a quantity whose q-th power is c ∏ f^(e
mod q). Such a quantity exists whatever the signs of the factors f are; for even q its own sign is
left open. A residual that reduces to zero with these quantities as symbols, one for each radicand,
therefore vanishes for all signs.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sp
from flint import fmpq

from .function_field import FunctionField
from .quotient_ring import Element
from .root_field import power_of_zero


class FormalRoots(FunctionField):
    """Fractions in which each radicand has one root, known only by its power."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self._formal: list[tuple[Element, int, Element]] = []

    def power(
        self,
        element: Element,
        exponents: Iterable[tuple[sp.Expr, sp.Rational]],
        value: Element | None,
    ) -> Element:
        """The product of powers; the base is not factored if all exponents are numbers."""
        exponents = tuple(exponents)
        if self.vanishes(element):
            raise power_of_zero(exponents)
        if any(theta != 1 for theta, _ in exponents):
            return super().power(element, exponents, value)
        exponent = sum((sp.Rational(number) for _, number in exponents), sp.S.Zero)
        return self._formal_root(element, int(exponent.q)) ** int(exponent.p)

    def logarithm(self, element: Element) -> Element:
        """The logarithm of an element, without splitting it into factors."""
        if self.vanishes(element):
            raise ZeroDivisionError
        return self.function_value("log", [element])

    def _formal_root(self, element: Element, degree: int) -> Element:
        if degree == 1:
            return element
        for known, known_degree, value in self._formal:
            if known_degree == degree and self.vanishes(known - element):
                return value
        value = self._new_root(element, degree)
        self._formal.append((element, degree, value))
        return value

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
        # For even q, ∏ f^(e // q) may be the negative of the root; then a symbol of its own is
        # needed.
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
