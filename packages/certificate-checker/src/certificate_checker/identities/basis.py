"""Basis of a proof: equations, divisors and signs, compared with the claim."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from ..claim.errors import CheckError
from ..claim.formulas import Formula
from ..claim.json_data import as_list, field, mapping
from ..claim.polynomials import Poly, monic
from .case_tree import Signs
from .comparisons import Comparisons
from .divisors import Entry, Matches, nonzero_factors, read_divisors
from .equations import Equations
from .generators import Generators
from .positivity import (
    Derived,
    check_radicand_positive,
    factors_of,
    learn_positive,
    read_derived,
    settle,
)
from .roots import check_functions, check_roots, is_radicand


@dataclass(frozen=True)
class Basis:
    """Basis of a proof, verified against the claim.

    Attributes
    ----------
    equations : tuple of Poly
        Polynomials that vanish on the level.
    nonzero : frozenset of str
        Keys of polynomials that are nonzero where the law is defined.
    signs : Signs
        Known signs, including the assumed ones.
    certain : Signs
        Signs that are known without assumptions.
    radicands : tuple of Entry
        Products that are positive where the law is defined, independent of assumed signs.
    """

    generators: Generators
    comparisons: Comparisons
    equations: tuple[Poly, ...]
    nonzero: frozenset[str]
    signs: Signs
    certain: Signs
    radicands: tuple[Entry, ...]


def read_basis(
    data: Mapping[str, object],
    generators: Generators,
    formulas: Iterable[Formula],
    seed: str,
    what: str,
) -> Basis:
    """Equations, divisors and signs of a proof, compared with the claim.

    Parameters
    ----------
    formulas : iterable of formulas
        Formulas that are compared later.
    """
    system = generators.claim.system
    entries = read_divisors(data, generators, what)
    stated = [*system.guards, *generators.claim.conditions, *(f for f, _ in system.admissible)]
    comparisons = Comparisons(
        generators, seed, [(e.content, e.powers) for e in entries], [*formulas, *stated]
    )
    matches = Matches(generators, entries, comparisons)
    # Signs are determined twice, without the assumed ones first, because assumed signs may not
    # justify the claim that all cases are covered.
    certain = Signs()
    knowledge = _Knowledge(data, matches, what)
    knowledge.extend(certain)
    radicands = tuple(matches.radicands)
    signs = certain.copy()
    for poly, sign in generators.signs:
        signs.learn(poly, sign)
    knowledge.extend(signs)
    knowledge.require_all()
    for sample in comparisons.samples:
        sample.require_definitions()
    nonzero = knowledge.nonzero(signs)
    for poly, _ in generators.signs:
        if monic(poly)[0] not in nonzero:
            raise CheckError(f"{what} assumes the sign of something that may vanish")
    known = matches.radicands
    check_roots(generators, signs, nonzero, known, what)
    check_functions(comparisons, nonzero, signs, what)
    for item in knowledge.positives:
        check_radicand_positive(mapping(item, what), generators, signs, what)
    equations = knowledge.equations.verify(nonzero, signs)
    return Basis(generators, comparisons, equations, nonzero, signs, certain, radicands)


class _Knowledge:
    """Signs and divisors, each of which may determine more of the other.

    A formula with a root has a known value once the signs in its radicand are known; these may
    follow from other positive quantities, such as another radicand.
    """

    def __init__(self, data: Mapping[str, object], matches: Matches, what: str) -> None:
        self.matches, self.what = matches, what
        generators = matches.generators
        self.positives = as_list(field(data, "positive", what), f"what is positive in {what}")
        ring = generators.ring
        stated = [mapping(item, what) for item in self.positives]
        self.polys = [ring.read(field(item, "poly", what), what) for item in stated]
        self._derived = read_derived(self.positives, generators, what)
        self.equations = Equations(data, matches.comparisons, what)
        self._reasons: Sequence[CheckError] = ()
        self._open: list[Derived] = []

    def extend(self, signs: Signs) -> None:
        """Learn all signs that follow, and find the divisors that are determined by them."""
        self.matches.comparisons.set_signs(signs)
        waiting = [*self.positives]
        changed = True
        # Both sets only grow, so the loop ends when neither has changed.
        while changed:
            before = len(waiting), len(self._open), signs.count
            pairs = [
                (item, learn_positive(item, self.matches.comparisons, signs, self.what))
                for item in waiting
            ]
            self._reasons = [reason for _, reason in pairs if reason is not None]
            waiting = [item for item, reason in pairs if reason is not None]
            found = self.matches.extend()
            self._learn_symbols(signs)
            radicands, nonzero = self.matches.radicands, self.nonzero(signs)
            polys, usable = self.equations.polys, self.equations.usable(signs)
            self._open = settle(signs, radicands, self._derived, nonzero, polys, usable)
            changed = found or before != (len(waiting), len(self._open), signs.count)

    def nonzero(self, signs: Signs) -> frozenset[str]:
        """Keys of polynomials that are known to be nonzero."""
        generators = self.matches.generators
        radicands = self.matches.radicands
        # A formal root is the root of a radicand of the law, divided by a nonzero factor.
        names = [
            a.name
            for a in generators.roots
            if a.kind == "formal root" and is_radicand(a, radicands)
        ]
        names += [
            a.name for a in generators.auxiliary if signs.of(generators.ring.generator(a.name))
        ]
        factors = nonzero_factors(generators, self.matches.of_law, names)
        return factors | factors_of(signs, self.polys)

    def _learn_symbols(self, signs: Signs) -> None:
        """Learn which roots, powers and exponentials are positive.

        A root is real only where its radicand is positive.
        """
        for auxiliary in self.matches.generators.auxiliary:
            rooted = auxiliary.kind in ("root", "power")
            real = not rooted or signs.of(auxiliary.of[0][0]) > 0
            if auxiliary.positive and real:
                signs.learn(self.matches.generators.ring.generator(auxiliary.name), 1)

    def require_all(self) -> None:
        """Raise CheckError if a sign or a divisor is not determined."""
        for reason in self._reasons:
            raise reason
        self.matches.require_all()
        if self._open:
            raise CheckError(f"what is positive in {self.what}: a sum is not")
