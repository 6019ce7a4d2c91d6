"""Fractions of polynomials modulo relations.

Elements are ``poly · ∏ factor^power`` with polynomials over the rationals (FLINT). Every divisor
is kept as a named factor, so that quotients cancel without a greatest common divisor. The
relations form a triangular set: the main variable of each occurs in no relation below it. Products
are reduced at once by the leading terms; the final result is reduced by pseudo-division, whose
multipliers do not vanish at the sample point.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeAlias

import sympy as sp
from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from .budget import Budget

Poly: TypeAlias = fmpq_mpoly

FACTORED_UP_TO = 1500
"""Maximum number of terms of a divisor that is factored."""


class Element:
    """An element of the field; immutable."""

    __slots__ = ("home", "poly", "powers")

    def __init__(self, home: QuotientRing, poly: Poly, powers: Mapping[int, int]) -> None:
        self.home, self.poly, self.powers = home, poly, powers

    def __add__(self, other: Element) -> Element:
        return self.home.add(self, other)

    def __sub__(self, other: Element) -> Element:
        return self.home.add(self, -other)

    def __neg__(self) -> Element:
        return Element(self.home, -self.poly, self.powers)

    def __mul__(self, other: Element) -> Element:
        return self.home.multiply(self, other)

    def __truediv__(self, other: Element) -> Element:
        return self.home.multiply(self, self.home.invert(other))

    def __pow__(self, exponent: int) -> Element:
        return self.home.integer_power(self, exponent)


class QuotientRing:
    """Fractions over the rationals in named generators, modulo a triangular set of relations.

    Parameters
    ----------
    names : sequence of str
        Generators, highest first; the main variable of a relation must be its highest.
    """

    exact = True

    def __init__(self, names: Sequence[str], budget: Budget | None = None) -> None:
        self.names = tuple(names)
        self.ring = fmpq_mpoly_ctx.get(self.names, Ordering.lex)
        self.generators = dict(zip(self.names, self.ring.gens(), strict=True))
        self.budget = budget or Budget()
        self.factors: list[Poly] = []
        self._factor_numbers: dict[str, int] = {}
        self._chain: list[tuple[str, Poly, tuple[tuple[int, int], ...]]] = []
        self.one = Element(self, self.ring.constant(1), {})
        self.zero = Element(self, self.ring.constant(0), {})

    def rational(self, value: int | sp.Rational) -> Element:
        """A rational number."""
        number = sp.Rational(value)
        return Element(self, self.ring.constant(fmpq(int(number.p), int(number.q))), {})

    def generator(self, name: str) -> Element:
        """A generator by name, reduced modulo the relations."""
        return Element(self, self.reduce(self.generators[name]), {})

    def multiply(self, first: Element, second: Element) -> Element:
        """The reduced product."""
        if not second.poly or not first.poly:
            return self.zero
        powers = dict(first.powers)
        for number, power in second.powers.items():
            total = powers.get(number, 0) + power
            if total:
                powers[number] = total
            else:
                del powers[number]
        return self.preferred_form(Element(self, self.product(first.poly, second.poly), powers))

    def preferred_form(self, element: Element) -> Element:
        """An element in normal form; subclasses simplify roots here."""
        return element

    def product(self, first: Poly, second: Poly) -> Poly:
        """Product of polynomials, reduced and within the budget."""
        self.budget.foresee(first, second)
        product = self.reduce(first * second)
        self.budget.spend(product)
        return product

    def add(self, first: Element, second: Element) -> Element:
        """The sum over the common denominator."""
        if not first.poly:
            return second
        if not second.poly:
            return first
        if first.powers == second.powers:
            return Element(self, first.poly + second.poly, first.powers)
        common: dict[int, int] = {}
        for number in {*first.powers, *second.powers}:
            low = min(first.powers.get(number, 0), second.powers.get(number, 0))
            if low:
                common[number] = low
        poly = self._over(first, common) + self._over(second, common)
        self.budget.spend(poly)
        return self._cancelled_generators(poly, common) if poly else self.zero

    def _cancelled_generators(self, poly: Poly, powers: dict[int, int]) -> Element:
        """An element with generators cancelled between numerator and denominator."""
        single = [n for n, p in powers.items() if p < 0 and len(self.factors[n]) == 1]
        if single:
            shared = poly.term_content().monoms()[0]
            for number in single:
                (position,) = (i for i, d in enumerate(self.factors[number].degrees()) if d)
                times = min(int(shared[position]), -powers[number])
                if times:
                    poly = divmod(poly, self.factors[number] ** times)[0]
                    powers[number] += times
        return Element(self, poly, {n: p for n, p in powers.items() if p})

    def _over(self, element: Element, common: Mapping[int, int]) -> Poly:
        poly = element.poly
        for number in {*element.powers, *common}:
            for _ in range(element.powers.get(number, 0) - common.get(number, 0)):
                poly = self.product(poly, self.factors[number])
        return poly

    def integer_power(self, element: Element, exponent: int) -> Element:
        """Power with an integer exponent."""
        if exponent < 0:
            return self.integer_power(self.invert(element), -exponent)
        result, square = self.one, element
        while exponent:
            if exponent & 1:
                result = self.multiply(result, square)
            exponent >>= 1
            if exponent:
                square = self.multiply(square, square)
        return result

    def invert(self, element: Element) -> Element:
        """The reciprocal; ZeroDivisionError if the element vanishes modulo the relations."""
        if self.vanishes(element):
            raise ZeroDivisionError
        content, parts = self.factorisation(element.poly)
        powers = {number: -power for number, power in element.powers.items()}
        for number, power in parts:
            powers[number] = powers.get(number, 0) - power
        nonzero = {number: power for number, power in powers.items() if power}
        return self.preferred_form(Element(self, self.ring.constant(1 / content), nonzero))

    def factorisation(self, poly: Poly) -> tuple[fmpq, list[tuple[int, int]]]:
        """Content, and the factors by index with their powers."""
        if poly.is_constant():
            return poly.leading_coefficient(), []
        if len(poly) > FACTORED_UP_TO:
            return fmpq(1), [(self.factor_number(poly), 1)]
        content, parts = poly.factor()
        named = []
        for part, power in parts:
            # Factors are stored as monic polynomials, so that multiples share one index.
            lead = part.leading_coefficient()
            content *= lead ** int(power)
            named.append((self.factor_number(part / lead), int(power)))
        return content, named

    def factor_number(self, poly: Poly) -> int:
        """The index of a factor, which is added if it is new."""
        key = str(poly)
        if key not in self._factor_numbers:
            self._factor_numbers[key] = len(self.factors)
            self.factors.append(poly)
        return self._factor_numbers[key]

    def impose(self, main: str, poly: Poly) -> None:
        """Add a relation with its main variable, above all relations imposed before."""
        lead = poly.monoms()[0]
        degrees = tuple((i, int(n)) for i, n in enumerate(lead) if n)
        self._chain.insert(0, (main, poly, degrees))

    @property
    def relations(self) -> tuple[tuple[str, Poly, tuple[tuple[int, int], ...]], ...]:
        """Main variable, polynomial and leading exponents of every relation, highest first."""
        return tuple(self._chain)

    def reduce(self, poly: Poly) -> Poly:
        """The remainder on division by the leading terms of the relations."""
        if not self._chain or not poly:
            return poly
        while True:
            highest = poly.degrees()
            before = poly
            # A division can only change poly if every exponent of the leading term is reached.
            for _, relation, lead in self._chain:
                if all(highest[i] >= n for i, n in lead):
                    poly = divmod(poly, relation)[1]
                    if not poly:
                        return poly
                    highest = poly.degrees()
            if poly == before:
                return poly

    def vanishes(self, element: Element) -> bool:
        """True if an element is zero modulo the relations."""
        poly = self.reduce(element.poly)
        for main, relation, _ in self._chain:
            if not poly:
                return True
            poly = self.reduce(self.pseudo_remainder(poly, relation, main))
        return not poly

    def pseudo_remainder(self, poly: Poly, relation: Poly, main: str) -> Poly:
        """The pseudo-remainder in `main`; poly is multiplied by powers of the initial."""
        position = self.names.index(main)
        degree = int(relation.degrees()[position])
        lead = initial_of(relation, position)
        variable = self.generators[main]
        while poly and (height := int(poly.degrees()[position])) >= degree:
            top = initial_of(poly, position)
            poly = lead * poly - top * variable ** (height - degree) * relation
            self.budget.spend(poly)
        return poly


def initial_of(poly: Poly, position: int) -> Poly:
    """The coefficient of the highest power of a generator in a non-zero polynomial."""
    generator = poly.context().gen(position)
    # In lexicographic division by g^n, all terms of lower degree go to the remainder.
    return divmod(poly, generator ** int(poly.degrees()[position]))[0]
