"""Signs of polynomials on the domain of a system.

Known are the signs of parameters and of other quantities that the system declares (admissible
sets, guards, assumptions of symbols), and what follows from them term by term.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum

from flint import fmpq, fmpq_mpoly_ctx

from .quotient_ring import Poly

MANY = 400
"""Polynomials of more terms are not compared with facts."""


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
    """Known signs in one ring of polynomials.

    Parameters
    ----------
    symbol_signs : mapping of str to Sign
        Signs of generators.
    facts : sequence of (polynomial, Sign)
        Further polynomials with a known sign.
    nonzero : sequence of polynomials
        Polynomials that do not vanish, whatever their sign.
    conditions : sequence of polynomials
        Polynomials that vanish.
    """

    ring: fmpq_mpoly_ctx
    symbol_signs: Mapping[str, Sign]
    facts: Sequence[tuple[Poly, Sign]] = ()
    nonzero: Sequence[Poly] = ()
    conditions: Sequence[Poly] = ()

    def with_positive(self, name: str) -> Signs:
        """The signs, with one more positive generator."""
        return replace(self, symbol_signs={**self.symbol_signs, name: Sign.POSITIVE})

    def of(self, poly: Poly) -> Sign:
        """The sign of a polynomial wherever the facts and the conditions hold."""
        sign = self._of_one(poly)
        if abs(sign) < Sign.POSITIVE and poly and len(poly) <= MANY:
            content, parts = poly.factor()
            if len(parts) > 1 or any(power > 1 for _, power in parts):
                product = _number(content)
                for part, power in parts:
                    product = product.times(self._of_power(part, int(power)))
                sign = product or sign
        return sign

    def never_zero(self, poly: Poly) -> bool:
        """Whether a polynomial is certainly not zero."""
        if abs(self.of(poly)) == Sign.POSITIVE:
            return True
        return self._said_nonzero(poly)

    def _said_nonzero(self, poly: Poly) -> bool:
        return any(_ratio(poly, fact) is not None for fact in self.nonzero)

    def _of_power(self, poly: Poly, power: int) -> Sign:
        sign = self._of_one(poly)
        if power % 2:
            return sign
        strict = abs(sign) == Sign.POSITIVE or self._said_nonzero(poly)
        return Sign.POSITIVE if strict else Sign.NOT_NEGATIVE

    def squares(self, poly: Poly) -> list[Poly] | None:
        """Polynomials that all vanish where `poly` does, if it is a sum of terms of one sign.

        ``[1]`` where it cannot vanish; None where it is no such sum.
        """
        terms = [self._term(exponents, number) for exponents, number in poly.to_dict().items()]
        if all(sign > 0 for sign, _ in terms) or all(sign < 0 for sign, _ in terms):
            return [base for _, base in terms]
        return self._linear_squares(poly)

    def _of_one(self, poly: Poly) -> Sign:
        sign = self._by_terms(poly)
        if sign is Sign.UNKNOWN and len(poly) <= MANY:
            sign = self._by_facts(poly) or self._by_conditions(poly) or self._by_squares(poly)
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
        """The sign of a term where it does not vanish, and a monomial that vanishes with it."""
        sign, base = _number(number), self.ring.constant(1)
        for index, exponent in enumerate(exponents):
            if not exponent:
                continue
            own = self.symbol_signs.get(self.ring.name(index), Sign.UNKNOWN)
            if abs(own) != Sign.POSITIVE:
                base = base * self.ring.gen(index)
            if exponent % 2:
                sign = sign.times(own) if own else Sign.UNKNOWN
                if sign is Sign.UNKNOWN:
                    return sign, base
                sign = Sign(2 if sign > 0 else -2)
        return sign, base

    def _by_facts(self, poly: Poly) -> Sign:
        """A fact times a term of known sign, and further terms of the same sign."""
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
        """The sign after a multiple of a condition by a term has taken one term away."""
        for condition in self.conditions:
            for share in multiples(poly, condition):
                sign = self._by_terms(poly - share * condition)
                if sign:
                    return sign
        return Sign.UNKNOWN

    def _by_squares(self, poly: Poly) -> Sign:
        for sign in (Sign.POSITIVE, Sign.NEGATIVE):
            bases = self._linear_squares(poly if sign > 0 else -poly, definite=True)
            if bases is not None:
                strict = any(base.is_constant() for base in bases)
                return sign if strict else Sign(sign // 2)
        return Sign.UNKNOWN

    def _linear_squares(self, poly: Poly, definite: bool = False) -> list[Poly] | None:
        """Linear forms whose squares, with positive weights, add up to a quadratic polynomial."""
        if not poly or poly.total_degree() != 2:
            return None
        for signed in (poly,) if definite else (poly, -poly):
            forms = completed_squares(signed, self.ring)
            if forms is not None:
                return [base for _, base in forms]
        return None


def _number(value: fmpq) -> Sign:
    return Sign(2 * ((value > 0) - (value < 0)))


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
    """Terms by which one polynomial has a term of another; of many terms, numbers alone."""
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
    """The number by which one polynomial is a multiple of another."""
    if not other or not poly or len(poly) != len(other):
        return None
    ratio = poly.leading_coefficient() / other.leading_coefficient()
    return ratio if poly == ratio * other else None


def completed_squares(poly: Poly, ring: fmpq_mpoly_ctx) -> list[tuple[fmpq, Poly]] | None:
    """Weights and linear forms whose weighted squares add up to a quadratic polynomial.

    Squares are completed one variable after the other; None unless all weights are positive.
    The last form is 1 where a positive number remains.
    """
    forms: list[tuple[fmpq, Poly]] = []
    remainder = poly
    for index in range(ring.nvars()):
        if not remainder or not int(remainder.degrees()[index]):
            continue
        parts: dict[int, dict[tuple[int, ...], fmpq]] = {1: {}, 2: {}}
        for exponents, number in remainder.to_dict().items():
            power = int(exponents[index])
            if power:
                lower = tuple(0 if i == index else int(e) for i, e in enumerate(exponents))
                parts[power][lower] = number
        square = ring.from_dict(parts[2]) if parts[2] else ring.constant(0)
        if not square or not square.is_constant() or not square.leading_coefficient() > 0:
            return None
        weight = square.leading_coefficient()
        base = ring.gen(index) + ring.from_dict(parts[1]) / (2 * weight)
        forms.append((weight, base))
        remainder = remainder - weight * base * base
    if remainder:
        if not remainder.leading_coefficient() > 0:
            return None
        forms.append((remainder.leading_coefficient(), ring.constant(1)))
    return forms
