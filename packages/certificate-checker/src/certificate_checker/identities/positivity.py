"""Positive quantities of a proof: guards, admissible parameters, radicands, sums."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence, Set
from typing import TypeAlias

from flint import fmpq

from ..claim.claim import Claim
from ..claim.errors import CheckError
from ..claim.formulas import Formula
from ..claim.json_data import as_list, field, items, mapping, only, rational, text
from ..claim.parsing import parse, parse_condition
from ..claim.polynomials import Poly, monic
from .case_tree import Signs
from .comparisons import Comparisons
from .divisors import Entry
from .generators import Generators
from .one_variable import is_positive_where
from .residues import UnknownRootError

#: Reasons that depend on other signs, with their additional fields.
DERIVED = {"sum": ("terms", "quotients"), "one variable": ("facts",)}


def learn_positive(
    item: object, comparisons: Comparisons, signs: Signs, what: str
) -> CheckError | None:
    """Learn a positive quantity from a guard or a condition on parameters.

    Returns an error if it does not follow, which may change when more signs are known.
    """
    label = f"what is positive in {what}"
    item = mapping(item, label)
    more = DERIVED.get(str(item.get("from")), ())
    only(item, label, "poly", "strict", "from", *more)
    generators = comparisons.generators
    poly = generators.ring.read(field(item, "poly", label), label)
    strict = field(item, "strict", label)
    source = text(field(item, "from", label), label)
    if not isinstance(strict, bool):
        raise CheckError(f"{label} has a field 'strict' that is neither true nor false")
    if source in DERIVED or source.startswith("radicand "):
        return None
    for formula, sign in _positive_formulas(source, generators.claim, label):
        if strict and sign != ">":
            continue
        try:
            ratio = comparisons.ratio(poly, formula)
        except UnknownRootError as error:
            return error
        if ratio is not None and ratio > 0:
            signs.learn(poly, 1, strict)
            return None
    return CheckError(f"{label}: {source} does not say so")


def _positive_formulas(source: str, claim: Claim, label: str) -> list[tuple[Formula, str]]:
    """Positive formulas of a guard or a condition on parameters, given as text."""
    system = claim.system
    if any(sign in source for sign in "<>=&"):
        stated = parse_condition(source, label)
        known = [pair for pair in system.admissible if pair[1] in (">", ">=")]
    else:
        stated = [(parse(source, label), ">")]
        known = [(guard, ">") for guard in system.guards]
    return [pair for pair in stated if pair in known]


def check_radicand_positive(
    item: Mapping[str, object], generators: Generators, signs: Signs, what: str
) -> None:
    """Check a quantity that is positive as a radicand."""
    source = text(item["from"], what)
    if not source.startswith("radicand "):
        return
    poly = generators.ring.read(item["poly"], what)
    for auxiliary in generators.auxiliary:
        if auxiliary.name == source.removeprefix("radicand ") and auxiliary.kind in (
            "root",
            "power",
        ):
            of = auxiliary.of[0][0]
            if monic(poly) == monic(of) and signs.of(poly) > 0:
                return
    raise CheckError(f"what is positive in {what}: {source} is not")


def _force(signs: Signs, radicands: Sequence[Entry]) -> None:
    """Learn the sign of the only factor of unknown sign in a positive product."""
    changed = True
    while changed:
        changed = False
        for entry in radicands:
            odd = [p for p, n in entry.powers if n % 2 and not p.is_constant()]
            unknown = [p for p in odd if not signs.of(p)]
            if len(unknown) == 1:
                others = 1 if entry.content > 0 else -1
                for poly, power in entry.powers:
                    if power % 2 and poly is not unknown[0]:
                        others *= signs.of(poly)
                signs.learn(unknown[0], others)
                changed = True


class PositiveSum:
    """Polynomial that is a sum of nonnegative terms, up to multiples of equations.

    The terms are constant · ∏ weight^power · base² with a positive constant; weights with odd
    powers are nonnegative.  If the sum is stated to be positive, it must be known to be nonzero,
    or one term must be positive: its base is a number, and its weights are nonzero.
    """

    def __init__(self, data: Mapping[str, object], generators: Generators, what: str) -> None:
        label = f"what is positive in {what}"
        ring = self.ring = generators.ring
        self.label = label
        self.poly = ring.read(field(data, "poly", label), label)
        self.strict = field(data, "strict", label) is True
        self.terms = []
        for term in as_list(field(data, "terms", label), label):
            weight, constant, base = items(term, 3, label)
            number = rational(constant, label)
            if number <= 0:
                raise CheckError(f"{label}: a term with a constant that is not positive")
            (inner,) = items(base, 1, label)
            base_poly = ring.read(inner, label)
            self.terms.append((ring.powers(weight, label), number, base_poly))
        self.quotients = [
            ring.read(q, label) for q in as_list(field(data, "quotients", label), label)
        ]

    def holds(
        self, signs: Signs, nonzero: frozenset[str], equations: Sequence[Poly], usable: Set[int]
    ) -> bool:
        """True if the signs of the terms are known.

        CheckError if the sum is a different polynomial.  Only equations with indices in `usable`
        are known to hold.
        """
        if len(self.quotients) != len(equations):
            raise CheckError(
                f"{self.label}: the numbers of quotients and equations of a sum differ"
            )
        # The identity poly = Σ quotient · equation + Σ terms is verified exactly.
        total = self.ring.constant(0)
        for quotient, equation in zip(self.quotients, equations, strict=True):
            total = total + quotient * equation
        certain = {i for i, quotient in enumerate(self.quotients) if quotient} <= usable
        strict = not self.strict or (not self.poly.is_constant() and monic(self.poly)[0] in nonzero)
        for weights, number, base in self.terms:
            positive = base.is_constant() and not base.is_zero()
            for part, power in weights:
                known = not part.is_constant() and monic(part)[0] in nonzero
                certain = certain and (power % 2 == 0 or signs.is_not_negative(part))
                positive = positive and (known or bool(signs.of(part)))
            strict = strict or positive
            fraction = fmpq(number.numerator, number.denominator)
            total = total + fraction * self.ring.expanded_product(weights) * base**2
        if total != self.poly:
            raise CheckError(f"{self.label}: a sum is a different polynomial")
        return certain and strict


class PositiveInOneVariable:
    """Polynomial that is positive where others in the same variable are."""

    strict = True

    def __init__(self, data: Mapping[str, object], generators: Generators, what: str) -> None:
        label = f"what is positive in {what}"
        ring = generators.ring
        self.poly = ring.read(field(data, "poly", label), label)
        self.facts = [ring.read(f, label) for f in as_list(field(data, "facts", label), label)]
        if field(data, "strict", label) is not True:
            raise CheckError(f"{label}: what is positive in one variable is so strictly")

    def holds(
        self, signs: Signs, nonzero: frozenset[str], equations: Sequence[Poly], usable: Set[int]
    ) -> bool:
        """True if the others are known to be positive, and imply that this one is positive."""
        if not all(map(signs.is_not_negative, self.facts)):
            return False
        return is_positive_where(self.poly, [(fact, signs.of(fact) > 0) for fact in self.facts])


Derived: TypeAlias = PositiveSum | PositiveInOneVariable


def read_derived(data: object, generators: Generators, what: str) -> list[Derived]:
    """Quantities that are positive because others are."""
    kinds: dict[str, type[Derived]] = {"sum": PositiveSum, "one variable": PositiveInOneVariable}
    label = f"what is positive in {what}"
    stated = [mapping(item, label) for item in as_list(data, label)]
    sources = [text(field(item, "from", label), label) for item in stated]
    return [
        kinds[source](item, generators, what)
        for item, source in zip(stated, sources, strict=True)
        if source in kinds
    ]


def factors_of(signs: Signs, polys: Iterable[Poly]) -> frozenset[str]:
    """Keys of the factors of polynomials that are known to be strictly positive or negative."""
    strict = [poly for poly in polys if not poly.is_constant() and signs.of(poly)]
    return frozenset(monic(part)[0] for poly in strict for part, _ in poly.factor()[1])


def settle(
    signs: Signs,
    radicands: Sequence[Entry],
    sums: Sequence[Derived],
    nonzero: frozenset[str],
    equations: Sequence[Poly],
    usable: Set[int],
) -> list[Derived]:
    """Learn signs from sums and radicands; the sums that are not yet decided are returned."""
    _force(signs, radicands)
    left = list(sums)
    changed = True
    while changed:
        changed = False
        for item in list(left):
            if item.holds(signs, nonzero, equations, usable):
                signs.learn(item.poly, 1, item.strict)
                left.remove(item)
                changed = True
        _force(signs, radicands)
    return left
