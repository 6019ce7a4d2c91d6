"""A change of variables in a claim, and points in the old and the new variables."""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import dataclass

from flint import arb, arb_mat

from ..claim.claim import Claim
from ..claim.errors import CheckError, UndefinedError
from ..claim.evaluate import Point
from ..claim.formulas import Formula, call, name, parse, product
from ..claim.jets import Number
from ..claim.json_data import as_list, items, text
from ..claim.unspecified_functions import Functions
from .accuracy import agree

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
class PointPair:
    """A point in the old and in the new variables."""

    old: Point
    new: Point


def read_change(claim: Claim, data: object, what: str) -> Change:
    """The change of variables that a proof says it makes."""
    circles: list[Circle] = []
    graph: dict[str, Formula] = {}
    system = claim.system
    used: set[str] = {*system.symbols, *system.definitions, *claim.law.quantities}
    gone: set[str] = set()
    for part in as_list(data, f"the substitution of {what}"):
        kind = as_list(part, f"a substitution of {what}")[:1]
        if list(kind) == ["circle"]:
            _, angle, sine, cosine, unit = (text(t, what) for t in items(part, 5, what))
            frequency = parse(unit, f"the unit of an angle of {what}")
            if angle not in system.symbols or angle in gone or {sine, cosine} & used:
                raise CheckError(f"{what} has a circle for {angle!r} that makes no sense")
            if sine == cosine:
                raise CheckError(f"{what} has a circle for {angle!r} that makes no sense")
            if not system.reach([frequency]) <= {*system.parameters, *system.definitions}:
                raise CheckError(f"{what} has a unit of {angle} that is no constant")
            used |= {sine, cosine}
            gone.add(angle)
            circles.append(Circle(angle, sine, cosine, frequency))
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


def point_pairs(claim: Claim, claim_there: Claim, change: Change, what: str) -> list[PointPair]:
    """Random points at which both claims are defined."""
    pairs: list[PointPair] = []
    generator = random.Random(what)
    for attempt in range(ATTEMPTS):
        try:
            pairs.append(_pair(claim, claim_there, change, generator, attempt))
        except UndefinedError:
            continue
        if len(pairs) == POINTS:
            return pairs
    raise CheckError(f"{what}: no random points were found at which its variables are defined")


def _pair(
    claim: Claim, claim_there: Claim, change: Change, generator: random.Random, attempt: int
) -> PointPair:
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
    old = Point(values, {**system.definitions, **graph}, own, functions)
    image = dict(values)
    for circle in change.circles:
        del image[circle.angle]
        for word, formula in circle.functions:
            image[word] = old(formula)
    known = {w: v for w, v in image.items() if w in claim_there.system.symbols}
    if len(known) < len(image) or len(image) < len(claim_there.system.symbols):
        raise CheckError("the variables of a claim in other variables are not those substituted")
    pair = PointPair(old, claim_there.system.point(known, functions))
    _require_defined(claim, claim_there, pair)
    return pair


def _require_defined(claim: Claim, claim_there: Claim, pair: PointPair) -> None:
    """Formulas are evaluated once, so that undefined points are left out."""
    old = pair.old.with_definitions(claim.law.quantities)
    new = pair.new.with_definitions(claim_there.law.quantities)
    for formula in (*claim.conditions, *claim.system.rates, *claim.law.formulas()):
        old(formula)
    for formula in (
        *claim_there.conditions,
        *claim_there.system.rates,
        *claim_there.law.formulas(),
    ):
        new(formula)


def slopes_determinant(claim: Claim, change: Change, pair: PointPair) -> arb:
    """The determinant of the conditions that express variables, derived by these."""
    words = list(change.graph)
    values = {w: pair.old(name(w)) for w in claim.system.symbols}
    point = Point(values, claim.system.definitions, {}, pair.old.functions)
    partial = point.partial(words)
    rows = []
    for condition in claim.conditions:
        if agree([pair.old(condition)], [arb(0)]):
            slopes = partial.slopes(condition)
            rows.append([slopes.get(i, arb(0)) for i in range(len(words))])
    return arb_mat(rows).det() if len(rows) == len(words) else arb(0)
