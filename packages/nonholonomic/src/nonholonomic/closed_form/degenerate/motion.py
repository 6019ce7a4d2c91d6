"""Motions on a degenerate curve: states at any time in double precision."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import arb, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.formulas.balls import Values, components
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System

from ...mechanics.rolling.attitude import attitude, place_rates
from ..base.solution import finite_times
from ..genus_two.attitude import Triad
from ..genus_two.separated_motion import on_arrays, on_balls
from ..genus_two.separation import SeparatedSystem
from ..one_degree.functions import BALLS, DOUBLES
from .exact_start import ExactStart
from .quadratures import AsymptoticQuadratures, Quadratures, quadratures_along
from .quaternion_sign import Signs, continuous_signs
from .theta_motion import Asymptotic, Pair, Periodic, direction

#: ν or ν′.
Arrays: TypeAlias = Sequence[FloatArray]
#: Maps ν and ν′, and further arrays, to the values (m, n) of formulas.
ArrayFunction: TypeAlias = Callable[..., FloatArray]

#: Precision in bits of the gain of the clock in a period, and its tolerance.
BITS = 160
MISS = arb(2) ** (-125)


@dataclass(frozen=True, repr=False)
class DegenerateMotion:
    """A motion on a curve of genus two that has a double root, in double precision.

    Attributes
    ----------
    system : System
        Lifted to space if it has a motion there.
    parameters : mapping of Symbol to number
    start : tuple of numbers
        The state at t = 0, as given.
    separable : SeparatedSystem
    exact : ExactStart
    motion : Periodic or Asymptotic
    e : arb
        The double root.
    """

    system: System
    parameters: Mapping[sp.Symbol, arb]
    start: tuple[NumberOrText, ...]
    separable: SeparatedSystem
    exact: ExactStart
    motion: Periodic | Asymptotic
    e: arb

    # --- functions of ν and ν′ ---------------------------------------------------------------

    @property
    def values(self) -> Values:
        """Parameters and constants in balls."""
        return self.exact.values

    @cached_property
    def _state(self) -> ArrayFunction:
        return on_arrays(self, self.separable.system.symbols)

    @cached_property
    def _fixed_vectors(self) -> ArrayFunction:
        return on_arrays(self, [c for vector in self.separable.fixed for c in components(vector)])

    @property
    def in_space(self) -> bool:
        """Whether the states include the motion in space."""
        return len(self.system.symbols) > len(self.separable.system.symbols)

    @cached_property
    def _integrands(self) -> ArrayFunction:
        """The rate of the clock, then the velocity in space, all with respect to τ."""
        clock = on_arrays(self, components(self.separable.time_rescaling))
        rates = place_rates(self.separable.system)
        if not (rates and self.in_space):
            return clock
        velocity = on_arrays(self, rates, attitude.symbols)

        def integrands(nu: Arrays, nuprime: Arrays) -> FloatArray:
            rate = clock(nu, nuprime)
            turns = self._attitude(nu, nuprime).T
            return np.concatenate([rate, rate * velocity(nu, nuprime, *turns)])

        return integrands

    # --- set-up ------------------------------------------------------------------------------

    @cached_property
    def triad(self) -> Triad:
        """The triad of the two vectors that are fixed in space."""
        six = self._fixed_vectors(*self._directions(np.zeros(1), np.zeros(1)))
        size = len(self.separable.system.symbols)
        quaternion = [float(x) for x in self.start[size : size + 4]]
        return Triad.through(six[:3, 0], six[3:, 0], quaternion)

    def _attitude(self, nu: Arrays, nuprime: Arrays) -> FloatArray:
        six = self._fixed_vectors(nu, nuprime)
        turns: FloatArray = self.triad.attitude(six[:3], six[3:])
        return turns

    def _directions(self, tau: FloatArray, turns: FloatArray) -> Pair[FloatArray]:
        return direction(DOUBLES, *self.motion.doubles(tau, turns))

    @cached_property
    def turn(self) -> arb:
        """The gain of the clock in a period, of the motion or of its limits.

        By the trapezoidal rule, whose error decreases exponentially: the number of points is
        doubled until the result no longer changes.
        """
        motion = self.motion
        clock = on_balls(self, components(self.separable.time_rescaling))
        with ctx.workprec(BITS):
            periodic = motion.limit(1) if isinstance(motion, Asymptotic) else motion
            period = periodic.period

            def total(numbers: range, count: int) -> arb:
                points = (arb(k) / count * period for k in numbers)
                return sum((clock(*directions(tau))[0] for tau in points), arb(0))

            def directions(tau: arb) -> list[arb]:
                # Use exact midpoints: python-flint has no even powers of balls that contain zero.
                nu, nuprime = direction(BALLS, *periodic.balls(tau))
                return [x.mid() for x in (*nu, *nuprime)]

            count = 16
            last = total(range(count), count)
            while True:
                doubled = last + total(range(1, 2 * count, 2), 2 * count)
                change = abs((doubled / 2 - last).mid())
                last, count = doubled, 2 * count
                if change < MISS * last or count > 1 << 13:
                    return last * period / count

    @cached_property
    def clock(self) -> Quadratures:
        """t as a function of τ and its inverse, and the quadratures of the position."""
        with ctx.workprec(BITS):
            return quadratures_along(self.motion, self._integrands, self.turn)

    @cached_property
    def _signs(self) -> Signs:
        size = len(self.separable.system.symbols)
        first = np.array([float(x) for x in self.start[size : size + 4]])

        def attitude_at(tau: FloatArray) -> FloatArray:
            return self._attitude(*self._directions(tau, np.zeros_like(tau)))

        clock = self.clock
        edges = clock.edges if isinstance(clock, AsymptoticQuadratures) else np.zeros(1)
        return continuous_signs(
            attitude_at, float(edges[0]), float(edges[-1]), float(self.motion.period), first
        )

    # --- answers -----------------------------------------------------------------------------

    @property
    def phase_rate(self) -> float:
        """Periods per unit of time."""
        return 1 / float(self.turn.mid())

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """Lifted states (n, size) at `times` (n,), in double precision."""
        moment = self.clock.moment(finite_times(times))
        nu, nuprime = self._directions(moment.remainder, moment.turns)
        reduced = self._state(nu, nuprime)
        if not self.in_space:
            return reduced.T
        turns = self._signs.continuous(moment.remainder, moment.turns, self._attitude(nu, nuprime))
        first = len(self.separable.system.symbols) + 4
        origin = np.array([float(x) for x in self.start[first:]])
        return np.concatenate([reduced, turns.T, moment.integrals + origin[:, None]]).T
