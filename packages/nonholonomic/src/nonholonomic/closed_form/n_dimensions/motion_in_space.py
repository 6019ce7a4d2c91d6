"""The motion in space of an n-dimensional body along its closed form.

The attitude satisfies ġ = g ω and the path of a ball on a hyperplane ẋ = R g ω γ.  These are linear
equations along the known motion, integrated here in double precision.  If the closed form has a
parameter of its own, in which the time need not be inverted, they are integrated in that parameter.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Protocol, runtime_checkable

import numpy as np
import numpy.typing as npt
from flint import arb

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.array_evaluation import values
from flowlanes.formulas.balls import ball, exact, number
from flowlanes.system.arrays import FloatArray

from ...catalogue.so_n.motion_in_space import omega_of
from ..base.derived_solution import DerivedSolution
from ..base.problem import Problem
from ..base.solution import Solution, finite_times
from .linear_motion import MOST, LinearMotion

#: Tolerance for the orthogonality of an attitude.
_SLACK = 1e-9


@runtime_checkable
class WithParameter(Protocol):
    """A motion with a parameter that is cheaper to evaluate in than time."""

    def parameters_at(self, times: FloatArray) -> FloatArray:
        """The parameter x at times (N,)."""

    def along(self, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        """States (N, size) and dt/dx at parameters (N,)."""


@dataclass(frozen=True, repr=False, eq=False)
class MotionInSpace(DerivedSolution):
    """A motion with attitude and path from linear equations along its closed form.

    Attributes
    ----------
    inner : Solution
        The motion of the reduced state.
    attitude : array (n, n)
        The attitude at t = 0.
    contact : array (n − 1,) or (0,)
        The position at t = 0 of a ball on a hyperplane.
    """

    attitude: FloatArray
    contact: FloatArray

    @property
    def not_rigorous(self) -> str:
        """Quantities without rigorous bounds."""
        inner = self.inner.not_rigorous
        here = (
            "attitude and path have no error bounds: they are integrated along the closed form, "
            f"{MOST} steps of it at most"
        )
        return f"{inner}; {here}" if inner else here

    @cached_property
    def _linear(self) -> LinearMotion:
        n = len(self.attitude)
        reduced = self.inner.system
        known = {str(symbol): value for symbol, value in self.parameters.items()}
        radius = number(ball(exact(known["R"]))) if len(self.contact) else 0.0
        places = {str(name): slice(place.start, place.stop) for name, place in reduced.slices}

        def rates(x: FloatArray) -> tuple[FloatArray, FloatArray]:
            states, pace = self._along(x)
            entries = values(reduced, omega_of(n).symbols, states, self.parameters)
            omega = np.zeros((len(x), n, n))
            rows, columns = np.triu_indices(n, 1)
            omega[:, rows, columns], omega[:, columns, rows] = entries, -entries
            omega *= pace[:, None, None]
            return omega, radius * np.einsum("xij,xj->xi", omega, states[:, places["gamma"]])

        return LinearMotion(rates, n)

    def _along(self, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        if isinstance(self.inner, WithParameter):
            return self.inner.along(x)
        return self.inner.states(x), np.ones_like(x)

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """Lifted states at `times` (N,), as an array (N, size), in double precision.

        Attitude and path are NaN at times that more than `MOST` steps would be needed to reach.
        """
        moments = finite_times(times)
        x = moments
        if isinstance(self.inner, WithParameter):
            x = self.inner.parameters_at(moments)
        turns, paths = self._linear.at(x)
        attitude = (self.attitude @ turns).reshape(len(moments), -1)
        path = (paths @ self.attitude.T)[:, : len(self.contact)] + self.contact
        return np.concatenate([self.inner.states(moments), attitude, path], axis=1)

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The state at one time as balls; infinite ones for attitude and path."""
        reduced = self.inner.rigorous(time, digits)
        more = len(self.system.symbols) - len(reduced)
        return (*reduced, *(arb(0, arb("inf")) for _ in range(more)))


def reduced_problem(problem: Problem) -> Problem:
    """The problem without the motion in space."""
    size = len(problem.system.symbols)
    return replace(
        problem, system=replace(problem.system, reconstruction=None), start=problem.start[:size]
    )


def in_space(problem: Problem, solution: Solution) -> Solution:
    """The motion of a problem in space, if requested.

    Parameters
    ----------
    problem : Problem
    solution : Solution
        Of the reduced problem.

    Raises
    ------
    InputError
        If the attitude at the start is no orthogonal matrix.
    """
    system = problem.system
    if system.reconstruction is None:
        return solution
    lifted = system.lifted()
    numbers = np.array([number(ball(exact(x))) for x in problem.start])
    places = {str(name): slice(place.start, place.stop) for name, place in lifted.slices}
    n = len(numbers[places["gamma"]])
    attitude = numbers[places["attitude"]].reshape(n, n)
    if np.abs(attitude @ attitude.T - np.eye(n)).max() > _SLACK:
        raise InputError("start: the attitude must be an orthogonal matrix")
    contact = numbers[places["contact"]] if "contact" in places else np.zeros(0)
    return MotionInSpace(lifted, problem.parameters, solution, attitude, contact)
