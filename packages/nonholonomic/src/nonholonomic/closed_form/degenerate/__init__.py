"""Degenerate curves: two roots coincide, and elliptic functions suffice for the motion.

The curve y² = leading ∏ (z − root) with a double root e reduces to w = y/(z − e), an elliptic
curve. Either one of the variables z₁, z₂ stays at e while the other one runs around an oval of w
(permanent rotations), or e has closed the gap between the two variables, and the motion runs from
one such motion to another (separatrices).

The numbers of a start count as exact (a float as the decimal that it is written as, a fraction as
it is) and are projected onto the phase space in many digits.  A collision is recognised if it is
exact to within 1e-40 of the largest root; nothing is rounded towards a degenerate motion.  A start
merely close to one is a generic case whose roots are separated by as many digits as they are.  All
collisions between the two variables, or of one of them with the end of its oval, are covered; if
two pairs of roots have collided at once, the result is None.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import sympy as sp
from flint import arb, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.formulas.balls import ball

from ..base.solution import ClosedForm, Solution
from ..genus_two.separation import SeparatedSystem
from .closed_form import form_of
from .double_root_motion import motion_at_double_root
from .exact_start import PRECISION, exact_start
from .motion import DegenerateMotion
from .rigorous import rigorous_state

__all__ = ["DegenerateSolution", "solve_degenerate"]


@dataclass(frozen=True, repr=False)
class DegenerateSolution(DegenerateMotion, Solution):
    """A motion on a curve of genus two that has a double root."""

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The lifted state at one time as balls."""
        return rigorous_state(self, time, digits)

    @cached_property
    def form(self) -> ClosedForm:
        """The curve, its double root, the frequencies."""
        return form_of(self.separable, self.exact, self.motion, self.e, self.turn)


@arguments_checked
def solve_degenerate(
    separable: SeparatedSystem,
    values: Mapping[sp.Symbol, NumberOrText],
    start: Sequence[NumberOrText],
) -> Solution | None:
    """Solve a motion whose curve is degenerate.

    Parameters
    ----------
    separable : SeparatedSystem
        With three different poles at these values.
    values : mapping of Symbol to number
        The parameters of its system, taken as exact numbers.
    start : sequence of numbers
        The lifted state at t = 0, in flat order (the reduced one where there is no motion).

    Returns
    -------
    Solution or None
        None when the curve is not degenerate where the motion goes on.

    Raises
    ------
    InputError
        If the start is off the phase space or off the level.
    """
    system = separable.system
    with ctx.workprec(PRECISION):
        exact = exact_start(separable, values, start)
        for e, others in exact.double_roots:
            motion = motion_at_double_root(exact, e, others)
            if motion is not None:
                lifted = system.reconstruction is not None and len(separable.fixed) == 2
                whole = system.lifted() if lifted else replace(system, reconstruction=None)
                numbers = {s: ball(x) for s, x in values.items()}
                return DegenerateSolution(whole, numbers, tuple(start), separable, exact, motion, e)
    return None
