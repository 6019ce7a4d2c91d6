"""The bifurcation diagram of a given motion, and its point in the diagram."""

from __future__ import annotations

import sympy as sp

from ..base.problem import Problem
from ..solvable_cases import find_match
from . import Diagram, bifurcation_diagram, locate


def diagram_of_motion(problem: Problem) -> tuple[Diagram, tuple[float, float]] | None:
    """The diagram of a motion, and the values of its two integrals.

    Parameters
    ----------
    problem : Problem
        System, parameters and start.

    Returns
    -------
    tuple of Diagram and (float, float), or None
        None where the motion is on no level that separates.

    Raises
    ------
    InputError
        If the parameters are degenerate; see :func:`~nonholonomic.closed_form.bifurcation_diagram`.
    """
    match = find_match(problem)
    if match is None or match.level:
        return None
    own = match.own
    if match.known_system.name == "chaplygin-ball-area":
        return _with_area(problem, own.poles, own.roots[4], [c for _, c in own.constants[:3]])
    diagram = bifurcation_diagram(own, problem.parameters)
    symbols = own.system.symbols
    start = problem.start[: len(symbols)]
    return diagram, locate(diagram, dict(zip(symbols, start, strict=True)))


def _with_area(
    problem: Problem, moments: tuple[sp.Expr, ...], root: sp.Expr, constants: list[sp.Expr]
) -> tuple[Diagram, tuple[float, float]]:
    """A Chaplygin ball with the given moments, D = −`root`, and h, f, g as `constants`."""
    h, f, g = (float(value) for value in problem.values(constants))
    known = {s: sp.Rational(str(x)) for s, x in problem.numbers.items()}
    numbers = {s: known[str(s)] for s in problem.parameters}
    inertia = {f"I_{i}": moment.subs(numbers) for i, moment in enumerate(moments, 1)}
    # m R² = D, for any m and R
    ball = {**inertia, "m": -root.subs(numbers), "R": 1, "f": f}
    return bifurcation_diagram("chaplygin-ball-area", ball), (h, g)
