"""The (h, K) diagram of the motion of a rubber body of revolution, and its point in it."""

from __future__ import annotations

import numpy as np
from flint import arb, ctx

from ..base.problem import Problem
from ..one_degree.working_precision import exact_time
from .body import BITS, AxisymmetricBody, body_of, u
from .diagram import Column, Diagram, columns_at, revolution_diagram
from .state import start_state

#: Number of values of K in the diagram, and how far they extend beyond the relevant range.
VALUES, BEYOND = 120, 1.5

#: Inclinations (cos θ) at which permanent rotations are searched, to find the relevant range of K.
INCLINATIONS = np.linspace(0.25, 0.9, 14)


def diagram_of_body_of_revolution(problem: Problem) -> tuple[Diagram, tuple[float, float]] | None:
    """The diagram of a motion, and its h and K; None for any other body.

    Parameters
    ----------
    problem : Problem
        System, parameters, start in space and what rolls.

    Returns
    -------
    tuple of Diagram and (float, float), or None

    Raises
    ------
    InputError
        If the start is off the phase space.
    """
    rolling = problem.rolling
    body = None if rolling is None else body_of(rolling, problem.parameters)
    if rolling is None or body is None:
        return None
    with ctx.workprec(BITS):
        level = start_state([exact_time(x) for x in problem.start]).level(body)
    place = float(level.h), float(level.K)
    most = BEYOND * max(abs(place[1]), _largest(body))
    spins = np.linspace(most / VALUES, most, VALUES)
    return revolution_diagram(rolling, spins.tolist(), problem.parameters), place


def column_of(problem: Problem, K: float) -> Column | None:
    """The permanent rotations with the K of a motion, and the number of motions that share it.

    None at K = 0, where the diagram ends, or for any other body.

    Raises
    ------
    InputError
        If two permanent rotations merge at this K.
    """
    rolling = problem.rolling
    body = None if rolling is None else body_of(rolling, problem.parameters)
    return None if body is None or not K else columns_at(body, abs(K))


def _largest(body: AxisymmetricBody) -> float:
    """Approximate largest K for which the axis can be inclined in a permanent rotation.

    1 if none can.

    By G = 0 that is K² = −(1 − u²)² U′/u.
    """
    slope = body.energy.diff(u)
    squares = [
        float(-((1 - x * x) ** 2) * body.value(slope, x) / x)
        for x in (arb(sign * float(value)) for sign in (1, -1) for value in INCLINATIONS)
    ]
    return float(np.sqrt(max(squares))) if max(squares) > 0 else 1.0
