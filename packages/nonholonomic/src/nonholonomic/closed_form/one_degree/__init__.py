"""Motions x′² = N(x)/B(x) at any time, with further quadratures along them.

The roots of N on either side determine the motion: it oscillates between two simple roots, rests at
a double root, or approaches double roots asymptotically.  In the phase σ of its uniformisation the
time t(σ) and every quadrature q(σ), q′ = g(x, x′), are integrals of analytic functions, and a whole
period adds a constant to each.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Generic

import numpy as np
from flint import acb, arb, ctx

from flowlanes.arguments import arguments_checked
from flowlanes.formulas.relative_zero import vanishes
from flowlanes.system.arrays import FloatArray

from .chebyshev_integrals import Integrals, Table, integrals, working_bits
from .divided_differences import slope, value
from .functions import BALLS, Count, Functions, T
from .inverse import enclosed_root
from .phase_reduction import pair, reduced_phase
from .turning_points import End, next_turning_point
from .uniformisation import Asymptotic, Equation, Heteroclinic, Oscillating, Uniformisation

__all__ = ["FAST", "Equilibrium", "MotionSample", "QuadratureMotion", "motion_chart"]

#: Digits used for the double-precision evaluator, and for printed constants.
FAST = 19

#: Maps (x, x′) to rates of the quadratures.
Rates = Callable[[acb, acb], Sequence[acb]]
#: Maps (chart, σ, derivatives of t and of the quadratures by σ, their values) to those of further
#: ones.
NestedRates = Callable[[Uniformisation, acb, Sequence[acb], Sequence[acb]], Sequence[acb]]


@dataclass(frozen=True)
class Equilibrium:
    """A motion that rests at a double root, such as a permanent rotation.

    Attributes
    ----------
    equation : Equation
    x : flint.arb
    """

    equation: Equation
    x: arb

    @cached_property
    def rigidity(self) -> arb:
        """−½(N/B)″, the squared frequency of small oscillations."""
        x = self.x
        bend = slope(self.equation.numerator, x, x, x).real
        return -bend / value(self.equation.denominator, x).real

    @property
    def stable(self) -> bool | None:
        """Whether nearby motions stay near; None if the second derivative does not decide it."""
        if self.rigidity > 0:
            return True
        return False if self.rigidity < 0 else None

    def description(self, name: str) -> str:
        """The name of the motion with its stability."""
        if self.stable is None:
            return f"{name}, on the border of stability"
        return f"{name}, {'stable' if self.stable else 'unstable'}"


@arguments_checked
def motion_chart(equation: Equation, x: arb, rate: arb) -> Uniformisation | Equilibrium:
    """The uniformisation of the motion through x with the rate x′, or the equilibrium there.

    Parameters
    ----------
    equation : Equation
        Satisfied by the start.
    x, rate : arb

    Returns
    -------
    Uniformisation or Equilibrium

    Raises
    ------
    InputError
        If the motion leaves the domain, or roots are too close together to be separated.
    """
    inner = equation.inner or equation.numerator
    edges = (equation.low, equation.high)
    size = abs(slope(inner, x, x).real) + abs(slope(inner, x, x, x).real)
    at_edge = [
        closed and vanishes(x - edge, arb(1))
        for edge, closed in zip(edges, equation.closed, strict=True)
    ]
    still = vanishes(value(inner, x).real, size)
    drift = slope(inner, x, x).real
    if still and (any(at_edge) or vanishes(drift, size)):
        return Equilibrium(equation, x)
    ends = []
    for edge, sign, begins, closed in zip(edges, (-1, 1), at_edge, equation.closed, strict=True):
        if begins:
            ends.append(End(edge, edge=True))
        elif still and drift * sign < 0:
            ends.append(End(x))
        else:
            end = next_turning_point(inner, x, edge, leaving=still, closed=closed)
            ends.append(end or End(edge, edge=True))
    left, right = ends
    if left.double and right.double:
        return Heteroclinic(equation, *((left, right) if rate > 0 else (right, left)))
    if left.double:
        return Asymptotic(equation, right, left)
    return (Asymptotic if right.double else Oscillating)(equation, left, right)


@dataclass(frozen=True)
class MotionSample(Generic[T, Count]):
    """The phase and the quadratures of a motion at one time (balls) or many (arrays).

    Attributes
    ----------
    periods : int or array
        Whole periods since the turning point σ = 0 before or after the start.
    phase : arb or array
        σ, between −π and π for a periodic motion.
    tail : arb or array
        Time spent in the tail of an asymptotic motion, where x equals its limit up to rounding;
        negative in the tail of the past.
    values : tuple of arb or arrays
        Every quadrature between σ = 0 and `phase`, not counting the tail.
    rate : arb or array
        dσ/dt.
    """

    periods: Count
    phase: T
    tail: T
    values: tuple[T, ...]
    rate: T


@dataclass(frozen=True)
class QuadratureMotion:
    """A motion x(t) with its quadratures.

    Attributes
    ----------
    chart : Uniformisation
    x, rate : flint.arb
        x and x′ at time 0.
    rates : callable
        (x, x′) ↦ rates q′ of the quadratures, in complex balls.
    nested : callable, optional
        (chart, σ, derivatives of t and of the quadratures by σ, their values) ↦ the derivatives by
        σ of further quadratures.
    parities : tuple of 1 and −1
        Of the time (odd) and all quadratures as functions of σ, if they have one.
    units : tuple of float
        Of all quadratures, the nested ones included: 1 for angles, a length of the body for the
        path.
    """

    chart: Uniformisation
    x: arb
    rate: arb
    rates: Rates
    nested: NestedRates | None = None
    parities: tuple[int, ...] = ()
    units: tuple[float, ...] = (1.0,)

    # --- quadratures -----------------------------------------------------------------------

    @property
    def periodic(self) -> bool:
        """Whether the motion oscillates between two turning points."""
        return isinstance(self.chart, Oscillating)

    def integrals(self, digits: int) -> Integrals:
        """The time (first), the quadratures and the nested ones, as functions of σ."""
        if digits not in self._by_digits:
            self._by_digits[digits] = self._build(digits)
        return self._by_digits[digits]

    @cached_property
    def _by_digits(self) -> dict[int, Integrals]:
        return {}

    @cached_property
    def time_scale(self) -> float:
        """The time in which σ grows by one, at the turning point."""
        return float(abs(self.chart.clock(acb(0)).real).mid())

    def horizon(self, digits: int) -> arb:
        """Limit of integration in σ: half a period, or the beginning of the tail."""
        return arb.pi() if self.periodic else arb(digits) * arb("1.152") + 3

    @property
    def start_phase(self) -> arb:
        """σ at time 0."""
        return self.chart.phase(self.x, self.rate)

    @property
    def start(self) -> MotionSample[arb, int]:
        """The motion at time 0, without its quadratures."""
        sigma = self.start_phase
        return MotionSample(0, sigma, arb(0), (), 1 / self.chart.clock(acb(sigma)).real)

    @property
    def passed_edges(self) -> tuple[bool, bool]:
        """Whether every period passes through the lower and the upper edge of the domain."""
        return self.periodic and self.chart.first.edge, self.periodic and self.chart.second.edge

    def _forms(self, sigma: acb) -> list[acb]:
        clock = self.chart.clock(sigma)
        x = self.chart.coordinate(BALLS, sigma)
        rates = self.rates(x, self.chart.slope(BALLS, sigma) / clock)
        return [clock, *(clock * rate for rate in rates)]

    def _build(self, digits: int) -> Integrals:
        """Compute the integrals."""
        nested = self.nested and partial(self.nested, self.chart)
        with ctx.workprec(working_bits(digits)):
            end = self.horizon(digits)
            units = (self.time_scale, *self.units)
            return integrals(self._forms, -end, end, digits, units, nested, self.parities)

    def advances(self, digits: int) -> tuple[arb, ...]:
        """The period of a periodic motion, and the gain of every quadrature in it."""
        with ctx.workprec(working_bits(digits)):
            known = self.integrals(digits)
            return tuple(known.right_end(i) - known.left_end(i) for i in range(known.count))

    def limits(self, digits: int, end: End) -> tuple[arb, ...]:
        """Rates of the quadratures in the tail of an asymptotic motion at a double root."""
        last = acb(self.horizon(digits))
        distance = abs(self.chart.coordinate(BALLS, last.real) - end.x)
        speed = abs(self.chart.slope(BALLS, last.real) / self.chart.clock(last).real)
        x = acb(arb(end.x.mid(), (distance + end.x.rad()).upper()))
        return tuple(rate.real for rate in self.rates(x, acb(arb(0, 2 * speed.upper()))))

    @property
    def tails(self) -> tuple[End, End]:
        """The double roots approached in the past and in the future."""
        past = self.chart.first if isinstance(self.chart, Heteroclinic) else self.chart.second
        return past, self.chart.second

    def end_of_tail(self, *, future: bool) -> End:
        """The double root approached in the past, or in the future."""
        return self.tails[1 if future else 0]

    # --- coordinates -----------------------------------------------------------------------

    def point(self, F: Functions[T], sample: MotionSample[T, Count]) -> tuple[T, T]:
        """x and x′."""
        x = self.chart.coordinate(F, sample.phase)
        return x, self.chart.slope(F, sample.phase) * sample.rate

    def half_angles(self, F: Functions[T], sample: MotionSample[T, Count]) -> tuple[T, T, T]:
        """sin θ/2, cos θ/2 and θ′ for x = cos θ in [−1, 1], continued through both poles."""
        low, high = self.chart.roots(F, sample.phase)
        rate = -self.chart.arc_slope(F, sample.phase) * sample.rate
        if isinstance(sample.tail, arb) and sample.tail != 0:
            end = self.end_of_tail(future=sample.tail > 0)
            low = low.union((1 + end.x).sqrt() * low.sgn())
            high = high.union((1 - end.x).sqrt() * high.sgn())
            rate = rate.union(arb(0))
        root = F.number(arb(2).sqrt())
        sine, cosine = high / root, low / root
        below, above = self.passed_edges
        if above:
            sine, rate = (F.alternating(sample.periods, x) for x in (sine, rate))
        if below:
            cosine, rate = (F.alternating(sample.periods, x) for x in (cosine, rate))
        return sine, cosine, rate

    # --- in balls --------------------------------------------------------------------------

    def sample(self, time: arb, digits: int) -> MotionSample[arb, int]:
        """The motion at one time, in balls.

        The working precision must be that of :func:`working_bits` for `digits`.
        """
        known = self.integrals(digits)
        moment = time + known.value(0, self.start_phase)
        periods, tail = 0, arb(0)
        if self.periodic:
            period = self.advances(digits)[0]
            periods = int((moment / period + arb("0.5")).mid().floor().fmpz())
            moment = moment - periods * period
            phase = self._phase(known, moment)
        else:
            phase = known.panels[-1].high if moment > 0 else known.panels[0].low
            limit = known.value(0, phase)
            if abs(moment) > abs(limit):
                tail = moment - limit
            else:
                phase = self._phase(known, moment)
        values = tuple(known.value(i, phase) for i in range(1, known.count))
        return MotionSample(periods, phase, tail, values, 1 / self.chart.clock(acb(phase)).real)

    def _phase(self, integrals: Integrals, moment: arb) -> arb:
        """σ with t(σ) = moment."""
        return enclosed_root(
            lambda sigma: integrals.value(0, sigma) - moment,
            lambda sigma: self.chart.clock(acb(sigma)).real,
            self.fast.phase(moment),
        )

    # --- in double precision ---------------------------------------------------------------

    @cached_property
    def fast(self) -> FastMotion:
        """The evaluator in double precision."""
        with ctx.workprec(working_bits(FAST)):
            return FastMotion(self)


class FastMotion:
    """A motion in double precision, at many times at once."""

    def __init__(self, motion: QuadratureMotion) -> None:
        known = motion.integrals(FAST)
        self._table: Table = known.table()
        self._count = known.count
        self._offset = pair(known.value(0, motion.start_phase))
        self._period = pair(motion.advances(FAST)[0]) if motion.periodic else None

    def phase(self, moment: arb) -> float:
        """σ at one time, measured from σ = 0."""
        points = self._table.inverse(np.array([float(moment.mid())]))
        return float(self._table.phase(points)[0])

    def sample(self, times: FloatArray) -> MotionSample[FloatArray, FloatArray]:
        """The motion at `times` (n,)."""
        tail = np.zeros_like(times)
        if self._period is not None:
            periods, moments = reduced_phase(times, self._offset, self._period)
        else:
            periods, moments = tail, times + self._offset[0]
            inside = np.clip(moments, *self._table.span)
            tail, moments = moments - inside, inside
        points = self._table.inverse(moments)
        values = tuple(self._table.value(i, points) for i in range(1, self._count))
        rate = 1 / self._table.rate(points)
        return MotionSample(periods, self._table.phase(points) + tail * rate, tail, values, rate)
