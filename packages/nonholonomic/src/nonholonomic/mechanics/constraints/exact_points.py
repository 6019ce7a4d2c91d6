"""Exact points of a configuration space.

Unit vectors, rows of a rotation matrix and angles have rational parametrisations; other relations
are solved for one coordinate each, if they are linear or quadratic in it.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

import sympy as sp
from flint import fmpq, nmod

from flowlanes.errors import InputError
from flowlanes.formulas.expansion import Angles, TaylorExpansion, angles
from flowlanes.formulas.taylor import IrrationalError, Numbers, Series
from flowlanes.parsing.exact_decimals import with_exact_decimals
from flowlanes.system.named_formulas import expand

from ..rotations import rotation_rows

ATTEMPTS = 60

#: An element of the field over which a point is taken.
FieldElement: TypeAlias = fmpq | nmod
#: Value of a parameter; a decimal is meant exactly.
ParameterValue: TypeAlias = float | sp.Expr
#: Orthogonal vectors of equal length, by components, and the square of the length.
Block: TypeAlias = tuple[tuple[tuple[sp.Symbol, ...], ...], sp.Expr]


class NoPointError(ArithmeticError):
    """No point was found over the field in use."""


class UnsolvedError(InputError):
    """A relation cannot be solved for any of its coordinates."""


@dataclass(frozen=True)
class ConfigurationSpace:
    """Conditions on points, and formulas to be evaluated there.

    Parameters
    ----------
    coordinates : tuple of Symbol
    relations : tuple of formula
        Expressions that vanish at the points.
    steps : pairs (Symbol, formula)
        Definitions.
    formulas : tuple of formula
        All formulas to be evaluated; the angles are taken from them.
    constants : pairs (Symbol, number)
        Parameters.
    free : tuple of Symbol
        Parameters without a value; they get random ones.
    """

    coordinates: tuple[sp.Symbol, ...]
    relations: tuple[sp.Expr, ...]
    steps: tuple[tuple[sp.Symbol, sp.Expr], ...]
    formulas: tuple[sp.Expr, ...]
    constants: tuple[tuple[sp.Symbol, ParameterValue], ...] = ()
    free: tuple[sp.Symbol, ...] = ()

    @cached_property
    def units(self) -> Angles:
        """The angles that occur, as of :func:`~flowlanes.formulas.expansion.angles`."""
        return angles((*self.formulas, *self.relations), dict(self.steps))

    @cached_property
    def expanded_relations(self) -> tuple[sp.Expr, ...]:
        """The relations with definitions substituted."""
        return tuple(expand(r, self.steps) for r in self.relations)

    @cached_property
    def blocks(self) -> list[Block]:
        """Spheres among the relations, grouped by orthogonality."""
        return _blocks(self.expanded_relations, set(self.coordinates))


@dataclass(frozen=True)
class ExactPoint:
    """A point with exact coordinates.

    Attributes
    ----------
    numbers : Numbers
    values : mapping of Symbol to number
        Coordinates and constants; the number of an angle is independent of its sine and cosine.
    circles : mapping of formula to (number, number)
        Sines and cosines, as of :class:`~flowlanes.formulas.expansion.TaylorExpansion`.
    formulas : mapping of Symbol to formula
        The coordinates as formulas; empty modulo a prime.
    formal : bool
        Whether a random number represents a transcendental one.
    seed : int
        Seed of the numbers that represent other transcendental values.
    """

    numbers: Numbers
    values: Mapping[sp.Symbol, FieldElement]
    circles: Mapping[sp.Expr, tuple[FieldElement, FieldElement]]
    formulas: Mapping[sp.Symbol, sp.Expr]
    formal: bool
    seed: int

    def germs(self, space: ConfigurationSpace, order: int) -> TaylorExpansion:
        """Taylor series of formulas about this point."""
        return TaylorExpansion(
            self.numbers,
            space.coordinates,
            self.values,
            self.circles,
            space.units,
            dict(space.steps),
            order,
            self.seed,
        )


def random_point(space: ConfigurationSpace, numbers: Numbers, rng: random.Random) -> ExactPoint:
    """A random point of a configuration space.

    Raises
    ------
    NoPointError
        If none was found.
    """
    return _first_success(space, {}, numbers, rng)


def point_at(
    space: ConfigurationSpace,
    point: Mapping[sp.Symbol, ParameterValue],
    numbers: Numbers,
    rng: random.Random,
) -> ExactPoint:
    """A given point; coordinates not given are chosen at random.

    Raises
    ------
    NoPointError
        If the field in use does not contain the point.
    InputError
        If a relation does not hold at the point.
    """
    fixed = {s: with_exact_decimals(v) for s, v in point.items()}
    return _first_success(space, fixed, numbers, rng)


def _first_success(
    space: ConfigurationSpace,
    fixed: Mapping[sp.Symbol, sp.Expr],
    numbers: Numbers,
    rng: random.Random,
) -> ExactPoint:
    for _ in range(ATTEMPTS):
        try:
            return _point_attempt(space, fixed, numbers, rng)
        except (ZeroDivisionError, IrrationalError):
            if set(space.coordinates) <= set(fixed):
                break
    raise NoPointError


def _point_attempt(
    space: ConfigurationSpace,
    fixed: Mapping[sp.Symbol, sp.Expr],
    numbers: Numbers,
    rng: random.Random,
) -> ExactPoint:
    plain = TaylorExpansion(numbers, (), {}, {}, {}, {}, 0)
    values = {s: plain.series(_rational(v)).value for s, v in space.constants if s not in fixed}
    circles: dict[sp.Expr, tuple[FieldElement, FieldElement]] = {}
    shown: dict[sp.Symbol, sp.Expr] = {}
    formal = False
    for symbol, value in fixed.items():
        if value.has(sp.pi):
            values[symbol] = numbers.random_number(rng)
        else:
            values[symbol] = plain.series(value).value
        shown[symbol] = value
    for core, n in space.units.items():
        circles[core], free = _circle(core, n, space, fixed, shown, plain, rng)
        formal = formal or free
    known = TaylorExpansion(numbers, (), values, {}, {}, {}, 0)
    for vectors, squared in space.blocks:
        formula = _rational(squared)
        if formula.free_symbols <= values.keys() and not any(
            s in values for v in vectors for s in v
        ):
            values |= _rows(vectors, known.series(formula).value, numbers, rng)
    trial = _Trial(space, numbers, values, circles, rng)
    for relation in space.expanded_relations:
        trial.impose(relation)
    for symbol in (*space.coordinates, *space.free):
        trial.values.setdefault(symbol, numbers.random_number(rng))
    trial.check(space.expanded_relations, bool(fixed))
    for s in space.coordinates:
        value = trial.values[s]
        if isinstance(value, fmpq):
            shown.setdefault(s, sp.Rational(int(value.p), int(value.q)))
    return ExactPoint(
        numbers, trial.values, circles, shown if numbers.exact else {}, formal, trial.seed
    )


def _rational(value: ParameterValue) -> sp.Expr:
    return with_exact_decimals(sp.sympify(value))


def _circle(
    core: sp.Expr,
    n: int,
    space: ConfigurationSpace,
    fixed: Mapping[sp.Symbol, sp.Expr],
    formulas: dict[sp.Symbol, sp.Expr],
    plain: TaylorExpansion,
    rng: random.Random,
) -> tuple[tuple[FieldElement, FieldElement], bool]:
    """Sine and cosine of core/n, and whether they represent transcendental numbers."""
    constants = {s: _rational(v) for s, v in space.constants}
    angle = core.xreplace({**constants, **fixed}) / n
    if not angle.free_symbols:
        turns = angle / sp.pi
        if angle == 0 or turns.is_Rational:
            exact = (sp.sin(angle), sp.cos(angle))
            if not any(value.has(sp.sin, sp.cos) for value in exact):
                return (plain.series(exact[0]).value, plain.series(exact[1]).value), False
    # rational point of the circle by the tangent of the half angle; an angle that must have a
    # value, such as 1 rad, is represented by a random point, since its sine and cosine are
    # transcendental
    t = plain.numbers.random_number(rng)
    if core.is_Symbol and core not in constants and core not in fixed and plain.numbers.exact:
        formulas[core] = 2 * n * sp.atan(sp.Rational(int(t.p), int(t.q)))
    below = 1 + t * t
    return (2 * t / below, (1 - t * t) / below), not angle.free_symbols


def _blocks(relations: Sequence[sp.Expr], coordinates: set[sp.Symbol]) -> list[Block]:
    """Groups of orthogonal vectors of fixed length, with the squared length."""
    spheres: dict[tuple[sp.Symbol, ...], sp.Expr] = {}
    products: list[sp.Expr] = []
    for relation in relations:
        expression = sp.expand(relation)
        own = sorted(expression.free_symbols & coordinates, key=str)
        remainder = expression - sp.Add(*(s**2 for s in own))
        if len(own) > 1 and not remainder.free_symbols & coordinates:
            spheres[tuple(own)] = -remainder
        else:
            products.append(expression)
    groups: list[list[tuple[sp.Symbol, ...]]] = []
    for vector in spheres:
        for group in groups:
            if len(vector) == 3 and _orthogonal(vector, group[0], products):
                group.append(vector)
                break
        else:
            groups.append([vector])
    return [(tuple(group), spheres[group[0]]) for group in groups]


def _orthogonal(
    left: tuple[sp.Symbol, ...], right: tuple[sp.Symbol, ...], products: Sequence[sp.Expr]
) -> bool:
    product = sp.Add(*(a * b for a, b in zip(left, right, strict=False)))
    return any(sp.expand(p - product) == 0 or sp.expand(p + product) == 0 for p in products)


def _rows(
    vectors: Sequence[tuple[sp.Symbol, ...]],
    square: FieldElement,
    numbers: Numbers,
    rng: random.Random,
) -> dict[sp.Symbol, FieldElement]:
    """Rational points of a sphere, or rows of a rational rotation."""
    length = numbers.root(square, 2)
    if len(vectors[0]) == 3:
        rows = _rotation(numbers, rng)
        return {
            s: length * x
            for v, row in zip(vectors, rows, strict=False)
            for s, x in zip(v, row, strict=True)
        }
    (own,) = vectors
    free = [numbers.random_number(rng) for _ in own[1:]]
    total = sum((x * x for x in free), numbers.number(0))
    # stereographic projection from the plane of `free`
    first = (1 - total) / (1 + total)
    others = [2 * x / (1 + total) for x in free]
    return {s: length * x for s, x in zip(own, (first, *others), strict=True)}


def _rotation(numbers: Numbers, rng: random.Random) -> list[list[FieldElement]]:
    """The rotation matrix of a random quaternion."""
    quaternion = [numbers.random_number(rng) for _ in range(4)]
    return rotation_rows(quaternion, 2 / sum((q * q for q in quaternion), numbers.number(0)))


class _Trial:
    """A point under construction: the coordinates that already have values."""

    def __init__(
        self,
        space: ConfigurationSpace,
        numbers: Numbers,
        values: dict[sp.Symbol, FieldElement],
        circles: Mapping[sp.Expr, tuple[FieldElement, FieldElement]],
        rng: random.Random,
    ) -> None:
        self.space, self.numbers, self.values = space, numbers, values
        self.circles, self.rng = circles, rng
        self.seed = rng.randrange(2**32)

    def _series(self, relation: sp.Expr, variables: Sequence[sp.Symbol], order: int) -> Series:
        filled = {**self.values, **{s: self.numbers.number(0) for s in variables}}
        return TaylorExpansion(
            self.numbers, variables, filled, self.circles, self.space.units, {}, order, self.seed
        ).series(relation)

    def impose(self, relation: sp.Expr) -> None:
        """Solve a relation for a coordinate without a value, or for a free parameter."""
        free = relation.free_symbols - self.values.keys()
        open_ = [s for s in (*self.space.free, *self.space.coordinates) if s in free]
        if not open_:
            return
        degrees = {s: int(sp.degree(relation, s)) for s in open_ if relation.is_polynomial(s)}
        if not degrees:
            raise UnsolvedError(
                f"the relation {relation} = 0 is a polynomial in none of its coordinates, so that "
                "no point of it can be found; give a point"
            )
        moving = [s for s in reversed(open_) if s in degrees and s in self.space.coordinates]
        # solve for the coordinate of lowest degree, the last one of equals
        main = min(moving or [s for s in open_ if s in degrees], key=lambda s: degrees[s])
        for s in open_:
            if s != main:
                self.values[s] = self.numbers.random_number(self.rng)
        parts = self._series(relation, (main,), degrees[main]).parts
        self.values[main] = self.numbers.zero_of([self._coefficient(part) for part in parts])

    def _coefficient(self, part: Any) -> Any:
        return self.numbers.number(0) if part.is_zero() else self.numbers.number(part.coeffs()[0])

    def check(self, relations: Sequence[sp.Expr], exact_input: bool) -> None:
        """Raise unless every relation holds."""
        for relation in relations:
            left = self._series(relation, (), 0).value
            if left != 0:
                if exact_input and set(self.space.coordinates) & relation.free_symbols:
                    raise InputError(f"the point does not lie on {relation} = 0")
                raise ZeroDivisionError
