"""Decide whether a ball with rotors can be brought from rest to any position and attitude.

Whether the fields of the rotors with their commutators span the five dimensions of R² × SO(3)
depends only on the vertical γ, not on position and heading.  If they do at every γ, any two
configurations can be joined (Chow–Rashevskii theorem).  This is proven on rectangles that cover the
sphere: on each a determinant of five commutators has Bernstein coefficients of one sign.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import sympy as sp
from flint import fmpq, fmpq_mpoly
from scipy.linalg import qr

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.vectors import Vector

from .fields import ControlFields, Field, control_fields, homogeneous, minor, values_at
from .nonvanishing import Rectangle, faces, vanishes_nowhere, without_real_zero
from .robot import SphericalRobot

DIMENSION = 5
STEPS = 7
"""Largest number of fields in a commutator."""
CUTS = 20
"""Maximum number of subdivisions of a face."""
LONGER_AFTER = 3
"""Number of subdivisions after which longer commutators, by one field, are tried."""
#: A generic point.
GENERIC = (fmpq(31, 50), fmpq(-17, 29), fmpq(1))

Decision = Literal["controllable", "not controllable", "undecided"]


@dataclass(frozen=True, repr=False)
class Controllability:
    """The motions that rotors can give a ball that starts from rest.

    Attributes
    ----------
    decision : str
        ``"controllable"``: any two configurations are joined by a motion; ``"not controllable"``;
        or ``"undecided"``.
    growth : tuple of int
        Dimensions spanned by the control fields, by these and their commutators, and so on, at
        generic verticals.
    exceptional : tuple of formula
        Forms in γ with real zeros; the growth is generic where none of them vanishes.
    growth_there : tuple of tuple of int
        The growth at a rational point of each exceptional plane; empty for a curved surface.
    steps : int
        Number of fields in the longest commutator of the proof.
    rectangles : int
        Number of parts of the sphere of verticals in the proof.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.control import Rotor, SphericalRobot, controllability
    >>> axes = ((1, 0, 0), (0, 1, 0))
    >>> robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, tuple(Rotor(e, 0.1) for e in axes))
    >>> controllability(robot).decision
    'controllable'
    """

    decision: Decision
    growth: tuple[int, ...]
    exceptional: tuple[sp.Expr, ...]
    growth_there: tuple[tuple[int, ...], ...]
    steps: int
    rectangles: int

    @property
    def proven(self) -> bool:
        """Whether the decision is exact."""
        return self.decision != "undecided"

    def __repr__(self) -> str:
        return str(self)

    def __str__(self) -> str:
        grown = ", ".join(map(str, self.growth))
        text = f"The control fields and their commutators span {grown} of {DIMENSION} dimensions"
        text += " at generic verticals"
        for form, there in zip(self.exceptional, self.growth_there, strict=True):
            text += f", {', '.join(map(str, there)) or 'other numbers'} where {form} = 0"
        reason = {
            "controllable": (
                "any two configurations can be joined; proven, since commutators of "
                f"{self.steps} fields at most span everything at every vertical "
                f"({self.rectangles} parts of the sphere)"
            ),
            "not controllable": "not controllable: all motions from one configuration fill a curve",
            "undecided": "undecided: no proof was found at every vertical",
        }[self.decision]
        return f"{text}; {reason}."


@arguments_checked
def controllability(robot: SphericalRobot) -> Controllability:
    """Decide whether the rotors of a balanced robot can bring it to any configuration.

    Parameters
    ----------
    robot : SphericalRobot
        Balanced and without moving mass; it starts from rest.

    Returns
    -------
    Controllability

    Raises
    ------
    InputError
        If the robot is not balanced.

    Examples
    --------
    >>> from nonholonomic.control import Rotor, SphericalRobot, controllability
    >>> axes = ((1, 0, 0), (0, 1, 0))
    >>> robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, tuple(Rotor(e, 0.1) for e in axes))
    >>> verdict = controllability(robot)
    >>> verdict.decision, verdict.growth, verdict.exceptional, verdict.growth_there
    ('controllable', (2, 3, 5), (gamma_3,), ((2, 3, 4, 5),))
    """
    fields = control_fields(_require_balanced(robot))
    growth = _growth(fields, GENERIC)
    if growth[-1] < DIMENSION:
        # one field commutes with itself; two or more always reached five in experience
        decision: Decision = "not controllable" if len(robot.rotors) == 1 else "undecided"
        return Controllability(decision, growth, (), (), 1, 0)
    search = _Search(fields, len(growth))
    exceptional = search.exceptional()
    planes = [_normal(form) for form in exceptional if form.total_degree() == 1]
    count = search.cover_size(planes)
    if count and search.steps <= len(growth):
        # where one determinant vanishes, another of commutators of the same length does not
        exceptional = []
    there = tuple(_growth_on(fields, form) for form in exceptional)
    return Controllability(
        "controllable" if count else "undecided",
        growth,
        tuple(map(_formula, exceptional)),
        there,
        search.steps,
        count,
    )


@arguments_checked
def growth_vector(robot: SphericalRobot, vertical: Sequence[float]) -> tuple[int, ...]:
    """The growth vector of the control fields of a balanced robot at a vertical.

    Parameters
    ----------
    robot : SphericalRobot
    vertical : 3 numbers
        Direction of γ, body axes, taken exactly; it need not be a unit vector.

    Returns
    -------
    tuple of int
        Dimensions spanned by the fields, with the commutators of two, of three, …, until they reach
        five, stay equal for three steps, or the commutators have seven fields.

    Raises
    ------
    InputError
        If the robot is not balanced, or the vertical is zero.

    Examples
    --------
    >>> from nonholonomic.control import Rotor, SphericalRobot, growth_vector
    >>> axes = ((1, 0, 0), (0, 1, 0))
    >>> robot = SphericalRobot(
    ...     1.0, (0.4, 0.5, 0.6), 1.0, tuple(Rotor(e, 0.1) for e in axes), "rubber"
    ... )
    >>> growth_vector(robot, (0, 0, 1)), growth_vector(robot, (3, 4, 0))
    ((2, 3, 5), (1, 2, 3, 4, 5))
    """
    numbers = [exact_number(x) for x in vertical]
    if len(numbers) != 3 or not any(numbers):
        raise InputError(f"vertical {tuple(vertical)}: it must be three numbers, not all zero")
    x, y, z = (fmpq(int(n.p), int(n.q)) for n in numbers)
    return _growth(control_fields(_require_balanced(robot)), (x, y, z))


def _require_balanced(robot: SphericalRobot) -> SphericalRobot:
    if not robot.is_balanced:
        raise InputError(
            "spherical robot: growth vectors are those of a balanced ball with rotors; with a "
            "moving mass, or a centre of mass beside the geometric centre, the motion from rest "
            "has a drift"
        )
    return robot


def _growth(fields: ControlFields, point: tuple[fmpq, fmpq, fmpq]) -> tuple[int, ...]:
    """Growth vector at a point, by the homogeneous forms of the commutators."""
    dimensions: list[int] = []
    rows: list[Field] = []
    while True:
        rows += fields.forms
        dimensions.append(int(values_at(rows, point).rank()))
        still = len(dimensions) > 3 and len(set(dimensions[-4:])) == 1
        done = not fields.levels[-1] or dimensions[-1] == DIMENSION
        if done or still or len(fields.levels) == STEPS:
            break
        fields = fields.with_next_commutators()
    while len(dimensions) > 1 and dimensions[-1] == dimensions[-2]:
        dimensions.pop()
    return tuple(dimensions)


class _Search:
    """Search for determinants of five commutators, cached without their positive factors."""

    def __init__(self, fields: ControlFields, generic: int) -> None:
        self._fields = fields
        self._forms: dict[tuple[int, ...], fmpq_mpoly] = {}
        self._rows: list[Field] = []
        self._levels: list[int] = []
        self._extend()
        self._generic = generic
        #: Longest commutators used.
        self.steps = 0

    def _extend(self) -> None:
        if self._rows:
            self._fields = self._fields.with_next_commutators()
        rows = self._fields.forms
        self._rows += rows
        self._levels += [len(self._fields.levels)] * len(rows)

    def _five_at(self, point: tuple[fmpq, fmpq, fmpq]) -> tuple[int, ...] | None:
        """The first five fields that are independent at a point."""
        while True:
            reduced, rank = values_at(self._rows, point).transpose().rref()
            if rank == DIMENSION:
                return tuple(
                    next(j for j in range(len(self._rows)) if reduced[i, j] != 0)
                    for i in range(DIMENSION)
                )
            if len(self._fields.levels) == STEPS:
                return None
            self._extend()

    def _most_independent(self, point: tuple[fmpq, fmpq, fmpq], more: int) -> tuple[int, ...]:
        """Five fields with a large determinant at a point, among longer commutators.

        They are chosen numerically; the result does not depend on the choice being optimal.
        """
        while len(self._fields.levels) < min(self._generic + more, STEPS):
            self._extend()
        count = sum(level <= self._generic + more for level in self._levels)
        values = values_at(self._rows[:count], point)
        rows = np.array([[float(x) for x in row] for row in values.tolist()])
        lengths = np.linalg.norm(rows, axis=1, keepdims=True)
        _, _, order = qr((rows / np.where(lengths > 0, lengths, 1)).T, pivoting=True)
        return tuple(sorted(int(i) for i in order[:DIMENSION]))

    def _determinant(self, five: tuple[int, ...]) -> fmpq_mpoly:
        if five not in self._forms:
            value = minor([self._rows[i] for i in five])
            form = homogeneous(value, value.total_degree())
            while not form.is_zero():
                quotient, remainder = divmod(form, self._fields.scale)
                if not remainder.is_zero():
                    break
                form = quotient
            self._forms[five] = form
        return self._forms[five]

    def exceptional(self) -> list[fmpq_mpoly]:
        """Factors with real zeros of the determinant at the generic point."""
        five = self._five_at(GENERIC)
        if five is None:
            return []
        _, factors = self._determinant(five).factor()
        return [form for form, _ in factors if without_real_zero(form) is not True]

    def _certificate(
        self, where: Rectangle, cuts: int, fives: Sequence[tuple[int, ...]]
    ) -> tuple[int, ...] | None:
        """Five fields that are independent everywhere on a rectangle."""
        for five in fives:
            if vanishes_nowhere(self._determinant(five), where):
                return five
        five = self._most_independent(where.middle, cuts // LONGER_AFTER)
        return five if vanishes_nowhere(self._determinant(five), where) else None

    def cover_size(self, planes: Sequence[tuple[fmpq, fmpq, fmpq]]) -> int:
        """The number of rectangles that cover all verticals, each with a determinant of one sign.

        Zero if none were found, or there is a vertical at which the fields do not span everything.
        `planes` are normals of planes on which the generic determinant vanishes.
        """
        # The determinants are homogeneous in γ: their zeros on the sphere are those on the faces of
        # a cube, on which they are polynomials in two variables.
        pending: list[tuple[Rectangle, int]] = [(face, 0) for face in faces()]
        count = 0
        while pending:
            where, cuts = pending.pop()
            places = [where.middle, *(_projection(where.middle, plane) for plane in planes)]
            # commutators are extended until five are independent at each of these points
            fives = [self._five_at(place) for place in places if any(place)]
            if None in fives:
                return 0
            five = self._certificate(where, cuts, [five for five in fives if five is not None])
            if five is not None:
                self.steps = max(self.steps, *(self._levels[i] for i in five))
                count += 1
            elif cuts == CUTS:
                return 0
            else:
                pending += [(half, cuts + 1) for half in where.halves()]
        return count


def _growth_on(fields: ControlFields, form: fmpq_mpoly) -> tuple[int, ...]:
    """The growth at a rational point of a plane through the origin."""
    if form.total_degree() > 1:
        return ()
    normal = _normal(form)
    x, y, z = _projection((fmpq(7), fmpq(-5), fmpq(3)), normal)
    return _growth(fields, (x, y, z))


def _normal(form: fmpq_mpoly) -> tuple[fmpq, fmpq, fmpq]:
    """The coefficients of a linear form."""
    table = form.to_dict()
    return (
        table.get((1, 0, 0), fmpq(0)),
        table.get((0, 1, 0), fmpq(0)),
        table.get((0, 0, 1), fmpq(0)),
    )


def _projection(
    point: tuple[fmpq, fmpq, fmpq], normal: tuple[fmpq, fmpq, fmpq]
) -> tuple[fmpq, fmpq, fmpq]:
    """The nearest point of the plane with a given normal."""
    share = sum((p * n for p, n in zip(point, normal, strict=True)), fmpq(0)) / sum(
        (n * n for n in normal), fmpq(0)
    )
    x, y, z = (p - share * n for p, n in zip(point, normal, strict=True))
    return x, y, z


def _formula(form: fmpq_mpoly) -> sp.Expr:
    gamma = Vector("gamma").symbols
    return sp.Add(
        *(
            sp.Rational(int(number.p), int(number.q))
            * sp.Mul(*(g ** int(k) for g, k in zip(gamma, powers, strict=True)))
            for powers, number in form.to_dict().items()
        )
    )
