"""The Lagrange top at any time: the holonomic control of the quadratures of §5 (§4.1).

With u = Γ₃ = cos θ, s = M₃, c = (M, Γ) and the energy h,

    I₁ u̇² = (2(h − Pu) − s²/I₃)(1 − u²) − (c − su)²/I₁,
    φ̇ = (1/I₃ − 1/I₁)s + (s − cu)/(I₁(1 − u²)),

so that u is an elliptic function of the time, see :mod:`chaplygin.explicit.lagrange.elliptic`, and
M₁, M₂ follow from θ̇ and c − su.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from flint import acb, arb, ctx, fmpq

from ...arguments import Numbers, Written, arguments_checked
from ...catalogue.fixed_point.lagrange_top import I_1, I_3, P
from ...core.system import System
from ...errors import InputError
from ...formulas.relative_zero import GIVEN, vanishes
from ..base.problem import exact
from ..base.solution import ClosedForm, Solution
from ..one_degree import Equilibrium, QuadratureMotion, chart_of
from ..one_degree.chebyshev_integrals import working_bits
from ..one_degree.uniformisation import BALLS, DOUBLES, Uniformisation
from ..revolution import balls_of, needed
from ..revolution.angles import LinearPhase
from ..revolution.body import BITS
from .closed_form import form_of
from .top import Top

__all__ = ["LagrangeSolution", "recognised", "solve_top"]

#: Digits behind the fast evaluator.
FAST = 19


def recognised(system: System) -> bool:
    """Whether a System is the catalogue's Lagrange top in M and Γ."""
    return system.name == "lagrange-top"


def solve_top(
    system: System, start: Sequence[Any], parameters: Mapping[sp.Symbol, Any] | None = None
) -> Solution | None:
    """The motion of the Lagrange top, or None if the System is another one.

    Parameters
    ----------
    system : System
        Of the catalogue entry ``lagrange-top``.
    start : sequence of 6 numbers
        M and Γ at time 0, read to fifty digits.
    parameters : mapping of Symbol to number, optional
        Values that replace the system's defaults.

    Raises
    ------
    InputError
        If Γ is not a unit vector.
    """
    if not recognised(system):
        return None
    values = {**system.defaults, **(parameters or {})}
    if len(start) != len(system.symbols):
        raise InputError(f"start has {len(start)} numbers: {len(system.symbols)} are needed")
    with ctx.workprec(BITS):
        numbers = [_ball(x) for x in start]
        length = sum((x * x for x in numbers[3:]), arb(0)).sqrt()
        if not vanishes(length - 1, arb(1), GIVEN):
            raise InputError(
                f"start: |Gamma| is {float(length):.9g}, and must be 1, the length of the vertical"
            )
        momentum, vertical = numbers[:3], [x / length for x in numbers[3:]]
        top = _top([_ball(values[symbol]) for symbol in (I_1, I_3, P)], momentum, vertical)
        rate = (vertical[0] * momentum[1] - vertical[1] * momentum[0]) / top.across
        chart = chart_of(top.equation, vertical[2], rate)
        return LagrangeSolution(system, values, top, chart, (momentum, vertical, rate))


def _ball(number: Any) -> Any:
    value = exact(number)
    return arb(fmpq(value.numerator, value.denominator))


def _top(numbers: Sequence[Any], momentum: Sequence[Any], vertical: Sequence[Any]) -> Top:
    across, axial, weight = numbers
    first, second, s = momentum
    energy = (first * first + second * second) / (2 * across) + s * s / (2 * axial)
    c = sum((a * b for a, b in zip(momentum, vertical, strict=True)), arb(0))
    size = sum((abs(x) for x in momentum), arb(0))
    if vanishes(s, size) or size.is_zero():
        s = arb(0)
    down, up = (vanishes(c - value, size) or bool(size.is_zero()) for value in (-s, s))
    c = s if up else -s if down else c
    return Top(across, axial, weight, energy + weight * vertical[2], s, c, (down, up))


class LagrangeSolution(Solution):
    """A motion of the top.

    Attributes
    ----------
    top : Top
    chart : Chart or Steady
    """

    def __init__(
        self,
        system: System,
        parameters: Mapping[sp.Symbol, Any],
        top: Top,
        chart: Uniformisation | Equilibrium,
        begin: tuple[Sequence[Any], Sequence[Any], Any],
    ) -> None:
        self.system, self.parameters, self.top, self.chart = system, parameters, top, chart
        self._momentum, self._vertical, self._rate = begin

    @property
    def pace(self) -> float:
        """How fast the phase of u grows with time, or φ where u rests."""
        return (
            abs(float(self._spin))
            if isinstance(self.chart, Equilibrium)
            else 1 / self.course.moment
        )

    @cached_property
    def course(self) -> QuadratureMotion:
        """u with φ; not for a steady motion."""
        assert not isinstance(self.chart, Equilibrium)
        return QuadratureMotion(self.chart, self._vertical[2], self._rate, self.top.rates)

    @cached_property
    def form(self) -> ClosedForm:
        """What the closed form looks like."""
        with ctx.workprec(working_bits(FAST)):
            course = None if isinstance(self.chart, Equilibrium) else self.course
            return form_of(self.top, self.chart, course)

    @arguments_checked
    def rigorous(self, time: Written, digits: int = 30) -> tuple[Any, ...]:
        """The state at one time as balls that contain the exact one."""
        work = needed(time, digits, 1, self.pace)
        with ctx.workprec(working_bits(work)):
            moment = balls_of(time)
            if isinstance(self.chart, Equilibrium):
                return tuple(self._turned(BALLS, self._spin * moment))
            at = self.course.place(moment, work)
            low, high = self.chart.roots(BALLS, at.phase)
            lean = -self.chart.lean(BALLS, at.phase) * at.rate
            phi = self._phase(work) + at.values[0]
            if self.course.periodic:
                phi = phi + at.periods * self.course.advances(work)[1]
                flips = [-1 if at.periods % 2 and end else 1 for end in self._passes]
                low, high, lean = flips[0] * low, flips[1] * high, flips[0] * flips[1] * lean
            elif at.beyond != 0:
                end = self.course.tails[1 if at.beyond > 0 else 0]
                phi = phi + self.course.limits(work, end)[0] * at.beyond
                low = low.union((1 + end.place).sqrt() * low.sgn())
                high = high.union((1 - end.place).sqrt() * high.sgn())
                lean = lean.union(arb(0))
            return tuple(self._assembled(BALLS, (low, high), lean, phi))

    @arguments_checked
    def states(self, times: Numbers) -> Any:
        """States at `times` (n,), as an array (n, 6)."""
        moments = np.asarray(times, dtype=float)
        if isinstance(self.chart, Equilibrium):
            columns = self._turned(DOUBLES, LinearPhase.of(self._spin)(moments))
            return np.stack([column + 0 * moments for column in columns], axis=1)
        at = self.course.fast.place(moments)
        begin, advance, tails = self._fast
        phi = begin + at.values[0] + advance(at.periods)
        for side, tail in tails:
            phi = np.where(at.beyond * side > 0, tail(moments), phi)
        odd = at.periods % 2 != 0
        flips = [np.where(odd & end, -1.0, 1.0) for end in self._passes]
        low, high = self.chart.roots(DOUBLES, at.phase)
        lean = -self.chart.lean(DOUBLES, at.phase) * at.rate * flips[0] * flips[1]
        roots = (flips[0] * low, flips[1] * high)
        return np.stack(self._assembled(DOUBLES, roots, lean, phi), axis=1)

    # --- parts -----------------------------------------------------------------------------

    @property
    def _passes(self) -> tuple[bool, bool]:
        """Whether the axis passes the vertical in every period, pointing down and up."""
        assert not isinstance(self.chart, Equilibrium)
        periodic = self.course.periodic
        return periodic and self.chart.first.edge, periodic and self.chart.second.edge

    @property
    def _spin(self) -> Any:
        """φ̇ of a steady motion (arb)."""
        return self.top.rates(acb(self._vertical[2]), acb(0))[0].real

    def _phase(self, digits: int) -> Any:
        """φ at the turning point next to the start (arb)."""
        assert not isinstance(self.chart, Equilibrium)
        sigma = self.chart.phase(self._vertical[2], self._rate)
        low, high = self.chart.roots(BALLS, sigma)
        across, lean = low * high, -self.chart.lean(BALLS, sigma)
        if across > 0 or across < 0:
            phi = arb.atan2(self._vertical[0] / across, self._vertical[1] / across)
        else:
            phi = arb.atan2(-self._momentum[1] / lean, self._momentum[0] / lean)
        return phi - self.course.integrals(digits).value(1, sigma)

    @cached_property
    def _fast(self) -> tuple[float, LinearPhase, list[tuple[int, LinearPhase]]]:
        """φ at the turning point, its gain by periods, and φ in the tails by time."""
        course = self.course
        with ctx.workprec(working_bits(FAST)):
            begin = self._phase(FAST)
            if course.periodic:
                return float(begin), LinearPhase.of(course.advances(FAST)[1]), []
            known, tails = course.integrals(FAST), []
            start = known.value(0, course.chart.phase(course.x, course.rate))
            for side, end in zip((-1, 1), course.tails, strict=True):
                edge = known.panels[-1].high if side > 0 else known.panels[0].low
                rate = course.limits(FAST, end)[0]
                phi = begin + known.value(1, edge) - rate * (known.value(0, edge) - start)
                tails.append((side, LinearPhase.of(rate, phi)))
            return float(begin), LinearPhase.of(arb(0)), tails

    def _turned(self, F: Any, phi: Any) -> list[Any]:
        """The start of a steady motion turned about the axis by φ: x + iy goes against it."""
        sin, cos = F.sin(phi), F.cos(phi)
        numbers = [[F.number(x) for x in vector] for vector in (self._momentum, self._vertical)]
        return [
            part
            for x, y, z in numbers
            for part in (x * cos + y * sin, y * cos - x * sin, z + 0 * phi)
        ]

    def _assembled(self, F: Any, roots: tuple[Any, Any], lean: Any, phi: Any) -> list[Any]:
        """M and Γ from √(1 + u), √(1 − u), θ̇ and φ."""
        (low, high), top = roots, self.top
        across, u = low * high, (low * low - high * high) / 2
        s, c = F.number(top.s), F.number(top.c)
        down, up = top.upright
        if down and up:
            side = 0 * across
        elif up:
            side = s * high / low
        elif down:
            side = -s * low / high
        else:
            side = (c - s * u) / across
        along = F.number(top.across) * lean
        sin, cos = F.sin(phi), F.cos(phi)
        return [
            along * cos + side * sin,
            -along * sin + side * cos,
            s + 0 * u,
            across * sin,
            across * cos,
            u,
        ]
