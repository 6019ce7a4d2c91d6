"""Motions in n dimensions that involve at most three axes: reduction to three dimensions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import arb, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.formulas.balls import ball, exact, number
from flowlanes.system.arrays import FloatArray
from flowlanes.system.matrices import Skew
from flowlanes.system.system import System
from flowlanes.system.tuple_vectors import dot

from ...catalogue import entry
from ..base.derived_solution import DerivedSolution
from ..base.problem import Problem
from ..base.solution import ClosedForm, Solution, finite_times
from .operators import InertiaByProducts, Kind
from .solution import in_state

#: The dimension of the systems of the paper.
SIZE = 3
_PLANES = ((0, 1), (0, 2), (1, 2))
_NAMES = {
    Kind.VESELOVA: "veselova-nd",
    Kind.BALL: "chaplygin-ball-nd",
    Kind.SURROUNDING: "rubber-ball-on-sphere-nd",
}


@dataclass(frozen=True)
class Axis:
    """A direction of the body that takes part in a motion.

    Attributes
    ----------
    index : int
        The index of a body axis with the same factor a_i.
    direction : tuple of n arb
    p, gamma : arb
        Components along it.
    """

    index: int
    direction: tuple[arb, ...]
    p: arb
    gamma: arb


@dataclass(frozen=True, repr=False)
class FewAxesSolution(DerivedSolution):
    """A motion given by a three-dimensional one in the subspace in which it takes place.

    Attributes
    ----------
    axes : tuple of three tuples of n arb
        An orthonormal basis of the subspace.
    """

    axes: tuple[tuple[arb, ...], ...]

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """States at `times` (N,), as an array (N, size), in double precision."""
        columns = np.array([[number(x) for x in axis] for axis in self.axes]).T
        p, gamma = _vectors(list(self.inner.states(times).T), self._by_momentum)
        return in_state(self.system, columns @ np.array(p), columns @ np.array(gamma))

    @property
    def _by_momentum(self) -> bool:
        return any(isinstance(name, Skew) for name in self.inner.system.state)

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The state at one time as balls that contain the exact one."""
        with ctx.workdps(digits + 30):
            p, gamma = _vectors(self.inner.rigorous(time, digits), self._by_momentum)
            whole = [
                [
                    sum((axis[i] * x for axis, x in zip(self.axes, vector, strict=True)), arb(0))
                    for i in range(len(self.axes[0]))
                ]
                for vector in (p, gamma)
            ]
        if not any(isinstance(name, Skew) for name in self.system.state):
            return (*whole[0], *whole[1])
        n = len(whole[0])
        k = [
            whole[0][i] * whole[1][j] - whole[0][j] * whole[1][i]
            for i in range(n)
            for j in range(i + 1, n)
        ]
        return (*k, *whole[1])


def _vectors(state: Sequence[Any], by_momentum: bool) -> tuple[list[Any], list[Any]]:
    """p and γ of a three-dimensional state; p = kγ if it contains k."""
    first, gamma = list(state[:SIZE]), list(state[SIZE : 2 * SIZE])
    if not by_momentum:
        return first, gamma
    p = [0 * x for x in gamma]
    for (i, j), x in zip(_PLANES, first, strict=True):
        p[i] = p[i] + x * gamma[j]
        p[j] = p[j] - x * gamma[i]
    return p, gamma


def solve_on_few_axes(
    problem: Problem,
    operator: InertiaByProducts,
    axes: Sequence[Axis],
    solve: Callable[[Problem], Solution],
) -> Solution:
    """Solve a motion that involves at most three axes.

    Parameters
    ----------
    problem : Problem
        The reduced problem, without the motion in space.
    axes : sequence of Axis
    solve : callable
        Solves the problem of three dimensions.
    """
    n = operator.dimension
    spare = spare_indices(operator, axes)
    directions = [axis.direction for axis in axes]
    directions += [_across(directions, n) for _ in spare]
    indices = [*(axis.index for axis in axes), *spare]
    p = [*(axis.p for axis in axes), *(arb(0) for _ in spare)]
    gamma = [*(axis.gamma for axis in axes), *(arb(0) for _ in spare)]
    moments = three_moments(operator, indices)
    numbers: dict[str, Fraction] = dict(zip(("I_12", "I_13", "I_23"), moments, strict=True))
    if operator.kind is not Kind.VESELOVA:
        numbers |= {"m": operator.D, "R": Fraction(1)}
    if operator.kind is Kind.SURROUNDING:
        numbers["a"] = Fraction(-1, 2)
    family = entry(_NAMES[operator.kind])
    system = family.system({"dimension": SIZE, **{s: float(x) for s, x in numbers.items()}})
    first = p
    if operator.kind is Kind.BALL:
        first = [p[i] * gamma[j] - p[j] * gamma[i] for i, j in _PLANES]
    if operator.kind is not Kind.SURROUNDING and len(set(moments)) < SIZE:
        # Bodies of revolution are solved with their attitude.
        space = _upright(system, gamma)
    else:
        system, space = replace(system, reconstruction=None), []
    parameters = {q.symbol: numbers[str(q.symbol)] for q in system.parameters}
    start = tuple(x.mid() for x in (*first, *gamma, *space))
    inner = solve(Problem(system, parameters, start))
    return FewAxesSolution(problem.system, problem.parameters, inner, tuple(directions))


def spare_indices(operator: InertiaByProducts, axes: Sequence[Axis]) -> list[int]:
    """Indices of further axes on which nothing moves, to make three in all."""
    used = [axis.index for axis in axes]
    return [i for i in range(operator.dimension) if i not in used][: SIZE - len(axes)]


def three_moments(operator: InertiaByProducts, indices: Sequence[int]) -> list[Fraction]:
    """The moments in the planes 12, 13, 23 of three axes."""
    return [
        _moment(operator.kind, operator.products[indices[i], indices[j]], operator.D)
        for i, j in _PLANES
    ]


def of_a_body(moments: Sequence[Fraction]) -> bool:
    """Whether three moments belong to a rigid body: none exceeds the sum of the others."""
    return 2 * max(moments) <= sum(moments)


def _upright(system: System, gamma: Sequence[arb]) -> list[arb]:
    """An attitude with last row γ, and the origin as contact point."""
    rows = [_across([gamma], SIZE)]
    rows.append(_across([gamma, *rows], SIZE))
    matrix = [*rows, gamma]
    known = {f"attitude_{i + 1}{j + 1}": matrix[i][j] for i in range(SIZE) for j in range(SIZE)}
    lifted = system.lifted().symbols[len(system.symbols) :]
    return [known.get(str(s), arb(0)) for s in lifted]


def _moment(kind: Kind, product: Fraction, D: Fraction) -> Fraction:
    if kind is Kind.VESELOVA:
        return product
    return D * product / (D - product) if kind is Kind.BALL else product - D


def _across(directions: Sequence[Sequence[arb]], n: int) -> tuple[arb, ...]:
    """A unit vector orthogonal to the given ones."""
    best: list[arb] = []
    for i in range(n):
        rest = [arb(int(i == j)) for j in range(n)]
        for one in directions:
            share = one[i]
            rest = [x - share * y for x, y in zip(rest, one, strict=True)]
        if not best or dot(rest, rest) > dot(best, best):
            best = rest
    length = dot(best, best).sqrt()
    return tuple((x / length).mid() for x in best)


@dataclass(frozen=True, repr=False)
class RestSolution(Solution):
    """Rest."""

    system: System
    parameters: Mapping[sp.Symbol, NumberOrText]
    state: tuple[arb, ...]

    @classmethod
    def of(cls, problem: Problem) -> RestSolution:
        """Rest at the start of a problem, not lifted."""
        size = len(problem.system.symbols)
        state = tuple(ball(exact(x)) for x in problem.start[:size])
        return cls(problem.system, problem.parameters, state)

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """The constant state, at all `times` (N,)."""
        state = np.array([number(x) for x in self.state])
        return np.tile(state, (len(finite_times(times)), 1))

    @property
    def phase_rate(self) -> float:
        """Zero: nothing moves."""
        return 0.0

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The state as balls."""
        return self.state

    @property
    def form(self) -> ClosedForm:
        """x = x_0."""
        equation = (sp.Symbol("x"), sp.Symbol("x_0"))
        return ClosedForm(
            title=self.system.title, motion="rest", equations=(equation,), constants=()
        )
