"""States of a motion on a torus as balls that contain the exact states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import ceil, log10

from flint import arb, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.balls import ball, components, number
from flowlanes.system.arrays import FloatArray

from ..genus_two.separated_motion import SeparatedMotion, separate
from .branch_formula import Branch, direction
from .quadrature import RigorousQuadrature, bits_for, quadratures, speed_of
from .reconstruction import Pair, PathRates, Turn, path_rates
from .theta import numerators_at
from .torus_motion import TorusMotion

__all__ = ["RigorousMotion", "rigorous_motion", "rigorous_state"]

#: Largest loss of bits between the start and the phases, for motions that are not nearly
#: degenerate.
_GUARD_BITS = 100
#: Turns of the phases up to the latest time; later times would need hundreds of digits.
_LATEST = 1e60
#: Motions are prepared for turns of the phases up to powers of 10 with this exponent step.
_DECADES = 6


@dataclass(frozen=True)
class RigorousMotion:
    """A motion on a torus with error bounds.

    Attributes
    ----------
    solution : TorusMotion
        The same motion in double precision.
    separated_motion : SeparatedMotion
        Constants, curve and torus at the precision that is needed.
    clock : RigorousQuadrature
        ∫ (dt/dτ) dτ.
    digits : int
        Decimal places after the point that are wanted.
    reach : float
        The largest |τ|.
    """

    solution: TorusMotion
    separated_motion: SeparatedMotion
    clock: RigorousQuadrature
    digits: int
    reach: float

    @cached_property
    def _state(self) -> Branch:
        return Branch.of(self.separated_motion, self.separated_motion.separable.system.symbols)

    @cached_property
    def _pair(self) -> Pair | None:
        return Pair.of_motion(self.separated_motion)

    def _turn(self, pair: Pair) -> Turn:
        """The triad at the start."""
        place = len(self.separated_motion.separable.system.symbols)
        quaternion = [ball(x) for x in self.solution.start[place : place + 4]]
        at_start = direction(*numerators_at(self.separated_motion.torus, arb(0)))
        return Turn.through(self.separated_motion, pair, at_start, quaternion)

    @cached_property
    def _angle(self) -> RigorousQuadrature | None:
        """The angle by which the triad turns about its first vector."""
        if self._pair is None or self._pair.rate is None:
            return None
        with ctx.workprec(self.clock.bits):
            rate = self._pair.turning(self.separated_motion)
        # An angle may grow by several whole turns in one turn of the phases.
        return quadratures(self.separated_motion.torus, rate, self.digits + 1, self.reach)[0]

    @cached_property
    def _paths(self) -> tuple[PathRates, tuple[RigorousQuadrature, ...]] | None:
        """Rates of the spatial variables other than the attitude, and the integrals in them."""
        if self._pair is None or self._pair.rate is not None:
            return None
        with ctx.workprec(self.clock.bits):
            rates = path_rates(self.separated_motion, self._pair)
            if rates is None:
                return None
            torus = self.separated_motion.torus
            return rates, quadratures(torus, rates.functions, self.digits, self.reach)

    def _motion_in_space(
        self, tau: arb, there: tuple[list[arb], list[arb]], rough: FloatArray
    ) -> list[arb]:
        """Attitude and positions; balls of infinite radius for those without bounds."""
        start = self.solution.start[-len(rough) :]
        if self._pair is None:
            return [arb(0, arb("inf")) for _ in start]
        places = [arb(0, arb("inf")) for _ in start[4:]]
        turn = self._turn(self._pair)
        if self._paths is not None:
            rates, integrals = self._paths
            values = [path.integral(tau) for path in integrals]
            moved = [
                sum((turn.axes[k] * values[i] for i, k in own), arb(0)) for own in rates.shares
            ]
            places = [ball(x) + y for x, y in zip(start[4:], moved, strict=True)]
        if self._angle is not None:
            turn = turn.after_rotation(self._angle.integral(tau))
        return turn.quaternion(there, rough) + places

    def reduced_state(self, tau: arb) -> tuple[list[arb], tuple[list[arb], list[arb]]]:
        """The reduced state, and ν and ν′, at one τ."""
        there = direction(*numerators_at(self.separated_motion.torus, tau))
        return self._state.at(*there), there

    def state(self, time: NumberOrText) -> tuple[arb, ...]:
        """The lifted state at one time, as balls (arb).

        The sign of the quaternion, which the attitude leaves open, is that of the evaluation in
        double precision. If a single direction is known to be fixed in space, the position has no
        bounds (infinite balls); if none is known, neither has the attitude.

        Parameters
        ----------
        time : float, int, str, Fraction or arb
            With |τ| ≤ reach there.
        """
        with ctx.workprec(self.clock.bits):
            moment = ball(time)
            tau = self.clock.inverse(moment)
            reduced_state, there = self.reduced_state(tau)
            if self.separated_motion.separable.system.reconstruction is None:
                return tuple(reduced_state)
            rough = self.solution.states([number(moment)])[0, len(reduced_state) :]
            return (*reduced_state, *self._motion_in_space(tau, there, rough))


@arguments_checked
def rigorous_motion(solution: TorusMotion, digits: int, until: NumberOrText) -> RigorousMotion:
    """Prepare a motion for evaluation with error bounds.

    Parameters
    ----------
    solution : TorusMotion
    digits : int
        Decimal places after the point that are wanted.
    until : number
        The largest |time| at which they are wanted.

    Returns
    -------
    RigorousMotion

    Raises
    ------
    InputError
        If the motion is so close to a separatrix that the bounds would take too long, or the time
        is too large.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.closed_form.rigorous import rigorous_motion
    >>> veselova = nonholonomic.from_catalogue("veselova")
    >>> motion = nonholonomic.solve(veselova, nonholonomic.CATALOGUE["veselova"].start.values)
    >>> all(ball.rad() < 1e-12 for ball in rigorous_motion(motion, 12, 10.0).state(1.0))
    True
    """
    own = solution.separated_motion
    turns = 10 + 1.1 * _turns(solution, until)
    reach = turns / speed_of(own.torus)
    start: Sequence[NumberOrText] = solution.start[: len(own.separable.system.symbols)]
    with ctx.workprec(bits_for(digits, turns) + _GUARD_BITS):
        exact = separate(own.separable, solution.parameters, start)
        branch = Branch.of(exact, components(own.separable.time_rescaling))
    (clock,) = quadratures(exact.torus, branch, digits, reach)
    return RigorousMotion(solution, exact, clock, digits, reach)


def _turns(solution: TorusMotion, time: NumberOrText) -> float:
    """Turns of the phases up to a time."""
    latest = number(ball(time))
    pace = solution.phase_rate
    if not abs(latest) * pace <= _LATEST:
        raise InputError(
            f"time: bounds are computed up to |t| = {_LATEST / pace:.3g}, not at {latest:g}"
        )
    return abs(latest) * pace


@arguments_checked
def rigorous_state(solution: TorusMotion, time: NumberOrText, digits: int) -> tuple[arb, ...]:
    """The lifted state of a motion at one time as balls that contain the exact state.

    Parameters
    ----------
    solution : TorusMotion
    time : float, int, str, Fraction or arb
    digits : int
        Requested decimal places; the radii of the balls give the accuracy attained.

    Returns
    -------
    tuple of arb

    Raises
    ------
    InputError
        See :func:`rigorous_motion`.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.closed_form.rigorous import rigorous_state
    >>> veselova = nonholonomic.from_catalogue("veselova")
    >>> motion = nonholonomic.solve(veselova, nonholonomic.CATALOGUE["veselova"].start.values)
    >>> all(ball.rad() < 1e-12 for ball in rigorous_state(motion, 1.0, 12))
    True
    """
    steps = ceil(log10(max(_turns(solution, time), 1.0)) / _DECADES)
    return _prepared_motion(solution, digits, _DECADES * max(1, steps)).state(time)


@lru_cache(maxsize=4)
def _prepared_motion(solution: TorusMotion, digits: int, decades: int) -> RigorousMotion:
    """A motion prepared for turns up to a power of ten; the most recent ones are cached."""
    return rigorous_motion(solution, digits, 10**decades / solution.phase_rate)
