"""Bodies with two equal moments, of the Veselova system and of the Chaplygin ball.

Any two of the three may be the equal ones; they are told to be equal when they are so to within
1e-40.  The Chaplygin ball is solved for every (M, γ).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import sympy as sp
from flint import arb, ctx

from ...core.system import System
from ...formulas.relative_zero import vanishes
from ..base.exact_start import on_phase_space
from ..base.solution import Solution
from ..one_degree import chart_of
from ..one_degree.uniformisation import Oscillating
from .axisymmetric import Axial, ChaplyginAxial, VeselovaAxial
from .axisymmetric_solution import AxialSolution, SpaceFrame
from .exact_start import PRECISION, exact_ball
from .uniform_motion import uniform

__all__ = ["chaplygin_of_revolution", "equal_pair", "veselova_of_revolution"]

Numbers = Mapping[sp.Symbol, Any]


def equal_pair(moments: Sequence[Any]) -> int | None:
    """The number, from 0, of the axis whose moment is not in a pair of equal ones.

    None when all three differ; the last axis when all are equal.
    """
    size = max(abs(moment) for moment in moments)
    for axis in (2, 1, 0):
        one, other = (moments[k] for k in range(3) if k != axis)
        if vanishes((one - other).mid(), size):
            return axis
    return None


def _solved(
    system: System,
    values: Numbers,
    start: Sequence[Any],
    moments: Sequence[Any],
    source: str,
    made: Callable[[Any, Any, list[Any], list[Any]], Axial],
) -> Solution | None:
    with ctx.workprec(PRECISION):
        known = {symbol: exact_ball(value) for symbol, value in values.items()}
        given = [exact_ball(x) for x in start]
        size = len(system.symbols)
        state = on_phase_space(system, (), given[:size], known)
        steady = uniform(system, known, (*state, *given[size:]), moments)
        if steady is not None:
            return steady
        axis = equal_pair(moments)
        if axis is None:
            return None
        length = sum((q * q for q in given[size : size + 4]), arb(0)).sqrt()
        scene = SpaceFrame(
            system.lifted(),
            known,
            system.title,
            source,
            axis,
            tuple(q / length for q in given[size : size + 4]),
            tuple(given[size + 4 :]),
        )
        first, second = (scene.with_axis_last(state[k : k + 3]) for k in (0, 3))
        axial = made(moments[(axis + 1) % 3], moments[axis], first, second)
        u = second[2]
        rate = axial.rising
        chart = chart_of(axial.equation, u, rate)
        if not isinstance(chart, Oscillating):
            return None
        return AxialSolution(scene, axial, chart, u, rate)


def veselova_of_revolution(
    system: System, values: Numbers, start: Sequence[Any], moments: Sequence[Any]
) -> Solution | None:
    """The Veselova system with two equal moments, or turning uniformly.

    Parameters
    ----------
    system : System
        State ω, γ; not lifted.
    values : mapping of Symbol to number
        Its parameters.
    start : sequence of 10 numbers
        The lifted state at t = 0; floats are the decimals that they are written as.
    moments : three arb
        I₁, I₂, I₃.

    Returns
    -------
    Solution or None
        None when all moments differ and the body does not turn uniformly.
    """
    return _solved(system, values, start, moments, "(6.1)", VeselovaAxial.begun)


def chaplygin_of_revolution(
    system: System,
    values: Numbers,
    start: Sequence[Any],
    moments: Sequence[Any],
    D: Any,
    R: Any,
) -> Solution | None:
    """The Chaplygin ball with two equal moments, or turning uniformly, for every (M, γ).

    Parameters
    ----------
    system : System
        State M, γ; not lifted.
    values, start, moments
        As of :func:`veselova_of_revolution`; the start has 12 numbers.
    D, R : arb
        mR² and the radius.
    """

    def made(I_1: Any, I_3: Any, M: list[Any], gamma: list[Any]) -> Axial:
        return ChaplyginAxial.begun(I_1 + D, I_3 + D, D, R, M, gamma)

    return _solved(system, values, start, moments, "(7.1)", made)
