"""The field in which laws are proved: fractions with roots, powers and functions.

Sines and cosines come in pairs with s² + c² = 1; every derivative of an unspecified function is a
symbol; for roots and powers see :mod:`.root_field`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp
from flint import fmpq

from .quotient_ring import Element, Poly
from .root_field import LOGARITHM, RootField

#: Ratios of arguments for which one exponential is a power of another.
MULTIPLES = tuple(
    fmpq(sign * above, below)
    for above, below in ((1, 1), (2, 1), (3, 1), (4, 1), (1, 2), (3, 2), (1, 3), (1, 4))
    for sign in (1, -1)
)


class FunctionField(RootField):
    """Fractions in generators, roots, powers and function values, modulo relations."""

    def __init__(self, *arguments: Any, **keywords: Any) -> None:
        super().__init__(*arguments, **keywords)
        #: Number of parts of each angle: sine and cosine of one part are generators.
        self.angle_parts: Mapping[sp.Expr, int] = {}
        self._circles: set[str] = set()
        self._arguments: list[tuple[Element, str]] = []
        self._exponentials: list[tuple[Element, Element]] = []

    def exponential(self, element: Element) -> Element:
        """The exponential, as a power of the exponential of a rational multiple if one is known."""
        if self.vanishes(element):
            return self.one
        for argument, known in self._exponentials:
            for ratio in MULTIPLES:
                if self.vanishes(element - self.rational(ratio) * argument):
                    return self.root(known, int(ratio.q)) ** int(ratio.p)
        value = self.function_value("exp", [element])
        self._exponentials.append((element, value))
        return value

    def logarithm(self, element: Element) -> Element:
        """The logarithm of a positive element, as the sum of the logarithms of its factors.

        log(c ∏ f^n) = log c + Σ n log|f|; log(u^(1/q)) = log(u)/q, and log(exp(a)) = a.
        """
        if self.vanishes(element):
            raise ZeroDivisionError
        content, parts = self._positive_parts(element, ((LOGARITHM, sp.S.One),))
        total = self.zero
        for prime, power in sp.factorrat(sp.Rational(int(content.p), int(content.q))).items():
            if prime != 1:
                parts.append((self.ring.constant(int(prime)), int(power)))
        for base, power in parts:
            total = total + self.rational(power) * self._logarithm_of_factor(base)
        return total

    def _logarithm_of_factor(self, base: Poly) -> Element:
        # log(u^(1/q)) = log(u)/q.
        if str(base) in self._roots:
            inner, degree = self._roots[str(base)]
            return self.rational(sp.Rational(1, degree)) * self._logarithm_of_factor(inner)
        # log(exp(a)) = a.
        for argument, known in self._exponentials:
            if known.poly == base and not known.powers:
                return argument
        return self.function_value("log", [Element(self, base, {})])

    def circle(self, angle: Element) -> tuple[Element, Element]:
        """Sine and cosine."""
        key = self._key(angle)
        value = self.value_at_sample(angle)
        sine = self._new(("sin", key), f"sin({key})", lambda: math.sin(value))
        cosine = self._new(("cos", key), f"cos({key})", lambda: math.cos(value))
        if key not in self._circles:
            self._circles.add(key)
            upper, lower = sorted((sine, cosine), key=lambda p: self.names.index(str(p)))
            circle = upper**2 + lower**2 - 1
            self.impose(str(upper), circle)
            self.signs = self.signs.with_condition(circle)
        return Element(self, sine, {}), Element(self, cosine, {})

    def pi(self) -> Element:
        """The number π, as a symbol: it is transcendental."""
        symbol = self._new(("pi",), "pi", lambda: math.pi, positive=True)
        return Element(self, symbol, {})

    def function_value(self, name: str, arguments: Sequence[Element]) -> Element:
        """A value of a known function, such as log, of which only derivatives are used."""
        keys = tuple(map(self._key, arguments))
        value = getattr(math, name)
        symbol = self._new(
            ("known", name, *keys),
            f"{name}({', '.join(keys)})",
            lambda: float(value(*map(self.value_at_sample, arguments))),
            positive=name == "exp",
        )
        return Element(self, symbol, {})

    def unspecified_value(
        self, function: str, orders: Sequence[int], arguments: Sequence[Element]
    ) -> Element:
        """A value of an unspecified function, or of one of its partial derivatives."""
        keys = tuple(map(self._key, arguments))
        label = derivative_name(function, orders)
        symbol = self._new(
            ("unspecified", function, tuple(orders), *keys),
            f"{label}({', '.join(keys)})",
            lambda: 0.7,
        )
        return Element(self, symbol, {})

    def same(self, first: Sequence[Element], second: Sequence[Element]) -> bool:
        """True if two lists of arguments are equal."""
        return all(self.vanishes(a - b) for a, b in zip(first, second, strict=True))

    def _key(self, element: Element) -> str:
        """A name shared by equal elements."""
        poly, powers = self.reduce(element.poly), dict(element.powers)
        for number in sorted(powers):
            while powers[number] > 0:
                poly = self.product(poly, self.factors[number])
                powers[number] -= 1
            while powers[number] < 0:
                quotient, remainder = divmod(poly, self.factors[number])
                if remainder:
                    break
                poly, powers[number] = quotient, powers[number] + 1
        below = "".join(f"/({self.factors[n]})^{-p}" for n, p in sorted(powers.items()) if p)
        name = f"{poly}{below}"
        for known, shared in self._arguments:
            if shared == name or self.vanishes(known - element):
                return shared
        self._arguments.append((element, name))
        return name


def derivative_name(function: str, orders: Sequence[int]) -> str:
    """Text of a partial derivative of an unspecified function."""
    return f"D{list(orders)} {function}" if any(orders) else function
