"""The field of a proof with its conditions, residuals and divisors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import cast

from flint import fmpq

from certificate_checker.claim.claim import Claim as CheckedClaim
from certificate_checker.claim.formulas import Formula
from flowlanes.formulas.errors import NeedMoreGeneratorsError, NoRealValueError
from flowlanes.system.formula_text import short_text
from flowlanes.system.laws import Law

from ..claim_text import Terms, powers_text, terms_text
from ..domain import divisors, sympy_formula
from ..fields.budget import Budget
from ..fields.quotient_ring import Element, Poly
from ..fields.unreduced_fields import UnreducedField
from ..level.level_set import LevelSet
from ..level.triangular_set import numerator
from ..level.trigonometric import angle_parts
from ..random_test import all_residuals
from ..residuals import in_words
from .sign_reasons import monic


class ProofSetting:
    """The field in which a proof is written, with the quantities evaluated in it.

    Parameters
    ----------
    claim : certificate_checker.claim.claim.Claim
        The claim as the checker reads it.
    level : LevelSet
        The whole level, not a component.
    sample : mapping of str to float
        A point of the level, by generator.
    signs : mapping of str to int
        Signs to be taken for factors under roots.
    """

    def __init__(
        self,
        kind: type[UnreducedField],
        claim: CheckedClaim,
        law: Law,
        level: LevelSet,
        sample: Mapping[str, float],
        budget: Budget,
        signs: Mapping[str, int],
    ) -> None:
        spare = 8
        #: Whether the proof is empty for these signs: the law is nowhere defined, or has a power
        #: of a negative base.
        self.void = False
        while True:
            self.field = kind([str(s) for s in level.generators], spare, sample, budget, signs)
            self.field.angle_parts = angle_parts(level.system, law)
            try:
                self._fill(claim, law, level)
                self.void = self.field.has_negative_base
            except NeedMoreGeneratorsError:
                spare *= 2
                continue
            except (NoRealValueError, ZeroDivisionError):
                self.void = True
            break
        self.level, self.sample = level, sample

    def _fill(self, claim: CheckedClaim, law: Law, level: LevelSet) -> None:
        field = self.field
        evaluate = level.evaluator(field)
        field.signs = level.signs_with(field, [])
        self.conditions = []
        for condition in level.conditions:
            value = field.zero if condition in level.zeros else evaluate.value(condition)
            if value.poly:
                self.conditions.append((short_text(condition), value))
        polys = [numerator(field, value) for _, value in self.conditions]
        field.signs = level.signs_with(field, polys)
        self.residuals = [
            (in_words(name), cast(Element, value))
            for name, value in all_residuals(law.by_formulas, level, field)
        ]
        self.divisors = list(divisors(claim, law, level, field))

    @property
    def ring(self) -> tuple[str, ...]:
        """The generators of the certificate: auxiliary symbols in use, then all others."""
        plain = self.field.names[self.field.spare :]
        return (*reversed(list(self.field.record)), *plain)

    @property
    def places(self) -> list[int | None]:
        """Index in the ring of every generator of the field; None if it is not used."""
        index = {name: i for i, name in enumerate(self.ring)}
        return [index.get(name) for name in self.field.names]

    def terms(self, poly: Poly) -> Terms:
        """A polynomial as text."""
        return terms_text(poly, self.places)

    def powers(self, powers: Sequence[tuple[Poly, int]]) -> list[list[object]]:
        """A product of powers as text."""
        return powers_text(powers, self.places)

    def states(self, formula: Formula, poly: Poly) -> bool:
        """True if a formula of the checker is a multiple of a polynomial."""
        value = self.level.evaluator(self.field).value(
            sympy_formula(formula, self.level.symbols_by_name)
        )
        own = numerator(self.field, value)
        return bool(own) and monic(own)[0] == monic(poly)[0]

    def product(self, element: Element) -> tuple[fmpq, list[tuple[Poly, int]]]:
        """Content of an element, and its factors with their powers."""
        content, parts = self.field.factorisation(element.poly)
        total = dict(element.powers)
        for number, power in parts:
            total[number] = total.get(number, 0) + power
        return content, [(self.field.factors[n], p) for n, p in total.items() if p]
