"""Generators and auxiliary symbols of a proof, and their values at points.

Generators are state variables, parameters, and definitions that replace a parameter; auxiliary
symbols are roots, powers and function values of them.  At a random point of the generators
everything else has a value, so formulas and polynomials can be compared (see :mod:`.residues`).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from itertools import product

from ..claim.claim import Claim
from ..claim.domain import Domain
from ..claim.errors import CheckError, UndefinedError
from ..claim.evaluate import Point
from ..claim.formulas import CONSTANTS, Formula, name
from ..claim.jets import Number, add, inverse, multiply
from ..claim.polynomials import Poly, Ring
from ..modular.prime_field import PrimeField
from .generator_functions import Auxiliary, GeneratorFunctions
from .residues import Residues

#: Maximum number of combinations of choices of the roots.
CHOICES = 4096


@dataclass(frozen=True)
class Exchange:
    """Definition ``name = factor · parameter + rest`` that is a generator."""

    name: str
    factor: Fraction
    rest: Formula


@dataclass(frozen=True)
class Generators:
    """Generators of a proof and their meanings."""

    claim: Claim
    domain: Domain
    ring: Ring
    auxiliary: tuple[Auxiliary, ...]
    settled_formulas: Mapping[str, Formula]
    exchanges: Mapping[str, Exchange]
    inverses: tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]
    zeros: tuple[Formula, ...]
    signs: tuple[tuple[Poly, int], ...]

    @property
    def plain(self) -> tuple[str, ...]:
        """Generators that are not auxiliary symbols."""
        gone = {a.name for a in self.auxiliary}
        return tuple(n for n in self.ring.names if n not in gone)

    @property
    def roots(self) -> tuple[Auxiliary, ...]:
        """Auxiliary symbols that are roots."""
        return tuple(a for a in self.auxiliary if a.kind in ("root", "formal root"))

    def samples(self, field: PrimeField, count: int, attempts: int) -> list[list[Sample]] | None:
        """Random points, each with all relevant choices of the roots; None if there are too few.

        Raises
        ------
        CheckError
            If there are too many choices of the roots.
        """
        choices = [range(root.number) for root in self.roots]
        if self._has_independent_roots(field):
            choices = [range(1) for _ in self.roots]
        if math.prod(map(len, choices)) > CHOICES:
            raise CheckError(f"the roots of a proof may be chosen in more than {CHOICES} ways")
        drawn: list[list[Sample]] = []
        for attempt in range(attempts):
            try:
                drawn.append(
                    [
                        self.sample(Residues(field, self.ring, f"{attempt}", choice))
                        for choice in product(*choices)
                    ]
                )
            except UndefinedError:
                continue
            if len(drawn) == count:
                return drawn
        return None

    def _has_independent_roots(self, field: PrimeField) -> bool:
        """True if the roots are square roots that certainly generate a field extension.

        This holds if no product of some radicands is a square (Kummer theory).  A product that is
        a square would be a square at every point modulo every prime.  The products that are
        squares at all sampled points form a space over 𝔽₂; if it is zero, the roots are
        independent.
        """
        names = {root.name for root in self.roots}
        plain = [
            root.number == 2
            and not names
            & {n for n, d in zip(self.ring.names, root.of[0][0].degrees(), strict=True) if d}
            for root in self.roots
        ]
        if not all(plain):
            return False
        rows: dict[int, int] = {}
        for number in range(8 * len(names) + 8):
            functions = Residues(field, self.ring, f"character {number}", ())
            functions.characters = []
            try:
                self.sample(functions)
            except UndefinedError:
                continue
            # Each row records which radicands are nonsquares at one point; full rank over 𝔽₂
            # leaves no product that is always a square.
            row = sum(1 << i for i, square in enumerate(functions.characters) if not square)
            while row and (top := row.bit_length()) in rows:
                row ^= rows[top]
            if row:
                rows[row.bit_length()] = row
        return len(rows) == len(names)

    def sample(self, functions: GeneratorFunctions) -> Sample:
        """Point at which the generators have the values given by functions."""
        drawn = {word: functions.free(f"generator {word}") for word in self.plain}
        solver = _Solver(self, drawn, functions)
        values = functions.values
        for word, value in drawn.items():
            values[self.ring.index[word]] = value
        zero = functions.number(Fraction(0))
        for formula in self.zeros:
            word, orders = formula.word
            functions.settle(word, orders, [solver(part) for part in formula.parts], zero)
        for auxiliary in self.auxiliary:
            index = self.ring.index[auxiliary.name]
            values[index] = self._auxiliary(auxiliary, values, solver, functions)
        return Sample(self, values, functions, solver)

    def _auxiliary(
        self,
        auxiliary: Auxiliary,
        values: list[Number],
        solver: Point,
        functions: GeneratorFunctions,
    ) -> Number:
        ring = self.ring
        inner = tuple(
            ring.value(above, values, functions)
            * inverse(ring.value_of_powers(below, values, functions))
            for above, below in auxiliary.of
        )
        if auxiliary.kind == "pi":
            return functions.constant("pi")
        if auxiliary.kind == "function":
            return functions.plain_unspecified(auxiliary.word, auxiliary.orders, inner)
        if auxiliary.kind in ("root", "formal root"):
            whole = ring.value_of_powers(auxiliary.whole, values, functions)
            return functions.new_root(auxiliary, inner[0], whole)
        if auxiliary.kind == "power":
            assert auxiliary.exponent is not None
            return functions.new_power(auxiliary, inner[0], partial(solver, auxiliary.exponent))
        if auxiliary.word == "log" and auxiliary.of[0][0].is_constant() and not auxiliary.of[0][1]:
            functions.logarithms_of_numbers.append(auxiliary)
        return functions.plain_value(auxiliary.word, inner)


@dataclass(frozen=True)
class Sample:
    """Values of the generators and of formulas at a point.

    Attributes
    ----------
    solver : Point
        Values of all symbols that are determined by the generators.
    """

    generators: Generators
    values: list[Number]
    functions: GeneratorFunctions
    solver: Point

    @cached_property
    def point(self) -> Point:
        """Point in state and parameters, at which formulas have derivatives.

        Raises
        ------
        UnknownRootError
            If a parameter depends on a root with factors whose signs are not yet known.
        """
        system = self.generators.claim.system
        known = {word: self.solver(name(word)) for word in system.symbols}
        return system.point(known, self.functions, self.generators.settled_formulas)

    @cached_property
    def places(self) -> Mapping[str, Point]:
        """The point and its image, as :meth:`certificate_checker.claim.domain.Domain.places`."""
        return self.generators.domain.places(self.point)

    def require_definitions(self) -> None:
        """Raise CheckError unless each generator agrees with its definition, if it has one."""
        for word in self.generators.plain:
            defined = word in self.generators.claim.system.definitions
            value = self.values[self.generators.ring.index[word]]
            if defined and self.point(name(word)) != value:
                raise CheckError(f"the generator {word} does not agree with its definition")


class _Solver(Point):
    """Point whose state and parameters are determined by its generators."""

    def __init__(
        self, generators: Generators, sample: Mapping[str, Number], functions: GeneratorFunctions
    ) -> None:
        system = generators.claim.system
        rates = dict(zip(system.state, system.rates, strict=True))
        super().__init__(sample, system.definitions, rates, functions, generators.settled_formulas)
        self._generators = generators
        self._parameters = generators.exchanges
        self._open: set[str] = set()
        self._places = {word: (a, i) for a, j in generators.inverses for i, word in enumerate(j)}

    def _prepare(self, formula: Formula) -> None:
        """Do nothing: definitions are followed in their order."""

    def _symbol_value(self, word: str) -> Number:
        if word in self.values:
            return self.values[word]
        if word in self._open:
            raise CheckError(f"the generators do not determine {word}")
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
            difference = add(self._symbol_value(change.name), multiply(-1, self(change.rest)))
            return difference / self.functions.number(change.factor)
        if word in self._generators.settled_formulas:
            return self(self._generators.settled_formulas[word])
        if word in self.definitions:
            return self(self.definitions[word])
        if word in CONSTANTS:
            return super()._symbol_value(word)
        raise CheckError(f"the generators do not determine {word}")


def _inverse_entry(six: Sequence[Number], number: int) -> Number:
    """Entry of the inverse of a symmetric matrix 11, 12, 13, 22, 23, 33."""
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
