"""Checks that constraints are independent and consistent."""

from __future__ import annotations

from collections.abc import Sequence

import mpmath
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.tape import Step, Tape

from .generic_points import ZERO, GenericPoint, regular_minor, with_working_precision
from .mechanism import Mechanism

NEWTON_STEPS = 80
#: Bound below which the derivative of a constraint by a velocity counts as zero.
FLAT = mpmath.mpf(10) ** -10


@with_working_precision
def check_constraints(
    mechanism: Mechanism,
    tape: Tape,
    points: Sequence[GenericPoint],
    constraints: Sequence[sp.Expr],
    slopes: Sequence[Sequence[sp.Expr]],
) -> None:
    """Refuse constraints that are dependent or contradictory at generic points.

    Raises
    ------
    InputError
        Names the first constraint that follows from those before it, or contradicts them.
    """
    if not constraints:
        return
    flat = [e for row in slopes for e in row]
    steps = tape.steps([*flat, *constraints])
    for point in (p.further(steps) for p in points):
        rows = [[point.value(e) for e in row] for row in slopes]
        chosen, _ = regular_minor(rows)
        if len(chosen) == len(constraints):
            return
    spare = next(i for i in range(len(constraints)) if i not in chosen)
    words = _constraint_text(mechanism, spare)
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


@with_working_precision
def check_velocities(
    mechanism: Mechanism,
    tape: Tape,
    points: Sequence[GenericPoint],
    constraints: Sequence[sp.Expr],
    slopes: Sequence[Sequence[sp.Expr]],
) -> None:
    """Refuse nonlinear constraints without solutions, or singular at their solutions.

    Linear constraints are left to `check_constraints`.

    Raises
    ------
    InputError
    """
    w = mechanism.frame.w
    steps = tape.steps([*constraints, *(e for row in slopes for e in row)])
    if not any(set(w) & e.free_symbols for row in slopes for e in (*row, *(v for _, v in steps))):
        return
    for point in points:
        state = _admissible_velocities(point, w, steps, constraints, slopes)
        if state is None:
            continue
        for index, row in enumerate(slopes):
            if all(abs(state.value(e)) < FLAT for e in row):
                raise InputError(
                    f"{mechanism.name}: {_constraint_text(mechanism, index)} is singular where it "
                    "holds: its derivatives by the velocities vanish there; write it without the "
                    "power"
                )
        return
    raise InputError(
        f"{mechanism.name}: no velocity was found that satisfies the constraints, which are not "
        "linear; do they contradict each other?"
    )


def _admissible_velocities(
    point: GenericPoint,
    w: Sequence[sp.Symbol],
    steps: Sequence[Step],
    constraints: Sequence[sp.Expr],
    slopes: Sequence[Sequence[sp.Expr]],
) -> GenericPoint | None:
    """Velocities at a configuration that satisfy the constraints, by Newton's method."""
    place = dict(point.point)
    for _ in range(NEWTON_STEPS):
        here = GenericPoint(place, steps)
        values = mpmath.matrix([here.value(f) for f in constraints])
        if mpmath.norm(values) < ZERO:
            return here
        rows = mpmath.matrix([[here.value(e) for e in row] for row in slopes])
        gram = rows * rows.T
        for i in range(gram.rows):
            gram[i, i] += ZERO**2
        # the shortest step that solves the linearised equations (Gauss–Newton)
        move = rows.T * mpmath.lu_solve(gram, values)
        for s, change in zip(w, move, strict=True):
            place[s] -= change
    return None


def _constraint_text(mechanism: Mechanism, index: int) -> str:
    velocity = len(mechanism.f)
    if index < velocity:
        return f"the constraint {index + 1}, {mechanism.f[index]} = 0,"
    place = index - velocity
    return f"the position constraint {place + 1}, {mechanism.F[place]} = 0,"


def _contradicts(
    point: GenericPoint,
    constraints: Sequence[sp.Expr],
    rows: Sequence[Sequence[mpmath.mpf]],
    mechanism: Mechanism,
) -> bool:
    """Whether the equations linearised at w₀, C w = C w₀ − f(w₀), are inconsistent."""
    w0 = [point.point[s] for s in mechanism.frame.w]
    extended = [
        [*row, sum(c * x for c, x in zip(row, w0, strict=True)) - point.value(f)]
        for row, f in zip(rows, constraints, strict=True)
    ]
    return len(regular_minor(extended)[0]) > len(regular_minor(rows)[0])
