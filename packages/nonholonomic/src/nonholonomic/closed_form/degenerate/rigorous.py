"""States of a degenerate motion in balls, with proven bounds of all errors.

The clock and the position are integrated in the phase σ = |dU/dτ| τ: over one period of a periodic
motion, or over the required part of the window outside which an asymptotic motion agrees with its
limits to the requested digits.  Beyond it the numerators are those of the limit with balls for the
remaining difference, so one period of them bounds every later period.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
import sympy as sp
from flint import acb, arb, ctx

from flowlanes.arguments import NumberOrText
from flowlanes.formulas.balls import ball, components
from flowlanes.system.tuple_vectors import cross, dot

from ...mechanics.rolling.attitude import place_rates
from ..genus_two.separated_motion import steps_from_torus
from ..one_degree.chebyshev_integrals import Integrals, integrals, working_bits
from ..one_degree.functions import BALLS, B
from ..one_degree.inverse import enclosed_root
from ..one_degree.vectors import product, quaternion_near
from ..one_degree.working_precision import exact_time, working_digits
from .analytic_formula import analytic, root, triad, velocity
from .motion import DegenerateMotion
from .theta_motion import Asymptotic, direction

#: Maps σ to N and N′ in complex balls.
Numerators: TypeAlias = Callable[[acb], tuple[list[acb], list[acb]]]
#: Distance in σ to which boxes extend from a panel on which functions are bounded.
REACH = 4
#: Balls smaller than this count as points; larger ones are boxes, where only bounds are needed.
POINTLIKE, BOX_BITS = 1e-6, 64
#: Boxes smaller than this are not divided further.
SMALLEST = 0.02
#: Number of points of a period at which the integrands are compared.
POINTS = 8


def rigorous_state(solution: DegenerateMotion, time: NumberOrText, digits: int) -> tuple[arb, ...]:
    """The lifted state at one time as balls that contain the exact state.

    Parameters
    ----------
    solution : DegenerateMotion
    time : float, int, str, Fraction or arb
    digits : int

    Raises
    ------
    InputError
        If more digits are needed than the start is carried with.
    """
    moment = exact_time(time)
    work = working_digits(time, digits, 1, solution.phase_rate)
    with ctx.workprec(working_bits(work)):
        return Rigorous(solution, work).state(moment)


@dataclass(frozen=True)
class Tail:
    """All periods beyond one end of the window.

    Attributes
    ----------
    edge : arb
        σ where they begin.
    integrals : Integrals
        Over one period from there, outwards; what it encloses holds for every period.
    side : int
        1 after the window, −1 before it.
    """

    edge: arb
    integrals: Integrals
    side: int

    def value(self, index: int, sigma: arb) -> arb:
        """An integral from the edge to a σ beyond it."""
        turns = self.turns(sigma)
        remainder = sigma - self.edge - turns * 2 * arb.pi()
        whole = self.integrals.value(index, self.side * 2 * arb.pi())
        return abs(turns) * whole + self.integrals.value(index, remainder)

    def turns(self, sigma: arb) -> int:
        """Whole periods from the edge to σ, with the sign of the side."""
        return self.side * int(abs(float((sigma - self.edge).mid())) / (2 * np.pi))


@dataclass(frozen=True)
class Rigorous:
    """A degenerate motion with proven bounds.

    Attributes
    ----------
    solution : DegenerateMotion
    digits : int
    """

    solution: DegenerateMotion
    digits: int

    # --- formulas --------------------------------------------------------------------------

    def _function(self, formulas: Sequence[sp.Expr]) -> Callable[..., list[Any]]:
        """Formulas of the system as a function of ν and ν′."""
        arguments, steps = steps_from_torus(self.solution.separable, formulas)
        function = analytic(arguments, formulas, steps)
        constants = [self.solution.exact.values[s] for s in arguments[6:]]
        return lambda nu, nuprime: function(*nu, *nuprime, *constants)

    @cached_property
    def _reduced_state(self) -> Callable[..., list[Any]]:
        return self._function(self.solution.separable.system.symbols)

    @cached_property
    def _rates(self) -> Callable[..., list[Any]]:
        """The clock, then the velocity in body axes."""
        clock = components(self.solution.separable.time_rescaling)
        rates = place_rates(self.solution.separable.system)
        return self._function([*clock, *(velocity(rates) if self.solution.in_space else ())])

    @cached_property
    def _triad(self) -> Callable[..., list[list[Any]]]:
        vectors = self._function(
            [c for vector in self.solution.separable.fixed for c in components(vector)]
        )

        six = vectors(self.solution.exact.nu, self.solution.exact.nuprime)
        normal = cross(six[:3], six[3:])
        sizes = (root(dot(six[:3], six[:3])), root(dot(normal, normal)))

        def triad_at(nu: Sequence[B], nuprime: Sequence[B]) -> list[list[B]]:
            six = vectors(nu, nuprime)
            return triad(six[:3], six[3:], sizes)

        return triad_at

    @cached_property
    def _still_triad(self) -> list[list[arb]]:
        """The fixed triad in space axes."""
        start = self.solution.exact
        size = len(start.state)
        turn = [ball(x) for x in self.solution.start[size : size + 4]]
        length = sum((q * q for q in turn), arb(0)).sqrt()
        return [
            product([q / length for q in turn], v) for v in self._triad(start.nu, start.nuprime)
        ]

    # --- along the motion ------------------------------------------------------------------

    @property
    def _speed(self) -> arb:
        return abs(self.solution.motion.speed)

    def _integrands(self, numerators: Numerators) -> Callable[[acb], list[acb]]:
        """Derivatives of the clock and the position with respect to σ."""

        def rates(sigma: acb) -> list[acb]:
            size = max(float(sigma.real.rad()), float(sigma.imag.rad()))
            if size < POINTLIKE:
                return on_box(sigma)
            with ctx.workprec(BOX_BITS):
                return on_quarters(sigma, size)

        def on_quarters(sigma: acb, size: float) -> list[acb]:
            """Evaluate a box as the union over its quarters, which reduces overestimation."""
            values = on_box(sigma)
            if size < SMALLEST or all(f.is_finite() for f in values):
                return values
            quarters = [on_quarters(quarter, size / 2) for quarter in _quarters(sigma)]
            return [a.union(b).union(c).union(d) for a, b, c, d in zip(*quarters, strict=True)]

        def on_box(sigma: acb) -> list[acb]:
            nu, nuprime = direction(BALLS, *numerators(sigma))
            clock, *velocity = self._rates(nu, nuprime)
            values = [clock]
            if velocity:
                along = [dot(axis, velocity) for axis in self._triad(nu, nuprime)]
                values += [clock * dot(along, [k[i] for k in self._still_triad]) for i in (0, 1)]
            return [acb(f / self._speed) for f in values]

        return rates

    @cached_property
    def _units(self) -> tuple[float, ...]:
        """The rate of the clock, and the largest velocity, at some points of a period."""
        rates = self._integrands(self._numerators)
        seen = [rates(acb(2 * arb.pi() * k / POINTS)) for k in range(POINTS)]
        sizes = [[float(abs(f.real).mid()) for f in row] for row in seen]
        fastest = max((x for row in sizes for x in row[1:]), default=0.0) or 1.0
        return (max(row[0] for row in sizes), fastest, fastest)

    def _numerators(self, sigma: B) -> tuple[list[B], list[B]]:
        return self.solution.motion.balls(sigma / self._speed)

    @cached_property
    def _edges(self) -> tuple[arb, arb]:
        """σ at the ends of the interval of integration."""
        motion = self.solution.motion
        if not isinstance(motion, Asymptotic):
            return arb(0), 2 * arb.pi() + arb(2) ** -20
        # exp(−|κ|) is below 10^−digits from |κ| = digits · ln 10 on, with a reserve.
        faded = arb(self.digits) * arb(10).log() + 3
        ends = [(k * faded - motion.offset) / motion.growth * self._speed for k in (-1, 1)]
        return min(*ends, arb(-1), key=float).mid(), max(*ends, arb(1), key=float).mid()

    def _window(self, sigma: arb) -> Integrals:
        """The integrals at least from 0 to σ."""
        low, high = self._edges
        pieces = 4 * (1 + abs(int(float(sigma.mid()))) // 4)
        if sigma < 0:
            ends = (max(low, arb(-pieces), key=float), arb("0.5"))
        else:
            ends = (arb(0), min(high, arb(pieces), key=float))
        key = (float(ends[0]), float(ends[1]))
        if key not in self._windows:
            rates = self._integrands(self._numerators)
            self._windows[key] = integrals(rates, *ends, self.digits, self._units)
        return self._windows[key]

    @cached_property
    def _windows(self) -> dict[tuple[float, float], Integrals]:
        return {}

    def _tail(self, side: int) -> Tail:
        motion = self.solution.motion
        assert isinstance(motion, Asymptotic)
        edge = self._edges[0 if side < 0 else 1]
        kappa = motion.offset + motion.growth * edge / self._speed
        slack = abs(motion.growth) / self._speed * REACH * 2
        faint = (slack - abs(kappa)).exp().upper()
        after = bool(kappa > 0)

        def numerators(sigma: acb) -> tuple[list[acb], list[acb]]:
            if not abs(sigma.real - side * arb.pi()) < arb.pi() + 2 * REACH:
                return [acb("nan")] * 3, [acb("nan")] * 3
            doubt = arb(0, faint)
            small = acb(doubt * faint, doubt * faint)
            U = motion.phase + motion.speed * (edge + sigma) / self._speed
            down, up = (small, acb(1)) if after else (acb(1), small)
            return motion.combination(BALLS, U, down, up, acb(doubt, doubt))

        low, high = (arb(-7), arb("0.5")) if side < 0 else (arb(0), arb(7))
        rates = self._integrands(numerators)
        return Tail(edge, integrals(rates, low, high, self.digits, self._units), side)

    @cached_property
    def _tails(self) -> dict[int, Tail]:
        return {}

    def _tail_at(self, sigma: arb) -> Tail | None:
        """The tail that contains σ."""
        low, high = self._edges
        if not isinstance(self.solution.motion, Asymptotic) or low <= sigma <= high:
            return None
        side = 1 if sigma > high else -1
        if side not in self._tails:
            self._tails[side] = self._tail(side)
        return self._tails[side]

    def _total(self, index: int, sigma: arb) -> arb:
        """An integral from τ = 0 to σ."""
        tail = self._tail_at(sigma.mid())
        if tail is None:
            return self._window(sigma).value(index, sigma)
        return self._window(tail.edge).value(index, tail.edge) + tail.value(index, sigma)

    # --- answers ---------------------------------------------------------------------------

    def _phase(self, time: arb) -> tuple[arb, int]:
        """σ at a time, modulo whole periods of a periodic motion, and their number."""
        rough = self.solution.clock.moment(np.array([float(time.mid())]))
        turns = 0
        sigma = (arb(float(rough.remainder[0])) * self._speed).mid()
        if isinstance(self.solution.motion, Asymptotic):
            sigma = (sigma + 2 * arb.pi() * int(rough.turns[0])).mid()
        else:
            turns = int(rough.turns[0])
            time = time - turns * self._total(0, 2 * arb.pi())
        sigma = enclosed_root(lambda x: self._total(0, x) - time, self._rate, sigma)
        return sigma, turns

    def _rate(self, sigma: arb) -> arb:
        return self._integrands(self._numerators)(acb(sigma))[0].real

    def state(self, time: arb) -> tuple[arb, ...]:
        """The lifted state at a time (arb)."""
        sigma, turns = self._phase(time)
        nu, nuprime = direction(BALLS, *self._numerators(sigma))
        reduced = self._reduced_state(nu, nuprime)
        if not self.solution.in_space:
            return tuple(reduced)
        size = len(reduced)
        near = self.solution.states(np.array([float(time.mid())]))[0]
        axes = self._triad(nu, nuprime)
        rows = [
            [dot([k[i] for k in self._still_triad], [a[j] for a in axes]) for j in range(3)]
            for i in range(3)
        ]
        turn = quaternion_near(rows, near[size : size + 4])
        position = [
            ball(x) + self._total(index, sigma) + turns * self._total(index, 2 * arb.pi())
            if turns
            else ball(x) + self._total(index, sigma)
            for index, x in enumerate(self.solution.start[size + 4 :], 1)
        ]
        return (*reduced, *turn, *position)


def _quarters(box: acb) -> list[acb]:
    """Four boxes that cover a box."""
    halves = []
    for side in (box.real, box.imag):
        half = side.rad() / 2
        halves.append([arb(side.mid() - half, half), arb(side.mid() + half, half)])
    return [acb(x, y) for x in halves[0] for y in halves[1]]


def quaternion(rows: Sequence[Sequence[arb]], near: Sequence[float]) -> list[arb]:
    """The unit quaternion of a rotation matrix, with the sign closer to `near`.

    Parameters
    ----------
    rows : three rows of three arb
        Body to space.
    near : 4 floats
        Roughly the quaternion.
    """
    (a, b, c), (d, e, f), (g, h, i) = rows
    squares = [1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i]
    largest = max(range(4), key=lambda k: abs(near[k]))
    parts = [
        [squares[0], h - f, c - g, d - b],
        [h - f, squares[1], b + d, c + g],
        [c - g, b + d, squares[2], f + h],
        [d - b, c + g, f + h, squares[3]],
    ][largest]
    size = 2 * squares[largest].sqrt()
    sign = 1 if near[largest] > 0 else -1
    return [sign * part / size for part in parts]
