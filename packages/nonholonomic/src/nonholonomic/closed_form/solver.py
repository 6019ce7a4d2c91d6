"""Solve in closed form: from a system and a start to the motion at every time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import cast

from sympy import Symbol

from flowlanes.arguments import NumberOrText, Parameters, Start, arguments_checked
from flowlanes.flow.initial_states import whole_start
from flowlanes.system.parameters import parameter_values
from flowlanes.system.system import System

from .base.problem import Problem
from .base.solution import Solution
from .solvable_cases import solution_of


@arguments_checked
def solve(system: System, start: Start, parameters: Parameters = None) -> Solution:
    """Solve an integrable system from a start.

    Parameters
    ----------
    system : System
        A system with a closed form, under any name and in any symbols.
    start : sequence of numbers, or mapping of str to number or numbers
        The state at t = 0 in flat order, with the motion in space, as
        :func:`nonholonomic.initial_state` gives it, or without, which gives the motion of the
        state alone; or by name (ω and γ, or the variables of the state).
    parameters : mapping of Symbol or name to number, optional
        Values that replace the system's defaults.

    Returns
    -------
    Solution
        ``solution(t)`` gives the state at any times; see
        :class:`nonholonomic.closed_form.base.solution.Solution`.

    Raises
    ------
    NoClosedFormError
        If no closed form is known; the message states the known laws of the motion.
    InputError
        If start or parameters do not fit the system.

    Examples
    --------
    >>> import nonholonomic
    >>> disk = nonholonomic.from_catalogue("rubber-disk")
    >>> solution = nonholonomic.solve(disk, nonholonomic.CATALOGUE["rubber-disk"].start.values)
    >>> [round(float(x), 6) for x in solution(1e6)["gamma"][0]]
    [0.312372, -0.233492, 0.920818]
    """
    # Values that are not single numbers are rejected with the first formula.
    values = cast(dict[Symbol, NumberOrText], parameter_values(system, parameters))
    if isinstance(start, Mapping):
        start = whole_start(system, start, values)
    return solution_of(Problem(system, values, tuple(start)))
