"""A start given in doubles, put on the phase space to many digits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import sympy as sp
from flint import arb, arb_mat

from ..errors import InputError
from ..system import System
from ..vectors import explicit
from .numbers import ball, ball_function

__all__ = ["on_phase_space"]

#: A start may miss the phase space by so much; rounding of a start in doubles does.
_MISS = 1e-9


def on_phase_space(
    system: System,
    level: Sequence[Any],
    start: Sequence[Any],
    values: Mapping[sp.Symbol, Any],
) -> tuple[Any, ...]:
    """The nearest state at which all relations, and the expressions of the level, vanish.

    The doubles are taken as exact numbers; what they miss by rounding is made up along the
    gradients (Newton's method of least change).

    Parameters
    ----------
    system : System
    level : sequence of sympy.Expr
        Further expressions that vanish.
    start : sequence of numbers
        The reduced state, in flat order.
    values : mapping of Symbol to arb
        The parameters.

    Raises
    ------
    InputError
        If the start misses the phase space by more than rounding.
    """
    names = (*system.symbols, *values)
    function, slopes, count = _conditions(system, tuple(level), names)
    state = [ball(x) for x in start]
    if count == 0:
        return tuple(state)
    fixed = list(values.values())
    size = len(state)
    for turn in range(9):
        misses = function(*state, *fixed)
        gradient = arb_mat(count, size, slopes(*state, *fixed))
        if turn == 0 and any(abs(miss) > _MISS for miss in misses):
            worst = max(float(abs(miss).mid()) for miss in misses)
            raise InputError(
                f"start: it misses the constraints by {worst:.3g}; rounding may make up {_MISS:g}"
            )
        step = gradient.transpose() * (gradient * gradient.transpose()).solve(
            arb_mat(count, 1, list(misses))
        )
        state = [arb((x - step[i, 0]).mid()) for i, x in enumerate(state)]
    return tuple(state)


@lru_cache(maxsize=64)
def _conditions(
    system: System, level: tuple[Any, ...], names: tuple[sp.Symbol, ...]
) -> tuple[Any, Any, int]:
    """The conditions and their gradients in the state, as functions of balls."""
    plain = (_plain(system, formula) for formula in (*system.relations, *level))
    # what depends on parameters alone is no condition on the state
    conditions = tuple(formula for formula in plain if formula.free_symbols & set(system.symbols))
    gradients = tuple(sp.diff(f, x) for f in conditions for x in system.symbols)
    return ball_function(names, conditions), ball_function(names, gradients), len(conditions)


def _plain(system: System, formula: Any) -> sp.Expr:
    """A formula in the state and the parameters, its definitions put in."""
    value = explicit(sp.sympify(formula))
    for name, meaning in reversed(system.needed([value])):
        value = value.xreplace({name: meaning})
    return value
