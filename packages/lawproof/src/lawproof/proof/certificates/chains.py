"""Triangular chains of polynomials, with the cofactors of each element in the given equations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from flint import fmpq_mpoly_ctx

from flowlanes.formulas.errors import OutOfReachError

from ..fields.budget import Budget
from ..fields.quotient_ring import Poly, initial_of
from ..fields.root_field import MOST_TERMS_OF_CONJUGATES
from .groebner import Multiples
from .sign_reasons import Reasons, monic

MOST_TERMS = 400_000


@dataclass(frozen=True)
class Combination:
    """A polynomial Σ multiplier_i · equation_i with its multipliers."""

    poly: Poly
    by: Mapping[int, Poly]

    def times(self, factor: Poly) -> Combination:
        """The product with a polynomial."""
        return Combination(self.poly * factor, {i: m * factor for i, m in self.by.items()})

    def minus(self, other: Combination) -> Combination:
        """The difference of two combinations."""
        by = dict(self.by)
        for i, m in other.by.items():
            by[i] = by[i] - m if i in by else -m
        return Combination(self.poly - other.poly, {i: m for i, m in by.items() if m})


@dataclass(frozen=True)
class Division:
    """A pseudo-division: ∏ multipliers · poly = Σ by_i · equation_i + rest."""

    multipliers: tuple[Poly, ...]
    by: Mapping[int, Poly]
    rest: Poly


@dataclass(frozen=True)
class Step:
    """An element of a chain, with its main variable, degree in it and initial."""

    main: int
    combination: Combination
    degree: int
    lead: Poly


@dataclass
class Chains:
    """Triangular chains of equations, and division by them.

    Parameters
    ----------
    reasons : Reasons
        Known signs and non-vanishing polynomials.
    moving : set of int
        Generators that are state variables.
    """

    ring: fmpq_mpoly_ctx
    reasons: Reasons
    moving: frozenset[int]
    budget: Budget

    def quotients(self, poly: Poly, equations: Sequence[Poly]) -> Mapping[int, Poly] | None:
        """Quotients of a polynomial by the equations; None if no exact division was found."""
        if not poly:
            return {}
        chain, contradiction = self.chain(tuple(equations), ())
        if contradiction is not None:
            return None
        division = self.division(poly, chain)
        return None if division.multipliers or division.rest else division.by

    def chain(
        self, equations: Sequence[Poly], nonzero: Sequence[Poly]
    ) -> tuple[list[Step], Combination | None]:
        """The chain, highest main variable first, or a combination that is zero but cannot be."""
        one = self.ring.constant(1)
        waiting = [Combination(e, {i: one}) for i, e in enumerate(equations)]
        chain: list[Step] = []
        # Ritt's procedure: reduce the remaining equations by the chain, then extend the chain by
        # the equation and main variable of least cost, until nothing is left.
        while True:
            waiting = [self._remainder(g, chain) for g in waiting]
            waiting = [g for g in waiting if g.poly]
            for g in waiting:
                if g.poly.is_constant() or self.is_nonzero(g.poly, nonzero):
                    return [], g
            choices = [
                (self._merit(g.poly, v, nonzero), i, v)
                for i, g in enumerate(waiting)
                for v in variables(g.poly)
                if _order_of_mains([*((s.main, s.combination.poly) for s in chain), (v, g.poly)])
                is not None
                and all(s.main != v for s in chain)
            ]
            if not choices:
                return self._in_order(chain), None
            _, index, main = min(choices)
            chain = self._in_order([*chain, self._step(waiting.pop(index), main)])

    def _step(self, combination: Combination, main: int) -> Step:
        degree = int(combination.poly.degrees()[main])
        return Step(main, combination, degree, initial_of(combination.poly, main))

    def _in_order(self, chain: list[Step]) -> list[Step]:
        order = _order_of_mains([(step.main, step.combination.poly) for step in chain])
        assert order is not None
        by_main = {step.main: step for step in chain}
        return [by_main[main] for main in order]

    def _merit(self, poly: Poly, main: int, nonzero: Sequence[Poly]) -> tuple[int, int, int]:
        degree = int(poly.degrees()[main])
        # Constant initials first (no case distinction), then initials of parameters alone, then
        # initials of state variables; an initial that may vanish costs a case and comes last.
        lead = initial_of(poly, main)
        if lead.is_constant():
            kind = 0 if degree == 1 else degree - 1
        else:
            moves = bool(self.moving & set(variables(lead)))
            kind = 10 * degree + (len(lead) > 1) + 4 * moves
            kind += 100 * (not self.is_nonzero(lead, nonzero))
        return kind, len(lead), -main

    def _remainder(self, combination: Combination, chain: Sequence[Step]) -> Combination:
        # The combination times all multipliers, minus its part in the chain, is the remainder.
        division = self.division(combination.poly, chain)
        total = self.ring.constant(1)
        for multiplier in division.multipliers:
            total = total * multiplier
        return combination.times(total).minus(
            Combination(combination.poly * total - division.rest, division.by)
        )

    def division(self, poly: Poly, chain: Sequence[Step]) -> Division:
        """Pseudo-division by a chain, with quotients by the original equations."""
        # At each step lc(poly) = t and the initial l of the step are made equal: poly is
        # multiplied by l / gcd(t, l), so that multipliers stay as small as possible, and the
        # leading term cancels.
        multipliers: list[Poly] = []
        quotients: list[Poly] = [self.ring.constant(0)] * len(chain)
        for number, step in enumerate(chain):
            variable = self.ring.gen(step.main)
            while poly and (height := int(poly.degrees()[step.main])) >= step.degree:
                top = initial_of(poly, step.main)
                factor, remainder = divmod(top, step.lead)
                if remainder:
                    shared = top.gcd(step.lead)
                    multiplier = divmod(step.lead, shared)[0]
                    factor = divmod(top, shared)[0]
                    multipliers.append(multiplier)
                    self.budget.foresee(poly, multiplier)
                    poly = poly * multiplier
                    quotients = [q * multiplier for q in quotients]
                factor = factor * variable ** (height - step.degree)
                self.budget.foresee(factor, step.combination.poly)
                poly = poly - factor * step.combination.poly
                quotients[number] = quotients[number] + factor
                if len(poly) > MOST_TERMS:
                    raise OutOfReachError(f"a remainder has more than {MOST_TERMS:,} terms")
        # Substitute step = Σ m_i e_i to obtain the quotients by the equations.
        by: Multiples = {}
        for quotient, step in zip(quotients, chain, strict=True):
            if quotient:
                for i, m in step.combination.by.items():
                    self.budget.foresee(quotient, m)
                    part = quotient * m
                    by[i] = by[i] + part if i in by else part
        return Division(tuple(multipliers), by, poly)

    def with_conjugate(
        self, division: Division, chain: Sequence[Step], nonzero: Sequence[Poly]
    ) -> Division:
        """An exact division of poly times a conjugate of the rest, or the given division.

        The conjugate r̄ of the rest r has the opposite sign of one generator g. If the equations
        fix g², the product r r̄ may reduce to zero; where r̄ ≠ 0 this proves r = 0.
        """
        rest, gens = division.rest, self.ring.gens()
        if not rest or len(rest) > MOST_TERMS_OF_CONJUGATES:
            return division
        for place in variables(rest):
            if rest.degrees()[place] != 1:
                continue
            conjugate = rest.compose(*(-g if i == place else g for i, g in enumerate(gens)))
            if not self.is_nonzero(conjugate, nonzero):
                continue
            further = self.division(rest * conjugate, chain)
            if not further.rest:
                factor = conjugate
                for multiplier in further.multipliers:
                    factor = factor * multiplier
                by = {i: m * factor for i, m in division.by.items()}
                for i, m in further.by.items():
                    by[i] = by[i] + m if i in by else m
                multipliers = (*division.multipliers, conjugate, *further.multipliers)
                return Division(multipliers, by, further.rest)
        return division

    def is_nonzero(self, poly: Poly, nonzero: Sequence[Poly]) -> bool:
        """True if no factor of a polynomial vanishes at a node."""
        if poly.is_constant():
            return bool(poly)
        keys = {monic(p)[0] for p in nonzero}
        return all(
            monic(part)[0] in keys or self.reasons.is_nonzero(part) for part, _ in poly.factor()[1]
        )


def variables(poly: Poly) -> list[int]:
    """Indices of the variables that occur in a polynomial."""
    return [i for i, degree in enumerate(poly.degrees()) if degree]


def _order_of_mains(chain: Sequence[tuple[int, Poly]]) -> list[int] | None:
    """Main variables from highest to lowest; None if they depend on each other cyclically."""
    mains = {main for main, _ in chain}
    needs = {main: (set(variables(poly)) & mains) - {main} for main, poly in chain}
    done: list[int] = []
    while len(done) < len(needs):
        ready = [m for m in needs if m not in done and needs[m] <= set(done)]
        if not ready:
            return None
        done.extend(ready)
    return done[::-1]
