"""Structure functions of a frame, [E_i, E_j] = c_ij^k E_k (1.8)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import mpmath
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.tape import simplify_small

from .generic_points import (
    ZERO,
    GenericPoint,
    generic_points,
    is_numerically_zero,
    regular_minor,
    with_working_precision,
)
from .mechanism import Frame, Mechanism

#: c_ij^k by (i, j, k), for i < j; missing entries are zero.
Coefficients = Mapping[tuple[int, int, int], sp.Expr]
VectorField = Mapping[sp.Symbol, sp.Expr]

DENOMINATOR = 1000
"""Largest denominator of a constant recognised as a fraction."""


def commutator(first: VectorField, second: VectorField) -> VectorField:
    """The nonzero components of [u, w] = uw − wu."""
    components = {}
    for q in {**first, **second}:
        value = lie_derivative(first, second.get(q, sp.S.Zero)) - lie_derivative(
            second, first.get(q, sp.S.Zero)
        )
        if value != 0:
            components[q] = value
    return components


def lie_derivative(field: VectorField, function: sp.Expr) -> sp.Expr:
    """The derivative of a function along a field."""
    return sp.Add(*(rate * sp.diff(function, q) for q, rate in field.items()))


@with_working_precision
def structure(frame: Frame, owner: str = "frame") -> Coefficients:
    """The structure functions of a frame.

    Constants are recognised at generic points; other functions solve the equations of as many
    coordinates as there are fields, and are checked on the remaining ones at generic points.

    Raises
    ------
    InputError
        If the fields are dependent, if there are fewer than the configuration space has
        dimensions, or if `Frame.structure` uses an unknown velocity.
    """
    if frame.structure is not None:
        return _stated_coefficients(frame, owner)
    constant = all(entry.is_number for entry in frame.matrix) and frame.matrix.is_square
    if constant and not frame.relations:
        if frame.matrix.det() == 0:
            raise InputError(f"{owner}: the frame does not span: its fields are dependent")
        return {}
    points = generic_points(owner, frame)
    rows = _spanning(frame, points[0], owner)
    fields = [frame.field(i) for i in range(len(frame.w))]
    coefficients: dict[tuple[int, int, int], sp.Expr] = {}
    for i, first in enumerate(fields):
        for j in range(i + 1, len(fields)):
            bracket = commutator(first, fields[j])
            if not bracket:
                continue
            column = [bracket.get(q, sp.S.Zero) for q in frame.coordinates]
            solution = _constant(frame, points, rows, column)
            if solution is None:
                solution = _solution_on_rows(frame, rows, column)
                _check_span(frame, points, column, solution, owner)
            for k, value in enumerate(solution):
                if value != 0:
                    coefficients[i, j, k] = value
    return coefficients


def written_frame(mechanism: Mechanism) -> Frame:
    """The frame of a mechanism with definitions substituted, for commutators."""
    frame, defined = mechanism.frame, {s for s, _ in mechanism.steps}
    if frame.structure is not None or not any(r.free_symbols & defined for r in frame.qdot):
        return frame
    rates = dict(zip(frame.coordinates, map(mechanism.expand, frame.qdot), strict=True))
    return Frame(rates, frame.velocities, frame.relations)


@with_working_precision
def check_structure(frame: Frame, owner: str = "frame") -> None:
    """Refuse structure functions that are impossible for a frame with these rates.

    Raises
    ------
    InputError
        If they break the identity of Jacobi, or differ from the commutators on the coordinates.
    """
    coefficients = _stated_coefficients(frame, owner)
    points = generic_points(owner, frame)
    size = range(len(frame.w))
    fields = [frame.field(i) for i in size]

    def c(i: int, j: int, k: int) -> sp.Expr:
        return (
            coefficients.get((i, j, k), sp.S.Zero)
            if i < j
            else -coefficients.get((j, i, k), sp.S.Zero)
        )

    for i, j in combinations(size, 2):
        bracket = commutator(fields[i], fields[j])
        for q, row in zip(frame.coordinates, frame.matrix.tolist(), strict=True):
            span = sp.Add(*(c(i, j, k) * row[k] for k in size))
            if not is_numerically_zero(bracket.get(q, sp.S.Zero) - span, points):
                raise InputError(
                    f"{owner}: the commutator of {frame.w[i]} and {frame.w[j]} is not that of "
                    f"their rates: they differ on the coordinate {q}"
                )
    # Jacobi identity with variable coefficients: the cyclic sum of c_ab^s c_sd^n − E_d(c_ab^n)
    # vanishes
    for i, j, k in combinations(size, 3):
        for n in size:
            terms = [
                sp.Add(*(c(a, b, s) * c(s, d, n) for s in size))
                - lie_derivative(fields[d], c(a, b, n))
                for a, b, d in ((i, j, k), (j, k, i), (k, i, j))
            ]
            if not is_numerically_zero(sp.Add(*terms), points):
                names = ", ".join(str(frame.w[s]) for s in (i, j, k))
                raise InputError(
                    f"{owner}: the commutators of {names} break the identity of Jacobi, so that "
                    "no frame has them"
                )


def _stated_coefficients(frame: Frame, owner: str) -> Coefficients:
    place = {s: i for i, s in enumerate(frame.w)}
    coefficients: dict[tuple[int, int, int], sp.Expr] = {}
    for pair, row in frame.structure or ():
        for s in (*pair, *(name for name, _ in row)):
            if s not in place:
                raise InputError(
                    f"{owner}: the structure names {s}, which is no velocity; allowed: "
                    f"{', '.join(map(str, frame.w))}"
                )
        i, j = (place[s] for s in pair)
        sign = 1 if i < j else -1
        for s, value in row:
            coefficients[min(i, j), max(i, j), place[s]] = sign * sp.sympify(value)
    return coefficients


def _spanning(frame: Frame, point: GenericPoint, owner: str) -> list[int]:
    """Rows of a regular minor of G; InputError if the fields are not a frame."""
    numbers = [[point.value(e) for e in frame.matrix.row(i)] for i in range(len(frame.qdot))]
    rows, _ = regular_minor(numbers)
    slopes = [[point.value(sp.diff(f, q)) for q in frame.coordinates] for f in frame.relations]
    dimension = len(frame.coordinates) - len(regular_minor(slopes)[0])
    if len(rows) < len(frame.w):
        raise InputError(
            f"{owner}: the frame does not span: its {len(frame.w)} fields have rank {len(rows)} "
            "only; drop a velocity, or give the structure functions if the frame is that of a "
            "system reduced by a symmetry group"
        )
    if len(rows) < dimension:
        raise InputError(
            f"{owner}: the frame does not span: {len(frame.w)} velocities for a configuration "
            f"space of dimension {dimension}; every direction needs one"
        )
    return rows


def _constant(
    frame: Frame, points: Sequence[GenericPoint], rows: Sequence[int], column: Sequence[sp.Expr]
) -> list[sp.Expr] | None:
    """The coefficients of a commutator if they are equal fractions at all points, else None."""
    coefficients: list[sp.Expr] | None = None
    for point in points:
        matrix = mpmath.matrix([[point.value(e) for e in frame.matrix.row(i)] for i in rows])
        right = mpmath.matrix([point.value(column[i]) for i in rows])
        solution = mpmath.lu_solve(matrix, right)
        fractions = [_fraction(x) for x in solution]
        if coefficients is None:
            if None in fractions:
                return None
            coefficients = [f for f in fractions if f is not None]
        if fractions != coefficients:
            return None
    return coefficients


def _fraction(number: mpmath.mpf) -> sp.Rational | None:
    near = sp.Rational(str(number)).limit_denominator(DENOMINATOR)
    close = abs(mpmath.mpf(near.p) / near.q - number) < mpmath.sqrt(ZERO)
    return near if close else None


def _solution_on_rows(
    frame: Frame, rows: Sequence[int], column: Sequence[sp.Expr]
) -> list[sp.Expr]:
    matrix = sp.Matrix([list(frame.matrix.row(i)) for i in rows])
    right = sp.Matrix([column[i] for i in rows])
    return [simplify_small(x) for x in matrix.LUsolve(right)]


def _check_span(
    frame: Frame,
    points: Sequence[GenericPoint],
    column: Sequence[sp.Expr],
    solution: Sequence[sp.Expr],
    owner: str,
) -> None:
    for i, value in enumerate(column):
        remainder = value - sp.Add(
            *(g * c for g, c in zip(frame.matrix.row(i), solution, strict=True))
        )
        if not is_numerically_zero(remainder, points):
            raise InputError(
                f"{owner}: a commutator of the frame's fields leaves their span in the coordinate "
                f"{frame.coordinates[i]}; the frame does not belong to one configuration space"
            )
