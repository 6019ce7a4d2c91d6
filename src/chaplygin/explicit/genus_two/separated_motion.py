"""One motion of a separable system: constants, curve and torus, to any precision."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from flint import arb

from ...arguments import NumberOrText
from ...core.named_formulas import by_dependence, needed_steps
from ...core.system import flat_pairs
from ...formulas.balls import Values, ball, ball_values, components
from ...formulas.program import Steps
from ..base.exact_start import on_phase_space
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
        :func:`chaplygin.explicit.base.exact_start.on_phase_space`.

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
    known = {**values, **dict(zip(system.symbols, state, strict=True))}
    for name, formula in system.scalar_definitions:
        known[name] = ball_values([formula], known)[0]
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


def chain(
    separable: SeparatedSystem, formulas: Sequence[sp.Expr]
) -> tuple[tuple[sp.Symbol, ...], Steps]:
    """Arguments and steps by which formulas of the system follow from ν and ν′.

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
    # quantities of the parameters alone may be used by the formulas of the state
    still, changing = by_dependence(system.scalar_definitions, system.symbols)
    steps = (*still, *flat_pairs(separable.state), *changing)
    parameters = tuple(p.symbol for p in system.parameters)
    constants = tuple(name for name, _ in separable.constants)
    arguments = (*nu.symbols, *nuprime.symbols, *parameters, *constants)
    return arguments, needed_steps(steps, formulas)
