"""The field in which laws are proved: fractions of polynomials modulo relations.

Elements are ``poly · ∏ factor^power`` with polynomials over the rationals (FLINT) in the state, the
parameters and auxiliary symbols; whatever was once divided by stays a named factor, so that
quotients cancel without a greatest common divisor.  Every root and every symbolic power is an
auxiliary symbol, roots with the relation they satisfy; sines and cosines come in pairs with
s² + c² = 1; an unspecified function is a symbol for each of its derivatives.

Relations form a triangular set: each has a main variable that occurs in no relation below it.
Products are reduced at once by the leading terms; what is left in the end is reduced by
pseudo-division, whose multipliers are known not to vanish at the witness point.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp
from flint import Ordering, fmpq, fmpq_mpoly_ctx

from .errors import OutOfReachError, SpareNeededError

__all__ = ["Budget", "Element", "Fractions"]

Poly = Any

#: Denominator of the exponents that symbolic powers may have: base^(θ/4) is the generator.
FINENESS = 4
FACTORED_UP_TO = 1500
"""Polynomials of more terms are divided by as they are."""


@dataclass
class Budget:
    """How large polynomials may become and how long the work may take."""

    terms: int = 20_000_000
    deadline: float = float("inf")
    largest: int = 0
    watch: Callable[[], None] = field(default=lambda: None)

    def spend(self, poly: Poly) -> None:
        """Note the size of a polynomial; OutOfReachError when it or the time is too much."""
        size = len(poly)
        self.largest = max(self.largest, size)
        if size > self.terms:
            raise OutOfReachError(
                f"a polynomial of {size:,} terms exceeds the limit of {self.terms:,}"
            )
        if time.monotonic() > self.deadline:
            raise OutOfReachError(f"the time given ran out at a polynomial of {size:,} terms")

    def foresee(self, first: Poly, second: Poly) -> None:
        """Refuse a product that would not fit into memory."""
        pairs = len(first) * len(second)
        if pairs > 200 * self.terms:
            raise OutOfReachError(
                f"a product of polynomials with {len(first):,} and {len(second):,} terms exceeds "
                f"the limit of {self.terms:,} terms"
            )


class Element:
    """An element of the field; immutable."""

    __slots__ = ("home", "poly", "powers")

    def __init__(self, home: Fractions, poly: Poly, powers: Mapping[int, int]) -> None:
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


class Fractions:
    """Fractions over the rationals in named generators, modulo a triangular set of relations.

    Parameters
    ----------
    names : sequence of str
        Generators, highest first; a relation's main variable must be its highest.
    spare : int
        Room for auxiliary symbols.
    sample : mapping of str to float
        A point of the phase space, which settles signs of roots.
    budget : Budget
    """

    exact = True

    def __init__(
        self,
        names: Sequence[str],
        spare: int = 12,
        sample: Mapping[str, float] | None = None,
        budget: Budget | None = None,
    ) -> None:
        self.spare = spare
        self.names = (*(f"aux{i}" for i in reversed(range(spare))), *names)
        self.ring = fmpq_mpoly_ctx.get(self.names, Ordering.lex)
        self.generators = dict(zip(self.names, self.ring.gens(), strict=True))
        self.budget = budget or Budget()
        self.sample: dict[str, float] | None = None if sample is None else dict(sample)
        self.factors: list[Poly] = []
        self.meanings: dict[str, str] = {}
        self._factor_numbers: dict[str, int] = {}
        self._root_of: dict[int, tuple[fmpq, int, int]] = {}
        self._roots: dict[str, tuple[Poly, int]] = {}
        self._auxiliary: dict[Any, Any] = {}
        self._circles: set[str] = set()
        self._zeros: set[str] = set()
        self._arguments: list[tuple[Element, str]] = []
        self._chain: list[tuple[str, Poly, tuple[tuple[int, int], ...]]] = []
        self.one = Element(self, self.ring.constant(1), {})
        self.zero = Element(self, self.ring.constant(0), {})

    # --- making elements -------------------------------------------------------------------

    def rational(self, value: Any) -> Element:
        """A rational number."""
        number = sp.Rational(value)
        return Element(self, self.ring.constant(fmpq(int(number.p), int(number.q))), {})

    def generator(self, name: str) -> Element:
        """A generator by its name, reduced where a relation gives its value."""
        return Element(self, self.reduce(self.generators[name]), {})

    def polynomial(self, poly: Poly) -> Element:
        """A polynomial of the ring as an element."""
        return Element(self, self.reduce(poly), {})

    def _new(self, key: Any, meaning: str, value: Callable[[], float]) -> Poly:
        """The auxiliary generator that stands for `key`, made when first asked for."""
        if key not in self._auxiliary:
            taken = len(self._auxiliary)
            if taken == self.spare:
                raise SpareNeededError(self.spare)
            name = f"aux{taken}"
            self._auxiliary[key] = self.generators[name]
            self.meanings[name] = meaning
            if self.sample is not None:
                self.sample[name] = value()
        return self._auxiliary[key]

    # --- arithmetic ------------------------------------------------------------------------

    def multiply(self, first: Element, second: Element) -> Element:
        """Product, reduced."""
        if not second.poly or not first.poly:
            return self.zero
        powers = dict(first.powers)
        for number, power in second.powers.items():
            total = powers.get(number, 0) + power
            if total:
                powers[number] = total
            else:
                del powers[number]
        return self._unrooted(Element(self, self._product(first.poly, second.poly), powers))

    def _unrooted(self, element: Element) -> Element:
        """Powers of a root written as powers of what it is a root of, where they are."""
        if not any(n in self._root_of for n in element.powers):
            return element
        poly, powers = element.poly, dict(element.powers)
        for number in [n for n in powers if n in self._root_of]:
            lead, base, degree = self._root_of[number]
            whole = int(powers[number] / degree)
            for n, change in ((number, -whole * degree), (base, whole)):
                powers[n] = powers.get(n, 0) + change
            poly = poly * lead**whole
        return Element(self, poly, {n: p for n, p in powers.items() if p})

    def _product(self, first: Poly, second: Poly) -> Poly:
        self.budget.foresee(first, second)
        made = self.reduce(first * second)
        self.budget.spend(made)
        return made

    def add(self, first: Element, second: Element) -> Element:
        """Sum over the common denominator."""
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
        return self._lightened(poly, common) if poly else self.zero

    def _lightened(self, poly: Poly, powers: dict[int, int]) -> Element:
        """An element in which generators are cancelled against the denominator."""
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
                poly = self._product(poly, self.factors[number])
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
        """Reciprocal; ZeroDivisionError if the element vanishes modulo the relations."""
        if self.vanishes(element):
            raise ZeroDivisionError
        content, parts = self._factorised(element.poly)
        powers = {number: -power for number, power in element.powers.items()}
        for number, power in parts:
            powers[number] = powers.get(number, 0) - power
        kept = {number: power for number, power in powers.items() if power}
        return self._unrooted(Element(self, self.ring.constant(1 / content), kept))

    def _factorised(self, poly: Poly) -> tuple[fmpq, list[tuple[int, int]]]:
        """Content and named factors with their powers."""
        if poly.is_constant():
            return poly.leading_coefficient(), []
        if len(poly) > FACTORED_UP_TO:
            return fmpq(1), [(self._named(poly), 1)]
        content, parts = poly.factor()
        named = []
        for part, power in parts:
            lead = part.leading_coefficient()
            content *= lead ** int(power)
            named.append((self._named(part / lead), int(power)))
        return content, named

    def _named(self, poly: Poly) -> int:
        key = str(poly)
        if key not in self._factor_numbers:
            self._factor_numbers[key] = len(self.factors)
            self.factors.append(poly)
        return self._factor_numbers[key]

    # --- relations -------------------------------------------------------------------------

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
        """Remainder after division by the relations, by leading terms."""
        if not self._chain or not poly:
            return poly
        while True:
            highest = poly.degrees()
            before = poly
            for _, relation, lead in self._chain:
                if all(highest[i] >= n for i, n in lead):
                    poly = divmod(poly, relation)[1]
                    if not poly:
                        return poly
                    highest = poly.degrees()
            if poly == before:
                return poly

    def vanishes(self, element: Element) -> bool:
        """Whether an element is zero modulo the relations."""
        poly = self.reduce(element.poly)
        for main, relation, _ in self._chain:
            if not poly:
                return True
            poly = self.reduce(self.pseudo_remainder(poly, relation, main))
        return not poly

    def pseudo_remainder(self, poly: Poly, relation: Poly, main: str) -> Poly:
        """Remainder in the variable `main`, up to powers of the leading coefficient."""
        position = self.names.index(main)
        degree = int(relation.degrees()[position])
        lead = self.coefficient(relation, position, degree)
        variable = self.generators[main]
        while poly and (height := int(poly.degrees()[position])) >= degree:
            top = self.coefficient(poly, position, height)
            poly = lead * poly - top * variable ** (height - degree) * relation
            self.budget.spend(poly)
        return poly

    def coefficient(self, poly: Poly, position: int, degree: int) -> Poly:
        """Coefficient of a power of one generator."""
        found = {}
        for exponents, number in poly.to_dict().items():
            if exponents[position] == degree:
                rest = list(exponents)
                rest[position] = 0
                found[tuple(rest)] = number
        return self.ring.from_dict(found)

    # --- roots, powers, functions ----------------------------------------------------------

    def at_sample(self, poly: Poly) -> float:
        """Value of a polynomial at the sample point, which settles signs."""
        if self.sample is None:
            return 1.0
        values = [self.sample.get(name, 1.0) for name in self.names]
        total = 0.0
        for exponents, number in poly.to_dict().items():
            term = float(number.p) / float(number.q)
            for value, exponent in zip(values, exponents, strict=True):
                if exponent:
                    term *= value ** int(exponent)
            total += term
        return total

    def _positive_parts(self, element: Element) -> tuple[fmpq, list[tuple[Poly, int]]]:
        """Content and factors with powers, every factor positive at the sample point."""
        content, parts = self._factorised(self.reduce(element.poly))
        total: dict[int, int] = dict(element.powers)
        for number, power in parts:
            total[number] = total.get(number, 0) + power
        signed = []
        for number, power in total.items():
            poly = self.factors[number]
            if self.at_sample(poly) < 0:
                poly = -poly
                content = -content if power % 2 else content
            if power:
                signed.append((poly, power))
        return content, signed

    def root(self, element: Element, degree: int) -> Element:
        """The root that is positive at the sample point."""
        if degree == 1:
            return element
        return self.power(element, ((sp.S.One, sp.Rational(1, degree)),), None)

    def power(
        self, element: Element, exponents: Iterable[tuple[Any, Any]], value: Element | None
    ) -> Element:
        """The product of element^(number · θ) over pairs (θ, number); θ = 1 or symbolic."""
        if self.vanishes(element):
            raise ZeroDivisionError
        content, parts = self._positive_parts(element)
        if content < 0:
            raise OutOfReachError("a root of a quantity that is negative at the sample point")
        bases: list[tuple[Poly, int]] = [*parts]
        for prime, power in sp.factorrat(sp.Rational(int(content.p), int(content.q))).items():
            if prime != 1:
                bases.append((self.ring.constant(int(prime)), int(power)))
        result = self.one
        for theta, number in exponents:
            for base, power in bases:
                result = result * self._one_power(base, theta, sp.Rational(number) * power)
        return result

    def as_rational(self, element: Element) -> sp.Rational | None:
        """The number that an element is, if it is one."""
        poly = self.reduce(element.poly)
        if element.powers or not poly.is_constant():
            return None
        value = poly.leading_coefficient() if poly else fmpq(0)
        return sp.Rational(int(value.p), int(value.q))

    def _one_power(self, base: Poly, theta: Any, exponent: Any) -> Element:
        if str(base) in self._roots:
            inner, degree = self._roots[str(base)]
            return self._one_power(inner, theta, exponent / degree)
        if theta == 1:
            whole = exponent.p // exponent.q
            result = self.integer_power(Element(self, base, {}), int(whole))
            part = exponent - whole
            return result * self._root(base, int(part.q)) ** int(part.p) if part else result
        fine = exponent * FINENESS
        if fine.q != 1:
            raise OutOfReachError(
                f"the exponent {exponent}·{theta} is not a multiple of 1/{FINENESS}"
            )
        value = self.at_sample(base)
        made = self._new(
            ("power", str(base), theta),
            f"({base})^({theta}/{FINENESS})",
            lambda: abs(value) ** 0.37,
        )
        return self.integer_power(Element(self, made, {}), int(fine.p))

    def _root(self, base: Poly, degree: int) -> Element:
        if base.is_one():
            return self.one
        for known in sorted(k[2] for k in self._auxiliary if k[:2] == ("root", str(base))):
            if known % degree == 0:
                made = Element(self, self._auxiliary["root", str(base), known], {})
                return self.integer_power(made, known // degree)
        value = self.at_sample(base)
        key = ("root", str(base), degree)
        made = self._new(key, f"({base})^(1/{degree})", lambda: float(value ** (1 / degree)))
        self.impose(str(made), made**degree - base)
        self._roots[str(made)] = (base, degree)
        if not base.is_constant():
            lead = base.leading_coefficient()
            self._root_of[self._named(made)] = (lead, self._named(base / lead), degree)
        return Element(self, made, {})

    def exponential(self, element: Element) -> Element:
        """The exponential; that of the opposite is its reciprocal."""
        opposite = ("exp", self._key(-element))
        if opposite in self._auxiliary:
            return self.invert(Element(self, self._auxiliary[opposite], {}))
        return self.opaque("exp", [element])

    def circle(self, angle: Element) -> tuple[Element, Element]:
        """Sine and cosine."""
        key = self._key(angle)
        sine = self._new(("sin", key), f"sin({key})", lambda: 0.6)
        cosine = self._new(("cos", key), f"cos({key})", lambda: 0.8)
        if key not in self._circles:
            self._circles.add(key)
            upper, lower = sorted((sine, cosine), key=lambda p: self.names.index(str(p)))
            self.impose(str(upper), upper**2 + lower**2 - 1)
        return Element(self, sine, {}), Element(self, cosine, {})

    def nothing(self, name: str) -> None:
        """State that an unspecified function takes the value zero."""
        self._zeros.add(name)

    def opaque(self, name: str, arguments: Sequence[Element], value: float = 0.7) -> Element:
        """A symbol for a function value about which nothing is known but its arguments."""
        if name in self._zeros:
            return self.zero
        key = (name, *map(self._key, arguments))
        return Element(self, self._new(key, f"{name}({', '.join(key[1:])})", lambda: value), {})

    def _key(self, element: Element) -> str:
        """A name that equal elements share."""
        poly, powers = self.reduce(element.poly), dict(element.powers)
        for number in sorted(powers):
            while powers[number] > 0:
                poly = self._product(poly, self.factors[number])
                powers[number] -= 1
            while powers[number] < 0:
                quotient, rest = divmod(poly, self.factors[number])
                if rest:
                    break
                poly, powers[number] = quotient, powers[number] + 1
        below = "".join(f"/({self.factors[n]})^{-p}" for n, p in sorted(powers.items()) if p)
        name = f"{poly}{below}"
        for known, shared in self._arguments:
            if shared == name or self.vanishes(known - element):
                return shared
        self._arguments.append((element, name))
        return name
