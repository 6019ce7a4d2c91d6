"""Constraints that repeat or contradict each other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from ..errors import InputError
from .quasivelocity import Mechanism
from .sampling import Sample, precisely, rank
from .tape import Tape

__all__ = ["check_constraints"]


@precisely
def check_constraints(
    mechanism: Mechanism,
    tape: Tape,
    points: Sequence[Sample],
    constraints: Sequence[sp.Expr],
    slopes: Sequence[Sequence[sp.Expr]],
) -> None:
    """Refuse constraints that are dependent or contradictory at generic points.

    Raises
    ------
    InputError
        Naming the first constraint that adds nothing to those before it, or contradicts them.
    """
    if not constraints:
        return
    flat = [e for row in slopes for e in row]
    steps = tape.steps([*flat, *constraints])
    for point in (p.further(steps) for p in points):
        rows = [[point.value(e) for e in row] for row in slopes]
        chosen, _ = rank(rows)
        if len(chosen) == len(constraints):
            return
    spare = next(i for i in range(len(constraints)) if i not in chosen)
    words = _words(mechanism, spare)
    if not any(abs(x) for x in rows[spare]):
        raise InputError(f"{mechanism.name}: {words} does not restrict the velocities")
    if _contradicts(point, constraints, rows, mechanism):
        raise InputError(
            f"{mechanism.name}: {words} contradicts the constraints before it: no velocity "
            "satisfies them all"
        )
    raise InputError(
        f"{mechanism.name}: {words} follows from the constraints before it; leave it out"
    )


def _words(mechanism: Mechanism, index: int) -> str:
    velocity = len(mechanism.f)
    if index < velocity:
        return f"the constraint {index + 1}, {mechanism.f[index]} = 0,"
    place = index - velocity
    return f"the position constraint {place + 1}, {mechanism.F[place]} = 0,"


def _contradicts(
    point: Sample,
    constraints: Sequence[sp.Expr],
    rows: Sequence[Sequence[Any]],
    mechanism: Mechanism,
) -> bool:
    """Whether the equations C w = C w₀ − f(w₀), linear at the point w₀, have no solution."""
    w0 = [point.point[s] for s in mechanism.frame.w]
    extended = [
        [*row, sum(c * x for c, x in zip(row, w0, strict=True)) - point.value(f)]
        for row, f in zip(rows, constraints, strict=True)
    ]
    return len(rank(extended)[0]) > len(rank(rows)[0])
