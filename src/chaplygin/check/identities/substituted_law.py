"""Whether a law in other variables says what it says in those of the claim."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb

from ..claim.claim import Claim, Law
from ..claim.evaluate import Point
from ..claim.formulas import Formula, call, name
from ..claim.jets import add, multiply
from .accuracy import agree
from .change_of_variables import Change, PointPair, slopes_determinant


def says_consistency(
    claim: Claim, claim_there: Claim, change: Change, pairs: Sequence[PointPair]
) -> bool:
    """Whether the claim is that the rate of each expression is that of its variable."""
    if claim_there.law.kind != "Identity":
        return False
    formulas = claim_there.law.several["value"]
    rates = dict(zip(claim.system.state, claim.system.rates, strict=True))
    for symbol, expression in change.graph.items():
        wanted = [
            add(p.old(call("Rate", [expression])), multiply(arb(-1), p.old(rates[symbol])))
            for p in pairs
        ]
        if not any(agree(wanted, [p.new(f) for p in pairs]) for f in formulas):
            return False
    return True


def says_law(claim: Claim, claim_there: Claim, change: Change, pairs: Sequence[PointPair]) -> bool:
    """Whether the claim is the law, carried along by the change of variables."""
    old, new = claim.law, claim_there.law
    if (old.kind, old.rank, old.target) != (new.kind, new.rank, new.target):
        return False
    if old.kind == "Measure":
        return _same_density(claim, claim_there, change, pairs)
    points = [
        (p.old.with_definitions(old.quantities), p.new.with_definitions(new.quantities))
        for p in pairs
    ]

    def equal(first: Formula, second: Formula) -> bool:
        return agree([a(first) for a, _ in points], [b(second) for _, b in points])

    for key, formula in old.single.items():
        if not equal(formula, new.single[key]):
            return False
    for key, formulas in old.several.items():
        others = new.several[key]
        if key == "onto":
            if formulas != others:
                return False
            continue
        if len(formulas) != len(others) or not all(map(equal, formulas, others)):
            return False
    for key in set(old.pairs) - {"field"}:
        first, second = dict(old.pairs[key]), dict(new.pairs[key])
        if list(first) != list(second) or not all(equal(first[w], second[w]) for w in first):
            return False
    return _same_tensors(claim, claim_there, change, pairs)


def _same_tensors(
    claim: Claim, claim_there: Claim, change: Change, pairs: Sequence[PointPair]
) -> bool:
    """Vector fields and brackets are carried along by the change of variables."""
    old, new = claim.law, claim_there.law
    if "field" in old.pairs:
        for pair in pairs:
            push = _components(old, claim.system.state, pair.old)
            wanted = [
                _sum(_rows(claim, claim_there, change, pair)[w], push)
                for w in claim_there.system.state
            ]
            if not agree(wanted, _components(new, claim_there.system.state, pair.new)):
                return False
    if old.matrix:
        for pair in pairs:
            rows = _rows(claim, claim_there, change, pair)
            matrix = [[pair.old(entry) for entry in row] for row in old.matrix]
            half = [
                [_sum(rows[w], column) for column in zip(*matrix, strict=True)]
                for w in claim_there.system.state
            ]
            wanted = [_sum(rows[w], row) for row in half for w in claim_there.system.state]
            if not agree(wanted, [pair.new(entry) for row in new.matrix for entry in row]):
                return False
    return True


def _components(law: Law, state: Sequence[str], point: Point) -> list[arb]:
    components = dict(law.pairs["field"])
    return [point(components[word]) if word in components else arb(0) for word in state]


def _rows(
    claim: Claim, claim_there: Claim, change: Change, pair: PointPair
) -> dict[str, list[arb]]:
    """Differentials of the new variables by the old ones."""
    partial = pair.old.partial(claim.system.state)
    images = {w: f for c in change.circles for w, f in c.functions}
    rows = {}
    for word in claim_there.system.state:
        slopes = partial.slopes(images.get(word, name(word)))
        rows[word] = [slopes.get(i, arb(0)) for i in range(len(claim.system.state))]
    return rows


def _sum(first: Sequence[arb], second: Sequence[arb]) -> arb:
    return sum((a * b for a, b in zip(first, second, strict=True)), arb(0))


def _same_density(
    claim: Claim, claim_there: Claim, change: Change, pairs: Sequence[PointPair]
) -> bool:
    """The density, divided by the factors of the conditions that express variables."""
    first, second = claim.law.pairs["density"], claim_there.law.pairs["density"]
    if len(second) != len(first) + len(change.graph):
        return False
    for (base, exponent), (image, number) in zip(first, second, strict=False):
        for before, after in ((base, image), (exponent, number)):
            if not agree([p.old(before) for p in pairs], [p.new(after) for p in pairs]):
                return False
    extra = second[len(first) :]
    if not change.graph:
        return True
    for pair in pairs:
        factor = arb(1)
        for base, exponent in extra:
            if not agree([pair.new(exponent)], [arb(-1)]):
                return False
            factor = factor * pair.new(base)
        determinant = slopes_determinant(claim, change, pair)
        if not (agree([factor], [determinant]) or agree([factor], [-determinant])):
            return False
    return True
