"""Generators and auxiliary symbols of a proof, and points of both.

Generators are state variables, parameters and definitions that take the place of a parameter;
auxiliary symbols are roots, powers and function values of them.  At a random point of the
generators everything else has a value, so that formulas and polynomials can be compared.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import arb, fmpq

from ..claim.claim import Claim
from ..claim.domain import Domain
from ..claim.errors import CheckError, UndefinedError
from ..claim.evaluate import Point
from ..claim.formulas import Formula, name
from ..claim.jets import Number, add, apply, arctangent, inverse, multiply
from ..claim.polynomials import Poly, Powers, Ring
from ..claim.unspecified_functions import Functions

#: Random points at which formulas and polynomials are compared.
POINTS = 4
ATTEMPTS = 1200


@dataclass(frozen=True)
class Auxiliary:
    """The meaning of an auxiliary symbol.

    A *formal root* is the root of inner · ∏ whole^(power · degree), divided by ∏ whole^power.  Its
    power is `inner`, which holds whatever signs the factors have; its own sign is not said.
    """

    name: str
    kind: str
    word: str
    number: int
    orders: tuple[int, ...]
    exponent: Formula | None
    of: tuple[tuple[Poly, Powers], ...]
    whole: Powers

    @property
    def positive(self) -> bool:
        """Whether it is positive wherever it is defined."""
        return self.kind in ("root", "power", "pi") or self.word == "exp"

    @property
    def radicand(self) -> tuple[Poly, Powers]:
        """The radicand in the law; of a formal root, with the factors taken out."""
        return self.of[0][0], [(poly, power * self.number) for poly, power in self.whole]


@dataclass(frozen=True)
class Exchange:
    """A definition ``name = factor · parameter + rest`` that is a generator."""

    name: str
    factor: Fraction
    rest: Formula


@dataclass(frozen=True)
class Sample:
    """A random point."""

    values: list[arb]
    point: Point
    nonzero: list[arb]
    positive: list[arb]
    logarithms: list[arb]
    bases: list[arb]


@dataclass(frozen=True)
class Generators:
    """The generators of a proof and what they stand for."""

    claim: Claim
    domain: Domain
    ring: Ring
    auxiliary: tuple[Auxiliary, ...]
    settled_formulas: Mapping[str, Formula]
    exchanges: Mapping[str, Exchange]
    inverses: tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]
    zeros: tuple[Formula, ...]
    signs: tuple[tuple[Poly, int], ...]
    near: Mapping[str, Fraction]

    @property
    def plain(self) -> tuple[str, ...]:
        """The generators that are no auxiliary symbols."""
        gone = {a.name for a in self.auxiliary}
        return tuple(n for n in self.ring.names if n not in gone)

    def samples(self, count: int = POINTS, positive: Sequence[Poly] = ()) -> list[Sample]:
        """Random points at which everything is defined, and some polynomials are positive.

        Raises
        ------
        CheckError
            If too few were found.
        """
        samples: list[Sample] = []
        generator = random.Random(str(self.ring.names))
        for attempt in range(ATTEMPTS):
            try:
                samples.append(self._sample(generator, attempt, positive))
            except UndefinedError:
                continue
            if len(samples) == count:
                return samples
        raise CheckError(
            "no random points were found at which the law is defined and roots and signs are as "
            "the proof says"
        )

    def _sample(self, generator: random.Random, attempt: int, positive: Sequence[Poly]) -> Sample:
        functions = Functions(f"{attempt}")
        drawn = {word: self._random_value(word, generator, attempt) for word in self.plain}
        solver = _Solver(self, drawn, functions)
        values: list[arb] = [arb(0)] * len(self.ring.names)
        for word, value in drawn.items():
            values[self.ring.index[word]] = value
        for zero in self.zeros:
            word, orders = zero.word
            functions.settle(word, orders, [solver(part) for part in zero.parts], arb(0))
        for auxiliary in self.auxiliary:
            index = self.ring.index[auxiliary.name]
            values[index] = self._auxiliary(auxiliary, values, solver, functions)
        for poly, sign in (*self.signs, *((poly, 1) for poly in positive)):
            if not self.ring.value(poly, values) * sign > 0:
                raise UndefinedError("a sign is not as assumed")
        known = {word: solver(name(word)) for word in self.claim.system.symbols}
        point = self.claim.system.point(known, functions, self.settled_formulas)
        for word in self.plain:
            defined = word in self.claim.system.definitions
            if defined and not point(name(word)).overlaps(drawn[word]):
                raise CheckError(f"the generator {word} does not agree with its definition")
        return Sample(values, point, *self.domain.values(point))

    def _random_value(self, word: str, generator: random.Random, attempt: int) -> arb:
        mode = attempt % 4
        fine = generator.randint(-(2**22), 2**22)
        if mode == 2 and word in self.near:
            middle = self.near[word]
            value = arb(fmpq(round(middle * 2**24), 2**24)) * (1 + arb(fine) / 2**27)
            return value if middle else arb(fine) / 2**24
        if mode == 1:
            return 1 + arb(fine) * 3 / 2**24
        return arb(fine) / 2 ** (21 if mode == 0 else 19)

    def _auxiliary(
        self, auxiliary: Auxiliary, values: list[arb], solver: Point, functions: Functions
    ) -> Number:
        ring = self.ring
        inner = [
            ring.value(above, values) * inverse(ring.value_of_powers(below, values))
            if below
            else ring.value(above, values)
            for above, below in auxiliary.of
        ]
        if auxiliary.kind == "pi":
            return arb.pi()
        if auxiliary.kind == "function":
            return functions.value(auxiliary.word, auxiliary.orders, inner)
        if auxiliary.kind == "known" and auxiliary.word == "atan2":
            return arctangent(inner[0], inner[1])
        if auxiliary.kind == "known" or auxiliary.kind in ("sin", "cos"):
            return apply(auxiliary.word, inner[0])
        if auxiliary.kind == "formal root":
            above, whole = auxiliary.radicand
            radicand = ring.value(above, values) * ring.value_of_powers(whole, values)
            if not radicand > 0:
                raise UndefinedError("a root of what is not positive")
            return radicand.root(auxiliary.number) * inverse(
                ring.value_of_powers(auxiliary.whole, values)
            )
        if not inner[0] > 0:
            raise UndefinedError("a root of what is not positive")
        if auxiliary.kind == "root":
            return inner[0].root(auxiliary.number)
        assert auxiliary.exponent is not None
        return (inner[0].log() * solver(auxiliary.exponent) / auxiliary.number).exp()


class _Solver(Point):
    """A point given by its generators: state and parameters there."""

    def __init__(
        self, generators: Generators, sample: Mapping[str, arb], functions: Functions
    ) -> None:
        super().__init__(
            sample, generators.claim.system.definitions, {}, functions, generators.settled_formulas
        )
        self._generators = generators
        self._parameters = generators.exchanges
        self._open: set[str] = set()
        self._places = {word: (a, i) for a, j in generators.inverses for i, word in enumerate(j)}

    def _prepare(self, formula: Formula) -> None:
        """Definitions are followed as they come."""

    def _symbol_value(self, word: str) -> Number:
        if word in self.values:
            return self.values[word]
        if word in self._open:
            raise CheckError(f"the generators do not say what {word} is")
        self._open.add(word)
        value = self._value_of(word)
        self._open.discard(word)
        return value

    def _value_of(self, word: str) -> Number:
        if word in self._places:
            names, number = self._places[word]
            return _inverse_entry([self._symbol_value(n) for n in names], number)
        if word in self._parameters:
            change = self._parameters[word]
            difference = add(self._symbol_value(change.name), multiply(arb(-1), self(change.rest)))
            return difference / arb(fmpq(change.factor.numerator, change.factor.denominator))
        if word in self._generators.settled_formulas:
            return self(self._generators.settled_formulas[word])
        if word in self.definitions:
            return self(self.definitions[word])
        if word == "pi":
            return super()._symbol_value(word)
        raise CheckError(f"the generators do not say what {word} is")


def _inverse_entry(six: Sequence[Number], number: int) -> Number:
    """An entry of the inverse of a symmetric matrix 11, 12, 13, 22, 23, 33."""
    a, b, c, d, e, f = six
    minors = (
        d * f - e * e,
        c * e - b * f,
        b * e - c * d,
        a * f - c * c,
        b * c - a * e,
        a * d - b * b,
    )
    return minors[number] * inverse(a * minors[0] + b * minors[1] + c * minors[2])
