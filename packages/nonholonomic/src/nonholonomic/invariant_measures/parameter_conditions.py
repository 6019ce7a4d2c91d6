"""Conditions on the parameters for an invariant measure, by exact elimination.

At a rational point the lifted fields and their commutators are rows of rational functions of the
parameters. After its component along the configuration space has been eliminated, the remainder of
a row points along z and must vanish.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp
from flint import fmpq_mpoly

from flowlanes.formulas.tape import Derivation, Tape
from flowlanes.formulas.taylor import Rational

from ..mechanics.constraints.exact_points import NoPointError, random_point
from ..mechanics.lagrangian.structure_functions import VectorField
from ..mechanics.reduction.rational_evaluation import Formulas, circle
from ..mechanics.reduction.rational_functions import Quotient, as_formula, quotients
from .lifted_fields import LiftedFields
from .positivity import definite

SEED = 20080830
POINTS = 3
ATTEMPTS = 40

Level = tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Branches:
    """Levels in the parameters on which the necessary conditions hold at the tested points.

    Attributes
    ----------
    complete : bool
        Whether the conditions hold on no other level.
    """

    levels: tuple[Level, ...]
    complete: bool


def branches(
    lifted_fields: LiftedFields, steps: int, positive: frozenset[sp.Symbol], metric: sp.Expr
) -> Branches:
    """Solve the conditions at a few points for the parameters.

    Parameters
    ----------
    steps : int
        Number of commutator steps.
    positive : frozenset of Symbol
        Parameters that are positive.
    metric : sympy.Expr
        The determinant of the kinetic form, in coordinates and parameters, which is positive.

    Raises
    ------
    InputError
        If the fields are not rational in coordinates, sines and cosines.
    NoPointError
        If no rational point is found.
    """
    parameters = tuple(s for s, _ in lifted_fields.lifted.constants)
    one, names = quotients(parameters)
    tape = Tape(lifted_fields.steps, (*lifted_fields.lifted.coordinates, *parameters))
    rows = _brackets(lifted_fields, tape, steps)
    coordinates = lifted_fields.lifted.coordinates
    entries = [row.get(x, sp.S.Zero) for row in rows for x in coordinates]
    order = tape.steps(entries)
    rng = random.Random(SEED)
    conditions: dict[sp.Expr, None] = {}
    regular: list[sp.Expr] = []
    clean = True
    name = lifted_fields.lifted.name
    evaluated = [(symbol, Formulas([formula], name)) for symbol, formula in order]
    wanted = Formulas([*entries, metric], name)

    def at_point() -> tuple[list[Quotient], Quotient]:
        """Entries and metric at a point where all of them are defined."""
        for _ in range(ATTEMPTS):
            known = {**names, **_point(lifted_fields, rng, one)}
            try:
                for symbol, formula in evaluated:
                    known[symbol] = formula.at(known, one)[0]
                *values, volume = wanted.at(known, one)
            except ZeroDivisionError:
                continue
            return values, volume
        raise NoPointError

    width = len(coordinates)
    for _ in range(POINTS):
        values, volume = at_point()
        matrix = [values[i * width : (i + 1) * width] for i in range(len(rows))]
        regular.append(as_formula(volume.above))
        left, constant = _elimination(matrix, coordinates.index(lifted_fields.height))
        conditions |= dict.fromkeys(as_formula(value.above) for value in left)
        # the result says nothing about parameters at which a denominator vanishes
        clean = clean and constant and all(_finite(v.below, volume, positive) for v in values)
    levels, complete = _solutions(tuple(conditions), positive)
    distinct = {
        _solved_form(level): None
        for level in levels
        if all(_restricted_to(level, volume) != 0 for volume in regular)
    }
    return Branches(tuple(distinct), complete and clean)


def solved_parameters(level: Level) -> dict[sp.Symbol, sp.Expr]:
    """The parameters p determined by a level of differences p − v, with v in the other ones."""
    table: dict[sp.Symbol, sp.Expr] = {}
    for condition in level:
        symbol = next(
            s
            for s in sorted(condition.free_symbols, key=str)
            if sp.diff(condition, s) == 1 and s not in table
        )
        value = (symbol - condition).xreplace(table)
        table = {s: sp.cancel(v.xreplace({symbol: value})) for s, v in table.items()}
        table[symbol] = value
    return table


def _restricted_to(level: Level, formula: sp.Expr) -> sp.Expr:
    return sp.cancel(formula.xreplace(solved_parameters(level)))


def _solved_form(level: Level) -> Level:
    return tuple(s - v for s, v in solved_parameters(level).items())


def _brackets(lifted_fields: LiftedFields, tape: Tape, steps: int) -> list[VectorField]:
    """The lifted fields and their repeated commutators with them."""
    fields = [dict(field) for field in lifted_fields.lifted.frame]
    rows, last = list(fields), list(fields)
    for _ in range(steps):
        brackets = []
        for i, first in enumerate(fields):
            # among the fields themselves each pair is taken once
            for second in last[i + 1 :] if last == fields else last:
                brackets.append(_bracket(tape, first, second))
        last = [field for field in brackets if field]
        rows += last
    return list(rows)


def _bracket(tape: Tape, first: VectorField, second: VectorField) -> dict[sp.Symbol, sp.Expr]:
    along_first, along_second = (Derivation(tuple(f.items())) for f in (first, second))
    components = {}
    for x in {**first, **second}:
        value = tape.along(along_first, second.get(x, sp.S.Zero))
        value = value - tape.along(along_second, first.get(x, sp.S.Zero))
        short = tape.name(tape.short(value))
        if short != 0:
            components[x] = short
    return components


def _point(
    lifted_fields: LiftedFields, rng: random.Random, one: Quotient
) -> dict[sp.Symbol, Quotient]:
    """A rational point of the configuration space, with sines and cosines, and z = 0."""
    parameters = tuple(s for s, _ in lifted_fields.lifted.constants)
    place = random_point(lifted_fields.lifted.space(parameters), Rational(), rng)
    values = {x: one * place.values[x] for x in lifted_fields.lifted.coordinates}
    for core, pair in place.circles.items():
        if core.is_Symbol:
            values |= {s: one * v for s, v in zip(circle(core), pair, strict=True)}
    return values


def _elimination(matrix: list[list[Quotient]], height: int) -> tuple[list[Quotient], bool]:
    """The entries along z that remain after elimination, and whether all pivots were numbers."""
    rows, constant = [list(row) for row in matrix], True
    width = len(rows[0])
    while True:
        places = [
            (r, c)
            for r, row in enumerate(rows)
            for c in range(width)
            if c != height and row[c] != 0
        ]
        if not places:
            return [row[height] for row in rows if row[height] != 0], constant
        plain = [(r, c) for r, c in places if _plain(rows[r][c])]
        constant = constant and bool(plain)
        r, c = (plain or places)[0]
        pivot = rows.pop(r)
        lead = pivot[c]
        for i, row in enumerate(rows):
            if row[c] != 0:
                factor = row[c] / lead
                rows[i] = [x - factor * y for x, y in zip(row, pivot, strict=True)]


def _finite(below: fmpq_mpoly, volume: Quotient, positive: frozenset[sp.Symbol]) -> bool:
    """Whether a denominator never vanishes while the kinetic form is definite."""
    factors = {str(factor) for factor, _ in volume.above.factor()[1]}
    return all(
        str(factor) in factors or definite(as_formula(factor), positive)
        for factor, _ in below.factor()[1]
    )


def _plain(value: Quotient) -> bool:
    return bool(value.above.is_constant() and value.below.is_constant())


def _solutions(
    conditions: Sequence[sp.Expr], positive: frozenset[sp.Symbol]
) -> tuple[list[Level], bool]:
    """Levels on which all conditions vanish, and whether the list is complete."""
    conditions = [c for c in conditions if c != 0]
    if not conditions:
        return [()], True
    # the simplest condition is factored, each factor solved for a parameter in which it is linear,
    # and the other conditions are solved on that level
    chosen = min(conditions, key=lambda c: (len(sp.Add.make_args(c)), sp.count_ops(c)))
    levels: list[Level] = []
    complete = True
    for factor, _ in sp.factor_list(chosen)[1]:
        if definite(factor, positive):
            continue
        parameter = _linear(factor, positive)
        if parameter is None:
            complete = False
            continue
        slope = sp.diff(factor, parameter)
        value = sp.cancel(-factor.xreplace({parameter: sp.S.Zero}) / slope)
        remaining = [sp.numer(sp.cancel(c.xreplace({parameter: value}))) for c in conditions]
        inner, whole = _solutions(remaining, positive)
        levels += [(parameter - value, *level) for level in inner]
        complete = complete and whole
    return levels, complete


def _linear(factor: sp.Expr, positive: frozenset[sp.Symbol]) -> sp.Symbol | None:
    """A parameter in which a factor is linear, with a nonvanishing coefficient."""
    for symbol in sorted(factor.free_symbols, key=lambda s: (s in positive, str(s))):
        slope = sp.diff(factor, symbol)
        if symbol not in slope.free_symbols and (slope.is_number or definite(slope, positive)):
            return symbol
    return None
