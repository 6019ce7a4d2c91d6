"""Motions x′² = N(x)/B(x) at any time, with further quadratures along them.

What the motion does is decided by the roots of N on either side of it: it swings between two simple
roots, rests at a double one, or approaches double roots for ever.  In the phase σ of its chart the
time t(σ) and every quadrature q(σ), q′ = g(x, x′), are integrals of analytic functions, and after a
whole period they are what they were, plus a constant.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import numpy as np
from flint import acb, arb, ctx

from ...formulas.relative_zero import vanishes
from .chebyshev_integrals import Integrals, Table, integrals, working_bits
from .divided_differences import slope, value
from .phase_reduction import pair, reduced
from .turning_points import End, next_end
from .uniformisation import BALLS, Asymptotic, Equation, Heteroclinic, Oscillating, Uniformisation

__all__ = ["Equilibrium", "MotionSample", "QuadratureMotion", "chart_of"]

#: Digits behind the evaluator in double precision.
FAST = 19

#: (x, x′) ↦ rates of the quadratures.
Rates = Callable[[Any, Any], Sequence[Any]]
#: (chart, σ, derivatives of t and of the quadratures by σ, their values) ↦ those of further ones.
Nested = Callable[[Uniformisation, Any, Sequence[Any], Sequence[Any]], Sequence[Any]]


@dataclass(frozen=True)
class Equilibrium:
    """A motion that rests at a double root, such as a permanent rotation.

    Attributes
    ----------
    equation : Equation
    place : flint.arb
    """

    equation: Equation
    place: Any

    @cached_property
    def rigidity(self) -> Any:
        """−½(N/B)″, the square of the frequency of small oscillations (arb)."""
        x = self.place
        bend = slope(self.equation.numerator, x, x, x).real
        return -bend / value(self.equation.denominator, x).real

    @property
    def stable(self) -> bool | None:
        """Whether nearby motions stay near; None where the second derivative does not tell."""
        if self.rigidity > 0:
            return True
        return False if self.rigidity < 0 else None


def chart_of(equation: Equation, x: Any, rate: Any) -> Uniformisation | Equilibrium:
    """What kind of motion passes through x with the rate x′.

    Parameters
    ----------
    equation : Equation
        Satisfied by the start.
    x, rate : arb

    Raises
    ------
    InputError
        If the motion leaves the domain, or roots are too close together to be told apart.
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
    for edge, sign, there, closed in zip(edges, (-1, 1), at_edge, equation.closed, strict=True):
        if there:
            ends.append(End(edge, edge=True))
        elif still and drift * sign < 0:
            ends.append(End(x))
        else:
            found = next_end(inner, x, edge, leaving=still, closed=closed)
            ends.append(found or End(edge, edge=True))
    left, right = ends
    if left.double and right.double:
        return Heteroclinic(equation, *((left, right) if rate > 0 else (right, left)))
    if left.double:
        return Asymptotic(equation, right, left)
    return (Asymptotic if right.double else Oscillating)(equation, left, right)


@dataclass(frozen=True)
class MotionSample:
    """Where a motion is, at some times.

    Attributes
    ----------
    periods : array or int
        Whole periods since the turning point σ = 0 before or after the start.
    phase : array or arb
        σ, between −π and π for a periodic motion.
    beyond : array or arb
        Time spent in the tail of an asymptotic motion, where it is at its end but for rounding;
        negative in the tail of the past.
    values : tuple of arrays or arb
        Every quadrature between σ = 0 and `phase`, not counting the tail.
    rate : array or arb
        dσ/dt.
    """

    periods: Any
    phase: Any
    beyond: Any
    values: tuple[Any, ...]
    rate: Any


@dataclass(frozen=True)
class QuadratureMotion:
    """A motion with its quadratures.

    Attributes
    ----------
    chart : Chart
    x, rate : flint.arb
        At time 0.
    rates : callable
        (x, x′) ↦ rates q′ of the quadratures, in complex balls.
    nested : callable, optional
        (chart, σ, derivatives of t and of the quadratures by σ, their values) ↦ the derivatives by
        σ of further quadratures.
    parities : tuple of 1 and −1
        Of the time (odd) and all quadratures as functions of σ, where they have one.
    units : tuple of float
        Of all quadratures, the nested ones included: 1 for angles, a length of the body for the
        path.
    """

    chart: Uniformisation
    x: Any
    rate: Any
    rates: Rates
    nested: Nested | None = None
    parities: tuple[int, ...] = ()
    units: tuple[float, ...] = (1.0,)

    # --- quadratures -----------------------------------------------------------------------

    @property
    def periodic(self) -> bool:
        """Whether the motion swings between two turning points."""
        return isinstance(self.chart, Oscillating)

    def integrals(self, digits: int) -> Integrals:
        """The time (first), the quadratures and the nested ones, by σ."""
        if digits not in self._known:
            self._known[digits] = self._build(digits)
        return self._known[digits]

    @cached_property
    def _known(self) -> dict[int, Integrals]:
        return {}

    @cached_property
    def moment(self) -> float:
        """The time in which σ grows by one, at the turning point."""
        return float(abs(self.chart.clock(acb(0)).real).mid())

    def horizon(self, digits: int) -> Any:
        """Where integrals end: at half a period, or where the tail begins."""
        return arb.pi() if self.periodic else arb(digits) * arb("1.152") + 3

    def _forms(self, sigma: Any) -> list[Any]:
        clock = self.chart.clock(sigma)
        x = self.chart.place(BALLS, sigma)
        rates = self.rates(x, self.chart.slope(BALLS, sigma) / clock)
        return [clock, *(clock * rate for rate in rates)]

    def _build(self, digits: int) -> Integrals:
        """The integrals, computed anew."""
        nested = self.nested and partial(self.nested, self.chart)
        with ctx.workprec(working_bits(digits)):
            end = self.horizon(digits)
            units = (self.moment, *self.units)
            return integrals(self._forms, -end, end, digits, units, nested, self.parities)

    def advances(self, digits: int) -> tuple[Any, ...]:
        """The period, and what every quadrature gains in it (arb); for a periodic motion."""
        with ctx.workprec(working_bits(digits)):
            known = self.integrals(digits)
            return tuple(
                known.end(i) - known.panels[0].value(i, known.panels[0].low)
                for i in range(len(known.panels[0].series))
            )

    def mean_rates(self, digits: int) -> tuple[Any, ...]:
        """Mean rates of the quadratures (arb): their linear drift."""
        period, *gains = self.advances(digits)
        return tuple(gain / period for gain in gains)

    def limits(self, digits: int, end: End) -> tuple[Any, ...]:
        """Rates of the quadratures in the tail of an asymptotic motion at a double root (arb)."""
        last = acb(self.horizon(digits))
        near = abs(self.chart.place(BALLS, last.real) - end.place)
        speed = abs(self.chart.slope(BALLS, last.real) / self.chart.clock(last).real)
        x = acb(arb(end.place.mid(), (near + end.place.rad()).upper()))
        return tuple(rate.real for rate in self.rates(x, acb(arb(0, 2 * speed.upper()))))

    @property
    def tails(self) -> tuple[End, End]:
        """The double roots approached in the past and in the future."""
        past = self.chart.first if isinstance(self.chart, Heteroclinic) else self.chart.second
        return past, self.chart.second

    # --- in balls --------------------------------------------------------------------------

    def place(self, time: Any, digits: int) -> MotionSample:
        """Where the motion is at one time (arb), in balls.

        The working precision must be that of :func:`working_bits` for `digits`.
        """
        known = self.integrals(digits)
        moment = time + known.value(0, self.chart.phase(self.x, self.rate))
        periods, beyond = 0, arb(0)
        if self.periodic:
            period = self.advances(digits)[0]
            periods = int((moment / period + arb("0.5")).mid().floor().unique_fmpz())
            moment = moment - periods * period
            phase = self._phase(known, moment)
        else:
            phase = known.panels[-1].high if moment > 0 else known.panels[0].low
            limit = known.value(0, phase)
            if abs(moment) > abs(limit):
                beyond = moment - limit
            else:
                phase = self._phase(known, moment)
        count = len(known.panels[0].series)
        values = tuple(known.value(i, phase) for i in range(1, count))
        return MotionSample(periods, phase, beyond, values, 1 / self.chart.clock(acb(phase)).real)

    def _phase(self, known: Integrals, moment: Any) -> Any:
        """σ with t(σ) = moment: Newton's method, then one step of it in intervals as a proof."""
        sigma = arb(self.fast.phase(moment))
        for _ in range(8):
            step = (known.value(0, sigma) - moment) / self.chart.clock(acb(sigma)).real
            sigma = (sigma - step).mid()
            if abs(step) < arb(2) ** (-ctx.prec // 2):
                break
        defect = moment - known.value(0, sigma)
        reach = 2 * abs(defect / self.chart.clock(acb(sigma)).real).upper()
        for _ in range(60):
            ball = arb(sigma, reach)
            image = sigma + defect / self.chart.clock(acb(ball)).real
            if image.is_finite() and ball.contains(image):
                return image
            reach = 2 * reach
        return arb(sigma, arb("inf"))

    # --- in double precision ---------------------------------------------------------------

    @cached_property
    def fast(self) -> Fast:
        """The evaluator in double precision."""
        with ctx.workprec(working_bits(FAST)):
            return Fast(self)


class Fast:
    """A course in double precision, for many times at once."""

    def __init__(self, course: QuadratureMotion) -> None:
        known = course.integrals(FAST)
        self._table: Table = known.table()
        self._count = len(known.panels[0].series)
        self._periodic = course.periodic
        self._offset = pair(known.value(0, course.chart.phase(course.x, course.rate)))
        if self._periodic:
            self._period = pair(course.advances(FAST)[0])

    def phase(self, moment: Any) -> float:
        """σ at one moment (arb) counted from σ = 0."""
        place = self._table.inverse(np.array([float(moment.mid())]))
        return float(self._table.phase(place)[0])

    def place(self, times: Any) -> MotionSample:
        """Where the motion is at `times` (n,)."""
        beyond = np.zeros_like(times)
        if self._periodic:
            periods, moments = reduced(times, self._offset, self._period)
        else:
            periods, moments = beyond, times + self._offset[0]
            inside = np.clip(moments, *self._table.span)
            beyond, moments = moments - inside, inside
        place = self._table.inverse(moments)
        values = tuple(self._table.value(i, place) for i in range(1, self._count))
        rate = 1 / self._table.rate(place)
        return MotionSample(periods, self._table.phase(place) + beyond * rate, beyond, values, rate)
