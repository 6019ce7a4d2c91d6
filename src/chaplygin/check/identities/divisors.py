"""Divisors of a law as products of polynomials, none of which vanishes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from flint import arb, fmpq

from ..claim.domain import GRAM
from ..claim.errors import CheckError, UndefinedError
from ..claim.formulas import Formula, parse
from ..claim.jets import Number
from ..claim.json_data import as_list, choice, field, mapping, only, rational, text
from ..claim.polynomials import Powers, monic
from ..claim.residuals import target_point
from .accuracy import InaccurateError, agree
from .generators import Generators, Sample


@dataclass(frozen=True)
class Entry:
    """A formula as a product: content · ∏ factor^power."""

    content: int
    powers: Powers


def _value_at(generators: Generators, sample: Sample, where: str, formula: Formula) -> Number:
    if where == "target":
        return target_point(generators.claim, sample.point)(formula)
    return sample.point.with_definitions(generators.claim.law.quantities)(formula)


def read_divisors(
    data: Mapping[str, object], generators: Generators, samples: list[Sample], what: str
) -> tuple[list[Entry], list[int | None], list[int | None]]:
    """Divisors as products, and the numbers of the entries of radicands and of bases.

    Radicands are followed by arguments of logarithms; bases are those of symbolic powers.
    """
    ring = generators.ring
    size = len(samples)
    known = [[s.nonzero[i] for s in samples] for i in range(len(samples[0].nonzero))]
    roots = [[s.positive[i] for s in samples] for i in range(len(samples[0].positive))]
    logs = [[s.logarithms[i] for s in samples] for i in range(len(samples[0].logarithms))]
    bases = [[s.bases[i] for s in samples] for i in range(len(samples[0].bases))]
    entries: list[Entry] = []
    matched: list[int | None] = [None] * (len(roots) + len(logs) + len(bases))
    for number, data_of_one in enumerate(as_list(field(data, "divisors", what), what)):
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
        if where == "target" and generators.claim.law.target is None:
            raise CheckError(f"{label} is one of a target that there is not")
        if shown != GRAM:
            formula = parse(shown, label)
            try:
                stated = [_value_at(generators, sample, where, formula) for sample in samples]
            except UndefinedError:
                raise CheckError(f"{label} is not defined") from None
            if not agree(values, stated):
                raise CheckError(f"{label}: its factors do not make {shown}")
        all_known = [*roots, *logs, *bases]
        here = [i for i, known_values in enumerate(all_known) if agree(values, known_values)]
        if not here and not any(agree(values, known_values) for known_values in known):
            raise CheckError(f"{label} is nothing by which the law divides")
        for i in here:
            matched[i] = len(entries)
        entries.append(Entry(1 if content > 0 else -1, powers))
    assert size
    sure = len(roots) + len(logs)
    return entries, matched[:sure], matched[sure:]


def nonzero_factors(generators: Generators, entries: Sequence[Entry]) -> frozenset[str]:
    """Keys of factors that do not vanish, where those in denominators are known not to."""
    # a formal root is that of a radicand of the law, divided by what does not vanish
    roots = [a.name for a in generators.auxiliary if a.positive or a.kind == "formal root"]
    keys = {monic(generators.ring.generator(name))[0] for name in roots}
    for names, _ in generators.inverses:
        # the inverse of a matrix is one that has an inverse
        a, b, c, d, e, f = (generators.ring.generator(word) for word in names)
        keys.add(monic(a * (d * f - e * e) + b * (c * e - b * f) + c * (b * e - c * d))[0])
    changed = True
    while changed:
        changed = False
        for entry in entries:
            below = {monic(p)[0] for p, n in entry.powers if n < 0 and not p.is_constant()}
            above = {monic(p)[0] for p, n in entry.powers if n > 0 and not p.is_constant()}
            if below <= keys and not above <= keys:
                keys |= above
                changed = True
    return frozenset(keys)
