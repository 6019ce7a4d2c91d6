"""The motion to be solved, and exact comparison of vector fields."""

from __future__ import annotations

import contextlib
import math
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import fmpq

from flowlanes.arguments import NumberOrText
from flowlanes.errors import InputError
from flowlanes.formulas.balls import exact
from flowlanes.formulas.errors import NotExactError, OutOfReachError, UnknownSymbolError
from flowlanes.formulas.jets import Evaluator, Jet
from flowlanes.formulas.number_fields import Rationals
from flowlanes.formulas.relative_zero import RESOLUTION, SizedNumber, state_sizes, values_with_sizes
from flowlanes.system.named_formulas import scalars
from flowlanes.system.parameters import require_admissible
from flowlanes.system.system import System

from ...mechanics.rolling.equations import RollingBody

#: Number of points at which two fields are compared.
POINTS = 3
#: Number of components of each of the two vectors of a state.
SIZE = 3

Numbers = Mapping[sp.Symbol, Fraction]


@dataclass(frozen=True)
class Problem:
    """A motion whose closed form is requested.

    Attributes
    ----------
    system : System
        The reduced system, without the motion in space.
    parameters : mapping of Symbol to number
        A value for every parameter of the system.
    start : tuple of numbers
        The state at time 0, lifted to space where the system has a motion, in flat order.
    rolling : RollingBody or None
        The body and the surface it rolls on, if known.
    """

    system: System
    parameters: Mapping[sp.Symbol, NumberOrText]
    start: tuple[NumberOrText, ...]
    rolling: RollingBody | None = None

    def well_posed(self) -> Problem:
        """The problem with validated numbers, for a reduced start without lift.

        Raises
        ------
        InputError
            If the start has not as many numbers as the state, or one that is not finite; if a
            parameter is not finite or not admissible.
        """
        lifted = self.system.lifted() if self.system.reconstruction else self.system
        reduced, whole = self.system.symbols, lifted.symbols
        if len(self.start) not in (len(reduced), len(whole)):
            names = ", ".join(map(str, whole))
            fewer = f", or the first {len(reduced)} of them" if whole != reduced else ""
            raise InputError(
                f"start has {len(self.start)} numbers: {len(whole)} are needed ({names}){fewer}"
            )
        for name, number in (*zip(whole, self.start, strict=False), *self.parameters.items()):
            if not math.isfinite(float(number)):
                raise InputError(f"{name} = {number}: it must be a finite number")
        self._check_admissible()
        if len(self.start) < len(whole):
            return replace(self, system=replace(self.system, reconstruction=None))
        return self

    def _check_admissible(self) -> None:
        numbers = {s: float(exact(value)) for s, value in self.parameters.items()}
        require_admissible(self.system, numbers, self.parameters)

    @property
    def numbers(self) -> dict[str, Fraction]:
        """The parameters by name; decimals count exactly as written."""
        return {str(symbol): exact(value) for symbol, value in self.parameters.items()}

    def values(self, formulas: Sequence[sp.Expr]) -> list[Any]:
        """Scalar formulas of the system at the start, as fractions or to 60 digits."""
        return [value.value for value in self.sized_values(formulas)]

    def sized_values(self, formulas: Sequence[sp.Expr]) -> list[SizedNumber]:
        """Values of scalar formulas at the start, with the sizes of their terms."""
        lifted = self.system.lifted() if self.system.reconstruction else self.system
        known = {s: exact(value) for s, value in self.parameters.items()}
        start = state_sizes(lifted.state, lifted.symbols, [exact(x) for x in self.start])
        wanted = scalars(tuple(formulas))
        return values_with_sizes(
            wanted,
            {**{s: SizedNumber(x, abs(x)) for s, x in known.items()}, **start},
            lifted.required_definitions(wanted),
        )

    def vanish(self, formulas: Sequence[sp.Expr], part: fmpq = RESOLUTION) -> bool:
        """Whether scalar formulas vanish at the start, up to a small fraction of their terms."""
        return all(value.vanishes(part) for value in self.sized_values(formulas))


def same_field(
    first: System, first_numbers: Numbers, second: System, second_numbers: Numbers
) -> bool:
    """Whether two systems with these parameters have the same field, variables in order.

    Both fields are evaluated in rational arithmetic at random points on the relations of the second
    system. Different rational functions agree at all of them with negligible probability, and
    nothing is rounded.

    Parameters
    ----------
    first, second : System
        Two systems with states of the same length.
    first_numbers, second_numbers : mapping of Symbol to Fraction
        A value for every parameter.
    """
    if len(first.symbols) != len(second.symbols):
        return False
    compared = False
    try:
        for point, rates in _points_with_rates(second, second_numbers):
            compared = True
            value = _evaluator(first, point, first_numbers).value
            if any(value(own) != rate for own, rate in zip(first.rates, rates, strict=True)):
                return False
    except (NotExactError, OutOfReachError, UnknownSymbolError, ZeroDivisionError):
        # A field with roots or functions, or singular elsewhere, differs from all known ones.
        return False
    return compared


def rational(system: System, numbers: Numbers) -> bool:
    """Whether a field can have exact values at rational states (u, n) with n² = 1.

    Without such values `same_field` is false for every system.
    """
    if len(system.symbols) != 2 * SIZE:
        return False
    generator = random.Random(system.name)
    for point in (point for _ in range(POINTS) for point in _candidates(generator)):
        with contextlib.suppress(
            NotExactError, OutOfReachError, UnknownSymbolError, ZeroDivisionError
        ):
            rates_at(system, point, numbers)
            return True
    return False


def _evaluator(system: System, point: Sequence[fmpq], numbers: Numbers) -> Evaluator:
    known = dict(zip(system.symbols, point, strict=True))
    known |= {s: fmpq(x.numerator, x.denominator) for s, x in numbers.items()}
    seeds = {s: Jet(value, {}) for s, value in known.items()}
    return Evaluator(Rationals({}), seeds.get, dict(system.scalar_definitions))


def rates_at(system: System, point: Sequence[fmpq], numbers: Numbers) -> list[fmpq]:
    """The rates of a system at a rational state, exactly."""
    evaluate = _evaluator(system, point, numbers)
    return [evaluate.value(rate) for rate in system.rates]


def rational_points(system: System, numbers: Numbers) -> Iterator[list[fmpq]]:
    """Rational points (u, n) of a phase space with n² = 1, and possibly (u, n) = 0."""
    return (point for point, _ in _points_with_rates(system, numbers))


def _points_with_rates(system: System, numbers: Numbers) -> Iterator[tuple[list[fmpq], list[fmpq]]]:
    if len(system.symbols) != 2 * SIZE:
        return
    relations = system.scalar.relations
    count = 0
    generator = random.Random(system.name)
    for _ in range(20 * POINTS):
        for point in _candidates(generator):
            values = _evaluator(system, point, numbers)
            try:
                on_it = all(values.value(relation) == 0 for relation in relations)
                if on_it and (rates := [values.value(rate) for rate in system.rates]):
                    yield point, rates
                    count += 1
                    break
            except ZeroDivisionError:
                continue
        if count == POINTS:
            return


def _candidates(generator: random.Random) -> tuple[list[fmpq], list[fmpq]]:
    """Rational (u, n) with n² = 1, and also such pairs with (u, n) = 0."""
    p, q = (fmpq(generator.randint(-9, 9), generator.randint(7, 13)) for _ in range(2))
    square = 1 + p * p + q * q
    n = [2 * p / square, 2 * q / square, (square - 2) / square]
    u = [fmpq(generator.randint(-20, 20), generator.randint(7, 13)) for _ in range(SIZE)]
    along = sum((a * b for a, b in zip(u, n, strict=True)), fmpq(0))
    level = [a - along * b for a, b in zip(u, n, strict=True)]
    return [*u, *n], [*level, *n]
