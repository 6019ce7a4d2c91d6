"""Symbolic computation of residuals on a component, for all choices of signs under roots.

The root of a product is split into roots of its factors, each taken with a sign. A sign that is
not known is a decision; the computation is repeated with each decision reversed, so that the
result holds for all signs or names the signs that it needs. Before that, formal roots are tried,
for which no sign is used.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field as dataclass_field
from typing import cast

from flowlanes.formulas.errors import (
    EffortSpentError,
    NeedMoreGeneratorsError,
    NoRealValueError,
    NoVolumeError,
    OutOfReachError,
)
from flowlanes.system.laws import Law

from .fields.budget import Budget
from .fields.formal_roots import FormalRoots
from .fields.function_field import FunctionField
from .fields.quotient_ring import Element
from .level.level_set import LevelSet
from .level.trigonometric import angle_parts
from .random_test import all_residuals
from .rank import rank_defect
from .residuals import in_words

NO_VOLUME = "the conditions of the level cut out no volume: their gradients depend on each other"
MOST_RUNS = 48
"""Maximum number of sign choices."""
NEGATIVE_BASE = "the base of a power with a symbolic exponent is negative"


@dataclass(frozen=True)
class Proof:
    """The outcome of the symbolic computation on one component.

    Attributes
    ----------
    residuals : int
        Number of zero residuals; 0 if the law is nowhere defined.
    conditions : tuple of str
        Signs required by the proof, as inequalities.
    failure : str
        Reason why a residual does not reduce to zero or cannot be computed; empty for a proof.
    lack : tuple of (str, Any), optional
        Rank that the law lacks at every point of the component, and the rank found.
    """

    residuals: int
    conditions: tuple[str, ...] = ()
    failure: str = ""
    lack: tuple[str, str] | None = None


@dataclass
class _Run:
    """One run, with the decided signs in words."""

    field: FunctionField
    residuals: int = 0
    failure: str = ""
    void: bool = False
    no_volume: bool = False
    words: dict[str, str] = dataclass_field(default_factory=dict)


def proof(
    law: Law, level: LevelSet, sample: Mapping[str, float] | None, budget: Budget, is_attained: bool
) -> Proof:
    """Try to prove a law on a component of its level, by reducing its residuals symbolically.

    Parameters
    ----------
    sample : mapping of str to float, optional
        A point of the component, whose signs are tried first.
    is_attained : bool
        Whether the law is known to attain its rank.
    """
    first = _first_run(law, level, sample, budget)
    if first.failure:
        return Proof(first.residuals, failure=first.failure)
    if not (is_attained or first.void):
        try:
            lack = rank_defect(law, level, first.field)
        except (OutOfReachError, NeedMoreGeneratorsError) as reason:
            return Proof(first.residuals, failure=f"{reason}")
        if lack is not None:
            return Proof(first.residuals, lack=lack)
    if first.field.decisions:
        formal = _run(FormalRoots, law, level, sample, budget, {})
        if formal.residuals and not formal.failure and not formal.field.decisions:
            return Proof(formal.residuals)
    proven = [] if first.void else [first]
    failed: set[str] = set()
    # (signs to take, number of fixed signs, first reversed decision)
    waiting = flipped_decisions(first.field, 0)
    runs = 1
    while waiting:
        signs, size, origin = waiting.pop()
        if origin in failed:
            continue
        runs += 1
        run = _run(FunctionField, law, level, sample, budget, signs) if runs <= MOST_RUNS else None
        if run is None or run.failure:
            failed.add(origin)
            continue
        if not run.void:
            proven.append(run)
        waiting += [(more, count, origin) for more, count, _ in flipped_decisions(run.field, size)]
    if not proven:
        return Proof(0, failure=NO_VOLUME if first.no_volume else "")
    conditions = tuple(first.words[key] for key in first.words if key in failed)
    return Proof(proven[0].residuals, conditions)


def _first_run(
    law: Law, level: LevelSet, sample: Mapping[str, float] | None, budget: Budget
) -> _Run:
    """A run with the signs at the sample point, or with others if a base would be negative."""
    first = _run(FunctionField, law, level, sample, budget, {})
    waiting = flipped_decisions(first.field, 0) if first.field.has_negative_base else []
    for signs, size, _ in waiting:
        run = _run(FunctionField, law, level, sample, budget, signs)
        if not (run.failure or run.void):
            return run
        if len(waiting) < MOST_RUNS:
            waiting += flipped_decisions(run.field, size)
    return first


def flipped_decisions(field: FunctionField, size: int) -> list[tuple[dict[str, int], int, str]]:
    """Signs for runs that reverse one decision after the first `size`.

    Each with the number of signs that it fixes and the reversed decision. Together the runs visit
    every combination once: a run fixes the decisions before the reversed one.
    """
    signs = {key: sign for key, (_, sign) in field.decisions.items()}
    keys = list(signs)
    return [
        ({**{k: signs[k] for k in keys[:i]}, keys[i]: -signs[keys[i]]}, i + 1, keys[i])
        for i in range(size, len(keys))
    ]


def _run(
    kind: type[FunctionField],
    law: Law,
    level: LevelSet,
    sample: Mapping[str, float] | None,
    budget: Budget,
    signs: Mapping[str, int],
) -> _Run:
    spare = 8
    while True:
        field = level.fractions(kind, spare, sample, budget, signs)
        field.angle_parts = angle_parts(level.system, law)
        run = _Run(field)
        try:
            run.residuals, run.failure = _zero_residuals(law, level, field)
        except NeedMoreGeneratorsError:
            spare *= 2
            continue
        except (NoRealValueError, ZeroDivisionError) as undefined:
            run.void = True
            run.no_volume = isinstance(undefined, NoVolumeError)
        except EffortSpentError:
            raise
        except OutOfReachError as reason:
            run.failure = str(reason)
        for key, (poly, sign) in field.decisions.items():
            run.words[key] = f"{field.readable_polynomial(poly if sign > 0 else -poly)} > 0"
        return run


def _zero_residuals(law: Law, level: LevelSet, field: FunctionField) -> tuple[int, str]:
    count = 0
    for name, residual in all_residuals(law, level, field):
        if not field.has_negative_base and not field.vanishes(cast(Element, residual)):
            return count, (
                f"{in_words(name)} vanishes at the points tried, but does not reduce to zero: a "
                f"polynomial of {len(cast(Element, residual).poly):,} terms remains"
            )
        count += 1
    return count, NEGATIVE_BASE if field.has_negative_base else ""
