"""One proof of a certificate: the residuals of a law over a ring, and why they vanish."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy as sp

from ...check.claim.claim import Claim as CheckedClaim
from ...check.claim.formulas import Formula
from ...core.laws import Law, Reduction, Separation
from ...formulas.errors import NeedMoreGeneratorsError, OutOfReachError
from ..claim_text import admissible, guards, powers_text, terms_text
from ..domain import divisors, sympy_formula
from ..fields.budget import Budget
from ..fields.function_field import FINENESS, FunctionField
from ..fields.quotient_ring import Element
from ..fields.unreduced_fields import Meaning, UnreducedField
from ..level.level_set import LevelSet
from ..level.triangular_set import numerator
from ..random_test import everything
from .case_tree import Cases
from .sign_reasons import Reasons, Sum, monic

__all__ = ["Excluded", "Made", "proof_text"]

Poly = Any
Text = dict[str, Any]

#: The condition of a verdict that excludes the zeros of a polynomial; None if none does.
Excluded = Callable[[Any, Poly], str | None]


class Made:
    """A field in which a proof is written, with what is known in it.

    Parameters
    ----------
    kind : type of Unreduced
    claim : chaplygin.check.claim.claim.Claim
        As the check reads it.
    law : Law
    ground : Ground
        The whole level.
    sample : mapping of str to float
        A point of the level, by the names of the generators.
    budget : Budget
    signs : mapping of str to int
        Signs of factors under roots that are to be taken.
    """

    def __init__(
        self,
        kind: type[UnreducedField],
        claim: CheckedClaim,
        law: Law,
        ground: LevelSet,
        sample: Mapping[str, float],
        budget: Budget,
        signs: Mapping[str, int],
    ) -> None:
        spare = 8
        while True:
            self.field = kind([str(s) for s in ground.generators], spare, sample, budget, signs)
            try:
                self._fill(claim, law, ground)
            except NeedMoreGeneratorsError:
                spare *= 2
                continue
            break
        self.ground, self.sample = ground, sample

    def _fill(self, claim: CheckedClaim, law: Law, ground: LevelSet) -> None:
        made = self.field
        evaluate = ground.evaluator(made)
        made.signs = ground.signs_with(made, [])
        self.conditions = []
        for condition in ground.conditions:
            value = made.zero if condition in ground.zeros else evaluate.value(condition)
            if value.poly:
                self.conditions.append((str(condition), value))
        polys = [numerator(made, value) for _, value in self.conditions]
        made.signs = ground.signs_with(made, polys)
        self.residuals: list[tuple[str, Element]] = list(everything(_formulas(law), ground, made))
        self.divisors = list(divisors(claim, law, ground, made))

    @property
    def ring(self) -> tuple[str, ...]:
        """The generators: auxiliary symbols that are used, and all others."""
        plain = self.field.names[self.field.spare :]
        return (*reversed(list(self.field.record)), *plain)

    @property
    def places(self) -> list[int | None]:
        """Where the generators of the field stand in the ring."""
        index = {name: i for i, name in enumerate(self.ring)}
        return [index.get(name) for name in self.field.names]

    def terms(self, poly: Poly) -> list[Any]:
        """A polynomial as text."""
        return terms_text(poly, self.places)

    def powers(self, powers: Sequence[tuple[Poly, int]]) -> list[Any]:
        """A product of powers as text."""
        return powers_text(powers, self.places)

    def states(self, formula: Formula, poly: Poly) -> bool:
        """Whether a formula of the check vanishes or is positive where a polynomial is."""
        value = self.ground.evaluator(self.field).value(sympy_formula(formula, self.ground.named))
        own = numerator(self.field, value)
        return bool(own) and monic(own)[0] == monic(poly)[0]

    def product(self, element: Element) -> tuple[Any, list[tuple[Poly, int]]]:
        """Content, and factors with their powers, of an element."""
        content, parts = self.field.factorised(element.poly)
        total = dict(element.powers)
        for number, power in parts:
            total[number] = total.get(number, 0) + power
        return content, [(self.field.factors[n], p) for n, p in total.items() if p]


def _formulas(law: Law) -> Law:
    """What of a law is a matter of formulas: the check sees by itself whether others separate."""
    if not isinstance(law, Separation):
        return law
    return Reduction(law.name, law.quantities, law.equations, on=law.on)


@dataclass(frozen=True)
class _Entry:
    """A divisor or radicand as a product."""

    formula: str
    where: str
    content: Any
    factors: list[tuple[Poly, int]]
    positive: bool


def proof_text(made: Made, excluded: Excluded, decided: bool) -> Text:
    """A proof, in the format of a certificate.

    Parameters
    ----------
    made : Made
    excluded : callable
    decided : bool
        Whether the proof takes the signs that were decided, for one of several proofs.

    Raises
    ------
    OutOfReachError
        If it cannot be completed.
    """
    field, ground = made.field, made.ground
    equations = _equations(made)
    reasons = _reasons(made, [poly for poly, _ in equations])
    assumed = list(field.decisions.values()) if decided else []
    entries = [
        _Entry(formula, where, *made.product(value), positive)
        for formula, where, value, positive in made.divisors
    ]
    _find_nonzero(reasons, entries)
    for poly, sign in assumed:
        reasons.learn(poly, sign)
    _force(reasons, entries)
    _root_signs(made, reasons)
    numerators = [field.reduce(value.poly) for _, value in _whole(made)]
    for _, value in _whole(made):
        for number, power in value.powers.items():
            if power < 0:
                reasons.is_nonzero(field.factors[number])
    state = {str(s) for s in ground.system.symbols}
    cases = Cases(
        field.ring,
        reasons,
        numerators,
        frozenset(i for i, name in enumerate(field.names) if name in state),
        made.terms,
        lambda poly: excluded(made, poly),
        field.budget,
    )
    tree = cases.tree([poly for poly, _ in equations])
    return {
        "ring": list(made.ring),
        "auxiliary": [[name, _meaning(made, m)] for name, m in field.record.items()],
        "settled": [[str(s), str(value)] for s, value in ground.settled.items()],
        "exchanged": [
            [str(e.name), str(e.factor), str(e.parameter), str(e.rest)] for e in ground.exchanged
        ],
        "inverted": [[[str(s) for s in i.name], [str(s) for s in i.of]] for i in ground.inverted],
        "zeros": [str(zero) for zero in ground.zeros],
        "signs": [[made.terms(poly), sign] for poly, sign in assumed],
        "near": _near(made),
        "equations": [text for _, text in equations],
        "divisors": [
            {
                "formula": entry.formula,
                "where": entry.where,
                "content": str(entry.content),
                "factors": made.powers(entry.factors),
            }
            for entry in entries
        ],
        "positive": [
            *_facts_text(made, reasons),
            *(_sum_text(made, found, len(equations)) for found in reasons.sums),
        ],
        "residuals": [_residual(made, what, value) for what, value in _whole(made)],
        "tree": tree,
    }


def _whole(made: Made) -> list[tuple[str, Element]]:
    """The residuals, with no factor in the numerator that is not multiplied out."""
    found = []
    for what, value in made.residuals:
        poly, below = value.poly, {}
        for number, power in value.powers.items():
            if power > 0:
                poly = poly * made.field.factors[number] ** power
            else:
                below[number] = power
        found.append((what, Element(made.field, poly, below)))
    return found


def _residual(made: Made, what: str, value: Element) -> Text:
    below = [(made.field.factors[n], -p) for n, p in value.powers.items()]
    return {
        "what": what,
        "numerator": made.terms(made.field.reduce(value.poly)),
        "denominator": made.powers(below),
    }


# --- equations -----------------------------------------------------------------------------------


def _equations(made: Made) -> list[tuple[Poly, Text]]:
    found = []
    for formula, value in made.conditions:
        poly = numerator(made.field, value)
        below = [(made.field.factors[n], -p) for n, p in value.powers.items() if p < 0]
        text = {"poly": made.terms(poly), "from": formula, "denominator": made.powers(below)}
        found.append((poly, text))
    for main, poly, _ in made.field.relations:
        kind = made.field.record[main].kind
        source = f"root {main}"
        if kind in ("sin", "cos"):
            both = [n for n in made.field.record if made.field.generators[n] in _gens(made, poly)]
            source = f"circle {' '.join(both)}"
        found.append((poly, {"poly": made.terms(poly), "from": source}))
    return _with_equal_values(made, found)


def _with_equal_values(made: Made, known: list[tuple[Poly, Text]]) -> list[tuple[Poly, Text]]:
    """Equations, and those of values that are equal because their arguments are on the level."""
    field = made.field
    found = list(known)
    record = list(field.record.items())
    for number, (name, meaning) in enumerate(record):
        value = field.generators[name]
        others = [(o, m) for o, m in record[:number] if m.kind == meaning.kind]
        tried: list[tuple[str, Poly, list[Poly]]] = []
        if meaning.kind in ("root", "power"):
            tried.append((f"one {name}", value - 1, [meaning.of[0].poly - 1]))
        for other, theirs in others:
            if meaning.kind != "formal root" and meaning.agrees(theirs):
                pairs = zip(meaning.of, theirs.of, strict=True)
                differences = [numerator(field, a - b) for a, b in pairs]
                tried.append((f"same {name} {other}", value - field.generators[other], differences))
        for source, poly, differences in tried:
            cases = Cases(
                field.ring, Reasons(field.ring, []), (), frozenset(), None, None, field.budget
            )
            by = [cases.combined(d, [p for p, _ in found]) for d in differences]
            if any(by) and None not in by:
                text = {
                    "poly": made.terms(poly),
                    "from": source,
                    "quotients": [
                        [made.terms(part[i]) if i in part else [] for i in range(len(found))]
                        for part in by
                        if part is not None
                    ],
                }
                found.append((poly, text))
                break
    return found


def _gens(made: Made, poly: Poly) -> list[Poly]:
    return [g for g, d in zip(made.field.ring.gens(), poly.degrees(), strict=True) if d]


def _meaning(made: Made, meaning: Meaning) -> Text:
    of = [_fraction(made, element) for element in meaning.of]
    if meaning.kind in ("root", "formal root"):
        text = {
            "kind": meaning.kind,
            "of": made.terms(meaning.of[0].poly),
            "degree": meaning.number,
        }
        if meaning.kind == "formal root":
            text["whole"] = made.powers(meaning.whole)
        return text
    if meaning.kind == "power":
        if meaning.of[0].powers:
            raise OutOfReachError("no certificate: a symbolic power of a fraction")
        return {
            "kind": "power",
            "of": made.terms(meaning.of[0].poly),
            "exponent": str(meaning.exponent),
            "fineness": FINENESS,
        }
    if meaning.kind in ("sin", "cos"):
        return {"kind": meaning.kind, "of": of[0]}
    if meaning.kind == "pi":
        return {"kind": "pi"}
    text = {"kind": meaning.kind, "name": meaning.name, "of": of}
    if meaning.kind == "function":
        text["orders"] = list(meaning.orders)
    return text


def _fraction(made: Made, element: Element) -> Text:
    poly, below = element.poly, []
    for number, power in element.powers.items():
        if power > 0:
            poly = poly * made.field.factors[number] ** power
        else:
            below.append((made.field.factors[number], -power))
    return {"numerator": made.terms(poly), "denominator": made.powers(below)}


def _near(made: Made) -> dict[str, str]:
    plain = made.ring[len(made.field.record) :]
    return {
        name: str(Fraction(repr(float(made.sample[name]))).limit_denominator(10**6))
        for name in plain
        if name in made.sample and abs(made.sample[name]) < 1e20
    }


# --- signs ---------------------------------------------------------------------------------------


def _reasons(made: Made, equations: Sequence[Poly]) -> Reasons:
    facts = []
    ground, field = made.ground, made.field
    for relation in admissible(ground.system):
        if isinstance(relation, sp.Gt | sp.Ge | sp.Lt | sp.Le):
            strict = isinstance(relation, sp.Gt | sp.Lt)
            poly = _polynomial(ground, field, relation.gts - relation.lts)
            if poly is not None:
                facts.append((poly, str(relation), strict))
    for formula in guards(ground.system):
        poly = _polynomial(ground, field, formula)
        if poly is not None:
            facts.append((poly, str(formula), True))
    made_reasons = Reasons(field.ring, facts, equations)
    for name, meaning in field.record.items():
        positive = meaning.kind in ("root", "power", "pi") or meaning.name == "exp"
        if positive:
            made_reasons.learn(field.generators[name], 1)
            made_reasons.nonzero.add(monic(field.generators[name])[0])
    for inversion in ground.inverted:
        a, b, c, d, e, f = (field.generators[str(s)] for s in inversion.name)
        determinant = a * (d * f - e * e) + b * (c * e - b * f) + c * (b * e - c * d)
        made_reasons.nonzero.add(monic(determinant)[0])
    return made_reasons


def _polynomial(ground: LevelSet, field: FunctionField, formula: Any) -> Poly | None:
    """The polynomial that a formula is, if it is one and no number."""
    try:
        value = ground.evaluator(field).value(formula)
    except (OutOfReachError, NeedMoreGeneratorsError, ZeroDivisionError):
        return None
    below = any(power < 0 for power in value.powers.values())
    poly = numerator(field, value)
    if below or not poly or poly.is_constant() or any(poly.degrees()[: field.spare]):
        return None
    return poly


def _find_nonzero(reasons: Reasons, entries: Sequence[_Entry]) -> None:
    """What does not vanish, where what is in denominators is known not to."""
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


def _force(reasons: Reasons, entries: Sequence[_Entry]) -> None:
    """The sign of the only factor of something positive whose sign is unknown."""
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


def _root_signs(made: Made, reasons: Reasons) -> None:
    for meaning in made.field.record.values():
        if meaning.kind in ("root", "power"):
            reasons.sign(meaning.of[0].poly)


def _facts_text(made: Made, reasons: Reasons) -> list[Text]:
    return [
        {"poly": made.terms(poly), "strict": strict, "from": source}
        for poly, source, strict in reasons.facts
    ]


def _sum_text(made: Made, found: Sum, size: int) -> Text:
    quotients: list[Any] = [[] for _ in range(size)]
    for number, ratio in found.multiples:
        quotients[number] = made.terms(made.field.ring.constant(ratio))
    return {
        "poly": made.terms(found.poly),
        "strict": True,
        "from": "sum",
        "terms": [
            [made.powers(term.weights), str(term.constant), [made.terms(term.base)]]
            for term in found.terms
        ],
        "quotients": quotients,
    }
