"""Motions on a degenerate curve in closed form: states at any time."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from flint import arb, ctx

from ...arguments import Numbers, Written, arguments_checked
from ...core.system import System, flat_pairs
from ...formulas.balls import array_function, ball_function, components, number
from ...mechanics.rolling.attitude import attitude
from ..base.solution import ClosedForm, Solution
from ..genus_two.attitude import Triad
from ..genus_two.separated_motion import chain
from ..genus_two.separation import SeparatedSystem
from .closed_form import form_of
from .exact_start import Beginning
from .quadratures import Moment, Quadratures, Window, along
from .quaternion_sign import Signs, signs
from .theta_motion import Asymptotic, Periodic, direction, direction_array

__all__ = ["DegenerateSolution"]

#: Bits in which the gain of the clock in a period is computed, and what it may miss.
BITS = 160
MISS = arb(2) ** (-125)


@dataclass(frozen=True, repr=False)
class DegenerateSolution(Solution):
    """A motion on a curve of genus two that has a double root.

    Attributes
    ----------
    system : System
        Lifted to space where it has a motion.
    parameters : mapping of Symbol to number
    start : tuple of numbers
        The state at t = 0, as given.
    separable : Separable
    beginning : Beginning
    motion : Periodic or Asymptotic
    e : arb
        The double root.
    """

    system: System
    parameters: Mapping[sp.Symbol, Any]
    start: tuple[Any, ...]
    separable: SeparatedSystem
    beginning: Beginning
    motion: Periodic | Asymptotic
    e: Any

    # --- functions of ν and ν′ ---------------------------------------------------------------

    def _arrays(
        self, formulas: Sequence[Any], further: Sequence[sp.Symbol] = ()
    ) -> Callable[..., Any]:
        """Formulas of the system as a function of ν, ν′ (3, n) and `further` arrays."""
        arguments, steps = chain(self.separable, formulas)
        made = array_function((*arguments, *further), tuple(formulas), steps)
        fixed = [number(self.beginning.values[s]) for s in arguments[6:]]

        def function(nu: Any, nuprime: Any, *others: Any) -> Any:
            found = made(*nu, *nuprime, *fixed, *others)
            return np.stack([np.broadcast_to(x, nu[0].shape) for x in found])

        return function

    @cached_property
    def _state(self) -> Callable[..., Any]:
        return self._arrays(self.separable.system.symbols)

    @cached_property
    def _fixed(self) -> Callable[..., Any]:
        return self._arrays([c for vector in self.separable.fixed for c in components(vector)])

    @property
    def lifted(self) -> bool:
        """Whether the motion in space is part of the states."""
        return len(self.system.symbols) > len(self.separable.system.symbols)

    @cached_property
    def _integrands(self) -> Callable[[Any, Any], Any]:
        """The clock's rate, then the rates of the places in space, all in τ."""
        clock = self._arrays(components(self.separable.clock))
        motion = self.separable.system.motion
        if motion is None or not self.lifted:
            return clock
        pairs = flat_pairs(motion.field)
        rates = [formula for name, formula in pairs if name not in attitude.symbols]
        if not rates:
            return clock
        places = self._arrays(rates, attitude.symbols)

        def integrands(nu: Any, nuprime: Any) -> Any:
            rate = clock(nu, nuprime)
            turns = self._attitude(nu, nuprime).T
            return np.concatenate([rate, rate * places(nu, nuprime, *turns)])

        return integrands

    # --- set-up ------------------------------------------------------------------------------

    @cached_property
    def triad(self) -> Triad:
        """The triad of the two vectors that are fixed in space."""
        six = self._fixed(*self._directions(np.zeros(1), np.zeros(1)))
        place = len(self.separable.system.symbols)
        quaternion = [float(x) for x in self.start[place : place + 4]]
        return Triad.through(six[:3, 0], six[3:, 0], quaternion)

    def _attitude(self, nu: Any, nuprime: Any) -> Any:
        six = self._fixed(nu, nuprime)
        return self.triad.attitude(six[:3], six[3:])

    def _directions(self, tau: Any, turns: Any) -> tuple[Any, Any]:
        return direction_array(*self.motion.array(tau, turns))

    @cached_property
    def turn(self) -> Any:
        """What the clock gains in a period, of the motion or of its limits.

        By the trapezoid rule, whose error falls off exponentially: the number of points is
        doubled until it does not change any more.
        """
        motion = self.motion
        arguments, steps = chain(self.separable, components(self.separable.clock))
        made = ball_function(arguments, components(self.separable.clock), steps)
        fixed = [self.beginning.values[s] for s in arguments[6:]]
        with ctx.workprec(BITS):
            periodic = motion.limit(1) if isinstance(motion, Asymptotic) else motion
            period = periodic.period

            def total(places: range, count: int) -> Any:
                points = (arb(k) / count * period for k in places)
                return sum((made(*at(tau), *fixed)[0] for tau in points), arb(0))

            def at(tau: Any) -> list[Any]:
                # exact numbers: a ball around zero has no even power in python-flint
                return [x.mid() for vector in direction(*periodic.at(tau)) for x in vector]

            count = 16
            found = total(range(count), count)
            while True:
                more = found + total(range(1, 2 * count, 2), 2 * count)
                change = abs((more / 2 - found).mid())
                found, count = more, 2 * count
                if change < MISS * found or count > 1 << 13:
                    return found * period / count

    @cached_property
    def clock(self) -> Quadratures | Window:
        """t as a function of τ and back, and the quadratures of the places."""
        with ctx.workprec(BITS):
            return along(self.motion, self._integrands, self.turn)

    @cached_property
    def _signs(self) -> Signs:
        place = len(self.separable.system.symbols)
        first = np.array([float(x) for x in self.start[place : place + 4]])

        def turned(tau: Any) -> Any:
            return self._attitude(*self._directions(tau, np.zeros_like(tau)))

        edges = self.clock.edges if isinstance(self.clock, Window) else np.zeros(1)
        return signs(turned, float(edges[0]), float(edges[-1]), float(self.motion.period), first)

    # --- answers -----------------------------------------------------------------------------

    @property
    def pace(self) -> float:
        """Periods in a unit of time."""
        return 1 / float(self.turn.mid())

    @arguments_checked
    def states(self, times: Numbers) -> Any:
        """Lifted states (n, size) at `times` (n,), in double precision."""
        moment: Moment = self.clock.when(np.asarray(times, dtype=float))
        nu, nuprime = self._directions(moment.rest, moment.turns)
        reduced = self._state(nu, nuprime)
        if not self.lifted:
            return reduced.T
        turns = self._signs.signed(moment.rest, moment.turns, self._attitude(nu, nuprime))
        first = len(self.separable.system.symbols) + 4
        origin = np.array([float(x) for x in self.start[first:]])
        return np.concatenate([reduced, turns.T, moment.integrals + origin[:, None]]).T

    @arguments_checked
    def rigorous(self, time: Written, digits: int = 30) -> tuple[Any, ...]:
        """The lifted state at one time as balls."""
        from .rigorous import rigorous_state

        return rigorous_state(self, time, digits)

    @cached_property
    def form(self) -> ClosedForm:
        """The curve, its double root, the frequencies."""
        return form_of(self.separable, self.beginning, self.motion, self.e, self.turn)
