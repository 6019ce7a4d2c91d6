"""States of a motion on a torus as balls that contain the exact ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from flint import arb, ctx

from .numbers import ball, components, number
from .prepared import Prepared, chain, prepared
from .rigorous_formula import Branch, direction
from .rigorous_quadrature import RigorousQuadrature, bits_for, quadratures
from .rigorous_theta import numerators_at
from .rigorous_turn import PathRates, Turn, path_rates

if TYPE_CHECKING:
    from .genus_two import GenusTwo

__all__ = ["RigorousMotion", "rigorous_motion", "rigorous_state"]

#: Bits lost between the start and the phases, at most on motions that are not nearly degenerate.
_LOST = 100


@dataclass(frozen=True)
class RigorousMotion:
    """A motion on a torus with error bounds.

    Attributes
    ----------
    solution : GenusTwo
        The same motion in double precision.
    prepared : Prepared
        Constants, curve and torus at the precision that is needed.
    clock : RigorousQuadrature
        ∫ (dt/dτ) dτ.
    digits : int
    reach : float
        The largest |τ|.
    """

    solution: GenusTwo
    prepared: Prepared
    clock: RigorousQuadrature
    digits: int
    reach: float

    @cached_property
    def _state(self) -> Branch:
        symbols = self.prepared.separable.system.symbols
        return Branch(symbols, self.prepared.values, chain(self.prepared.separable, symbols)[1])

    @cached_property
    def _turn(self) -> Turn:
        start = self.solution.start
        place = len(self.prepared.separable.system.symbols)
        with ctx.workprec(self.clock.bits):
            at_start = direction(*numerators_at(self.prepared.torus, 0))
            return Turn.through(
                self.prepared, at_start, [ball(x) for x in start[place : place + 4]]
            )

    @cached_property
    def _paths(self) -> tuple[PathRates, tuple[RigorousQuadrature, ...]] | None:
        """Rates of what the motion has in space beside the attitude, and the integrals in them."""
        with ctx.workprec(self.clock.bits):
            found = path_rates(self.prepared)
            if found is None:
                return None
            torus = self.prepared.torus
            return found, quadratures(torus, found.functions, self.digits, self.reach)

    def _moved(self, tau: Any) -> list[Any]:
        """By how much the coordinates in space beside the attitude have changed."""
        if self._paths is None:
            return []
        rates, integrals = self._paths
        values, axes = [path.at(tau) for path in integrals], self._turn.axes
        return [sum((axes[k] * values[i] for i, k in own), arb(0)) for own in rates.shares]

    def reduced(self, tau: Any) -> tuple[list[Any], tuple[list[Any], list[Any]]]:
        """The reduced state, and ν and ν′, at one τ."""
        there = direction(*numerators_at(self.prepared.torus, tau))
        return self._state.at(*there), there

    def state(self, time: Any) -> tuple[Any, ...]:
        """The lifted state at one time, as balls (arb).

        The sign of the quaternion, which the attitude leaves open, is that of the evaluation in
        double precision.

        Parameters
        ----------
        time : float, int, str, Fraction or arb
            With |τ| ≤ reach there.
        """
        with ctx.workprec(self.clock.bits):
            moment = ball(time)
            tau = self.clock.inverse(moment)
            reduced, there = self.reduced(tau)
            if self.prepared.separable.system.motion is None:
                return tuple(reduced)
            rough = self.solution.states([number(moment)])[0]
            first = len(reduced)
            turn = self._turn.quaternion(there, rough[first : first + 4])
            origin = self.solution.start[first + 4 :]
            places = [ball(x) + y for x, y in zip(origin, self._moved(tau), strict=True)]
            return (*reduced, *turn, *places)


def rigorous_motion(solution: GenusTwo, digits: int, until: Any) -> RigorousMotion:
    """Prepare a motion for evaluation with error bounds.

    Parameters
    ----------
    solution : GenusTwo
    digits : int
        Decimal places after the point that are wanted.
    until : number
        The largest |time| at which they are wanted.

    Raises
    ------
    InputError
        If the motion is so close to a separatrix that the bounds would take too long.
    """
    own = solution.prepared
    reach = 10 + 1.1 * abs(number(ball(until))) / number(solution.clock.mean)
    system = own.separable.system
    values = {p.symbol: own.values[p.symbol] for p in system.parameters}
    start: Sequence[Any] = solution.start[: len(system.symbols)]
    with ctx.workprec(bits_for(digits, reach) + _LOST):
        exact = prepared(own.separable, values, start)
        rate = components(own.separable.clock)
        branch = Branch(rate, exact.values, chain(own.separable, rate)[1])
    (clock,) = quadratures(exact.torus, branch, digits, reach)
    return RigorousMotion(solution, exact, clock, digits, reach)


def rigorous_state(solution: GenusTwo, time: Any, digits: int) -> tuple[Any, ...]:
    """The lifted state of a motion at one time as balls that contain the exact one.

    Parameters
    ----------
    solution : GenusTwo
    time : float, int, str, Fraction or arb
    digits : int
        Decimal places aimed at; the radii of the balls say what was reached.

    Raises
    ------
    InputError
        See :func:`rigorous_motion`.
    """
    return rigorous_motion(solution, digits, time).state(time)
