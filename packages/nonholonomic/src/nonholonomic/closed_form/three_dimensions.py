"""Closed forms of n-dimensional systems for n = 3, from those of the paper's systems."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import arb, arb_mat, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.formulas.balls import array_function, ball, ball_values, exact, number
from flowlanes.system.arrays import FloatArray
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.matrices import Skew, SymmetricMatrix
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.system import System

from ..catalogue import entry
from ..catalogue.so_n.three_dimensions import NAME, SIZE, TARGETS, state_in_three_dimensions
from .base.derived_solution import DerivedSolution
from .base.problem import Problem
from .base.solution import Solution
from .principal_axes import DIGITS, principal_axes, quaternion_of, to_original_axes


@dataclass(frozen=True, repr=False)
class ThreeDimensionsSolution(DerivedSolution):
    """A motion of an n-dimensional system with n = 3, from that of the system of the paper.

    Attributes
    ----------
    formulas : tuple of sympy.Expr
        The lifted state in that of the other system, and the parameters.
    """

    formulas: tuple[sp.Expr, ...]

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """Lifted states at `times` (n,), as an array (n, size), in double precision."""
        names = (*self.inner.system.symbols, *self.parameters)
        columns = self.inner.states(times).T
        values = array_function(names, self.formulas)(
            *columns, *(number(x) for x in self.parameters.values())
        )
        return np.stack([np.broadcast_to(x, columns[0].shape) for x in values], axis=1)

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The lifted state at one time as balls that contain the exact one."""
        with ctx.workdps(digits + 30):
            inner = self.inner.rigorous(time, digits)
            known = dict(zip(self.inner.system.symbols, inner, strict=True))
            known |= {s: ball(exact(x)) for s, x in self.parameters.items()}
            return ball_values(self.formulas, known)


def solve_in_three_dimensions(
    problem: Problem, solve: Callable[[Problem], Solution]
) -> Solution | None:
    """Solve an n-dimensional system with n = 3; None for any other problem.

    Parameters
    ----------
    problem : Problem
    solve : callable
        Solves the problem of the paper.
    """
    law = next((law for law in problem.system.laws if law.name == NAME), None)
    if not isinstance(law, Isomorphism):
        turned = _with_moments(problem)
        if turned is None:
            return None
        return to_original_axes(problem, solve(turned[0]), turned[1])
    # With its own isomorphisms, by which some systems are solved.
    target, system = entry(law.target.name).system(), problem.system
    lifted = system.lifted() if system.reconstruction else system
    if system.reconstruction is None:
        target = replace(target, reconstruction=None)
    whole = target.lifted() if target.reconstruction else target
    start = dict(zip(lifted.symbols, problem.start, strict=True))
    constants = {s: problem.parameters[f] for s, f in flat_pairs(law.constants)}
    parameters: dict[sp.Symbol, NumberOrText] = {
        p.symbol: constants.get(p.symbol, problem.parameters.get(p.symbol, p.default))
        for p in target.parameters
    }
    images = flat_pairs(law.map)
    values = dict(zip((s for s, _ in images), problem.values([f for _, f in images]), strict=True))
    with ctx.workdps(DIGITS):
        values |= _lift(whole, {str(s): x for s, x in start.items()})
    inner = solve(Problem(target, parameters, tuple(values[s] for s in whole.symbols)))
    back = state_in_three_dimensions(system)
    return ThreeDimensionsSolution(
        lifted, problem.parameters, inner, tuple(back[s] for s in lifted.symbols)
    )


def _with_moments(problem: Problem) -> tuple[Problem, arb_mat] | None:
    """A body given by a mass tensor, n = 3, in its principal axes, if it has moments.

    Returns
    -------
    Problem, arb_mat
        The same motion in those axes, and the orthogonal matrix that takes its lifted states
        back; None for any other system.
    """
    system, numbers = problem.system, {str(s): exact(x) for s, x in problem.parameters.items()}
    J = SymmetricMatrix("J", SIZE)
    names = [str(s) for s in J.symbols]
    if system.name not in TARGETS or not set(names) <= set(numbers) or "J_44" in numbers:
        return None
    family = entry(system.name)
    own = family.system({"dimension": SIZE} | {n: float(x) for n, x in numbers.items()})
    if (own.field, own.definitions) != (system.field, system.definitions):
        return None
    with ctx.workdps(DIGITS):
        entries = [[ball(numbers[str(J.entries[i, j])]) for j in range(SIZE)] for i in range(SIZE)]
        eigenvalues, axes = principal_axes(entries)
        a, b, c = eigenvalues
        moments = {"I_12": a + b, "I_13": a + c, "I_23": b + c}
        rest = {name: float(x) for name, x in numbers.items() if name not in names}
        rounded = {name: number(x) for name, x in moments.items()}
        target = family.system({"dimension": SIZE} | rounded | rest)
        lifted = system.lifted() if system.reconstruction else system
        if system.reconstruction is None:
            target = replace(target, reconstruction=None)
        matrix = _turn_of_states(lifted, axes)
        column = arb_mat([[ball(exact(x))] for x in problem.start])
        start = tuple(row[0] for row in (matrix.transpose() * column).tolist())
        parameters: dict[sp.Symbol, NumberOrText] = {
            p.symbol: moments.get(str(p.symbol), numbers.get(str(p.symbol), p.default))
            for p in target.parameters
        }
    return Problem(target, parameters, start), matrix


def _turn_of_states(lifted: System, axes: arb_mat) -> arb_mat:
    """The matrix that takes lifted states in principal axes to those in the body's own axes."""
    S = axes.tolist()
    size = len(lifted.symbols)
    matrix = [[arb(int(i == j)) for j in range(size)] for i in range(size)]
    planes = [(0, 1), (0, 2), (1, 2)]
    for name, place in lifted.slices:
        first = place.start
        if isinstance(name, Skew):
            for r, (i, j) in enumerate(planes):
                for c, (k, m) in enumerate(planes):
                    matrix[first + r][first + c] = S[i][k] * S[j][m] - S[i][m] * S[j][k]
        elif str(name) != "contact":
            # Vectors, and the rows of the attitude, which are space vectors in body axes.
            for corner in range(first, place.stop, SIZE):
                for i in range(SIZE):
                    matrix[corner + i][corner : corner + SIZE] = S[i]
    return arb_mat(matrix)


def _lift(whole: System, start: Mapping[str, NumberOrText]) -> dict[sp.Symbol, NumberOrText]:
    """Quaternion and position of the lifted start."""
    found: dict[sp.Symbol, NumberOrText] = {}
    for name, place in whole.slices:
        symbols = whole.symbols[place]
        if str(name) == "attitude":
            axes = range(1, SIZE + 1)
            matrix = [[ball(exact(start[f"attitude_{i}{j}"])) for j in axes] for i in axes]
            found |= dict(zip(symbols, quaternion_of(arb_mat(matrix)), strict=True))
        elif str(name) == "place":
            found |= dict(zip(symbols, (start["contact_1"], start["contact_2"]), strict=True))
    return found
