"""Reasons for the signs of polynomials, in the form a certificate states them.

The known signs (see :mod:`lawproof.proof.fields.signs`) are written as sums: modulo the equations,
a polynomial is a sum of terms c ∏ part^power · base² with c > 0 and positive parts.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from flint import fmpq, fmpq_mpoly_ctx

from ..fields.positive_forms import (
    completed_squares,
    in_one_variable,
    less_a_multiple,
    meets,
    only_variable,
    signs_in_one_variable,
)
from ..fields.quotient_ring import Poly
from ..fields.signs import MANY, multiples

Powers = tuple[tuple[Poly, int], ...]


def monic(poly: Poly) -> tuple[str, int]:
    """A key that is common to all multiples of a polynomial, and its leading sign."""
    lead = poly.leading_coefficient()
    return str(poly / lead), 1 if lead > 0 else -1


@dataclass(frozen=True)
class Term:
    """The term constant · ∏ weight^power · base²."""

    weights: Powers
    constant: fmpq
    base: Poly


@dataclass(frozen=True)
class Sum:
    """A positive polynomial as Σ terms + Σ multiplier_i · equation_i.

    If `strict` is False the sum may be zero.
    """

    poly: Poly
    terms: tuple[Term, ...]
    multiples: tuple[tuple[int, Poly], ...] = ()
    strict: bool = True


@dataclass(frozen=True)
class InOneVariable:
    """A polynomial that is positive wherever other polynomials in the same variable are."""

    poly: Poly
    facts: tuple[Poly, ...]


@dataclass
class Reasons:
    """Signs of polynomials of one ring, with the reasons for them.

    Parameters
    ----------
    facts : list of (polynomial, str, bool)
        Positive or non-negative polynomials, their sources, and whether they are strict.
    equations : mapping of number to polynomial
        Polynomials that vanish for every choice of signs. The equation of a root is not among
        them, since the root is real only where its radicand is non-negative.
    nonzero : set of str
        Keys of polynomials that do not vanish on the domain of the law.
    divisors : list of polynomials
        The non-vanishing polynomials themselves.
    """

    ring: fmpq_mpoly_ctx
    facts: list[tuple[Poly, str, bool]]
    equations: Mapping[int, Poly] = field(default_factory=dict)
    nonzero: set[str] = field(default_factory=set)
    divisors: list[Poly] = field(default_factory=list)
    #: Strict signs by key, as far as they are known.
    known_signs: dict[str, int] = field(default_factory=dict)
    #: Sums that prove them, in the order in which they were found.
    sums: list[Sum | InOneVariable] = field(default_factory=list)
    _open: set[str] = field(default_factory=set)
    _unknown: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        for poly, _, strict in self.facts:
            if strict:
                self.learn(poly, 1)

    def learn(self, poly: Poly, sign: int) -> None:
        """Store a sign that is known or assumed."""
        key, lead = monic(poly)
        self.known_signs[key] = sign * lead
        # A new sign may decide polynomials that were undecided before.
        self._unknown.clear()

    def is_nonzero(self, poly: Poly) -> bool:
        """True if a polynomial does not vanish on the domain of the law."""
        if poly.is_constant():
            return bool(poly)
        key = monic(poly)[0]
        if key in self.nonzero or self.sign(poly):
            return True
        divides = any(strict and not divmod(fact, poly)[1] for fact, _, strict in self.facts)
        if divides or (only_variable(poly) is not None and self._in_one_variable(poly**2)):
            self.nonzero.add(key)
        return key in self.nonzero

    def sign(self, poly: Poly) -> int:
        """The strict sign of a polynomial; 0 if unknown."""
        if poly.is_constant():
            return 0 if not poly else 1 if poly.leading_coefficient() > 0 else -1
        key, lead = monic(poly)
        if key in self.known_signs:
            return self.known_signs[key] * lead
        # Polynomials in work are skipped, so that the recursion ends.
        if key in self._open or key in self._unknown or len(poly) > MANY:
            return 0
        self._open.add(key)
        try:
            total = self._sum_of(poly)
        finally:
            self._open.discard(key)
        if total is not None:
            self.sums.append(total)
            self.known_signs[key] = monic(total.poly)[1]
        elif not (self._in_one_variable(poly) or self._in_one_variable(-poly)):
            self._unknown.add(key)
            return 0
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
            whole = whole or self._by_multiples(signed)
            if whole is not None:
                return whole
        if key in self.nonzero:
            for signed in (poly, -poly):
                if (terms := self.squares(signed)) is not None:
                    return Sum(signed, terms)
        return None

    def _in_one_variable(self, poly: Poly) -> bool:
        """True if other polynomials in its only variable imply that a polynomial is positive."""
        position, key = only_variable(poly), str(poly)
        if position is None or key in self._unknown:
            return False
        parts, one = [], self.ring.constant(1)
        for fact, _, strict in self.facts:
            parts += self._part(Term(((fact, 1),), fmpq(1), one), position, strict)
        for number, equation in self.equations.items():
            for ratio in (fmpq(1), fmpq(-1)):
                parts += self._part((number, ratio * equation), position, False)
        facts = [(in_one_variable(part.poly, position), part.strict) for part in parts]
        if signs_in_one_variable(in_one_variable(poly, position), facts) != {1}:
            self._unknown.add(key)
            return False
        self.sums += [part for part in parts if part not in self.sums]
        self.sums.append(InOneVariable(poly, tuple(part.poly for part in parts)))
        self.learn(poly, 1)
        return True

    def _part(self, of: Term | tuple[int, Poly], position: int, strict: bool) -> list[Sum]:
        """The univariate part of a positive polynomial, if all other terms are non-positive."""
        whole = of.weights[0][0] if isinstance(of, Term) else of[1]
        own = {
            exponents: number
            for exponents, number in whole.to_dict().items()
            if not any(n for i, n in enumerate(exponents) if i != position)
        }
        part = self.ring.from_dict(own)
        others = self._by_terms(part - whole, strict=False)
        if others is None or not int(part.degrees()[position]):
            return []
        if isinstance(of, Term):
            return [Sum(part, (of, *others), (), strict)]
        ratio = whole.leading_coefficient() / self.equations[of[0]].leading_coefficient()
        return [Sum(part, others, ((of[0], self.ring.constant(ratio)),), False)]

    def _by_multiples(self, poly: Poly) -> Sum | None:
        """A positive polynomial as a multiple of a fact or an equation plus squares."""
        one = self.ring.constant(1)
        open_parts = list(self._open_parts(poly))
        known: list[tuple[Poly, int | None, bool]] = [(f, None, s) for f, _, s in self.facts]
        known += [(equation, number, False) for number, equation in self.equations.items()]
        for other, number, strict in known:
            if not meets(poly, other):
                continue
            for signed, left in open_parts:
                form = less_a_multiple(left, other, self.ring, number is not None)
                if form is None:
                    continue
                ratio, squares = form
                terms = (*signed, *(Term((), weight, base) for weight, base in squares))
                if not (strict or any(self._is_positive(term) for term in terms)):
                    continue
                if number is not None:
                    return Sum(poly, terms, ((number, self.ring.constant(ratio)),))
                return Sum(poly, (Term(((other, 1),), ratio, one), *terms))
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
                if not sign and not strict:
                    sign = self._weak_sign(generator)
                if sign:
                    weights.append((generator if sign > 0 else -generator, exponent))
                    number = number if sign > 0 or exponent % 2 == 0 else -number
                elif strict and exponent % 2 == 0 and self.is_nonzero(generator):
                    weights.append((generator, exponent))
                elif exponent % 2 == 0:
                    base = base * generator ** (exponent // 2)
                else:
                    # An odd power of a generator without a sign decides nothing.
                    return None
            if number < 0:
                return None
            certain = certain or base.is_constant()
            terms.append(Term(tuple(weights), number, base))
        return tuple(terms) if certain else None

    def _weak_sign(self, generator: Poly) -> int:
        """The sign of a generator that a non-strict fact gives."""
        key = monic(generator)[0]
        return next((monic(fact)[1] for fact, _, _ in self.facts if monic(fact)[0] == key), 0)

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
        for number, equation in self.equations.items():
            for share in multiples(poly, equation):
                terms = self._by_terms(poly - share * equation, strict)
                if terms is not None:
                    return Sum(poly, terms, ((number, share),))
        return None

    def _by_squares(self, poly: Poly) -> Sum | None:
        terms = self.squares(poly)
        if terms is None or not any(map(self._is_positive, terms)):
            return None
        return Sum(poly, terms)

    def squares(self, poly: Poly) -> tuple[Term, ...] | None:
        """A polynomial as a sum of non-negative terms; None if not found."""
        terms = self._by_terms(poly, strict=False)
        if terms is not None:
            return terms
        for signed, left in self._open_parts(poly):
            squares = completed_squares(left, self.ring)
            if squares is not None:
                return (*signed, *(Term((), weight, base) for weight, base in squares))
        return None

    def _is_positive(self, term: Term) -> bool:
        """True if a term is strictly positive."""
        return term.base.is_constant() and all(self.is_nonzero(part) for part, _ in term.weights)

    def _open_parts(self, poly: Poly) -> Iterator[tuple[list[Term], Poly]]:
        """A polynomial, and the rest of it after removing terms of known positive sign.

        Each with the terms that were removed.
        """
        yield [], poly
        signed: list[Term] = []
        left = {}
        for exponents, number in poly.to_dict().items():
            own = self.ring.from_dict({exponents: number})
            terms = self._by_terms(own, strict=False) if any(n % 2 for n in exponents) else None
            signed += terms or ()
            if terms is None:
                left[exponents] = number
        if 0 < len(left) < len(poly):
            yield signed, self.ring.from_dict(left)
