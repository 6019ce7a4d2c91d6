"""Sections of the bundle of velocities as Taylor series, and their commutators.

A section has components along the fields of the frame if structure functions are given, and along
the coordinates otherwise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import sympy as sp

from flowlanes.formulas.expansion import TaylorExpansion
from flowlanes.formulas.taylor import Numbers, Series

from .distribution import Distribution
from .exact_points import ConfigurationSpace, ExactPoint, FieldElement

Section: TypeAlias = list[Series]
#: Coefficients of a vector of series, by degree, component and exponents.
Remainder: TypeAlias = dict[tuple[int, int, tuple[int, ...]], FieldElement]


class SingularError(ArithmeticError):
    """The constraints, or the fields of the frame, become dependent at the point."""


class Bundle:
    """Sections of the bundle of velocities, with their bracket."""

    def __init__(self, distribution: Distribution, germs: TaylorExpansion) -> None:
        self.germs = germs
        self.zero = germs.constant(germs.numbers.number(0))
        self.one = germs.constant(germs.numbers.number(1))
        number = {s: i for i, s in enumerate(distribution.coordinates)}
        self.anchor = [
            {number[s]: germs.series(v) for s, v in field.items()} for field in distribution.frame
        ]
        self.forms = [[germs.series(entry) for entry in row] for row in distribution.forms]
        self.width = len(distribution.frame)
        self.constants: dict[tuple[int, int, int], Series] | None = None
        if distribution.structure is not None:
            self.constants = {ijk: germs.series(v) for ijk, v in distribution.structure.items()}
        #: Pivots used in the solution of the constraints.
        self.leads: list[FieldElement] = []
        self.size = self.width if self.constants is not None else len(distribution.coordinates)

    def admissible(self) -> list[Section]:
        """A basis of solutions of the constraints, in components along the frame."""
        rows = [list(row) for row in self.forms]
        pivots: list[tuple[int, Section]] = []
        while rows:
            # Gauss–Jordan elimination over power series: a pivot must have an inverse series, so it
            # must not vanish at the point.
            place = leading(rows, self.width)
            if place is None:
                if all(entry.is_zero for row in rows for entry in row):
                    break
                raise SingularError
            chosen = rows.pop(place[0])
            self.leads.append(chosen[place[1]].value)
            inverse = self.one / chosen[place[1]]
            chosen = [entry * inverse for entry in chosen]
            pivots = [(c, pivot_eliminated(other, chosen, place[1])) for c, other in pivots]
            rows = [pivot_eliminated(other, chosen, place[1]) for other in rows]
            pivots.append((place[1], chosen))
        pivot_rows = dict(pivots)
        sections = []
        for free in (c for c in range(self.width) if c not in pivot_rows):
            section = [self.zero] * self.width
            section[free] = self.one
            for c, row in pivots:
                section[c] = -row[free]
            sections.append(section)
        return sections

    def coordinate_rates(self, section: Section) -> dict[int, Series]:
        """The rates of the coordinates along a section given in components along the frame."""
        rates: dict[int, Series] = {}
        for entry, field in zip(section, self.anchor, strict=True):
            if not entry.is_zero:
                for q, value in field.items():
                    step = entry * value
                    rates[q] = rates[q] + step if q in rates else step
        return rates

    def section(self, section: Section) -> Section:
        """A section in the components used for brackets."""
        if self.constants is not None:
            return section
        rates = self.coordinate_rates(section)
        return [rates.get(q, self.zero) for q in range(self.size)]

    def rates(self, section: Section) -> dict[int, Series]:
        """The rates of the coordinates along a section."""
        if self.constants is not None:
            return self.coordinate_rates(section)
        return {q: value for q, value in enumerate(section) if not value.is_zero}

    def bracket(self, left: Section, right: Section) -> Section:
        """[u, w] = uw − wu, of an order lower by one."""
        by, back = self.rates(left), self.rates(right)
        order = min(left[0].order, right[0].order) - 1
        components = []
        for u, w in zip(left, right, strict=True):
            total = self.zero.truncation(order)
            for rates, entry, sign in ((by, w, 1), (back, u, -1)):
                if entry.is_constant:
                    continue
                for q, rate in rates.items():
                    slope = entry.derivative(q)
                    if not slope.is_zero:
                        total = total + rate * slope if sign > 0 else total - rate * slope
            components.append(total)
        for (i, j, k), c in (self.constants or {}).items():
            components[k] = components[k] + c * (left[i] * right[j] - left[j] * right[i])
        return components


def leading(rows: Sequence[Section], width: int) -> tuple[int, int] | None:
    """The position of an entry that is nonzero at the point, a constant if possible."""
    best: tuple[int, int] | None = None
    for r, row in enumerate(rows):
        for c in range(width):
            if row[c].value != 0:
                if row[c].is_constant:
                    return r, c
                best = best or (r, c)
    return best


def pivot_eliminated(section: Section, pivot: Section, column: int) -> Section:
    """A section minus the multiple of the pivot that makes a component zero."""
    factor = section[column]
    if factor.is_zero:
        return [entry.truncation(pivot[0].order) for entry in section]
    return [a - factor * b for a, b in zip(section, pivot, strict=True)]


class Span:
    """Generators found so far: new directions at the point, and remainders that vanish there."""

    def __init__(self, numbers: Numbers) -> None:
        self.numbers = numbers
        self.pivots: list[tuple[int, Section]] = []
        self.remainders: list[Remainder] = []
        #: The value of the pivot of each new direction at the point.
        self.leads: list[FieldElement] = []

    def add(self, section: Section) -> tuple[Section, bool] | None:
        """The new part of a section, and whether it is a direction; None if it is dependent."""
        for column, pivot in self.pivots:
            section = pivot_eliminated(section, pivot, column)
        place = leading([section], len(section))
        if place is not None:
            lead = section[place[1]]
            self.leads.append(lead.value)
            inverse = lead.power(-1, 1)
            section = [entry * inverse for entry in section]
            self.pivots.append((place[1], section))
            return section, True
        return None if self._dependent(section) else (section, False)

    def _dependent(self, section: Section) -> bool:
        """Whether a remainder is a combination of earlier ones with constant coefficients."""
        order = section[0].order
        vector: Remainder = {}
        for c, entry in enumerate(section):
            for part in entry.parts:
                for powers, value in part.to_dict().items():
                    vector[sum(powers), c, powers] = self.numbers.number(value)
        for other in self.remainders:
            lead = min(other)
            if lead in vector:
                factor = vector[lead] / other[lead]
                zero: FieldElement = self.numbers.number(0)
                for key, value in other.items():
                    if key[0] <= order:
                        vector[key] = vector.get(key, zero) - factor * value
            vector = {key: value for key, value in vector.items() if value != 0}
        if vector:
            self.remainders.append(vector)
        return not vector


@dataclass(frozen=True)
class Values:
    """Values of formulas at a point, with their derivatives.

    Attributes
    ----------
    germs : TaylorExpansion
        Expansions about the point, for further formulas.
    letters : list
        Values of the formulas.
    along : list of list
        Rates of the letters along each admissible field.
    gradient : list of list
        Derivatives of the letters by each coordinate.
    normals : list of list
        Gradients of the relations.
    """

    germs: TaylorExpansion
    letters: list[FieldElement]
    along: list[list[FieldElement]]
    gradient: list[list[FieldElement]]
    normals: list[list[FieldElement]]


def slopes(germs: TaylorExpansion, formula: sp.Expr) -> list[FieldElement]:
    """Derivatives of a formula by the coordinates at the point."""
    series = germs.series(formula)
    return [series.derivative(q).value for q, _ in enumerate(germs.variables)]


def values_at(
    distribution: Distribution,
    place: ExactPoint,
    space: ConfigurationSpace,
    letters: Sequence[sp.Expr],
) -> Values:
    """Values of formulas at a point, with their rates along the fields of a distribution.

    Raises
    ------
    SingularError
        If the constraints are dependent there.
    """
    germs = place.germs(space, 1)
    bundle = Bundle(distribution, germs)
    zero = place.numbers.number(0)
    columns = [slopes(germs, letter) for letter in letters]
    moved = [
        {q: v.value for q, v in bundle.coordinate_rates(u).items()} for u in bundle.admissible()
    ]
    return Values(
        germs,
        [germs.series(letter).value for letter in letters],
        [[sum((v * c[q] for q, v in by.items()), zero) for c in columns] for by in moved],
        [[c[q] for c in columns] for q, _ in enumerate(distribution.coordinates)],
        [slopes(germs, relation) for relation in distribution.relations],
    )
