"""Recognise bodies with two equal moments, for the Veselova system and the Chaplygin ball.

Any two of the three moments may be the equal ones; they count as equal if they agree to within
1e-40. The Chaplygin ball is solved for every (M, γ).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import sympy as sp
from flint import arb, ctx

from flowlanes.arguments import NumberOrText
from flowlanes.formulas.balls import ball
from flowlanes.formulas.relative_zero import vanishes
from flowlanes.system.system import System

from ..base.exact_start import on_phase_space
from ..base.solution import Solution
from ..one_degree import motion_chart
from ..one_degree.uniformisation import Oscillating
from .axial_frame import AxialStart, axial_solution
from .axisymmetric import Axial, ChaplyginAxial, VeselovaAxial
from .exact_start import PRECISION
from .uniform_motion import uniform_solution

Numbers = Mapping[sp.Symbol, NumberOrText]
Vector = Sequence[arb]


def equal_pair(moments: Vector) -> int | None:
    """The index, from 0, of the axis whose moment differs from two equal ones.

    None if all three differ; the last axis if all are equal.
    """
    size = max(abs(moment) for moment in moments)
    for axis in (2, 1, 0):
        one, other = (moments[k] for k in range(3) if k != axis)
        if vanishes((one - other).mid(), size):
            return axis
    return None


def _solution(
    system: System,
    values: Numbers,
    start: Sequence[NumberOrText],
    moments: Vector,
    source: str,
    axial_motion: Callable[[arb, arb, Vector, Vector], Axial],
) -> Solution | None:
    with ctx.workprec(PRECISION):
        known = {symbol: ball(value) for symbol, value in values.items()}
        numbers = [ball(x) for x in start]
        size = len(system.symbols)
        state = on_phase_space(system, (), numbers[:size], known)
        steady = uniform_solution(system, known, (*state, *numbers[size:]), moments)
        if steady is not None:
            return steady
        axis = equal_pair(moments)
        if axis is None:
            return None
        length = sum((q * q for q in numbers[size : size + 4]), arb(0)).sqrt()
        initial = AxialStart(
            system.lifted(),
            known,
            system.title,
            source,
            axis,
            tuple(q / length for q in numbers[size : size + 4]),
            tuple(numbers[size + 4 :]),
        )
        first, second = (initial.with_axis_last(state[k : k + 3]) for k in (0, 3))
        axial = axial_motion(moments[(axis + 1) % 3], moments[axis], first, second)
        u = second[2]
        rate = axial.start_rate
        chart = motion_chart(axial.equation, u, rate)
        if not isinstance(chart, Oscillating):
            return None
        return axial_solution(initial, axial, chart, u, rate)


def veselova_of_revolution(
    system: System, values: Numbers, start: Sequence[NumberOrText], moments: Vector
) -> Solution | None:
    """Solve the Veselova system with two equal moments, or in uniform rotation.

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
    return _solution(system, values, start, moments, "(6.1)", VeselovaAxial.from_start)


def chaplygin_of_revolution(
    system: System,
    values: Numbers,
    start: Sequence[NumberOrText],
    moments: Vector,
    D: arb,
    R: arb,
) -> Solution | None:
    """Solve the Chaplygin ball with two equal moments, or in uniform rotation, for every (M, γ).

    Parameters
    ----------
    system : System
        State M, γ; not lifted.
    values, start, moments
        As of :func:`veselova_of_revolution`; the start has 12 numbers.
    D, R : arb
        mR² and the radius.
    """

    def axial_motion(I_1: arb, I_3: arb, M: Vector, gamma: Vector) -> Axial:
        return ChaplyginAxial.from_start(I_1 + D, I_3 + D, D, R, M, gamma)

    return _solution(system, values, start, moments, "(7.1)", axial_motion)
