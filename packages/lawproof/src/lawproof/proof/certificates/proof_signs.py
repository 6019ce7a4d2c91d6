"""Positive and non-zero quantities of a proof, with reasons."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from flint import fmpq

from flowlanes.formulas.errors import NeedMoreGeneratorsError, OutOfReachError
from flowlanes.system.formula_text import short_text

from ..claim_text import Terms, Text, admissible, guards
from ..fields.function_field import FunctionField
from ..fields.quotient_ring import Poly
from ..level.level_set import LevelSet
from ..level.triangular_set import numerator
from .proof_setting import ProofSetting
from .sign_reasons import InOneVariable, Reasons, Sum, monic


@dataclass(frozen=True)
class FactoredDivisor:
    """A divisor or radicand as a product of powers."""

    formula: str
    where: str
    content: fmpq
    factors: list[tuple[Poly, int]]
    positive: bool


def sign_reasons(
    setting: ProofSetting, equations: Mapping[int, Poly], assumptions: Sequence[tuple[Poly, int]]
) -> tuple[Reasons, list[FactoredDivisor]]:
    """The signs known on the domain from divisors and assumptions, and the factored divisors."""
    reasons = _reasons(setting, equations)
    entries = [
        FactoredDivisor(formula, where, *setting.product(value), positive)
        for formula, where, value, positive in setting.divisors
    ]
    # Order matters: non-zero factors, then assumed signs, then those that follow from both.
    _find_nonzero(reasons, entries)
    for poly, sign in assumptions:
        reasons.learn(poly, sign)
    _force(reasons, entries)
    _root_signs(setting, reasons)
    for entry in entries:
        for poly, _ in entry.factors if entry.positive else ():
            reasons.sign(poly)
    return reasons, entries


def _reasons(setting: ProofSetting, equations: Mapping[int, Poly]) -> Reasons:
    facts = []
    level, field = setting.level, setting.field
    for relation in admissible(level.system):
        if isinstance(relation, sp.Gt | sp.Ge | sp.Lt | sp.Le):
            strict = isinstance(relation, sp.Gt | sp.Lt)
            poly = _polynomial(level, field, relation.gts - relation.lts)
            if poly is not None:
                facts.append((poly, short_text(relation), strict))
    for formula in guards(level.system):
        poly = _polynomial(level, field, formula)
        if poly is not None:
            facts.append((poly, short_text(formula), True))
    reasons = Reasons(field.ring, facts, equations)
    for name, meaning in field.record.items():
        positive = meaning.kind in ("root", "power", "pi") or meaning.name == "exp"
        if positive:
            reasons.learn(field.generators[name], 1)
        if positive or meaning.kind == "formal root":
            reasons.nonzero.add(monic(field.generators[name])[0])
    for inversion in level.exchanged_inverses:
        # The determinant of a symmetric 3 × 3 matrix, which has an inverse by assumption.
        a, b, c, d, e, f = (field.generators[str(s)] for s in inversion.name)
        determinant = a * (d * f - e * e) + b * (c * e - b * f) + c * (b * e - c * d)
        reasons.nonzero.add(monic(determinant)[0])
    return reasons


def _polynomial(level: LevelSet, field: FunctionField, formula: sp.Expr) -> Poly | None:
    """The polynomial equal to a formula; None if it is a fraction, a constant or has a root."""
    try:
        value = level.evaluator(field).value(formula)
    except (OutOfReachError, NeedMoreGeneratorsError, ZeroDivisionError):
        return None
    below = any(power < 0 for power in value.powers.values())
    poly: Poly = numerator(field, value)
    if below or not poly or poly.is_constant() or any(poly.degrees()[: field.spare]):
        return None
    return poly


def _find_nonzero(reasons: Reasons, entries: Sequence[FactoredDivisor]) -> None:
    """Mark the numerator factors of a non-zero quantity as non-zero."""
    # p/q ≠ 0 with q ≠ 0 gives that no factor of p vanishes; repeat until nothing changes.
    changed = True
    while changed:
        changed = False
        for entry in entries:
            below = {monic(p)[0] for p, n in entry.factors if n < 0}
            above = {monic(p)[0]: p for p, n in entry.factors if n > 0 and not p.is_constant()}
            if below <= reasons.nonzero and not set(above) <= reasons.nonzero:
                reasons.divisors += [p for k, p in above.items() if k not in reasons.nonzero]
                reasons.nonzero |= set(above)
                changed = True


def _force(reasons: Reasons, entries: Sequence[FactoredDivisor]) -> None:
    """Find the sign of the one unknown odd factor of a positive product."""
    changed = True
    while changed:
        changed = False
        for entry in entries:
            odd = [p for p, n in entry.factors if n % 2 and not p.is_constant()]
            unknown = [p for p in odd if not reasons.sign(p)]
            if entry.positive and len(unknown) == 1:
                sign = 1 if entry.content > 0 else -1
                for poly in odd:
                    sign *= reasons.sign(poly) or 1
                reasons.learn(unknown[0], sign)
                changed = True


def _root_signs(setting: ProofSetting, reasons: Reasons) -> None:
    for meaning in setting.field.record.values():
        if meaning.kind in ("root", "power") or meaning.name == "log":
            reasons.sign(meaning.of[0].poly)


def positive_texts(setting: ProofSetting, reasons: Reasons, size: int) -> list[Text]:
    """The positive quantities of a certificate with `size` equations: facts, then sums."""
    facts = [
        {"poly": setting.terms(poly), "strict": strict, "from": source}
        for poly, source, strict in reasons.facts
    ]
    return [*facts, *(_sum_text(setting, term, size) for term in reasons.sums)]


def _sum_text(setting: ProofSetting, own: Sum | InOneVariable, size: int) -> Text:
    if isinstance(own, InOneVariable):
        return {
            "poly": setting.terms(own.poly),
            "strict": True,
            "from": "one variable",
            "facts": [setting.terms(fact) for fact in own.facts],
        }
    quotients: list[Terms] = [[] for _ in range(size)]
    for number, share in own.multiples:
        quotients[number] = setting.terms(share)
    return {
        "poly": setting.terms(own.poly),
        "strict": own.strict,
        "from": "sum",
        "terms": [
            [setting.powers(term.weights), str(term.constant), [setting.terms(term.base)]]
            for term in own.terms
        ],
        "quotients": quotients,
    }
