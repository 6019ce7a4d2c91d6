"""Fields with roots and powers of positive quantities.

Every root and every symbolic power is an auxiliary symbol; a root also has the relation that it
satisfies. A power of a product is the product of the powers of its factors, each taken with its
sign.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, TypeAlias

import sympy as sp
from flint import fmpq

from flowlanes.formulas.errors import NeedMoreGeneratorsError, NoRealValueError, OutOfReachError

from .budget import Budget
from .quotient_ring import Element, Poly, QuotientRing
from .sign_choices import contradict
from .signs import Sign, Signs

#: Identifies an auxiliary generator: its kind, and the data that distinguish it.
Key: TypeAlias = tuple[Any, ...]

#: Maximum number of terms of a polynomial that is multiplied by conjugates.
MOST_TERMS_OF_CONJUGATES = 12

#: Denominator of the exponents of symbolic powers: the generator is base^(θ/4), where θ is a
#: multiple of a symbol.
FINENESS = 4

#: Exponent whose derivative at zero turns a power into a logarithm.
LOGARITHM = sp.Dummy("logarithm")


def power_of_zero(exponents: Iterable[tuple[sp.Expr, sp.Rational]]) -> Exception:
    """The error for a power of zero with fractional or symbolic exponents.

    A root of zero is real, so the level has such points, but the root has no derivative there.
    """
    if any(theta == 1 and number < 0 for theta, number in exponents):
        return ZeroDivisionError()
    return OutOfReachError("a root is taken of what vanishes here, where it has no derivative")


class _NegativeBaseError(Exception):
    """The base of a symbolic power is negative for the chosen signs."""


class RootField(QuotientRing):
    """Fractions in generators, roots and powers, modulo relations.

    Parameters
    ----------
    names : sequence of str
        Generators, highest first; the main variable of a relation must be its highest.
    spare : int
        Number of auxiliary symbols, which come before all others.
    sample : mapping of str to float
        A point of the phase space that determines signs under roots that are not known.
    choices : mapping of str to int
        Signs of factors under roots that replace those at the sample point.
    """

    def __init__(
        self,
        names: Sequence[str],
        spare: int = 12,
        sample: Mapping[str, float] | None = None,
        budget: Budget | None = None,
        choices: Mapping[str, int] | None = None,
    ) -> None:
        prefix = "aux"
        while any(name.startswith(prefix) for name in names):
            prefix += "_"
        self._auxiliaries = tuple(f"{prefix}{i}" for i in range(spare))
        super().__init__((*reversed(self._auxiliaries), *names), budget)
        self.spare = spare
        self.sample: dict[str, float] | None = None if sample is None else dict(sample)
        self.meanings: dict[str, str] = {}
        #: Known signs; set by the level that uses the field.
        self.signs = Signs(self.ring, {})
        #: Signs of factors under roots that were chosen, since nothing determines them.
        self.decisions: dict[str, tuple[Poly, int]] = {}
        #: Whether a negative base was raised to a symbolic exponent.
        self.has_negative_base = False
        self._choices = dict(choices or {})
        self._implied_signs: dict[str, int] = {}
        #: For each root: content, factors with powers, and degree, of root^degree.
        self._root_of: dict[int, tuple[fmpq, tuple[tuple[int, int], ...], int]] = {}
        self._roots: dict[str, tuple[Poly, int]] = {}
        self._auxiliary: dict[Key, Poly] = {}
        #: Multiples of symbols that replace them as units of exponents.
        self._exponent_units: dict[sp.Expr, sp.Rational] = {}

    def _new(
        self, key: Key, meaning: str, value: Callable[[], float], positive: bool = False
    ) -> Poly:
        """The auxiliary generator for `key`, created on first use."""
        if key not in self._auxiliary:
            count = len(self._auxiliary)
            if count == self.spare:
                raise NeedMoreGeneratorsError(self.spare)
            name = self._auxiliaries[count]
            self._auxiliary[key] = self.generators[name]
            self.meanings[name] = meaning
            if positive:
                self.signs = self.signs.with_positive(name)
            if self.sample is not None:
                self.sample[name] = number_or(value)
        return self._auxiliary[key]

    def readable_polynomial(self, poly: Poly) -> str:
        """Text of a polynomial, with the auxiliary symbols replaced by their definitions."""
        words = str(poly)
        while used := [n for n in self.meanings if re.search(rf"\b{n}\b", words)]:
            words = re.sub(rf"\b{used[-1]}\b", lambda _: f"({self.meanings[used[-1]]})", words)
        return words

    def preferred_form(self, element: Element) -> Element:
        """An element in which powers of a root are replaced by powers of its radicand."""
        if not any(n in self._root_of for n in element.powers):
            return element
        poly, powers = element.poly, dict(element.powers)
        for number in [n for n in powers if n in self._root_of]:
            content, factors, degree = self._root_of[number]
            whole = int(powers[number] / degree)
            powers[number] -= whole * degree
            for n, power in factors:
                powers[n] = powers.get(n, 0) + whole * power
            poly = poly * content**whole
        return Element(self, poly, {n: p for n, p in powers.items() if p})

    def at_sample(self, poly: Poly) -> float:
        """The value of a polynomial at the sample point, which determines signs."""
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

    def value_at_sample(self, element: Element) -> float:
        """The value of an element at the sample point."""
        value = self.at_sample(element.poly)
        for number, power in element.powers.items():
            value *= self.at_sample(self.factors[number]) ** power
        return value

    def vanishes(self, element: Element) -> bool:
        """True if an element is zero modulo the relations, or by the sign of a conjugate.

        If p(g) p(−g) = 0 and the conjugate p(−g) has a strict sign, then p(g) = 0. Example: z −
        √u, where z² = u and z > 0.
        """
        if super().vanishes(element):
            return True
        poly = self.reduce(element.poly)
        return len(poly) <= MOST_TERMS_OF_CONJUGATES and any(
            self.signs.never_zero(conjugate)
            and super(RootField, self).vanishes(Element(self, poly * conjugate, {}))
            for conjugate in self._conjugates(poly)
        )

    def _conjugates(self, poly: Poly) -> Iterator[Poly]:
        """Polynomials with the sign of one generator reversed, whose square a relation gives."""
        for main, relation, lead in self.relations:
            position = self.names.index(main)
            power = (position, 2) if relation.degrees()[position] == 2 else None
            if power in lead and poly.degrees()[position] == 1:
                yield poly.compose(
                    *(-g if i == position else g for i, g in enumerate(self.ring.gens()))
                )

    def _positive_parts(
        self, element: Element, exponents: Sequence[tuple[sp.Expr, sp.Rational]]
    ) -> tuple[fmpq, list[tuple[Poly, int]]]:
        """Content and factors, made positive, of the base of a power.

        If the exponents are numbers, the base is positive wherever the power is real and smooth;
        so is the argument of a logarithm. With a symbolic exponent, which may be an integer, the
        base may be negative; that it is positive is then a decision, as are the signs of its
        factors.
        """
        content, parts = self.factorisation(self.reduce(element.poly))
        total: dict[int, int] = dict(element.powers)
        for number, power in parts:
            total[number] = total.get(number, 0) + power
        is_number = all(theta == 1 for theta, _ in exponents)
        is_positive = is_number or all(theta in (1, LOGARITHM) for theta, _ in exponents)
        signed, overall = [], 1 if content > 0 else -1
        odd: tuple[Poly, int] | None = None
        for number, power in total.items():
            poly = self.factors[number]
            if not power:
                continue
            # An even integer power needs no sign of its base.
            if is_number and all((sp.Rational(n) * power / 2).is_Integer for _, n in exponents):
                signed.append((poly, power))
                continue
            sign = self._known_sign(poly)
            if not sign and power % 2 and odd is None:
                # The product is positive, so this sign follows from the signs of the other
                # factors.
                odd = poly, power
                continue
            sign = sign or self._decision(poly, 0 if is_positive else 1)
            if power % 2:
                overall *= sign
            signed.append((poly if sign > 0 else -poly, power))
        if odd is not None:
            poly, power = odd
            if is_positive:
                sign = self._implied_signs[str(poly)] = overall
                if self._is_contradicted(poly, sign):
                    raise NoRealValueError
            else:
                sign = self._decision(poly, overall)
            overall *= sign
            signed.append((poly if sign > 0 else -poly, power))
        if overall < 0:
            raise NoRealValueError if is_positive else _NegativeBaseError
        return abs(content), signed

    def _known_sign(self, poly: Poly) -> int:
        """The sign of a factor of a positive product, if known or chosen before; else 0."""
        key = str(poly)
        if key in self._implied_signs:
            return self._implied_signs[key]
        if key in self.decisions:
            return self.decisions[key][1]
        sign = self.signs.of(poly)
        return 0 if sign is Sign.UNKNOWN else (1 if sign > 0 else -1)

    def _decision(self, poly: Poly, default: int = 0) -> int:
        """Choose the sign of a factor, here and under all other roots."""
        key = str(poly)
        sign = self._choices.get(key) or default or (-1 if self.at_sample(poly) < 0 else 1)
        if self._is_contradicted(poly, sign):
            if key in self._choices or self._is_contradicted(poly, -sign):
                raise NoRealValueError
            sign = -sign
        self.decisions[key] = poly, sign
        return sign

    def _is_contradicted(self, poly: Poly, sign: int) -> bool:
        """True if earlier decisions exclude a sign of a factor."""
        return any(contradict(poly * sign, known * own) for known, own in self.decisions.values())

    def root(self, element: Element, degree: int) -> Element:
        """The root that is positive at the sample point."""
        if degree == 1:
            return element
        return self.power(element, ((sp.S.One, sp.Rational(1, degree)),), None)

    def power(
        self,
        element: Element,
        exponents: Iterable[tuple[sp.Expr, sp.Rational]],
        value: Element | None,
    ) -> Element:
        """The product of element^(number · θ) over pairs (θ, number); θ = 1 or symbolic."""
        exponents = tuple(exponents)
        if self.vanishes(element):
            raise power_of_zero(exponents)
        try:
            content, parts = self._positive_parts(element, exponents)
        except _NegativeBaseError:
            # Not raised at once: a later root may show that the law is undefined for these signs.
            self.has_negative_base = True
            key = ("negative base", len(self._auxiliary))
            return Element(self, self._new(key, "a power of a negative base", lambda: 0.7), {})
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
        """The rational number equal to an element, or None."""
        poly = self.reduce(element.poly)
        if element.powers or not poly.is_constant():
            return None
        value = poly.leading_coefficient() if poly else fmpq(0)
        return sp.Rational(int(value.p), int(value.q))

    def _one_power(self, base: Poly, theta: sp.Expr, exponent: sp.Rational) -> Element:
        if str(base) in self._roots:
            inner, degree = self._roots[str(base)]
            return self._one_power(inner, theta, exponent / degree)
        if theta == 1:
            # base^(whole + p/q) = base^whole · (base^(1/q))^p with the integer part whole =
            # ⌊exponent⌋.
            whole = exponent.p // exponent.q
            result = self.integer_power(Element(self, base, {}), int(whole))
            part = exponent - whole
            return result * self._root(base, int(part.q)) ** int(part.p) if part else result
        # The first exponent met fixes the unit in which later multiples of θ are measured.
        is_multiple = (exponent * FINENESS).is_Integer
        unit = self._exponent_units.setdefault(theta, sp.S.One if is_multiple else abs(exponent))
        fine = exponent / unit * FINENESS
        if fine.q != 1:
            raise OutOfReachError(
                f"the exponent {exponent}·{theta} is not a multiple of {unit / FINENESS}·{theta}"
            )
        theta = theta * unit
        value = self.at_sample(base)
        symbol = self._new(
            ("power", str(base), theta),
            f"({base})^({theta}/{FINENESS})",
            lambda: abs(value) ** 0.37,
            positive=True,
        )
        return self.integer_power(Element(self, symbol, {}), int(fine.p))

    def _root(self, base: Poly, degree: int) -> Element:
        if base.is_one():
            return self.one
        # A known root of a multiple of the degree expresses this one as its power.
        for known in sorted(k[2] for k in self._auxiliary if k[:2] == ("root", str(base))):
            if known % degree == 0:
                higher = Element(self, self._auxiliary["root", str(base), known], {})
                return self.integer_power(higher, known // degree)
        value = self.at_sample(base)
        key = ("root", str(base), degree)
        symbol = self._new(
            key, f"({base})^(1/{degree})", lambda: abs(value) ** (1 / degree), positive=True
        )
        self.impose(str(symbol), symbol**degree - base)
        self._roots[str(symbol)] = (base, degree)
        if not base.is_constant():
            lead = base.leading_coefficient()
            self._root_of[self.factor_number(symbol)] = (
                lead,
                ((self.factor_number(base / lead), 1),),
                degree,
            )
        return Element(self, symbol, {})


def number_or(value: Callable[[], float], otherwise: float = 0.7) -> float:
    """The value of a function, or a default if it is undefined; used only for signs."""
    try:
        return value()
    except (ValueError, OverflowError, ZeroDivisionError):
        return otherwise
