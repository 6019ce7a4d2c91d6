"""Signs of polynomials on the domain of a system.

The signs of parameters and other quantities are declared by the system (admissible sets, guards,
assumptions on symbols); further signs follow term by term or by one of the methods of
:mod:`.positive_forms`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum

from flint import fmpq, fmpq_mpoly_ctx

from .positive_forms import (
    completed_squares,
    in_one_variable,
    less_a_multiple,
    meets,
    only_variable,
    signs_in_one_variable,
)
from .quotient_ring import Poly

MANY = 400
"""Maximum number of terms of a polynomial that is compared with facts."""


class Sign(IntEnum):
    """The sign of a real quantity, as far as it is known."""

    NEGATIVE = -2
    NOT_POSITIVE = -1
    UNKNOWN = 0
    NOT_NEGATIVE = 1
    POSITIVE = 2

    def times(self, other: Sign) -> Sign:
        """The sign of a product."""
        if not self or not other:
            return Sign.UNKNOWN
        size = min(abs(self), abs(other))
        return Sign(size if (self > 0) == (other > 0) else -size)


@dataclass(frozen=True)
class Signs:
    """The known signs in a ring of polynomials.

    Parameters
    ----------
    symbol_signs : mapping of str to Sign
        Signs of generators.
    facts : sequence of (polynomial, Sign)
        Other polynomials of known sign.
    nonzero : sequence of polynomials
        Polynomials that do not vanish but whose sign may be unknown.
    conditions : sequence of polynomials
        Polynomials that vanish.
    """

    ring: fmpq_mpoly_ctx
    symbol_signs: Mapping[str, Sign]
    facts: Sequence[tuple[Poly, Sign]] = ()
    nonzero: Sequence[Poly] = ()
    conditions: Sequence[Poly] = ()

    def with_condition(self, poly: Poly) -> Signs:
        """The signs on the zero set of one more polynomial."""
        return replace(self, conditions=(*self.conditions, poly))

    def with_positive(self, name: str) -> Signs:
        """The signs with one more positive generator."""
        return replace(self, symbol_signs={**self.symbol_signs, name: Sign.POSITIVE})

    def of(self, poly: Poly) -> Sign:
        """The sign of a polynomial where the facts and the conditions hold."""
        sign = self._of_one(poly)
        # Factors are tried last, because factorization takes long.
        if abs(sign) < Sign.POSITIVE and poly and len(poly) <= MANY:
            content, parts = poly.factor()
            if len(parts) > 1 or any(power > 1 for _, power in parts):
                product = _number(content)
                for part, power in parts:
                    product = product.times(self._of_power(part, int(power)))
                sign = product or sign
        return sign

    def never_zero(self, poly: Poly) -> bool:
        """True if a polynomial is certainly non-zero."""
        if abs(self.of(poly)) == Sign.POSITIVE:
            return True
        signs = self._in_one_variable(poly)
        return self._said_nonzero(poly) or (bool(signs) and 0 not in signs)

    def _said_nonzero(self, poly: Poly) -> bool:
        products = [fact for fact, sign in self.facts if abs(sign) == Sign.POSITIVE]
        if any(_ratio(poly, fact) is not None for fact in self.nonzero):
            return True
        return bool(poly) and any(not divmod(fact, poly)[1] for fact in products)

    def _of_power(self, poly: Poly, power: int) -> Sign:
        sign = self._of_one(poly)
        if power % 2:
            return sign
        strict = abs(sign) == Sign.POSITIVE or self._said_nonzero(poly)
        return Sign.POSITIVE if strict else Sign.NOT_NEGATIVE

    def squares(self, poly: Poly) -> list[Poly] | None:
        """Polynomials that all vanish where `poly` does, if it is a sum of terms of one sign.

        ``[1]`` if it cannot vanish; None if it is not such a sum.
        """
        terms = [self._term(exponents, number) for exponents, number in poly.to_dict().items()]
        if all(sign > 0 for sign, _ in terms) or all(sign < 0 for sign, _ in terms):
            return [base for _, base in terms]
        for signed in (poly, -poly):
            squares = completed_squares(signed, self.ring)
            if squares is not None:
                return [base for _, base in squares]
        return None

    def _of_one(self, poly: Poly) -> Sign:
        sign = self._by_terms(poly)
        if sign is Sign.UNKNOWN and len(poly) <= MANY:
            sign = self._by_facts(poly) or self._by_conditions(poly) or self._by_squares(poly)
            sign = sign or self._by_multiples(poly) or _common(self._in_one_variable(poly))
        return sign

    def _by_terms(self, poly: Poly) -> Sign:
        signs = []
        for exponents, number in poly.to_dict().items():
            sign, base = self._term(exponents, number)
            if sign is Sign.UNKNOWN:
                return Sign.UNKNOWN
            signs.append(sign if base.is_constant() else Sign(sign // abs(sign)))
        return _sum(signs)

    def _term(self, exponents: Sequence[int], number: fmpq) -> tuple[Sign, Poly]:
        """The sign of a term where it does not vanish, and a monomial with the same zeros."""
        sign, base = _number(number), self.ring.constant(1)
        for index, exponent in enumerate(exponents):
            if not exponent:
                continue
            own = self.symbol_signs.get(self.ring.name(index), Sign.UNKNOWN)
            if abs(own) != Sign.POSITIVE:
                base = base * self.ring.gen(index)
            # Only odd powers depend on the sign of the symbol.
            if exponent % 2:
                sign = sign.times(own) if own else Sign.UNKNOWN
                if sign is Sign.UNKNOWN:
                    return sign, base
                sign = Sign(2 if sign > 0 else -2)
        return sign, base

    def _by_facts(self, poly: Poly) -> Sign:
        """The sign if poly is a signed multiple of a fact plus terms of the same sign."""
        for fact, sign in self.facts:
            for share in multiples(poly, fact):
                part = sign.times(self._by_terms(share))
                if not part:
                    continue
                remainder = poly - share * fact
                whole = _sum([part, self._by_terms(remainder)]) if remainder else part
                if whole:
                    return whole
        return Sign.UNKNOWN

    def _by_conditions(self, poly: Poly) -> Sign:
        """The sign after a multiple of a condition has cancelled one term."""
        for condition in self.conditions:
            for share in multiples(poly, condition):
                sign = self._by_terms(poly - share * condition)
                if sign:
                    return sign
        return Sign.UNKNOWN

    def _by_squares(self, poly: Poly) -> Sign:
        for sign in (Sign.POSITIVE, Sign.NEGATIVE):
            for strict, left in self._open_parts(poly, sign):
                squares = completed_squares(left, self.ring)
                if squares is not None:
                    positive = strict or any(base.is_constant() for _, base in squares)
                    return sign if positive else Sign(sign // 2)
        return Sign.UNKNOWN

    def _open_parts(self, poly: Poly, sign: Sign) -> Iterator[tuple[bool, Poly]]:
        """±poly, and the rest of it after removing terms of known positive sign.

        Each with whether a removed term is strictly positive.
        """
        yield False, poly if sign > 0 else -poly
        strict, left = False, {}
        for exponents, number in poly.to_dict().items():
            known, base = self._term(exponents, number)
            if known.times(sign) <= 0 or not any(n % 2 for n in exponents):
                left[exponents] = number if sign > 0 else -number
            else:
                strict = strict or base.is_constant()
        if 0 < len(left) < len(poly):
            yield strict, self.ring.from_dict(left)

    def _by_multiples(self, poly: Poly) -> Sign:
        """The sign from a multiple of a fact or a condition plus squares."""
        known = [(fact, sign) for fact, sign in self.facts]
        known += [(condition, Sign.UNKNOWN) for condition in self.conditions]
        for other, sign in known:
            if not meets(poly, other):
                continue
            signed = -other if sign < 0 else other
            for own in (Sign.POSITIVE, Sign.NEGATIVE):
                for positive, left in self._open_parts(poly, own):
                    form = less_a_multiple(left, signed, self.ring, either_sign=not sign)
                    if form is not None:
                        strict = any(base.is_constant() for _, base in form[1])
                        strict = strict or positive or abs(sign) == Sign.POSITIVE
                        return own if strict else Sign(own // 2)
        return Sign.UNKNOWN

    def _in_one_variable(self, poly: Poly) -> frozenset[int]:
        """The possible signs of a univariate polynomial, given the facts."""
        position = only_variable(poly)
        if position is None:
            return frozenset()
        facts = []
        known = [(fact if sign > 0 else -fact, abs(sign)) for fact, sign in self.facts]
        # A condition is zero, so both signs of it are nonnegative.
        known += [(signed, 1) for c in self.conditions for signed in (c, -c)]
        for fact, strength in known:
            part = self.part_in_one_variable(fact, position)
            if part is not None:
                facts.append((in_one_variable(part, position), strength == Sign.POSITIVE))
        return signs_in_one_variable(in_one_variable(poly, position), facts)

    def part_in_one_variable(self, poly: Poly, position: int) -> Poly | None:
        """The terms in one variable, if all other terms are negative or zero."""
        own = {}
        # fact = own + others ≥ 0 with others ≤ 0 implies own ≥ 0.
        for exponents, number in poly.to_dict().items():
            if not any(n for i, n in enumerate(exponents) if i != position):
                own[exponents] = number
            elif self._term(exponents, number)[0] >= 0:
                return None
        part = self.ring.from_dict(own)
        return part if int(part.degrees()[position]) else None


def _number(value: fmpq) -> Sign:
    return Sign(2 * ((value > 0) - (value < 0)))


def _common(signs: frozenset[int]) -> Sign:
    """The weakest sign that covers a set of signs."""
    if not signs or {1, -1} <= signs or signs == {0}:
        return Sign.UNKNOWN
    sign = max(signs, key=abs)
    return Sign(sign if 0 in signs else 2 * sign)


def _sum(signs: Iterable[Sign]) -> Sign:
    """The sign of a sum."""
    signs = list(signs)
    if not signs:
        return Sign.UNKNOWN
    if all(sign > 0 for sign in signs):
        return max(signs)
    if all(sign < 0 for sign in signs):
        return min(signs)
    return Sign.UNKNOWN


def multiples(poly: Poly, other: Poly) -> Iterator[Poly]:
    """Monomials m such that m · other has a term of poly; constants only for long polynomials."""
    long = len(other) * len(poly) > MANY
    seen = set()
    for exponents, number in other.to_dict().items():
        for own, coefficient in poly.to_dict().items():
            powers = tuple(o - e for o, e in zip(own, exponents, strict=True))
            key = powers, str(coefficient / number)
            if min(powers, default=0) < 0 or (any(powers) and long) or key in seen:
                continue
            seen.add(key)
            yield poly.context().from_dict({powers: coefficient / number})


def _ratio(poly: Poly, other: Poly) -> fmpq | None:
    """The constant ratio of two polynomials; None if they are not proportional."""
    if not other or not poly or len(poly) != len(other):
        return None
    ratio = poly.leading_coefficient() / other.leading_coefficient()
    return ratio if poly == ratio * other else None
