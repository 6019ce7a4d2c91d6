"""Claims in other variables: angles as points of circles, variables expressed by others.

A proof may be one of a claim in which an angle φ has become s = sin(uφ) and c = cos(uφ), or in
which a state variable that a condition gives has become a definition.  That this claim implies
the one of the user is tested at random points that match, as the formulas of a proof are.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from flint import arb, arb_mat

from ..claim.claim import Claim, Law
from ..claim.domain import Domain, domain
from ..claim.errors import CheckError, UndefinedError
from ..claim.evaluate import Place
from ..claim.formulas import Formula, call, name, parse, product, total
from ..claim.jets import Number, add, multiply
from ..claim.json_data import items, listed, text
from ..claim.unspecified_functions import Functions
from .accuracy import agree, with_precision
from .proof import Condition

__all__ = ["CONSISTENCY", "LAW", "expressed", "substituted"]

#: What a claim in other variables says: the law, or that expressed variables move as they should.
LAW, CONSISTENCY = "law", "consistency"

POINTS, ATTEMPTS = 3, 300
GRAPH_KINDS = ("Identity", "Integral", "Isomorphism", "Measure", "Reduction", "Separation")


@dataclass(frozen=True)
class Circle:
    """An angle that has become a sine and a cosine of a multiple of it."""

    angle: str
    sine: str
    cosine: str
    unit: Formula

    @property
    def functions(self) -> tuple[tuple[str, Formula], ...]:
        """Sine and cosine by name."""
        inner = product((self.unit, name(self.angle)))
        return (self.sine, call("sin", [inner])), (self.cosine, call("cos", [inner]))


@dataclass(frozen=True)
class Change:
    """All that is substituted."""

    circles: tuple[Circle, ...]
    graph: Mapping[str, Formula]


@dataclass(frozen=True)
class Pair:
    """A point in the old and in the new variables."""

    old: Place
    new: Place


def expressed(data: Any) -> tuple[tuple[str, str], ...]:
    """The variables that are expressed by others, with the texts of their formulas."""
    return tuple(sorted((part[1], part[2]) for part in data if part[0] == "graph"))


def substituted(
    claim: Claim,
    stated: Claim,
    data: Any,
    region: Sequence[Formula],
    conditions: Sequence[Condition],
    what: str,
) -> set[str]:
    """What a claim in other variables says of `claim`: `LAW`, `CONSISTENCY` or both.

    It must be defined wherever `claim` is and `conditions` hold.

    Raises
    ------
    CheckError
        If it says neither.
    """
    change = _read(claim, data, what)
    found: set[str] = with_precision(
        lambda: _matched(claim, stated, change, region, conditions, what)
    )
    return found


def _read(claim: Claim, data: Any, what: str) -> Change:
    circles: list[Circle] = []
    graph: dict[str, Formula] = {}
    system = claim.system
    used: set[str] = {*system.symbols, *system.definitions, *claim.law.quantities}
    gone: set[str] = set()
    for part in listed(data, f"the substitution of {what}"):
        kind = listed(part, f"a substitution of {what}")[:1]
        if list(kind) == ["circle"]:
            _, angle, sine, cosine, unit = (text(t, what) for t in items(part, 5, what))
            made = parse(unit, f"the unit of an angle of {what}")
            if angle not in system.symbols or angle in gone or {sine, cosine} & used:
                raise CheckError(f"{what} has a circle for {angle!r} that makes no sense")
            if sine == cosine:
                raise CheckError(f"{what} has a circle for {angle!r} that makes no sense")
            if not system.reach([made]) <= {*system.parameters, *system.definitions}:
                raise CheckError(f"{what} has a unit of {angle} that is no constant")
            used |= {sine, cosine}
            gone.add(angle)
            circles.append(Circle(angle, sine, cosine, made))
        elif list(kind) == ["graph"]:
            _, symbol, formula = (text(t, what) for t in items(part, 3, what))
            if symbol not in system.state or symbol in gone:
                raise CheckError(f"{what} expresses {symbol!r}, which is no state variable")
            gone.add(symbol)
            graph[symbol] = parse(formula, f"the expression of {symbol} in {what}")
        else:
            raise CheckError(f"{what} has a substitution of an unknown kind")
    if graph and claim.law.kind not in GRAPH_KINDS:
        raise CheckError(f"{what} expresses variables of a law of the kind {claim.law.kind}")
    units = system.reach(c.unit for c in circles)
    if units & {c.angle for c in circles} or units & set(system.state):
        raise CheckError(f"{what} has a unit of an angle that is no constant")
    return Change(tuple(circles), graph)


def _pairs(claim: Claim, stated: Claim, change: Change, what: str) -> list[Pair]:
    found: list[Pair] = []
    generator = random.Random(what)
    for attempt in range(ATTEMPTS):
        try:
            found.append(_pair(claim, stated, change, generator, attempt))
        except UndefinedError:
            continue
        if len(found) == POINTS:
            return found
    raise CheckError(f"{what}: no random points were found at which its variables are defined")


def _pair(
    claim: Claim, stated: Claim, change: Change, generator: random.Random, attempt: int
) -> Pair:
    system = claim.system
    functions = Functions(str(attempt))
    values: dict[str, Number] = {}
    for word in system.symbols:
        if word not in change.graph:
            fine = arb(generator.randint(-(2**22), 2**22))
            values[word] = 1 + fine * 3 / 2**24 if attempt % 2 else fine / 2**21
    rates = dict(zip(system.state, system.rates, strict=True))
    graph = dict(change.graph)
    # expressed variables are definitions, so that they move as their expressions do
    own = {word: rate for word, rate in rates.items() if word not in graph}
    old = Place(values, {**system.definitions, **graph}, own, functions)
    image = dict(values)
    for circle in change.circles:
        del image[circle.angle]
        for word, formula in circle.functions:
            image[word] = old(formula)
    known = {w: v for w, v in image.items() if w in stated.system.symbols}
    if len(known) < len(image) or len(image) < len(stated.system.symbols):
        raise CheckError("the variables of a claim in other variables are not those substituted")
    pair = Pair(old, stated.system.place(known, functions))
    _defined(claim, stated, pair)
    return pair


def _defined(claim: Claim, stated: Claim, pair: Pair) -> None:
    """Formulas are evaluated once, so that undefined points are left out."""
    old = pair.old.with_definitions(claim.law.quantities)
    new = pair.new.with_definitions(stated.law.quantities)
    for formula in (*claim.conditions, *claim.system.rates, *claim.law.formulas()):
        old(formula)
    for formula in (*stated.conditions, *stated.system.rates, *stated.law.formulas()):
        new(formula)


def _matched(
    claim: Claim,
    stated: Claim,
    change: Change,
    region: Sequence[Formula],
    conditions: Sequence[Condition],
    what: str,
) -> set[str]:
    new, old = stated.system, claim.system
    circles = {c.angle: c for c in change.circles}
    wanted = []
    for word in old.state:
        if word in circles:
            wanted += [circles[word].sine, circles[word].cosine]
        elif word not in change.graph:
            wanted.append(word)
    if sorted(wanted) != sorted(new.state):
        raise CheckError(f"the state of the claim of {what} is not the substituted one")
    pairs = _pairs(claim, stated, change, what)

    def equal(first: Formula, second: Formula) -> bool:
        values = [p.old(first) for p in pairs]
        return agree(values, [p.new(second) for p in pairs])

    images = {w: f for c in change.circles for w, f in c.functions}
    rates = dict(zip(old.state, old.rates, strict=True))
    for word, rate in zip(new.state, new.rates, strict=True):
        before = call("Rate", [images[word]]) if word in images else rates[word]
        if not equal(before, rate):
            raise CheckError(
                f"the rate of {word} in the claim of {what} is not the substituted one"
            )
    _check_conditions(claim, stated, change, pairs, what)
    _check_domain(claim, stated, change, conditions, pairs, what)
    for guard in new.guards:
        if not any(equal(before, guard) for before in old.guards):
            raise CheckError(f"a guard in the claim of {what} is none of the system")
    if not set(new.admissible) <= set(old.admissible):
        raise CheckError(f"what is admissible in the claim of {what} is not so in the system")
    for formula in region:
        if not equal(formula, formula):
            raise CheckError(f"the region of {what} is not the substituted one")
    found = set()
    if change.graph and _says_consistency(claim, stated, change, pairs):
        found.add(CONSISTENCY)
    if _says_law(claim, stated, change, pairs):
        found.add(LAW)
    if not found:
        raise CheckError(f"the law in the claim of {what} is not the substituted one")
    return found


def _check_conditions(
    claim: Claim, stated: Claim, change: Change, pairs: Sequence[Pair], what: str
) -> None:
    """Conditions stay, but those that express variables; and points are on circles."""
    left = []
    for condition in claim.conditions:
        values = [pair.old(condition) for pair in pairs]
        if not (change.graph and agree(values, [arb(0)] * len(values))):
            left.append(values)
    expressed = len(claim.conditions) - len(left)
    if expressed != len(change.graph):
        raise CheckError(
            f"{what} expresses {len(change.graph)} variables by {expressed} conditions"
        )
    others = []
    for condition in stated.conditions:
        values = [pair.new(condition) for pair in pairs]
        index = next((i for i, known in enumerate(left) if agree(values, known)), None)
        if index is None:
            others.append(condition)
        else:
            del left[index]
    if left:
        raise CheckError(f"a condition of the system is missing in the claim of {what}")
    _check_circles(others, change, what)


def _check_domain(
    claim: Claim,
    stated: Claim,
    change: Change,
    conditions: Sequence[Condition],
    pairs: Sequence[Pair],
    what: str,
) -> None:
    """No point is lost: what the new claim divides by vanishes only where the old one has no sense.

    That the conditions cut out a volume does not depend on the variables.
    """
    before, after = (replace(domain(c, {}), gram=False) for c in (claim, stated))
    known = _columns([_of_domain(before, pair.old) for pair in pairs])
    new = _columns([_of_domain(after, pair.new) for pair in pairs])
    known[0] += [[pair.old(c.formula) for pair in pairs] for c in conditions]
    known[1] += [[pair.old(c.formula) for pair in pairs] for c in conditions if c.positive]
    factors = [_factors(claim, change, pair) for pair in pairs]
    new[0] += [list(column) for column in zip(*factors, strict=True)]
    constant = [arb(1)] * len(pairs)
    for values in new[0]:
        if not any(_vanish_alike(values, others) for others in [constant, *known[0], *known[1]]):
            raise CheckError(f"the claim of {what} divides by what the system does not")
    for values in new[1]:
        if not any(_positive_alike(values, others) for others in [constant, *known[1]]):
            raise CheckError(f"the claim of {what} takes a root that the system does not")


def _of_domain(made: Domain, place: Place) -> tuple[list[Any], list[Any]]:
    nonzero, positive, logarithms = made.values(place)
    return nonzero, [*positive, *logarithms]


def _columns(rows: Sequence[Sequence[list[Any]]]) -> list[list[Any]]:
    """Lists of values at all points, from lists at each."""
    return [
        [list(column) for column in zip(*lists, strict=True)] for lists in zip(*rows, strict=True)
    ]


def _vanish_alike(values: Sequence[Any], others: Sequence[Any]) -> bool:
    """Whether two functions, or one and the square of the other, differ by a number."""
    forms = [(values, others), ([v * v for v in values], others)]
    forms.append((values, [o * o for o in others]))
    return any(_proportional(a, b) for a, b in forms)


def _proportional(values: Sequence[Any], others: Sequence[Any]) -> bool:
    if any(v.contains(0) for v in (*values, *others)):
        return False
    ratios = [v / o for v, o in zip(values, others, strict=True)]
    return agree(ratios[:1] * len(ratios), ratios)


def _positive_alike(values: Sequence[Any], others: Sequence[Any]) -> bool:
    return _proportional(values, others) and bool(values[0] / others[0] > 0)


def _factors(claim: Claim, change: Change, pair: Pair) -> list[Any]:
    """Determinant of the derivatives of the conditions by the variables they express."""
    return [_slopes_determinant(claim, change, pair)] if change.graph else []


def _check_circles(conditions: Sequence[Formula], change: Change, what: str) -> None:
    """The conditions that are none of the system must be those of the circles."""
    circles = [parse(f"{c.sine}**2 + {c.cosine}**2 - 1", "a circle") for c in change.circles]
    stated, wanted = (sorted(map(_ordered, group), key=id) for group in (conditions, circles))
    if stated != wanted:
        raise CheckError(f"the conditions of the claim of {what} are not the substituted ones")


def _ordered(formula: Formula) -> Formula:
    """A sum with its terms in an order of its own."""
    return total(sorted(formula.parts, key=id)) if formula.kind == "sum" else formula


# --- laws ----------------------------------------------------------------------------------------


def _says_consistency(claim: Claim, stated: Claim, change: Change, pairs: Sequence[Pair]) -> bool:
    """Whether the claim is that the rate of each expression is that of its variable."""
    if stated.law.kind != "Identity":
        return False
    formulas = stated.law.several["value"]
    rates = dict(zip(claim.system.state, claim.system.rates, strict=True))
    for symbol, expression in change.graph.items():
        wanted = [
            add(p.old(call("Rate", [expression])), multiply(arb(-1), p.old(rates[symbol])))
            for p in pairs
        ]
        if not any(agree(wanted, [p.new(f) for p in pairs]) for f in formulas):
            return False
    return True


def _says_law(claim: Claim, stated: Claim, change: Change, pairs: Sequence[Pair]) -> bool:
    old, new = claim.law, stated.law
    if (old.kind, old.rank, old.target) != (new.kind, new.rank, new.target):
        return False
    if old.kind == "Measure":
        return _same_density(claim, stated, change, pairs)
    places = [
        (p.old.with_definitions(old.quantities), p.new.with_definitions(new.quantities))
        for p in pairs
    ]

    def equal(first: Formula, second: Formula) -> bool:
        return agree([a(first) for a, _ in places], [b(second) for _, b in places])

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
    return _same_tensors(claim, stated, change, pairs)


def _same_tensors(claim: Claim, stated: Claim, change: Change, pairs: Sequence[Pair]) -> bool:
    """Vector fields and brackets are carried along by the change of variables."""
    old, new = claim.law, stated.law
    if "field" in old.pairs:
        for pair in pairs:
            push = _components(old, claim.system.state, pair.old)
            wanted = [
                _sum(_rows(claim, stated, change, pair)[w], push) for w in stated.system.state
            ]
            if not agree(wanted, _components(new, stated.system.state, pair.new)):
                return False
    if old.matrix:
        for pair in pairs:
            rows = _rows(claim, stated, change, pair)
            matrix = [[pair.old(entry) for entry in row] for row in old.matrix]
            half = [
                [_sum(rows[w], column) for column in zip(*matrix, strict=True)]
                for w in stated.system.state
            ]
            wanted = [_sum(rows[w], row) for row in half for w in stated.system.state]
            if not agree(wanted, [pair.new(entry) for row in new.matrix for entry in row]):
                return False
    return True


def _components(law: Law, state: Sequence[str], place: Place) -> list[Any]:
    given = dict(law.pairs["field"])
    return [place(given[word]) if word in given else arb(0) for word in state]


def _rows(claim: Claim, stated: Claim, change: Change, pair: Pair) -> dict[str, list[Any]]:
    """Differentials of the new variables by the old ones."""
    partial = pair.old.partial(claim.system.state)
    images = {w: f for c in change.circles for w, f in c.functions}
    found = {}
    for word in stated.system.state:
        slopes = partial.slopes(images.get(word, name(word)))
        found[word] = [slopes.get(i, arb(0)) for i in range(len(claim.system.state))]
    return found


def _sum(first: Sequence[Any], second: Sequence[Any]) -> Any:
    return sum((a * b for a, b in zip(first, second, strict=True)), arb(0))


def _same_density(claim: Claim, stated: Claim, change: Change, pairs: Sequence[Pair]) -> bool:
    """The density, divided by the factors of the conditions that express variables."""
    first, second = claim.law.pairs["density"], stated.law.pairs["density"]
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
        determinant = _slopes_determinant(claim, change, pair)
        if not (agree([factor], [determinant]) or agree([factor], [-determinant])):
            return False
    return True


def _slopes_determinant(claim: Claim, change: Change, pair: Pair) -> Any:
    """Of the derivatives of the conditions by the variables they express."""
    words = list(change.graph)
    values = {w: pair.old(name(w)) for w in claim.system.symbols}
    place = Place(values, claim.system.definitions, {}, pair.old.functions)
    partial = place.partial(words)
    rows = []
    for condition in claim.conditions:
        if agree([pair.old(condition)], [arb(0)]):
            slopes = partial.slopes(condition)
            rows.append([slopes.get(i, arb(0)) for i in range(len(words))])
    return arb_mat(rows).det() if len(rows) == len(words) else arb(0)
