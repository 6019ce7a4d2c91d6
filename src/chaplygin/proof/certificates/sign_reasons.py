"""Reasons for the signs of polynomials, as a certificate states them.

The known signs (see :mod:`chaplygin.proof.fields.signs`) are written as sums: a polynomial is
a sum of terms c ∏ part^power · base² with c > 0 and parts that are positive themselves, up to
multiples of equations.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from flint import fmpq, fmpq_mpoly_ctx

from ..fields.quotient_ring import Poly
from ..fields.signs import MANY, completed_squares, multiples

Powers = tuple[tuple[Poly, int], ...]


def monic(poly: Poly) -> tuple[str, int]:
    """A key that a polynomial shares with its multiples, and its leading sign."""
    lead = poly.leading_coefficient()
    return str(poly / lead), 1 if lead > 0 else -1


@dataclass(frozen=True)
class Term:
    """constant · ∏ weight^power · base²."""

    weights: Powers
    constant: fmpq
    base: Poly


@dataclass(frozen=True)
class Sum:
    """A positive polynomial as a sum of terms, plus factors times equations by their number."""

    poly: Poly
    terms: tuple[Term, ...]
    multiples: tuple[tuple[int, Poly], ...] = ()


@dataclass
class Reasons:
    """Signs of polynomials of one ring, with what shows them.

    Parameters
    ----------
    facts : list of (polynomial, str, bool)
        Positive (strictly or not), and the reason.
    equations : sequence of polynomials
        Vanish.
    nonzero : set of str
        Keys of polynomials that do not vanish where the law is defined.
    divisors : list of polynomials
        The polynomials themselves.
    """

    ring: fmpq_mpoly_ctx
    facts: list[tuple[Poly, str, bool]]
    equations: Sequence[Poly] = ()
    nonzero: set[str] = field(default_factory=set)
    divisors: list[Poly] = field(default_factory=list)
    #: Strict signs by key, once they are known.
    known_signs: dict[str, int] = field(default_factory=dict)
    #: Sums that show them, in the order in which they were found.
    sums: list[Sum] = field(default_factory=list)
    _open: set[str] = field(default_factory=set)
    _unknown: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        for poly, _, strict in self.facts:
            if strict:
                self.learn(poly, 1)

    def learn(self, poly: Poly, sign: int) -> None:
        """A sign that is known or assumed."""
        key, lead = monic(poly)
        self.known_signs[key] = sign * lead
        self._unknown.clear()

    def is_nonzero(self, poly: Poly) -> bool:
        """Whether a polynomial does not vanish where the law is defined."""
        if poly.is_constant():
            return bool(poly)
        return monic(poly)[0] in self.nonzero or bool(self.sign(poly))

    def sign(self, poly: Poly) -> int:
        """The strict sign of a polynomial; 0 if it is not known."""
        if poly.is_constant():
            return 0 if not poly else 1 if poly.leading_coefficient() > 0 else -1
        key, lead = monic(poly)
        if key in self.known_signs:
            return self.known_signs[key] * lead
        if key in self._open or key in self._unknown or len(poly) > MANY:
            return 0
        self._open.add(key)
        try:
            total = self._sum_of(poly)
        finally:
            self._open.discard(key)
        if total is None:
            self._unknown.add(key)
            return 0
        self.sums.append(total)
        self.known_signs[key] = monic(total.poly)[1]
        return self.known_signs[key] * lead

    def _sum_of(self, poly: Poly) -> Sum | None:
        key = monic(poly)[0]
        for fact, _, strict in self.facts:
            if not strict and monic(fact)[0] == key and key in self.nonzero:
                return Sum(fact, (Term(((fact, 1),), fmpq(1), self.ring.constant(1)),))
        for signed in (poly, -poly):
            if (terms := self._by_terms(signed)) is not None:
                return Sum(signed, terms)
        product = self._by_factors(poly)
        if product is not None:
            return product
        for signed in (poly, -poly):
            whole = self._by_facts(signed) or self._by_equations(signed) or self._by_squares(signed)
            if whole is not None:
                return whole
        if key in self.nonzero:
            for signed in (poly, -poly):
                if (terms := self.squares(signed)) is not None:
                    return Sum(signed, terms)
        return None

    def _by_terms(self, poly: Poly, strict: bool = True) -> tuple[Term, ...] | None:
        terms = []
        certain = not strict
        for exponents, coefficient in poly.to_dict().items():
            number = coefficient
            weights: list[tuple[Poly, int]] = []
            base = self.ring.constant(1)
            for i, exponent in enumerate(map(int, exponents)):
                if not exponent:
                    continue
                generator = self.ring.gen(i)
                sign = self.known_signs.get(monic(generator)[0], 0)
                if sign:
                    weights.append((generator if sign > 0 else -generator, exponent))
                    number = number if sign > 0 or exponent % 2 == 0 else -number
                elif exponent % 2 == 0 and self.is_nonzero(generator):
                    weights.append((generator, exponent))
                elif exponent % 2 == 0:
                    base = base * generator ** (exponent // 2)
                else:
                    return None
            if number < 0:
                return None
            certain = certain or base.is_constant()
            terms.append(Term(tuple(weights), number, base))
        return tuple(terms) if certain else None

    def _by_factors(self, poly: Poly) -> Sum | None:
        content, parts = poly.factor()
        if len(parts) == 1 and parts[0][1] == 1:
            return None
        weights = []
        for part, power in parts:
            sign = self.sign(part)
            if not sign and (power % 2 or not self.is_nonzero(part)):
                return None
            if sign < 0 and power % 2:
                content = -content
            weights.append((-part if sign < 0 else part, int(power)))
        term = Term(tuple(weights), abs(content), self.ring.constant(1))
        return Sum(poly if content > 0 else -poly, (term,))

    def _by_facts(self, poly: Poly) -> Sum | None:
        for fact, _, strict in self.facts:
            for exponents, number in fact.to_dict().items():
                own = poly[exponents] if exponents in poly else fmpq(0)
                if own == 0 or not strict or not own / number > 0:
                    continue
                ratio = own / number
                terms = self._by_terms(poly - ratio * fact, strict=False)
                if terms is not None:
                    first = Term(((fact, 1),), ratio, self.ring.constant(1))
                    return Sum(poly, (first, *terms))
        return None

    def _by_equations(self, poly: Poly) -> Sum | None:
        strict = monic(poly)[0] not in self.nonzero
        for number, equation in enumerate(self.equations):
            for share in multiples(poly, equation):
                terms = self._by_terms(poly - share * equation, strict)
                if terms is not None:
                    return Sum(poly, terms, ((number, share),))
        return None

    def _by_squares(self, poly: Poly) -> Sum | None:
        terms = self.squares(poly)
        if terms is None or not any(term.base.is_constant() for term in terms):
            return None
        return Sum(poly, terms)

    def squares(self, poly: Poly) -> tuple[Term, ...] | None:
        """A polynomial as a sum of terms none of which is negative."""
        terms = self._by_terms(poly, strict=False)
        if terms is not None:
            return terms
        if not poly or poly.total_degree() != 2:
            return None
        forms = completed_squares(poly, self.ring)
        if forms is None:
            return None
        return tuple(Term((), weight, base) for weight, base in forms)
