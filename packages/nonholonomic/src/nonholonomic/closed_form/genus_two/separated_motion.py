"""One motion of a separable system: constants, curve and torus, to any precision."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
import sympy as sp
from flint import arb

from flowlanes.arguments import NumberOrText
from flowlanes.formulas.balls import (
    Values,
    array_function,
    ball,
    ball_function,
    ball_values,
    components,
    number,
)
from flowlanes.formulas.straight_line_program import Steps
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import by_dependence, flat_pairs, needed_steps

from ..base.exact_start import on_phase_space, with_definitions
from .curve import Curve
from .separation import SeparatedSystem, nu, nuprime
from .torus import InvariantTorus, torus


@dataclass(frozen=True)
class SeparatedMotion:
    """One motion of a separable system.

    Attributes
    ----------
    state : tuple of arb
        The reduced start, on the phase space, in flat order.
    values : mapping of Symbol to arb
        Parameters and constants.
    """

    separable: SeparatedSystem
    state: tuple[arb, ...]
    values: Values
    curve: Curve
    torus: InvariantTorus


def separate(
    separable: SeparatedSystem,
    parameters: Mapping[sp.Symbol, NumberOrText],
    start: Sequence[NumberOrText],
) -> SeparatedMotion:
    """Find constants, curve and torus through a start, at the working precision.

    Parameters
    ----------
    parameters : mapping of Symbol to number
        Taken as exact numbers.
    start : sequence of numbers
        The reduced state in flat order; see
        :func:`nonholonomic.closed_form.base.exact_start.on_phase_space`.

    Raises
    ------
    InputError
        If the start is off the phase space or off the level.
    DegenerateError
        If roots of the curve coincide.
    """
    system = separable.system
    values: dict[sp.Symbol, arb] = {name: ball(x) for name, x in parameters.items()}
    state = on_phase_space(system, separable.level, start, values)
    known = with_definitions(system, values, state)
    for name, formula in separable.constants:
        known[name] = values[name] = ball_values(components(formula), known)[0]

    def start_values(*formulas: sp.Expr) -> tuple[arb, ...]:
        return ball_values([part for formula in formulas for part in components(formula)], known)

    curve = Curve.of(start_values(separable.leading)[0], start_values(*separable.roots))
    motion = torus(
        curve,
        start_values(*separable.poles),
        start_values(*separable.weights),
        start_values(*separable.speeds),
        start_values(separable.direction),
        start_values(separable.turning),
        None if separable.along is None else start_values(*separable.along),
    )
    return SeparatedMotion(separable, state, values, curve, motion)


def steps_from_torus(
    separable: SeparatedSystem, formulas: Sequence[sp.Expr]
) -> tuple[tuple[sp.Symbol, ...], Steps]:
    """Arguments and steps that compute formulas of the system from ν and ν′.

    Parameters
    ----------
    formulas : sequence of sympy.Expr
        In the state, the definitions, parameters and constants.

    Returns
    -------
    arguments : tuple of Symbol
        ν, ν′, then the parameters and constants.
    steps : tuple of (Symbol, sympy.Expr)
        The state and those definitions that are needed, in order.
    """
    system = separable.system
    # Quantities of the parameters alone may be used by the formulas of the state.
    still, changing = by_dependence(system.scalar_definitions, system.symbols)
    steps = (*still, *flat_pairs(separable.state), *changing)
    parameters = tuple(p.symbol for p in system.parameters)
    constants = tuple(name for name, _ in separable.constants)
    arguments = (*nu.symbols, *nuprime.symbols, *parameters, *constants)
    return arguments, needed_steps(steps, formulas)


class MotionValues(Protocol):
    """A separable system with the parameters and constants of one motion."""

    @property
    def separable(self) -> SeparatedSystem:
        """The formulas."""

    @property
    def values(self) -> Values:
        """Parameters and constants in balls."""


def on_balls(motion: MotionValues, formulas: Sequence[sp.Expr]) -> Callable[..., tuple[Any, ...]]:
    """Formulas as a function of the six components of ν and ν′, in balls."""
    arguments, steps = steps_from_torus(motion.separable, formulas)
    evaluate = ball_function(arguments, tuple(formulas), steps)
    fixed = [motion.values[s] for s in arguments[6:]]
    return lambda *six: evaluate(*six, *fixed)


def on_arrays(
    motion: MotionValues, formulas: Sequence[sp.Expr], further: Sequence[sp.Symbol] = ()
) -> Callable[..., FloatArray]:
    """Formulas as a function of ν, ν′, each three arrays (n,), and of `further` arrays (n,)."""
    arguments, steps = steps_from_torus(motion.separable, formulas)
    evaluate = array_function((*arguments, *further), tuple(formulas), steps)
    fixed = [number(motion.values[s]) for s in arguments[6:]]

    def function(
        direction: Sequence[FloatArray], turning: Sequence[FloatArray], *others: FloatArray
    ) -> FloatArray:
        values = evaluate(*direction, *turning, *fixed, *others)
        return np.stack([np.broadcast_to(x, direction[0].shape) for x in values])

    return function
