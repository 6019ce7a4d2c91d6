"""Domain of a law: the divisors of its formulas and their radicands.

A law is claimed only where no divisor and no argument of an absolute value or a sign vanishes, and
where radicands, bases of non-integer powers and arguments of logarithms are positive.

A power b^a, where a is not written as a number, is defined for positive b and, for integer a, also
for negative b.  So only b ≠ 0 may be assumed; a proof that uses b > 0 is valid where that is known
or is a condition of the verdict.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

from .claim import Claim
from .errors import UndefinedError
from .evaluate import Point, exact_value
from .formulas import Formula, call, number, power, product, total, walk
from .functions import HALF
from .residuals import gram_determinants, target_point

#: Label of the determinant that vanishes if the conditions define no volume.
GRAM = "the volume of the conditions"


@dataclass(frozen=True)
class Domain:
    """Formulas that determine where a law is defined.

    Attributes
    ----------
    nonzero : tuple of (side, formula)
        Nonzero formulas; the side is ``"own"`` or ``"target"``.
    positive : tuple of (side, formula, exponent)
        Positive formulas, each with the exponent of the power in which it occurs.
    bases : tuple of (side, formula)
        Bases of powers with symbolic exponents; nonzero, but possibly negative.
    logarithms : tuple of (side, formula)
        Positive formulas, the arguments of logarithms.
    gram : bool
        True if the conditions must be independent.
    """

    claim: Claim
    nonzero: tuple[tuple[str, Formula], ...]
    positive: tuple[tuple[str, Formula, Fraction], ...]
    bases: tuple[tuple[str, Formula], ...]
    logarithms: tuple[tuple[str, Formula], ...]
    gram: bool

    @property
    def formulas(self) -> list[tuple[str, Formula]]:
        """All formulas: divisors, radicands, arguments of logarithms, bases of symbolic powers."""
        positive = [(where, formula) for where, formula, _ in self.positive]
        return [*self.nonzero, *positive, *self.logarithms, *self.bases]

    def places(self, point: Point) -> dict[str, Point]:
        """The point and its image, for formulas of either side."""
        places = {"own": point.with_definitions(self.claim.law.quantities)}
        if self.claim.law.target is not None:
            places["target"] = target_point(self.claim, point)
        return places

    def require(self, point: Point) -> None:
        """Raise an error unless the law is defined at a point, in real balls.

        Raises
        ------
        UndefinedError
            If the law is not certainly defined there, or has a power with a symbolic exponent and
            a base that is not positive.
        """
        places = self.places(point)
        values = [places[where](formula) for where, formula in self.formulas]
        nonzero = values[: len(self.nonzero)]
        if self.gram:
            nonzero += gram_determinants(self.claim, point)
        if any(value.contains(0) for value in nonzero):
            raise UndefinedError("a divisor may vanish")
        if not all(value > 0 for value in values[len(self.nonzero) :]):
            raise UndefinedError("a radicand or the argument of a logarithm may not be positive")


def domain(claim: Claim, parameter_formulas: Mapping[str, Formula]) -> Domain:
    """Formulas that determine where the law of a claim is defined.

    Parameters
    ----------
    parameter_formulas : mapping of name to formula
        Parameters with a value on the level; with it an exponent may become an integer.
    """
    system, law = claim.system, claim.law
    collector = _Collector()
    known = {**system.definitions, **law.quantities}
    # A positive guard is defined, so its divisors are nonzero too.
    base = [*system.rates, *claim.conditions, *system.guards, *law.formulas()]
    needed = system.reach(base, law.quantities)
    formulas = [*base, *(f for word, f in known.items() if word in needed)]
    collector.collect("own", formulas, known, parameter_formulas)
    if law.kind == "Measure":
        for density, _ in law.pairs["density"]:
            collector.nonzero_factors("own", density)
    if law.target is not None:
        target = law.target
        base = [*target.rates, *target.relations, *law.several["onto"]]
        needed = target.reach(base)
        formulas = [*base, *(f for word, f in target.definitions.items() if word in needed)]
        constants = constant_values(claim, {**known, **parameter_formulas})
        own = {**target.definitions, **constant_values(claim, known)}
        collector.collect("target", formulas, own, constants)
    gram = law.kind == "Measure" and bool(claim.moving)
    return Domain(
        claim,
        tuple(collector.nonzero),
        tuple(collector.positive),
        tuple(collector.bases),
        tuple(collector.logarithms),
        gram,
    )


def constant_values(claim: Claim, definitions: Mapping[str, Formula]) -> dict[str, Formula]:
    """Parameters of the target that have a constant value."""
    law, target = claim.law, claim.law.target
    assert target is not None
    formulas = dict(law.pairs["constants"])
    values = {}
    for word in target.parameters:
        formula = formulas.get(word, definitions.get(word))
        value = None if formula is None else exact_value(formula, definitions)
        if value is not None:
            values[word] = number(value)
    return values


class _Collector:
    """Collected formulas without repetitions."""

    def __init__(self) -> None:
        self.nonzero: dict[tuple[str, Formula], None] = {}
        self.positive: dict[tuple[str, Formula, Fraction], None] = {}
        self.bases: dict[tuple[str, Formula], None] = {}
        self.logarithms: dict[tuple[str, Formula], None] = {}

    def collect(
        self,
        where: str,
        formulas: Iterable[Formula],
        own_definitions: Mapping[str, Formula],
        parameter_formulas: Mapping[str, Formula],
    ) -> None:
        definitions = {**own_definitions, **parameter_formulas}
        for node in walk(formulas):
            if node.kind == "power":
                base, exponent = node.parts
                value = exact_value(exponent, definitions)
                if exact_value(exponent, own_definitions) is None:
                    # An exponent that is a number only on the level may be another number next to
                    # it, so derivatives divide by the base.
                    self.nonzero[where, base] = None
                if value is None:
                    self.bases[where, base] = None
                elif value.denominator != 1:
                    self.positive[where, base, value] = None
                elif value < 0:
                    self.nonzero_factors(where, base)
            elif node.kind == "call":
                self._add_call(where, node.word, node.parts)

    def nonzero_factors(self, where: str, base: Formula) -> None:
        """Collect the factors that are nonzero if `base` is nonzero."""
        for part in _factors(base):
            self.nonzero[where, part] = None

    def _add_call(self, where: str, word: str, parts: tuple[Formula, ...]) -> None:
        first = parts[0]
        if word == "sqrt":
            self.positive[where, first, HALF] = None
        elif word in ("Abs", "sign"):
            # |a| is (a²)^1/2, which is differentiable only for a ≠ 0.
            self.positive[where, power(first, number(2)), HALF] = None
        elif word == "log":
            self.logarithms[where, first] = None
        elif word in ("asin", "acos"):
            # The derivatives divide by the square root of 1 − a².
            square = total((number(1), product((number(-1), power(first, number(2))))))
            self.positive[where, square, HALF] = None
        elif word == "atan2":
            self.nonzero[where, total(power(part, number(2)) for part in parts)] = None
        elif word in _DIVISORS:
            self.nonzero[where, call(_DIVISORS[word], parts)] = None


_DIVISORS = {"tan": "cos", "sec": "cos", "cot": "sin", "csc": "sin", "tanh": "cosh"}


def _factors(base: Formula) -> Iterator[Formula]:
    """A formula and, if it is a product, its factors."""
    if base.kind == "number":
        if not base.word:
            yield base
        return
    yield base
    if base.kind == "product":
        for part in base.parts:
            yield from _factors(part)
    elif base.kind == "power" and base.parts[1].kind == "number":
        yield from _factors(base.parts[0])
