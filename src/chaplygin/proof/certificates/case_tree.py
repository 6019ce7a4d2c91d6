"""Why numerators vanish wherever equations do: a tree of cases, each step an identity.

At a node equations are made triangular, every polynomial of the chain with its cofactors in the
equations, and the numerators are divided by it.  Where that leaves a remainder, or multiplies by
something that may vanish, the node is parted: by the factors of an equation, by a sum of squares,
or by whether an initial vanishes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from flint import fmpq

from ...formulas.errors import OutOfReachError
from ..fields.budget import Budget
from .groebner import Basis
from .sign_reasons import Reasons, Term, monic

__all__ = ["Cases", "Multiples", "Written"]

Poly = Any
Written = dict[str, Any]
#: Polynomials by the number of the equation with which they are multiplied.
Multiples = dict[int, Poly]

MOST_NODES = 120
MOST_TERMS = 400_000
MOST_FOR_A_BASIS = 80
"""Terms of the equations together, up to which a Gröbner basis is tried."""


@dataclass(frozen=True)
class _Tracked:
    """A polynomial Σ multiple · equation."""

    poly: Poly
    by: Mapping[int, Poly]

    def scaled(self, factor: Poly) -> _Tracked:
        return _Tracked(self.poly * factor, {i: m * factor for i, m in self.by.items()})

    def minus(self, other: _Tracked) -> _Tracked:
        by = dict(self.by)
        for i, m in other.by.items():
            by[i] = by[i] - m if i in by else -m
        return _Tracked(self.poly - other.poly, {i: m for i, m in by.items() if m})


@dataclass(frozen=True)
class _Division:
    """multipliers · poly = Σ multiple · equation + rest."""

    multipliers: tuple[Poly, ...]
    by: Mapping[int, Poly]
    rest: Poly


@dataclass(frozen=True)
class _Step:
    main: int
    tracked: _Tracked
    degree: int
    lead: Poly


@dataclass
class Cases:
    """The tree for some numerators.

    Parameters
    ----------
    ring : fmpq_mpoly_ctx
    reasons : Reasons
        What is known of signs, and what does not vanish.
    numerators : sequence of polynomials
    moving : set of int
        Generators that are state variables.
    write : callable
        A polynomial as text.
    left : callable
        The condition of the verdict that excludes the zeros of a polynomial, if one does.
    budget : Budget
    """

    ring: Any
    reasons: Reasons
    numerators: Sequence[Poly]
    moving: frozenset[int]
    write: Any
    left: Any
    budget: Budget
    _nodes: int = field(default=0, init=False)

    def tree(self, equations: Sequence[Poly], nonzero: Sequence[Poly] = ()) -> Written:
        """The tree at a node.

        Raises
        ------
        OutOfReachError
            If there is none, as far as is tried.
        """
        self._nodes += 1
        if self._nodes > MOST_NODES:
            raise OutOfReachError(f"a certificate would have more than {MOST_NODES} cases")
        equations = tuple(equations)
        for equation in equations[::-1]:
            if (condition := self.left(equation)) is not None:
                return {"case": "unproven", "condition": condition}
        chain, contradiction = self._chain(equations, nonzero)
        if contradiction is not None:
            return self._empty(contradiction, equations)
        divisions = [self._divided(poly, chain) for poly in self.numerators]
        exact = not any(division.rest for division in divisions)
        doubtful = list(self._doubtful(divisions, nonzero))
        if exact and not doubtful:
            return self._zero(divisions, equations)
        if (found := self._vanishing_divisor(chain, nonzero)) is not None:
            return self._empty(found, equations)
        if (direct := self._direct(divisions, equations)) is not None:
            return self._zero(direct, equations)
        polys = [_Tracked(e, {i: self.ring.constant(1)}) for i, e in enumerate(equations)]
        polys += [step.tracked for step in chain]
        for tracked in polys:
            if (made := self._split(tracked, equations, nonzero)) is not None:
                return made
        for tracked in polys:
            if (made := self._squares(tracked, equations, nonzero)) is not None:
                return made
        if doubtful:
            return self._vanishing(doubtful[0], equations, nonzero)
        raise OutOfReachError("no certificate: a residual leaves a remainder")

    def _direct(
        self, divisions: Sequence[_Division], equations: Sequence[Poly]
    ) -> list[_Division] | None:
        """The numerators as sums of multiples of equations, without a factor."""
        if sum(map(len, equations)) > MOST_FOR_A_BASIS:
            return None
        basis = Basis(self.ring, equations, self.budget)
        found = []
        for division, poly in zip(divisions, self.numerators, strict=True):
            if not division.multipliers and not division.rest:
                found.append(division)
                continue
            quotients = basis.quotients(poly)
            if quotients is None:
                return None
            found.append(_Division((), quotients, self.ring.constant(0)))
        return found

    def combined(self, poly: Poly, equations: Sequence[Poly]) -> Mapping[int, Poly] | None:
        """Quotients of a polynomial by equations, or None where it is not found to be a sum."""
        if not poly:
            return {}
        chain, contradiction = self._chain(tuple(equations), ())
        if contradiction is not None:
            return None
        division = self._divided(poly, chain)
        return None if division.multipliers or division.rest else division.by

    # --- triangular chains -----------------------------------------------------------------------

    def _chain(
        self, equations: Sequence[Poly], nonzero: Sequence[Poly]
    ) -> tuple[list[_Step], _Tracked | None]:
        """Steps from the highest main variable to the lowest; or what cannot be zero, but is."""
        one = self.ring.constant(1)
        waiting = [_Tracked(e, {i: one}) for i, e in enumerate(equations)]
        chain: list[_Step] = []
        while True:
            waiting = [self._remainder(g, chain) for g in waiting]
            waiting = [g for g in waiting if g.poly]
            for g in waiting:
                if g.poly.is_constant() or self._certain(g.poly, nonzero):
                    return [], g
            choices = [
                (self._merit(g.poly, v, nonzero), i, v)
                for i, g in enumerate(waiting)
                for v in _variables(g.poly)
                if _ordered([*((s.main, s.tracked.poly) for s in chain), (v, g.poly)]) is not None
                and all(s.main != v for s in chain)
            ]
            if not choices:
                return self._sorted(chain), None
            _, index, main = min(choices)
            chain = self._sorted([*chain, self._step(waiting.pop(index), main)])

    def _step(self, tracked: _Tracked, main: int) -> _Step:
        degree = int(tracked.poly.degrees()[main])
        return _Step(main, tracked, degree, self._coefficient(tracked.poly, main, degree))

    def _sorted(self, chain: list[_Step]) -> list[_Step]:
        order = _ordered([(step.main, step.tracked.poly) for step in chain])
        assert order is not None
        by_main = {step.main: step for step in chain}
        return [by_main[main] for main in order]

    def _merit(self, poly: Poly, main: int, nonzero: Sequence[Poly]) -> tuple[int, int, int]:
        degree = int(poly.degrees()[main])
        lead = self._coefficient(poly, main, degree)
        if lead.is_constant():
            kind = 0 if degree == 1 else degree - 1
        else:
            moves = bool(self.moving & set(_variables(lead)))
            kind = 10 * degree + (len(lead) > 1) + 4 * moves
            kind += 100 * (not self._certain(lead, nonzero))
        return kind, len(lead), -main

    def _coefficient(self, poly: Poly, position: int, degree: int) -> Poly:
        found = {}
        for exponents, number in poly.to_dict().items():
            if exponents[position] == degree:
                rest = list(exponents)
                rest[position] = 0
                found[tuple(rest)] = number
        return self.ring.from_dict(found)

    def _remainder(self, tracked: _Tracked, chain: Sequence[_Step]) -> _Tracked:
        division = self._divided(tracked.poly, chain)
        total = self.ring.constant(1)
        for multiplier in division.multipliers:
            total = total * multiplier
        return tracked.scaled(total).minus(
            _Tracked(tracked.poly * total - division.rest, division.by)
        )

    def _divided(self, poly: Poly, chain: Sequence[_Step]) -> _Division:
        """Division by a chain, whose quotients are those by the equations."""
        multipliers: list[Poly] = []
        quotients: list[Poly] = [self.ring.constant(0)] * len(chain)
        for number, step in enumerate(chain):
            variable = self.ring.gen(step.main)
            while poly and (height := int(poly.degrees()[step.main])) >= step.degree:
                top = self._coefficient(poly, step.main, height)
                factor, rest = divmod(top, step.lead)
                if rest:
                    shared = top.gcd(step.lead)
                    multiplier = divmod(step.lead, shared)[0]
                    factor = divmod(top, shared)[0]
                    multipliers.append(multiplier)
                    self.budget.foresee(poly, multiplier)
                    poly = poly * multiplier
                    quotients = [q * multiplier for q in quotients]
                factor = factor * variable ** (height - step.degree)
                self.budget.foresee(factor, step.tracked.poly)
                poly = poly - factor * step.tracked.poly
                quotients[number] = quotients[number] + factor
                if len(poly) > MOST_TERMS:
                    raise OutOfReachError(f"a remainder has more than {MOST_TERMS:,} terms")
        by: Multiples = {}
        for quotient, step in zip(quotients, chain, strict=True):
            if quotient:
                for i, m in step.tracked.by.items():
                    self.budget.foresee(quotient, m)
                    part = quotient * m
                    by[i] = by[i] + part if i in by else part
        return _Division(tuple(multipliers), by, poly)

    # --- what does not vanish --------------------------------------------------------------------

    def _certain(self, poly: Poly, nonzero: Sequence[Poly]) -> bool:
        """Whether no factor of a polynomial vanishes at a node."""
        if poly.is_constant():
            return bool(poly)
        keys = {monic(p)[0] for p in nonzero}
        return all(
            monic(part)[0] in keys or self.reasons.is_nonzero(part) for part, _ in poly.factor()[1]
        )

    def _doubtful(self, divisions: Iterable[_Division], nonzero: Sequence[Poly]) -> Iterator[Poly]:
        """Factors of multipliers that may vanish, each once."""
        seen = set()
        for division in divisions:
            for multiplier in division.multipliers:
                for part, _ in multiplier.factor()[1]:
                    if str(part) not in seen and not self._certain(part, nonzero):
                        seen.add(str(part))
                        yield part

    def _vanishing_divisor(
        self, chain: Sequence[_Step], nonzero: Sequence[Poly]
    ) -> _Tracked | None:
        """A multiple of the equations that is a product of what does not vanish."""
        for poly in (*nonzero, *self.reasons.divisors):
            division = self._divided(poly, chain)
            if not division.rest and all(self._certain(m, nonzero) for m in division.multipliers):
                total = poly
                for multiplier in division.multipliers:
                    total = total * multiplier
                return _Tracked(total, division.by)
        return None

    # --- cases -----------------------------------------------------------------------------------

    def _quotients(self, by: Mapping[int, Poly], equations: Sequence[Poly]) -> list[Any]:
        return [self.write(by[i]) if i in by else [] for i in range(len(equations))]

    def _powers(self, polys: Iterable[Poly]) -> tuple[fmpq, list[tuple[Poly, int]]]:
        """Content and irreducible factors of a product."""
        content = fmpq(1)
        found: dict[str, tuple[Poly, int]] = {}
        for poly in polys:
            if poly.is_constant():
                content *= poly.leading_coefficient()
                continue
            number, parts = poly.factor()
            content *= number
            for part, power in parts:
                _, known = found.get(str(part), (part, 0))
                found[str(part)] = part, known + int(power)
        return content, list(found.values())

    def _written(self, powers: Iterable[tuple[Poly, int]]) -> list[Any]:
        return [[self.write(poly), power] for poly, power in powers]

    def _empty(self, tracked: _Tracked, equations: Sequence[Poly]) -> Written:
        content, powers = self._powers([tracked.poly])
        return {
            "case": "empty",
            "factors": self._written(powers),
            "constant": str(content),
            "quotients": self._quotients(tracked.by, equations),
        }

    def _zero(self, divisions: Sequence[_Division], equations: Sequence[Poly]) -> Written:
        identities = []
        for number, division in enumerate(divisions):
            content, powers = self._powers(division.multipliers)
            identities.append(
                {
                    "residual": number,
                    "factors": self._written(powers),
                    "constant": str(content),
                    "quotients": self._quotients(division.by, equations),
                }
            )
        return {"case": "zero", "identities": identities}

    def _split(
        self, tracked: _Tracked, equations: Sequence[Poly], nonzero: Sequence[Poly]
    ) -> Written | None:
        if not tracked.poly or tracked.poly.is_constant():
            return None
        content, parts = tracked.poly.factor()
        if len(parts) == 1 and parts[0][1] == 1:
            return None
        open_parts = [part for part, _ in parts if not self._certain(part, nonzero)]
        known = {monic(e)[0] for e in equations if not e.is_constant()}
        if any(monic(part)[0] in known for part in open_parts):
            return None
        return {
            "case": "split",
            "polynomial": self.write(tracked.poly),
            "factors": self._written((part, int(power)) for part, power in parts),
            "constant": str(content),
            "by": [],
            "quotients": self._quotients(tracked.by, equations),
            "children": [self.tree((*equations, part), nonzero) for part in open_parts],
        }

    def _squares(
        self, tracked: _Tracked, equations: Sequence[Poly], nonzero: Sequence[Poly]
    ) -> Written | None:
        if not tracked.poly:
            return None
        for sign in (1, -1):
            terms = self.reasons.squares(sign * tracked.poly)
            if terms is None or not self._new(terms, equations):
                continue
            bases = [term.base for term in terms]
            return {
                "case": "squares",
                "polynomial": self.write(sign * tracked.poly),
                "by": [],
                "quotients": self._quotients(
                    {i: sign * m for i, m in tracked.by.items()}, equations
                ),
                "terms": [
                    [self._written(term.weights), str(term.constant), [self.write(term.base)]]
                    for term in terms
                ],
                "child": self.tree((*equations, *bases), nonzero),
            }
        return None

    def _new(self, terms: Sequence[Term], equations: Sequence[Poly]) -> bool:
        """Whether the bases of squares say something that the equations do not."""
        known = {monic(e)[0] for e in equations if e and not e.is_constant()}
        return any(t.base.is_constant() or monic(t.base)[0] not in known for t in terms)

    def _vanishing(self, poly: Poly, equations: Sequence[Poly], nonzero: Sequence[Poly]) -> Written:
        return {
            "case": "vanishing",
            "polynomial": self.write(poly),
            "nonzero": self.tree(equations, (*nonzero, poly)),
            "zero": self.tree((*equations, poly), nonzero),
        }


def _variables(poly: Poly) -> list[int]:
    return [i for i, degree in enumerate(poly.degrees()) if degree]


def _ordered(chain: Sequence[tuple[int, Poly]]) -> list[int] | None:
    """Main variables from the highest to the lowest; None if they need each other in a circle."""
    mains = {main for main, _ in chain}
    needs = {main: (set(_variables(poly)) & mains) - {main} for main, poly in chain}
    done: list[int] = []
    while len(done) < len(needs):
        ready = [m for m in needs if m not in done and needs[m] <= set(done)]
        if not ready:
            return None
        done.extend(ready)
    return done[::-1]
