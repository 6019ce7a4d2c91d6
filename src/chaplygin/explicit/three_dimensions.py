"""Closed forms of the systems of n dimensions for n = 3, where they are those of the paper."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import arb, arb_mat, ctx

from ..arguments import NumberOrText, arguments_checked
from ..catalogue import entry
from ..catalogue.so_n.three_dimensions import NAME, SIZE, state_in_three_dimensions
from ..core.arrays import FloatArray
from ..core.isomorphism import Isomorphism
from ..core.system import System, flat_pairs
from ..formulas.balls import array_function, ball, ball_values, exact, number
from .base.derived_solution import DerivedSolution
from .base.problem import Problem
from .base.solution import Solution
from .principal_axes import DIGITS, quaternion_of


@dataclass(frozen=True, repr=False)
class ThreeDimensionsSolution(DerivedSolution):
    """A motion of a system of n dimensions, n = 3, by that of the system of the paper.

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
    """The motion of a system of n dimensions for n = 3; None where the problem is another.

    Parameters
    ----------
    problem : Problem
    solve : callable
        Solves the problem of the paper.
    """
    law = next((law for law in problem.system.laws if law.name == NAME), None)
    if not isinstance(law, Isomorphism):
        return None
    # with its own isomorphisms, by which some are solved
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


def _lift(whole: System, start: Mapping[str, NumberOrText]) -> dict[sp.Symbol, NumberOrText]:
    """Quaternion and place of the lifted start."""
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
