"""One proof: that the residuals of a claim vanish wherever certain signs are as assumed.

What the polynomials of a proof have to do with the claim is tested at random points: a formula and
a polynomial that agree there, to sixty digits and more, are taken to be equal.  This is the test of
Schwartz and Zippel; it errs with a probability of about degree / 2^22 at every point, and is no
proof.  Everything that follows from the polynomials is computed exactly.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from flint import arb, ctx, fmpq

from .claims import Claim
from .domain import GRAM
from .errors import CheckError, UndefinedError
from .formulas import Formula, parse, parse_condition
from .ground import FIELDS, POINTS, Auxiliary, Ground, Sample, read_ground
from .laws import residuals
from .polynomials import Poly, Powers, Ring, monic
from .reading import choice, field, items, listed, mapping, only, rational, text
from .tree import Node, Signs, check_tree

__all__ = ["Basis", "Condition", "Entry", "agree", "check_left", "check_proof"]
__all__ += ["read_basis", "read_region", "same", "with_precision"]

DIGITS = 60
#: Points at which roots are compared of which the sign is not said.
FORMAL = 10
PRECISIONS = (640, 2560, 10240)


class InaccurateError(Exception):
    """Balls are too wide to compare anything."""


def _accurate(value: Any) -> bool:
    bound = arb(10) ** -DIGITS
    return bool(value.is_finite() and value.rad() <= bound * max(arb(1), abs(value).lower()))


def agree(first: Sequence[Any], second: Sequence[Any]) -> bool:
    """Whether numbers are equal, as far as their balls tell.

    Raises
    ------
    InaccurateError
        If they tell too little.
    """
    if not all(a.overlaps(b) for a, b in zip(first, second, strict=True)):
        return False
    if not all(map(_accurate, [*first, *second])):
        raise InaccurateError
    return True


def with_precision(task: Any) -> Any:
    """Do a task with balls that are narrow enough."""
    for precision in PRECISIONS:
        try:
            with ctx.workprec(precision):
                return task()
        except InaccurateError:
            continue
    raise CheckError("the formulas cannot be evaluated accurately enough")


@dataclass(frozen=True)
class Condition:
    """A condition of a verdict: a formula is positive, or is not zero."""

    text: str
    formula: Formula
    positive: bool


@dataclass(frozen=True)
class Entry:
    """A formula as a product: content · ∏ factor^power."""

    content: int
    powers: Powers


@dataclass(frozen=True)
class Basis:
    """What a proof works with, as checked against the claim.

    Attributes
    ----------
    ground : Ground
    samples : list of Sample
    equations : tuple of Poly
        Vanish on the level.
    nonzero : frozenset of str
        Keys of polynomials that do not vanish where the law is defined.
    signs : Signs
        Known signs, the assumed ones included.
    certain : Signs
        Signs that are known without assuming any.
    radicands : tuple of Entry
        Are positive where the law is defined.
    """

    ground: Ground
    samples: list[Sample]
    equations: tuple[Poly, ...]
    nonzero: frozenset[str]
    signs: Signs
    certain: Signs
    radicands: tuple[Entry, ...]


def check_proof(
    data: Mapping[str, Any], claim: Claim, what: str, conditions: Sequence[Condition]
) -> Basis:
    """Check a proof of a claim, where conditions hold; CheckError where it fails."""
    only(data, what, "claim", "substitution", "region", *FIELDS, "residuals", "tree")
    region = read_region(data, claim, what)
    basis: Basis = with_precision(lambda: _checked_residuals(data, claim, region, what))
    ring = basis.ground.ring
    numerators = [
        ring.fraction(item, f"a residual of {what}")[0] for item in field(data, "residuals", what)
    ]

    def leaf(node: Node, data: Mapping[str, Any], where: str) -> None:
        check_left(node, data, where, basis, conditions)

    node = Node(ring, basis.equations, basis.nonzero, basis.signs, numerators, leaf)
    check_tree(node, field(data, "tree", what), f"the tree of {what}")
    return basis


def read_region(data: Mapping[str, Any], claim: Claim, what: str) -> tuple[Formula, ...]:
    """The equations of the part of the level that a proof treats."""
    region = listed(data.get("region", []), f"the region of {what}")
    found = tuple(parse(formula, f"the region of {what}") for formula in region)
    known = {*claim.system.symbols, *claim.system.definitions}
    for formula in found:
        if not claim.system.reach([formula]) <= known:
            raise CheckError(f"the region of {what} uses an unknown symbol")
    return found


def _checked_residuals(
    data: Mapping[str, Any], claim: Claim, region: Sequence[Formula], what: str
) -> Basis:
    ground = read_ground(data, claim, what)
    basis = read_basis(data, ground, region, what)
    stated = listed(field(data, "residuals", what), f"the residuals of {what}")
    fractions = [ground.ring.fraction(item, f"a residual of {what}") for item in stated]
    for sample in basis.samples:
        try:
            values = residuals(claim, sample.place)
        except UndefinedError as error:
            raise CheckError(f"{what}: a residual is not defined: {error}") from None
        if len(values) != len(fractions):
            raise CheckError(
                f"{what} states {len(fractions)} residuals, but the law has {len(values)}"
            )
        for number, ((above, below), value) in enumerate(zip(fractions, values, strict=True)):
            upper = ground.ring.value(above, sample.values)
            lower = ground.ring.value_of_powers(below, sample.values)
            if lower.contains(0):
                raise InaccurateError
            if not agree([value], [upper / lower]):
                raise CheckError(f"{what}: residual {number} is not that of the law")
    for number, (_, below) in enumerate(fractions):
        for poly, _ in below:
            _require_nonzero(basis, poly, f"the denominator of residual {number} of {what}")
    return basis


def check_left(
    node: Node,
    data: Mapping[str, Any],
    where: str,
    basis: Basis,
    conditions: Sequence[Condition],
) -> None:
    """A case may be left unproven if a condition of the verdict excludes it."""
    if data["case"] != "unproven":
        raise CheckError(f"{where} has a case {data['case']!r}, which has no place there")
    only(data, where, "case", "condition")
    said = text(field(data, "condition", where), f"the condition of {where}")
    for condition in conditions:
        if condition.text == said and any(
            with_precision(lambda e=e, c=condition: same(basis, e, c.formula) is not None)
            for e in node.equations
        ):
            return
    raise CheckError(f"{where} is left unproven, which no condition of the verdict excludes")


def same(basis: Basis, poly: Poly, formula: Formula) -> int | None:
    """The sign of the number by which a polynomial and a formula differ; None if by none."""
    try:
        values = [basis.ground.ring.value(poly, sample.values) for sample in basis.samples]
        ratio = _ratio(values, [sample.place(formula) for sample in basis.samples])
    except UndefinedError:
        return None
    return None if ratio is None else 1 if ratio > 0 else -1


def _require_nonzero(basis: Basis, poly: Poly, what: str) -> None:
    if not poly.is_constant() and monic(poly)[0] not in basis.nonzero and not basis.signs.of(poly):
        raise CheckError(f"{what} may vanish")


# --- equations, divisors, signs ------------------------------------------------------------------


def read_basis(
    data: Mapping[str, Any],
    ground: Ground,
    region: Sequence[Formula],
    what: str,
    treated: bool = True,
) -> Basis:
    """Equations, divisors and signs of a proof, compared with the claim at random points.

    Where residuals are `treated`, all roots of the law must be those of factors with known signs.
    """
    ring = ground.ring
    samples = ground.samples(FORMAL if _formal(ground) else POINTS)
    entries, matched = _divisors(data, ground, samples, what)
    nonzero = _nonzero(ground, entries)
    certain = Signs()
    for auxiliary in ground.auxiliary:
        if auxiliary.positive:
            certain.learn(ground.ring.generator(auxiliary.name), 1)
    positives = listed(field(data, "positive", what), f"what is positive in {what}")
    for item in positives:
        _learn_positive(item, ground, samples, certain, what)
    signs = certain.copy()
    for poly, sign in ground.signs:
        if not poly.is_constant() and monic(poly)[0] not in nonzero:
            raise CheckError(f"{what} assumes the sign of something that may vanish")
        signs.learn(poly, sign)
    radicands = tuple(entries[i] for i in matched if i is not None)
    stated = [item for item in positives if mapping(item, what).get("from") == "sum"]
    sums = [_Sum(mapping(item, what), ground, what) for item in stated]
    written = [
        ring.read(field(mapping(item, what), "poly", what), what)
        for item in listed(field(data, "equations", what), what)
    ]
    _settle(certain, radicands, sums, nonzero, written)
    left = _settle(signs, radicands, sums, nonzero, written)
    if left:
        raise CheckError(f"what is positive in {what}: a sum is not")
    if treated:
        _check_roots(ground, signs, nonzero, entries, matched, what)
        _check_radicands(ground, signs, entries, matched, what)
    _check_functions(ground, samples, nonzero, signs, what)
    for item in positives:
        _check_radicand_positive(mapping(item, what), ground, signs, what)
    equations = _equations(data, ground, samples, region, nonzero, signs, what)
    return Basis(ground, samples, equations, nonzero, signs, certain, radicands)


def _at(ground: Ground, sample: Sample, where: str, formula: Formula) -> Any:
    if where == "target":
        from .laws import target_place

        return target_place(ground.claim, sample.place)(formula)
    return sample.place.with_definitions(ground.claim.law.quantities)(formula)


def _divisors(
    data: Mapping[str, Any], ground: Ground, samples: list[Sample], what: str
) -> tuple[list[Entry], list[int | None]]:
    """Divisors as products, and the number of the entry of each radicand."""
    ring = ground.ring
    size = len(samples)
    known = [[s.nonzero[i] for s in samples] for i in range(len(samples[0].nonzero))]
    roots = [[s.positive[i] for s in samples] for i in range(len(samples[0].positive))]
    logs = [[s.logarithms[i] for s in samples] for i in range(len(samples[0].logarithms))]
    entries: list[Entry] = []
    matched: list[int | None] = [None] * (len(roots) + len(logs))
    for number, data_of_one in enumerate(listed(field(data, "divisors", what), what)):
        label = f"divisor {number} of {what}"
        item = mapping(data_of_one, label)
        only(item, label, "formula", "content", "factors", "where")
        powers = ring.powers(field(item, "factors", label), label, negative=True)
        content = rational(field(item, "content", label), label)
        if not content:
            raise CheckError(f"{label} is zero")
        factor = arb(fmpq(content.numerator, content.denominator))
        values = []
        for sample in samples:
            try:
                values.append(factor * ring.value_of_powers(powers, sample.values))
            except UndefinedError:
                raise InaccurateError from None
        shown = text(field(item, "formula", label), label)
        where = choice(item.get("where", "own"), label, "own", "target")
        if where == "target" and ground.claim.law.target is None:
            raise CheckError(f"{label} is one of a target that there is not")
        if shown != GRAM:
            formula = parse(shown, label)
            try:
                stated = [_at(ground, sample, where, formula) for sample in samples]
            except UndefinedError:
                raise CheckError(f"{label} is not defined") from None
            if not agree(values, stated):
                raise CheckError(f"{label}: its factors do not make {shown}")
        here = [i for i, known_values in enumerate([*roots, *logs]) if agree(values, known_values)]
        if not here and not any(agree(values, known_values) for known_values in known):
            raise CheckError(f"{label} is nothing by which the law divides")
        for i in here:
            matched[i] = len(entries)
        entries.append(Entry(1 if content > 0 else -1, powers))
    assert size
    return entries, matched


def _nonzero(ground: Ground, entries: Sequence[Entry]) -> frozenset[str]:
    """Keys of factors that do not vanish, where those in denominators are known not to."""
    found = {monic(ground.ring.generator(a.name))[0] for a in ground.auxiliary if a.positive}
    for names, _ in ground.inverted:
        # the inverse of a matrix is one that has an inverse
        a, b, c, d, e, f = (ground.ring.generator(word) for word in names)
        found.add(monic(a * (d * f - e * e) + b * (c * e - b * f) + c * (b * e - c * d))[0])
    changed = True
    while changed:
        changed = False
        for entry in entries:
            below = {monic(p)[0] for p, n in entry.powers if n < 0 and not p.is_constant()}
            above = {monic(p)[0] for p, n in entry.powers if n > 0 and not p.is_constant()}
            if below <= found and not above <= found:
                found |= above
                changed = True
    return frozenset(found)


def _learn_positive(
    item: Any, ground: Ground, samples: list[Sample], signs: Signs, what: str
) -> None:
    """Something positive that a guard or a condition on parameters says."""
    label = f"what is positive in {what}"
    item = mapping(item, label)
    more = ("terms", "quotients") if item.get("from") == "sum" else ()
    only(item, label, "poly", "strict", "from", *more)
    poly = ground.ring.read(field(item, "poly", label), label)
    strict = field(item, "strict", label)
    source = text(field(item, "from", label), label)
    if not isinstance(strict, bool):
        raise CheckError(f"{label} has a field 'strict' that is neither true nor false")
    if source == "sum" or source.startswith("radicand "):
        return
    values = [ground.ring.value(poly, sample.values) for sample in samples]
    for formula, sign in _positive_formulas(source, ground.claim, label):
        if strict and sign != ">":
            continue
        try:
            ratio = _ratio(values, [sample.place(formula) for sample in samples])
        except UndefinedError:
            continue
        if ratio is not None and ratio > 0:
            signs.learn(poly, 1, strict)
            return
    raise CheckError(f"{label}: {source} does not say so")


def _positive_formulas(source: str, claim: Claim, label: str) -> list[tuple[Formula, str]]:
    """What a guard or a condition on parameters says, given by its text."""
    system = claim.system
    if any(sign in source for sign in "<>=&"):
        found = parse_condition(source, label)
        known = [pair for pair in system.admissible if pair[1] in (">", ">=")]
    else:
        found = [(parse(source, label), ">")]
        known = [(guard, ">") for guard in system.guards]
    return [pair for pair in found if pair in known]


def _ratio(first: Sequence[Any], second: Sequence[Any]) -> Any:
    """The number by which two lists of numbers differ, or None if there is none."""
    if any(b.contains(0) for b in second):
        return None
    ratios = [a / b for a, b in zip(first, second, strict=True)]
    return ratios[0] if agree(ratios[:1] * len(ratios), ratios) and ratios[0] != 0 else None


def _check_radicand_positive(
    item: Mapping[str, Any], ground: Ground, signs: Signs, what: str
) -> None:
    """What a proof says to be positive because it stands under a root."""
    source = item["from"]
    if not source.startswith("radicand "):
        return
    poly = ground.ring.read(item["poly"], what)
    for auxiliary in ground.auxiliary:
        if auxiliary.name == source.removeprefix("radicand ") and auxiliary.kind in (
            "root",
            "power",
        ):
            of = auxiliary.of[0][0]
            if monic(poly) == monic(of) and signs.of(poly) > 0:
                return
    raise CheckError(f"what is positive in {what}: {source} is not")


def _force(signs: Signs, radicands: Sequence[Entry]) -> None:
    """The sign of the only factor of something positive whose sign is unknown."""
    changed = True
    while changed:
        changed = False
        for entry in radicands:
            odd = [p for p, n in entry.powers if n % 2 and not p.is_constant()]
            unknown = [p for p in odd if not signs.of(p)]
            if len(unknown) == 1:
                others = entry.content
                for poly, power in entry.powers:
                    if power % 2 and poly is not unknown[0]:
                        others *= signs.of(poly)
                signs.learn(unknown[0], others)
                changed = True


class _Sum:
    """A polynomial that is a sum of positive terms, up to multiples of equations.

    The terms are constant · ∏ weight^power · base² with a positive constant, and with weights that
    are positive, or do not vanish where their power is even.
    """

    def __init__(self, data: Mapping[str, Any], ground: Ground, what: str) -> None:
        label = f"what is positive in {what}"
        ring = self.ring = ground.ring
        self.label = label
        self.poly = ring.read(field(data, "poly", label), label)
        if field(data, "strict", label) is not True:
            raise CheckError(f"{label}: a sum that is not strictly positive")
        self.terms = []
        for term in listed(field(data, "terms", label), label):
            weight, constant, base = items(term, 3, label)
            number = rational(constant, label)
            if number <= 0:
                raise CheckError(f"{label}: a term with a constant that is not positive")
            (inner,) = items(base, 1, label)
            made = ring.read(inner, label)
            self.terms.append((ring.powers(weight, label), number, made))
        self.quotients = [
            ring.read(q, label) for q in listed(field(data, "quotients", label), label)
        ]

    def holds(self, signs: Signs, nonzero: frozenset[str], equations: Sequence[Poly]) -> bool:
        """Whether the terms are known to be positive; CheckError where the sum is another."""
        if len(self.quotients) != len(equations):
            raise CheckError(
                f"{self.label}: a sum has not as many quotients as there are equations"
            )
        total = self.ring.constant(0)
        for quotient, equation in zip(self.quotients, equations, strict=True):
            total = total + quotient * equation
        certain, strict = True, False
        for weights, number, base in self.terms:
            for part, power in weights:
                known = not part.is_constant() and monic(part)[0] in nonzero
                sign = signs.of(part) or (signs.weak(part) if known else 0)
                certain = certain and (known or bool(sign) if power % 2 == 0 else sign > 0)
            strict = strict or (base.is_constant() and not base.is_zero())
            fraction = fmpq(number.numerator, number.denominator)
            total = total + fraction * self.ring.multiplied(weights) * base**2
        if total != self.poly:
            raise CheckError(f"{self.label}: a sum is another polynomial")
        return certain and strict


def _settle(
    signs: Signs,
    radicands: Sequence[Entry],
    sums: Sequence[_Sum],
    nonzero: frozenset[str],
    equations: Sequence[Poly],
) -> list[_Sum]:
    """Learn what sums and radicands say; the sums of which the terms are not known."""
    _force(signs, radicands)
    left = list(sums)
    changed = True
    while changed:
        changed = False
        for item in list(left):
            if item.holds(signs, nonzero, equations):
                signs.learn(item.poly, 1)
                left.remove(item)
                changed = True
        _force(signs, radicands)
    return left


def _formal(ground: Ground) -> bool:
    return any(auxiliary.kind == "formal root" for auxiliary in ground.auxiliary)


def _check_roots(
    ground: Ground,
    signs: Signs,
    nonzero: frozenset[str],
    entries: Sequence[Entry],
    matched: Sequence[int | None],
    what: str,
) -> None:
    for auxiliary in ground.auxiliary:
        if auxiliary.kind == "formal root":
            if not _is_radicand(auxiliary, [entries[i] for i in matched if i is not None]):
                raise CheckError(f"{what}: {auxiliary.name} is no root of the law")
            for poly, _ in auxiliary.whole:
                if monic(poly)[0] not in nonzero and not signs.of(poly):
                    raise CheckError(f"{what}: what is taken out of {auxiliary.name} may vanish")
            continue
        if auxiliary.kind in ("root", "power") and signs.of(auxiliary.of[0][0]) <= 0:
            raise CheckError(f"{what}: what stands under the root {auxiliary.name} may be negative")


def _check_functions(
    ground: Ground,
    samples: list[Sample],
    nonzero: frozenset[str],
    signs: Signs,
    what: str,
) -> None:
    """Auxiliary function values are defined wherever the law is."""
    for auxiliary in ground.auxiliary:
        label = f"{what}: the argument of {auxiliary.name}"
        for _, below in auxiliary.of:
            for poly, _ in below:
                if monic(poly)[0] not in nonzero and not signs.of(poly):
                    raise CheckError(f"{label} has a denominator that may vanish")
        if auxiliary.kind != "known" or auxiliary.word in ("exp", "atan"):
            continue
        ring = ground.ring
        places = [
            [ring.value(above, s.values) / ring.value_of_powers(below, s.values) for s in samples]
            for above, below in auxiliary.of
        ]
        if auxiliary.word == "log":
            known, stated = "logarithms", places[0]
        elif auxiliary.word == "atan2":
            known = "nonzero"
            stated = [y * y + x * x for y, x in zip(*places, strict=True)]
        else:
            known, stated = "positive", [1 - x * x for x in places[0]]
        lists = zip(*(getattr(s, known) for s in samples), strict=True)
        if not any(agree(stated, values) for values in lists):
            raise CheckError(f"{label} is none of the law")


def _is_radicand(auxiliary: Auxiliary, radicands: Sequence[Entry]) -> bool:
    """Whether what stands under a formal root has the sign of a radicand of the law."""
    inner, whole = auxiliary.radicand
    mine = _odd(_factors(inner) + [(p, n) for p, n in whole])
    return any(_odd([*entry.powers], entry.content) == mine for entry in radicands)


def _factors(poly: Poly) -> Powers:
    """The irreducible factors of a polynomial, with its content."""
    content, parts = poly.factor()
    constant = poly.context().constant(content)
    return [(constant, 1), *((part, int(power)) for part, power in parts)]


def _odd(powers: Powers, content: int = 1) -> tuple[int, frozenset[str]]:
    """The sign of a product and its factors with odd powers, which decide its sign."""
    found: set[str] = set()
    for poly, power in powers:
        if power % 2 == 0:
            continue
        key, lead = monic(poly)
        content *= lead
        if not poly.is_constant():
            found ^= {key}
    return content, frozenset(found)


def _check_radicands(
    ground: Ground,
    signs: Signs,
    entries: Sequence[Entry],
    matched: Sequence[int | None],
    what: str,
) -> None:
    """Every root of the law is a product of roots of factors with known signs."""
    taken = [a for a in ground.auxiliary if a.kind == "formal root"]
    for (_, _, exponent), number in zip(ground.domain.positive, matched, strict=False):
        if number is None:
            raise CheckError(f"{what} does not say of what factors a root of the law is taken")
        if exponent is not None and any(
            exponent.denominator == a.number and _is_radicand(a, [entries[number]]) for a in taken
        ):
            continue
        for poly, power in entries[number].powers:
            share = None if exponent is None else exponent * power
            even = share is not None and share.denominator == 1 and share % 2 == 0
            if not even and not signs.of(poly):
                raise CheckError(f"{what} leaves open the sign of a factor under a root")


def _equations(
    data: Mapping[str, Any],
    ground: Ground,
    samples: list[Sample],
    region: Sequence[Formula],
    nonzero: frozenset[str],
    signs: Signs,
    what: str,
) -> tuple[Poly, ...]:
    found: list[Poly] = []
    ring = ground.ring
    for number, data_of_one in enumerate(listed(field(data, "equations", what), what)):
        label = f"equation {number} of {what}"
        item = mapping(data_of_one, label)
        only(item, label, "poly", "from", "denominator", "quotients")
        poly = ring.read(field(item, "poly", label), label)
        source = text(field(item, "from", label), label)
        words = source.split(" ")
        if words[0] == "root" and len(words) == 2:
            _check_root(poly, words[1], ground, label)
        elif words[0] in ("one", "same") and len(words) == 3 - (words[0] == "one"):
            _check_equal_values(
                poly, words[1:], field(item, "quotients", label), found, ground, label
            )
        elif words[0] == "circle" and len(words) == 3:
            _check_circle(poly, words[1:], ground, label)
        else:
            powers = ring.powers(item.get("denominator", []), label, negative=True)
            for factor, _ in powers:
                key = None if factor.is_constant() else monic(factor)[0]
                if key is not None and key not in nonzero and not signs.of(factor):
                    raise CheckError(f"{label} multiplies by something that may vanish")
            _check_condition(poly, powers, parse(source, label), ground, samples, region, label)
        found.append(poly)
    return tuple(found)


def _check_condition(
    poly: Poly,
    powers: Powers,
    formula: Formula,
    ground: Ground,
    samples: list[Sample],
    region: Sequence[Formula],
    label: str,
) -> None:
    if formula not in (*ground.claim.conditions, *region):
        raise CheckError(f"{label} comes from no condition")
    try:
        stated = [sample.place(formula) for sample in samples]
        values = [
            ground.ring.value(poly, sample.values)
            / ground.ring.value_of_powers(powers, sample.values)
            for sample in samples
        ]
    except UndefinedError:
        raise CheckError(f"{label} is not defined") from None
    if not agree(stated, values):
        raise CheckError(f"{label} is not the condition from which it comes")


def _check_root(poly: Poly, word: str, ground: Ground, label: str) -> None:
    for auxiliary in ground.auxiliary:
        if auxiliary.name == word and auxiliary.kind in ("root", "formal root"):
            root = ground.ring.generator(word) ** auxiliary.number - auxiliary.of[0][0]
            if not poly.is_zero() and monic(poly)[0] == monic(root)[0]:
                return
    raise CheckError(f"{label} is not that of a root")


def _check_equal_values(
    poly: Poly,
    words: Sequence[str],
    quotients: Any,
    equations: Sequence[Poly],
    ground: Ground,
    label: str,
) -> None:
    """A value is that of another symbol, or 1, because their arguments are equal on the level."""
    ring = ground.ring
    known = {a.name: a for a in ground.auxiliary}
    if not set(words) <= set(known):
        raise CheckError(f"{label} is one of an unknown symbol")
    first = known[words[0]]
    value = ring.generator(first.name)
    one: tuple[Poly, Powers] = (ring.constant(1), [])
    if len(words) == 2:
        second = known[words[1]]
        others, value = second.of, value - ring.generator(second.name)
        alike = _function(first) == _function(second) and first.kind != "formal root"
    else:
        others, value = (one,), value - 1
        alike = first.kind in ("root", "power")
    given = items(quotients, len(first.of), label)
    if not alike or not first.of or poly != value or len(others) != len(first.of):
        raise CheckError(f"{label} does not say that values are equal")
    for mine, theirs, listed_of_one in zip(first.of, others, given, strict=True):
        parts = items(listed_of_one, len(equations), label)
        total = ring.constant(0)
        for part, equation in zip(parts, equations, strict=True):
            total = total + ring.read(part, label) * equation
        left = mine[0] * ring.multiplied(theirs[1]) - theirs[0] * ring.multiplied(mine[1])
        if left != total:
            raise CheckError(f"{label}: the arguments are not equal on the level")


def _function(auxiliary: Auxiliary) -> tuple[Any, ...]:
    """Of what an auxiliary symbol is a value, whatever the arguments."""
    return (
        auxiliary.kind,
        auxiliary.word,
        auxiliary.number,
        auxiliary.orders,
        auxiliary.exponent,
    )


def _check_circle(poly: Poly, words: Sequence[str], ground: Ground, label: str) -> None:
    known = {a.name: a for a in ground.auxiliary if a.kind in ("sin", "cos")}
    if len(set(words)) == 2 and set(words) <= set(known):
        first, second = (known[word] for word in words)
        ring = ground.ring
        circle = ring.generator(words[0]) ** 2 + ring.generator(words[1]) ** 2 - 1
        same = _same_fraction(first.of[0], second.of[0], ring)
        both = {first.kind, second.kind} == {"sin", "cos"} and not poly.is_zero()
        if both and same and monic(poly)[0] == monic(circle)[0]:
            return
    raise CheckError(f"{label} is not that of a circle")


def _same_fraction(first: tuple[Poly, Powers], second: tuple[Poly, Powers], ring: Ring) -> bool:
    left = first[0] * ring.multiplied(second[1])
    return bool(left == second[0] * ring.multiplied(first[1]))
