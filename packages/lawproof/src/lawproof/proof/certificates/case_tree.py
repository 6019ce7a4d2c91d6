"""Proof that numerators vanish on a variety, as a tree of cases whose steps are identities.

At each node the equations are made triangular (every polynomial of the chain is kept with its
cofactors in the equations) and the numerators are divided by the chain. If a remainder is left, or
a multiplier may vanish, the node branches: over the factors of an equation, over the terms of a
sum of squares, or over whether an initial vanishes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from flint import fmpq

from flowlanes.formulas.errors import OutOfReachError

from ..claim_text import Terms, Text
from ..fields.quotient_ring import Poly
from .chains import Chains, Combination, Division, Step
from .groebner import Basis
from .sign_reasons import Term, monic

MOST_NODES = 120
MOST_FOR_A_BASIS = 80
"""Maximum number of terms of all equations together for which a Gröbner basis is tried."""


@dataclass
class Cases:
    """The tree of cases that proves that the numerators vanish.

    Parameters
    ----------
    chains : Chains
        Chains of the ring, with the known signs.
    write : callable
        Writes a polynomial as text.
    exclusion : callable
        The condition of the verdict that excludes the zeros of a polynomial, or None.
    """

    chains: Chains
    numerators: Sequence[Poly]
    write: Callable[[Poly], Terms]
    exclusion: Callable[[Poly], str | None]
    _nodes: int = field(default=0, init=False)

    def tree(self, equations: Sequence[Poly], nonzero: Sequence[Poly] = ()) -> Text:
        """The subtree for these equations, where the polynomials `nonzero` do not vanish.

        Raises
        ------
        OutOfReachError
            If no tree was found within the limits.
        """
        self._nodes += 1
        if self._nodes > MOST_NODES:
            raise OutOfReachError(f"a certificate would have more than {MOST_NODES} cases")
        equations = tuple(equations)
        for equation in equations[::-1]:
            if (condition := self.exclusion(equation)) is not None:
                return {"case": "unproven", "condition": condition}
        chain, contradiction = self.chains.chain(equations, nonzero)
        if contradiction is not None:
            return self._empty(contradiction, equations)
        # m · p = Σ q_i e_i + r for each numerator p: it vanishes if r = 0 and no multiplier does.
        divisions = [
            self.chains.with_conjugate(self.chains.division(poly, chain), chain, nonzero)
            for poly in self.numerators
        ]
        exact = not any(division.rest for division in divisions)
        doubtful = list(self._doubtful(divisions, nonzero))
        if exact and not doubtful:
            return self._zero(divisions, equations)
        # A product of non-vanishing factors in the ideal: the node has no points.
        if (multiple := self._vanishing_divisor(chain, nonzero)) is not None:
            return self._empty(multiple, equations)
        # The chain multiplies by initials; a Gröbner basis may represent the numerators without
        # them.
        if (direct := self._direct(divisions, equations)) is not None:
            return self._zero(direct, equations)
        polys = [Combination(e, {i: self.chains.ring.constant(1)}) for i, e in enumerate(equations)]
        polys += [step.combination for step in chain]
        for combination in polys:
            if (node := self._split(combination, equations, nonzero)) is not None:
                return node
        for combination in polys:
            if (node := self._squares(combination, equations, nonzero)) is not None:
                return node
        if doubtful:
            return self._vanishing(doubtful[0], equations, nonzero)
        raise OutOfReachError("no certificate: a residual leaves a remainder")

    def _direct(
        self, divisions: Sequence[Division], equations: Sequence[Poly]
    ) -> list[Division] | None:
        """The numerators as combinations of the equations without multipliers, or None."""
        if sum(map(len, equations)) > MOST_FOR_A_BASIS:
            return None
        basis = Basis(self.chains.ring, equations, self.chains.budget)
        exact_divisions = []
        for division, poly in zip(divisions, self.numerators, strict=True):
            if not division.multipliers and not division.rest:
                exact_divisions.append(division)
                continue
            quotients = basis.quotients(poly)
            if quotients is None:
                return None
            exact_divisions.append(Division((), quotients, self.chains.ring.constant(0)))
        return exact_divisions

    def _doubtful(self, divisions: Iterable[Division], nonzero: Sequence[Poly]) -> Iterator[Poly]:
        """Factors of the multipliers that may vanish, without repetition."""
        seen = set()
        for division in divisions:
            for multiplier in division.multipliers:
                for part, _ in multiplier.factor()[1]:
                    if str(part) not in seen and not self.chains.is_nonzero(part, nonzero):
                        seen.add(str(part))
                        yield part

    def _vanishing_divisor(
        self, chain: Sequence[Step], nonzero: Sequence[Poly]
    ) -> Combination | None:
        """A combination of the equations equal to a product of non-vanishing factors, or None."""
        for poly in (*nonzero, *self.chains.reasons.divisors):
            division = self.chains.division(poly, chain)
            if not division.rest and all(
                self.chains.is_nonzero(m, nonzero) for m in division.multipliers
            ):
                total = poly
                for multiplier in division.multipliers:
                    total = total * multiplier
                return Combination(total, division.by)
        return None

    def _quotient_texts(self, by: Mapping[int, Poly], equations: Sequence[Poly]) -> list[Terms]:
        return [self.write(by[i]) if i in by else [] for i in range(len(equations))]

    def _powers(self, polys: Iterable[Poly]) -> tuple[fmpq, list[tuple[Poly, int]]]:
        """Content and irreducible factors of a product."""
        content = fmpq(1)
        powers: dict[str, tuple[Poly, int]] = {}
        for poly in polys:
            if poly.is_constant():
                content *= poly.leading_coefficient()
                continue
            number, parts = poly.factor()
            content *= number
            for part, power in parts:
                _, known = powers.get(str(part), (part, 0))
                powers[str(part)] = part, known + int(power)
        return content, list(powers.values())

    def _powers_text(self, powers: Iterable[tuple[Poly, int]]) -> list[list[object]]:
        return [[self.write(poly), power] for poly, power in powers]

    def _empty(self, combination: Combination, equations: Sequence[Poly]) -> Text:
        content, powers = self._powers([combination.poly])
        return {
            "case": "empty",
            "factors": self._powers_text(powers),
            "constant": str(content),
            "quotients": self._quotient_texts(combination.by, equations),
        }

    def _zero(self, divisions: Sequence[Division], equations: Sequence[Poly]) -> Text:
        identities = []
        for number, division in enumerate(divisions):
            content, powers = self._powers(division.multipliers)
            identities.append(
                {
                    "residual": number,
                    "factors": self._powers_text(powers),
                    "constant": str(content),
                    "quotients": self._quotient_texts(division.by, equations),
                }
            )
        return {"case": "zero", "identities": identities}

    def _split(
        self, combination: Combination, equations: Sequence[Poly], nonzero: Sequence[Poly]
    ) -> Text | None:
        if not combination.poly or combination.poly.is_constant():
            return None
        content, parts = combination.poly.factor()
        if len(parts) == 1 and parts[0][1] == 1:
            return None
        open_parts = [part for part, _ in parts if not self.chains.is_nonzero(part, nonzero)]
        # A factor that is an equation already would lead back to this node.
        known = {monic(e)[0] for e in equations if not e.is_constant()}
        if any(monic(part)[0] in known for part in open_parts):
            return None
        return {
            "case": "split",
            "polynomial": self.write(combination.poly),
            "factors": self._powers_text((part, int(power)) for part, power in parts),
            "constant": str(content),
            "by": [],
            "quotients": self._quotient_texts(combination.by, equations),
            "children": [self.tree((*equations, part), nonzero) for part in open_parts],
        }

    def _squares(
        self, combination: Combination, equations: Sequence[Poly], nonzero: Sequence[Poly]
    ) -> Text | None:
        if not combination.poly:
            return None
        for sign in (1, -1):
            terms = self.chains.reasons.squares(sign * combination.poly)
            if terms is None or not self._new(terms, equations):
                continue
            bases = [term.base for term in terms]
            return {
                "case": "squares",
                "polynomial": self.write(sign * combination.poly),
                "by": [],
                "quotients": self._quotient_texts(
                    {i: sign * m for i, m in combination.by.items()}, equations
                ),
                "terms": [
                    [self._powers_text(term.weights), str(term.constant), [self.write(term.base)]]
                    for term in terms
                ],
                "child": self.tree((*equations, *bases), nonzero),
            }
        return None

    def _new(self, terms: Sequence[Term], equations: Sequence[Poly]) -> bool:
        """True if a base is new, that is, not among the equations up to a constant."""
        known = {monic(e)[0] for e in equations if e and not e.is_constant()}
        return any(t.base.is_constant() or monic(t.base)[0] not in known for t in terms)

    def _vanishing(self, poly: Poly, equations: Sequence[Poly], nonzero: Sequence[Poly]) -> Text:
        return {
            "case": "vanishing",
            "polynomial": self.write(poly),
            "nonzero": self.tree(equations, (*nonzero, poly)),
            "zero": self.tree((*equations, poly), nonzero),
        }
