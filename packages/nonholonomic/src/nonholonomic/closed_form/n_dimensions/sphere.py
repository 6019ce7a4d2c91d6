"""Motions with a special operator of inertia: the axes that move, and the solver for them.

Axes on which p and γ vanish do not take part in the motion.  Axes with equal factors a_i may be
rotated among each other, so that p and γ involve at most two of them, or one if they are parallel.
If at most three axes remain, they form a three-dimensional system; otherwise the motion separates
on a curve of genus n − 1 (:mod:`.separation`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations

import numpy as np
from flint import arb, ctx, fmpq

from flowlanes.formulas.balls import ball, number
from flowlanes.formulas.relative_zero import RESOLUTION, ROUNDING, vanishes
from flowlanes.system.tuple_vectors import dot

from ..base.no_closed_form import degenerate, not_among
from ..base.problem import Problem
from ..base.solution import Solution
from ..genus_two.curve import DegenerateError
from .clock import Clock, ProductClock, RootClock
from .few_axes import (
    SIZE,
    Axis,
    RestSolution,
    of_a_body,
    solve_on_few_axes,
    spare_indices,
    three_moments,
)
from .motion_in_space import in_space, reduced_problem
from .operators import InertiaByProducts, Kind, momentum_and_vector, operator_of
from .separation import SeparatedVector, of_ball, of_surrounding_ball, of_veselova
from .solution import BITS, SphereSolution
from .torus_motion import TorusMotion
from .two_blocks import blocks_of
from .two_blocks_solution import solve_two_blocks

Balls = Sequence[arb]


def solve_on_sphere(problem: Problem, solve: Callable[[Problem], Solution]) -> Solution | None:
    """Solve a motion with a special operator of inertia; None for any other problem.

    Parameters
    ----------
    problem : Problem
    solve : callable
        Solves a problem of three dimensions.

    Raises
    ------
    InputError
        If the start is off the phase space.
    NoClosedFormError
        If roots of the curve coincide, or k is not p∧γ.
    """
    operator = operator_of(problem)
    if operator is None:
        return None
    blocks = None
    if operator.kind is not Kind.BALL:
        # If a block has a single axis, the motion on a plane is that of a three-dimensional body.
        least = 2 if operator.kind is Kind.VESELOVA else 1
        blocks = blocks_of(operator.dimension, operator.products, least)
    if blocks is None and not operator.special:
        return None
    with ctx.workprec(BITS):
        state = momentum_and_vector(problem)
        if state is None:
            raise not_among(problem, "on k = p∧γ, without momentum in planes across γ")
        reduced = reduced_problem(problem)
        p, gamma = state
        if all(x == 0 for x in p):
            solution: Solution = RestSolution.of(reduced)
        elif blocks is not None:
            solution = solve_two_blocks(reduced, blocks, operator.epsilon, p, gamma)
        else:
            solution = _solve_on_axes(reduced, operator, p, gamma, solve)
        return in_space(problem, solution)


def _solve_on_axes(
    problem: Problem,
    operator: InertiaByProducts,
    p: Balls,
    gamma: Balls,
    solve: Callable[[Problem], Solution],
) -> Solution:
    for part in (RESOLUTION, ROUNDING):
        axes = moving_axes(operator, p, gamma, part)
        try:
            if _belongs_to_a_body(operator, axes):
                return solve_on_few_axes(problem, operator, axes, solve)
            return _on_torus(problem, operator, axes)
        except DegenerateError:
            continue
    pair = next(
        ((a, b) for a, b in combinations(axes, 2) if operator.equal(a.index, b.index)), None
    )
    if pair is None:
        raise degenerate(problem)
    equal = [
        i + 1
        for i in range(operator.dimension)
        if i == pair[0].index or operator.equal(pair[0].index, i)
    ]
    names = " and ".join(map(str, equal)) if len(equal) < SIZE else ", ".join(map(str, equal))
    raise not_among(
        problem,
        f"with p and γ parallel in the axes {names}, whose a_i are equal, and those on three axes",
    )


def _belongs_to_a_body(operator: InertiaByProducts, axes: Sequence[Axis]) -> bool:
    """Whether at most three axes move, with the moments of a three-dimensional body."""
    if len(axes) > SIZE:
        return False
    indices = [axis.index for axis in axes] + spare_indices(operator, axes)
    return of_a_body(three_moments(operator, indices))


def moving_axes(operator: InertiaByProducts, p: Balls, gamma: Balls, part: fmpq) -> list[Axis]:
    """The axes on which p or γ does not vanish; at most two of equal ones.

    Parameters
    ----------
    part : fmpq
        The largest part of p and γ that counts as zero.
    """
    n = operator.dimension
    size = sum((x * x for x in p), arb(0)).sqrt()
    groups: list[list[int]] = []
    for i in range(n):
        group = next((g for g in groups if operator.equal(g[0], i)), None)
        if group is None:
            groups.append([i])
        else:
            group.append(i)
    found = []
    for group in groups:
        left: list[list[arb]] = []
        for vector, whole in ((gamma, arb(1)), (p, size)):
            rest = [vector[i] if i in group else arb(0) for i in range(n)]
            for one in left:
                share = dot(one, rest)
                rest = [x - share * y for x, y in zip(rest, one, strict=True)]
            length = dot(rest, rest).sqrt()
            if length.is_zero() or vanishes(length, whole, part):
                continue
            direction = (
                [arb(int(i == group[0])) for i in range(n)]
                if len(group) == 1
                else [(x / length).mid() for x in rest]
            )
            left.append(direction)
            if len(group) == 1:
                break
        found += [
            Axis(group[min(k, len(group) - 1)], tuple(one), dot(one, p), dot(one, gamma))
            for k, one in enumerate(left)
        ]
    return found


def _on_torus(problem: Problem, operator: InertiaByProducts, axes: Sequence[Axis]) -> Solution:
    a = operator.factors
    factors = [a[axis.index] for axis in axes]
    p, gamma = [axis.p for axis in axes], [axis.gamma for axis in axes]
    D = ball(operator.D)
    separation, clock = _separation(operator.kind, factors, D, p, gamma)
    motion = TorusMotion.of(separation, clock)
    return SphereSolution(
        problem.system,
        problem.parameters,
        operator.kind,
        tuple(factors),
        D,
        np.array([[number(x) for x in axis.direction] for axis in axes]).T,
        motion,
    )


def _separation(
    kind: Kind, a: Balls, D: arb, p: Balls, gamma: Balls
) -> tuple[SeparatedVector, Clock]:
    product = arb(1)
    for x in a:
        product *= x
    if kind is Kind.VESELOVA:
        # W = ∏z ∏a
        return of_veselova(a, p, gamma), ProductClock(product.sqrt())
    if kind is Kind.BALL:
        return of_ball(a, D, p, gamma), ProductClock(D * product.sqrt())
    total = sum((1 / x for x in a), arb(0))
    return of_surrounding_ball(a, p, gamma), RootClock(total)
