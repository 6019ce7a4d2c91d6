"""Generic points of a configuration space, and evaluation of formulas there.

Decisions at such points (ranks, whether a coefficient is a constant) only select the form in which
equations are written; the equations themselves are proven.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import wraps
from typing import ParamSpec, TypeVar

import mpmath
import sympy as sp
from sympy.core.function import AppliedUndef

from flowlanes.errors import InputError
from flowlanes.formulas.multiprecision import Multiprecision
from flowlanes.system.named_formulas import expand

from .mechanism import TIME, Frame, Mechanism

DIGITS = 50
SEED = 20080830
POINTS = 3
ATTEMPTS = 40
NEWTON_STEPS = 60
#: Bound below which a number of moderate size counts as zero.
ZERO = mpmath.mpf(10) ** (-DIGITS // 2)
P = ParamSpec("P")
T = TypeVar("T")


def with_working_precision(function: Callable[P, T]) -> Callable[P, T]:
    """Decorate a function to compute with `DIGITS` digits of mpmath."""

    @wraps(function)
    def wrapper(*args: P.args, **kwargs: P.kwargs) -> T:
        with mpmath.workdps(DIGITS):
            return function(*args, **kwargs)

    return wrapper


Point = Mapping[sp.Symbol, mpmath.mpf]


class GenericPoint:
    """A point at which formulas and their definitions are evaluated."""

    def __init__(self, point: Point, steps: Sequence[tuple[sp.Symbol, sp.Expr]] = ()) -> None:
        self.point = dict(point)
        self._values = dict(point)
        for symbol, value in steps:
            self._values[symbol] = value_at_generic_point(value, self._values)

    def value(self, formula: sp.Expr) -> mpmath.mpf:
        """The value of a formula at the point.

        Raises
        ------
        ZeroDivisionError, ValueError
            Where the formula is not defined, or not real.
        """
        return value_at_generic_point(formula, self._values)

    def further(self, steps: Sequence[tuple[sp.Symbol, sp.Expr]]) -> GenericPoint:
        """The same point with further definitions."""
        point = GenericPoint(self.point)
        point._values = dict(self._values)
        for symbol, value in steps:
            if symbol not in point._values:
                point._values[symbol] = value_at_generic_point(value, point._values)
        return point


@with_working_precision
def value_at_generic_point(formula: sp.Expr, values: Mapping[sp.Symbol, mpmath.mpf]) -> mpmath.mpf:
    """The value of a formula; unspecified functions are replaced by generic polynomials."""
    number = Multiprecision(values)(_with_generic_functions(formula))
    if isinstance(number, mpmath.mpc):
        if abs(number.imag) > ZERO:
            raise ValueError(f"{formula} is not real here")
        number = number.real
    if not mpmath.isfinite(number):
        raise ZeroDivisionError
    return number


def _with_generic_functions(formula: sp.Expr) -> sp.Expr:
    """Replace unspecified functions by generic polynomials of their arguments."""
    if not formula.has(AppliedUndef):
        return formula

    def polynomial(name: str, arguments: Sequence[sp.Expr]) -> sp.Expr:
        rng = random.Random(name)
        pairs = [x * y for i, x in enumerate(arguments) for y in arguments[i:]]
        terms = [*arguments, *pairs, *(x**3 for x in arguments)]
        numbers = [sp.Rational(rng.choice([-1, 1]) * rng.randint(20, 99), 100) for _ in terms]
        return sp.Add(*(number * term for number, term in zip(numbers, terms, strict=True)))

    kinds = {f.func for f in formula.atoms(AppliedUndef)}
    for kind in kinds:
        formula = formula.replace(kind, lambda *a, n=str(kind): polynomial(n, a))
    return formula.doit()


@with_working_precision
def generic_parameters(mechanism: Mechanism) -> dict[sp.Symbol, mpmath.mpf]:
    """Generic values of the parameters, within 10 % or so of their defaults."""
    rng = random.Random(SEED)
    return {
        p.symbol: p.default * (1 + _number(rng) / 10) if p.default else _number(rng)
        for p in mechanism.parameters
    }


@with_working_precision
def default_parameters(mechanism: Mechanism) -> dict[sp.Symbol, mpmath.mpf]:
    """The default values of the parameters."""
    return {p.symbol: mpmath.mpf(repr(float(p.default))) for p in mechanism.parameters}


@with_working_precision
def generic_points(
    owner: str,
    frame: Frame,
    mechanism: Mechanism | None = None,
    parameters: Point | None = None,
    many: int = POINTS,
) -> tuple[GenericPoint, ...]:
    """Random points that satisfy relations and position constraints, with random velocities.

    Parameters are generic unless given.

    Raises
    ------
    InputError
        If no point is found at which the relations hold and every formula has a value.
    """
    rng = random.Random(SEED)
    relations = [*frame.relations, *(mechanism.F if mechanism else ())]
    steps = mechanism.steps if mechanism else ()
    constants = dict(parameters or (generic_parameters(mechanism) if mechanism else {}))
    named = {*frame.coordinates, *frame.w, *constants, *(s for s, _ in steps), TIME}
    loose = sorted(
        {s for formula in (*frame.qdot, *relations) for s in formula.free_symbols} - named, key=str
    )
    constants |= {s: _number(rng) for s in loose}
    used = [*frame.qdot]
    if mechanism is not None:
        used += [mechanism.L, *mechanism.f, *mechanism.Q.values()]
    points: list[GenericPoint] = []
    for _ in range(ATTEMPTS):
        try:
            point = _on_relations(rng, frame.coordinates, relations, steps, constants)
            velocities = {s: _number(rng) for s in frame.w}
            sample = GenericPoint({**point, **velocities}, steps)
            for formula in used:
                sample.value(formula)
        except (ZeroDivisionError, ValueError):
            continue
        points.append(sample)
        if len(points) == many:
            return tuple(points)
    raise InputError(
        f"{owner}: no configuration was found where the relations and position constraints hold "
        "and every formula has a real value"
    )


def _number(rng: random.Random) -> mpmath.mpf:
    # the offset excludes zero and simple fractions, at which formulas may be singular
    return mpmath.mpf(rng.randint(-999, 999)) / 1000 + mpmath.mpf(1) / 7001


def _on_relations(
    rng: random.Random,
    coordinates: Sequence[sp.Symbol],
    relations: Sequence[sp.Expr],
    steps: Sequence[tuple[sp.Symbol, sp.Expr]],
    constants: Point,
) -> dict[sp.Symbol, mpmath.mpf]:
    """A random point moved to a solution of the relations by Newton's method."""
    point = {**constants, TIME: _number(rng), **{q: _number(rng) for q in coordinates}}
    written = [expand(relation, steps) for relation in relations]
    slopes = [[sp.diff(f, q) for q in coordinates] for f in written]
    for _ in range(NEWTON_STEPS if relations else 0):
        values = mpmath.matrix([value_at_generic_point(f, point) for f in written])
        defect = mpmath.norm(values)
        if defect < mpmath.mpf(10) ** (5 - DIGITS):
            return point
        jacobian = mpmath.matrix(
            [[value_at_generic_point(s, point) for s in row] for row in slopes]
        )
        # redundant relations make J Jᵀ singular; the shift (Levenberg–Marquardt) vanishes with the
        # square of the defect, so that convergence stays quadratic
        gram = jacobian * jacobian.T
        for i in range(gram.rows):
            gram[i, i] += defect**2 + ZERO**2
        move = jacobian.T * mpmath.lu_solve(gram, values)
        for q, change in zip(coordinates, move, strict=True):
            point[q] -= change
    if relations:
        raise ValueError
    return point


@with_working_precision
def is_numerically_zero(formula: sp.Expr, points: Iterable[GenericPoint]) -> bool:
    """Whether a formula vanishes at all points, to working precision."""
    if formula == 0:
        return True
    return all(abs(point.value(formula)) < ZERO for point in points)


@with_working_precision
def regular_minor(rows: Sequence[Sequence[mpmath.mpf]]) -> tuple[list[int], list[int]]:
    """Rows and columns of a regular minor of maximal size, with the first rows preferred."""
    left = [list(row) for row in rows]
    chosen: list[int] = []
    columns: list[int] = []
    for index, row in enumerate(left):
        # Gaussian elimination with the largest entry of each row as pivot; rows are not
        # interchanged
        column = max(range(len(row)), key=lambda j: abs(row[j]), default=None)
        if column is None or abs(row[column]) < ZERO:
            continue
        chosen.append(index)
        columns.append(column)
        for other in left[index + 1 :]:
            factor = other[column] / row[column]
            for j, value in enumerate(row):
                other[j] -= factor * value
    return chosen, columns
