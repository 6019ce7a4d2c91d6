"""Project a start given in doubles onto the phase space, to many digits."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache

import sympy as sp
from flint import arb, arb_mat

from flowlanes.arguments import NumberOrText
from flowlanes.errors import InputError
from flowlanes.formulas.balls import ball, ball_function, ball_values, exact
from flowlanes.formulas.relative_zero import (
    START_TOLERANCE,
    SizedNumber,
    state_sizes,
    values_with_sizes,
)
from flowlanes.system.system import System


def on_phase_space(
    system: System,
    level: Sequence[sp.Expr],
    start: Sequence[NumberOrText],
    values: Mapping[sp.Symbol, arb],
) -> tuple[arb, ...]:
    """The nearest state at which all relations, and the given level expressions, vanish.

    The numbers count as exact; their rounding errors are corrected along the gradients (Newton's
    method with steps of minimal norm, where the change of each vector is measured relative to its
    length, so that the result does not depend on the units).

    Parameters
    ----------
    level : sequence of sympy.Expr
        Further expressions that vanish.
    start : sequence of numbers
        The reduced state, in flat order.
    values : mapping of Symbol to arb
        The parameters.

    Raises
    ------
    InputError
        If the start misses the phase space by more than rounding, relative to the sizes of the
        terms.
    """
    names = (*system.symbols, *values)
    function, slopes, count = _conditions(system, tuple(level), names)
    state = [ball(x) for x in start]
    if count == 0:
        return tuple(state)
    numbers = state_sizes(system.state, system.symbols, [exact(x) for x in state])
    _check(system, level, numbers, values)
    fixed = list(values.values())
    size = len(state)
    lengths = [ball(numbers[s].size) if numbers[s].size else arb(1) for s in system.symbols]
    weights = arb_mat(
        [[x * x if i == j else arb(0) for j in range(size)] for i, x in enumerate(lengths)]
    )
    for _ in range(9):
        misses = function(*state, *fixed)
        gradient = arb_mat(count, size, slopes(*state, *fixed))
        weighted = weights * gradient.transpose()
        step = weighted * (gradient * weighted).solve(arb_mat(count, 1, list(misses)))
        state = [arb((x - step[i, 0]).mid()) for i, x in enumerate(state)]
    return tuple(state)


def with_definitions(
    system: System, values: Mapping[sp.Symbol, arb], state: Sequence[arb]
) -> dict[sp.Symbol, arb]:
    """Parameters, state and definitions of a system by their symbols."""
    known = {**values, **dict(zip(system.symbols, state, strict=False))}
    for symbol, formula in system.scalar_definitions:
        (known[symbol],) = ball_values([formula], known)
    return known


def _check(
    system: System,
    level: Sequence[sp.Expr],
    state: Mapping[sp.Symbol, SizedNumber],
    values: Mapping[sp.Symbol, arb],
) -> None:
    """Raise an error if a start violates a condition by more than rounding."""
    conditions, _ = _moving(system, tuple(level))
    numbers = {s: exact(x) for s, x in values.items()}
    known = {**{s: SizedNumber(x, abs(x)) for s, x in numbers.items()}, **state}
    misses = values_with_sizes(conditions, known)
    worst = max((value.share for value in misses), default=0.0)
    if not all(value.vanishes(START_TOLERANCE) for value in misses):
        raise InputError(
            f"start: it misses the constraints by {worst:.3g} of the size of their terms; rounding "
            f"may make up {float(Fraction(int(START_TOLERANCE.p), int(START_TOLERANCE.q))):g}"
        )


@lru_cache(maxsize=64)
def _conditions(
    system: System, level: tuple[sp.Expr, ...], names: tuple[sp.Symbol, ...]
) -> tuple[Callable[..., tuple[arb, ...]], Callable[..., tuple[arb, ...]], int]:
    """The conditions and their gradients in the state, as functions of balls."""
    conditions, gradients = _moving(system, level)
    return ball_function(names, conditions), ball_function(names, gradients), len(conditions)


@lru_cache(maxsize=64)
def _moving(
    system: System, level: tuple[sp.Expr, ...]
) -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
    """The conditions that involve the state, and their gradients."""
    plain = map(system.expand, (*system.relations, *level))
    # An expression in the parameters alone is not a condition on the state.
    conditions = tuple(formula for formula in plain if formula.free_symbols & set(system.symbols))
    gradients = tuple(sp.diff(f, x) for f in conditions for x in system.symbols)
    return conditions, gradients
