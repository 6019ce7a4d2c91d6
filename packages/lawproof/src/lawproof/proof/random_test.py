"""Random test of laws: a law is refuted by a point where a residual does not vanish."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from flint import arb, fmpq

from flowlanes.formulas.errors import NotExactError, OutOfReachError
from flowlanes.formulas.number_fields import Balls, Rationals
from flowlanes.system.laws import Law

from .fields.field import Field, FieldElement
from .level.level_set import Draw, LevelSet
from .level.positivity_conditions import unmet_conditions
from .level.sample_points import (
    moderate_number,
    number_near_default,
    number_of_any_magnitude,
    small_number,
)
from .level.target_conditions import has_target, is_admissible_target
from .rank import rank_defect
from .residuals import Residuals, condition_rates, conditions_are_independent, in_words, residuals

ATTEMPTS = 400
"""Maximum number of points tried in search of one at which the law is defined."""
SEED = 20080830
FIRST = (number_near_default,) * 2 + (moderate_number,) * 4
"""Draws of the first points at which a law is evaluated."""
FURTHER = (number_near_default,) * 6 + (moderate_number,) * 40 + (small_number,) * 30
"""Draws of further points, used if a remainder is left, before a law is undecided."""


@dataclass(frozen=True)
class Trial:
    """A law evaluated at a point of its level.

    Attributes
    ----------
    field : Rationals or Balls
        The field of numbers at the point.
    values : mapping of str to number
        The values of the generators, rational if possible.
    witness : tuple of (str, number), optional
        The first non-zero residual, with its name.
    lack : tuple of (str, Any), optional
        A missing rank and the rank found: a hint only, since the point may be special.
    """

    field: Rationals | Balls
    values: Mapping[str, fmpq | arb]
    witness: tuple[str, FieldElement | str] | None = None
    lack: tuple[str, str] | None = None


def all_residuals(law: Law, level: LevelSet, field: Field) -> Residuals:
    """All residuals: those of the invariance of the level, and those of the law."""
    yield from condition_rates(level, field)
    yield from residuals(law, level, field)


def trials(
    law: Law,
    level: LevelSet,
    draws: Sequence[Draw] = FIRST,
) -> Iterator[Trial]:
    """The law at random points of the domain; fewer than requested if not enough are found.

    Parameters
    ----------
    level : LevelSet
        A component of the level.
    draws : sequence of callable
        Functions that draw the free numbers of each point.
    """
    generator = random.Random(SEED)
    compute = partial(_trial_at, law, level)
    in_vain: set[Draw] = set()
    for draw in draws:
        for kind in (draw, number_of_any_magnitude):
            trial = None if kind in in_vain else _first(compute, level, generator, kind)
            if trial is not None:
                yield trial
                break
            in_vain.add(kind)


def point_of_reversed_time(law: Law, level: LevelSet) -> Trial | None:
    """A point of the domain at which dτ/dt of an isomorphism is not positive."""
    if not has_target(law):
        return None

    def trial_at(field: Rationals | Balls, values: Mapping[str, fmpq | arb]) -> Trial:
        (witness, *_) = unmet_conditions(law, level, field) or (None,)
        return Trial(field, values, witness)

    return _first(trial_at, level, random.Random(SEED), number_near_default)


def is_nowhere(level: LevelSet, holds: Callable[[LevelSet, Field], bool]) -> bool:
    """True if points were found on a level, but none satisfies a predicate."""
    found = []

    def trial_at(field: Rationals | Balls, values: Mapping[str, fmpq | arb]) -> Trial:
        found.append(values)
        if not holds(level, field):
            raise ZeroDivisionError
        return Trial(field, values)

    first = _first(trial_at, level, random.Random(SEED), number_near_default)
    return first is None and bool(found)


def _first(
    compute: Callable[[Rationals | Balls, Mapping[str, fmpq | arb]], Trial],
    level: LevelSet,
    generator: random.Random,
    draw: Draw,
) -> Trial | None:
    for _ in range(ATTEMPTS):
        try:
            values, exact = level.point(generator, draw)
        except OutOfReachError:
            return None
        if not level.inside(values, exact):
            continue
        for rational in (True, False) if exact else (False,):
            try:
                return compute(level.numbers(values, rational), values)
            except NotExactError:
                continue
            except ZeroDivisionError:
                break
    return None


def _trial_at(
    law: Law, level: LevelSet, field: Rationals | Balls, values: Mapping[str, fmpq | arb]
) -> Trial:
    if unmet_conditions(law, level, field):
        # The law is undefined here.
        raise ZeroDivisionError
    if not is_admissible_target(law, level, field):
        raise ZeroDivisionError
    if law.of_volume and not conditions_are_independent(level, field):
        raise ZeroDivisionError
    for name, residual in all_residuals(law, level, field):
        if not field.vanishes(residual):
            return Trial(field, values, (in_words(name), residual))
    try:
        return Trial(field, values, lack=rank_defect(law, level, field))
    except OutOfReachError as reason:
        return Trial(field, values, lack=(str(reason), "not certain"))
