"""The heavy rubber body of revolution at any time (§5).

θ(t) follows from (5.2); the angle of intrinsic rotation φ, the precession ψ = −∫ cos θ dφ and the
path on the plane are quadratures along it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from flint import acb, arb, ctx, fmpq

from ...arguments import Numbers, Written, arguments_checked
from ...core.system import System
from ...errors import InputError
from ...mechanics.rolling.equations import Rolling
from ..base.problem import exact
from ..base.solution import ClosedForm, Solution
from ..one_degree import Equilibrium, QuadratureMotion, chart_of
from ..one_degree.chebyshev_integrals import working_bits
from ..one_degree.uniformisation import BALLS, DOUBLES, Uniformisation
from .angles import LinearPhase, glide, glides, turned, walk
from .body import BITS, Level, body_of
from .closed_form import form_of, steady_form
from .double_precision import FastRevolution, StartFrame
from .state import (
    Begin,
    angles_of,
    assembled,
    begin_of,
    path_parities,
    path_rates,
    path_speed,
    turning_rates,
)

__all__ = ["RevolutionSolution", "SteadySolution", "recognised", "solve_rolling"]

#: Digits behind the numbers of a form and of the fast evaluator.
FAST = 19
MOST = 100


def recognised(rolling: Rolling, parameters: Mapping[sp.Symbol, Any]) -> bool:
    """Whether this is a rubber body of revolution on a plane, in a potential U(γ₃) or in none.

    Parameters
    ----------
    rolling : Rolling
        Kind of shape, surface, contact and field.
    parameters : mapping of Symbol to number
        The values that count.
    """
    return body_of(rolling, parameters) is not None


def solve_rolling(
    rolling: Rolling,
    system: System,
    start: Sequence[Any],
    parameters: Mapping[sp.Symbol, Any] | None = None,
) -> Solution | None:
    """The motion of a rubber body of revolution, or None if it is none.

    The contact is taken to be two-sided, as by the equations: where the normal force would have to
    pull, the motion goes on.

    Parameters
    ----------
    rolling : Rolling
        What rolls on what; its numbers are not used.
    system : System
        ``rolling.system()`` or that of a catalogue entry, not lifted.
    start : sequence of 12 numbers
        ω, γ, attitude and place at time 0; see
        :func:`~chaplygin.mechanics.rolling.initial_state.initial_state`. Numbers are read to fifty
        digits: what these do not tell from zero is zero.
    parameters : mapping of Symbol to number, optional
        Values that replace the system's defaults.

    Raises
    ------
    InputError
        If the start is off the phase space, the body falls flat in finite time, or the contact
        leaves the convex part of the body.
    """
    values = {**system.defaults, **(parameters or {})}
    body = body_of(rolling, values)
    if body is None or system.motion is None:
        return None
    lifted = system.lifted()
    if len(start) != len(lifted.symbols):
        raise InputError(f"start has {len(start)} numbers: {len(lifted.symbols)} are needed")
    with ctx.workprec(BITS):
        numbers = [exact(x) for x in start]
        begin = begin_of([arb(fmpq(x.numerator, x.denominator)) for x in numbers])
        level = begin.level(body)
        chart = _chart(level, begin)
        if isinstance(chart, Equilibrium):
            body.require_convex(chart.place, chart.place)
            return SteadySolution(lifted, values, level, begin, chart)
        a, b = chart.first.place, chart.second.place
        body.require_convex(*((a, b) if a < b else (b, a)))
        return RevolutionSolution(lifted, values, level, begin, chart)


def _chart(level: Level, begin: Begin) -> Uniformisation | Equilibrium:
    flat = level.body.flat
    if flat and not abs(begin.normal[2]) < 1 - arb(5e-13):
        raise InputError("the body lies flat, where the equations of a body on its edge end")
    try:
        return chart_of(level.equation, begin.normal[2], begin.rate)
    except InputError as mistake:
        if flat and level.K == 0:
            raise InputError(
                "the body falls flat in finite time, where the equations of a body on its edge "
                "end: it needs a rotation about its axis, omega_3 not zero"
            ) from mistake
        raise


def balls_of(time: Any) -> Any:
    """A time as a ball."""
    if isinstance(time, arb):
        return time
    value = exact(time)
    return arb(fmpq(value.numerator, value.denominator))


def needed(time: Any, digits: int, powers: int, pace: float) -> int:
    """Digits to work with, so that `digits` are left when errors grow with t to some power.

    Parameters
    ----------
    time : number
    digits, powers : int
    pace : float
        How fast a phase of the motion grows with the time.
    """
    large = abs(float(time.mid())) if isinstance(time, arb) else abs(float(exact(time)))
    grown = digits + powers * max(0, int(np.ceil(np.log10(large * pace + 1)))) + 5
    wanted = 10 * -(-grown // 10)
    if wanted > MOST:
        raise InputError(
            f"{digits} digits at time {large:g} need {wanted} digits of the start: at most {MOST} "
            "are carried"
        )
    return int(wanted)


class RevolutionSolution(Solution):
    """A motion on which θ changes.

    Attributes
    ----------
    level : Level
    begin : Begin
    course : Course
        θ with φ, ψ and the path, in the frame in which ψ = 0 at the turning point.
    """

    def __init__(
        self,
        system: System,
        parameters: Mapping[sp.Symbol, Any],
        level: Level,
        begin: Begin,
        chart: Uniformisation,
    ) -> None:
        self.system, self.parameters, self.level, self.begin = system, parameters, level, begin
        self.course = QuadratureMotion(
            chart,
            begin.normal[2],
            begin.rate,
            turning_rates(level),
            path_rates(level),
            path_parities(chart),
            (1.0, 1.0, *(abs(float(level.body.p(acb(begin.normal[2])).real)),) * 2),
        )
        with ctx.workprec(working_bits(FAST)):
            self._form = form_of(level, self.course)

    @property
    def form(self) -> ClosedForm:
        """The quadrature, its roots and rates."""
        return self._form

    @property
    def pace(self) -> float:
        """How fast the phase of θ grows with time."""
        return 1 / self.course.moment

    # --- constants -------------------------------------------------------------------------

    def _halves(self, F: Any, sigma: Any) -> tuple[Any, Any]:
        """sin θ/2 and cos θ/2."""
        low, high = self.course.chart.roots(F, sigma)
        scale = F.number(1 / arb(2).sqrt())
        return scale * high, scale * low

    @property
    def _passes(self) -> tuple[bool, bool]:
        """Whether the axis passes the vertical in every period, at θ = 0 and at θ = π."""
        chart = self.course.chart
        if not self.course.periodic:
            return False, False
        return chart.second.edge, chart.first.edge

    def _frame(self, digits: int) -> StartFrame:
        """The constants that join the course to the start."""
        course, chart = self.course, self.course.chart
        known = course.integrals(digits)
        sigma = chart.phase(self.begin.normal[2], self.begin.rate)
        phi, psi = angles_of(self.begin, self._halves(BALLS, sigma), -chart.lean(BALLS, sigma))
        phi, psi = phi - known.value(1, sigma), psi - known.value(2, sigma)
        there = acb(known.value(3, sigma), known.value(4, sigma))
        origin = acb(*self.begin.place) - turned(psi) * there
        if not course.periodic:
            return StartFrame(phi, psi, origin, *(arb(0),) * 3, acb(0), self._passes)
        _, own, precession, *_ = course.advances(digits)
        turn = precession + (arb.pi() if sum(self._passes) == 1 else 0)
        left = acb(*(known.panels[0].value(i, known.panels[0].low) for i in (3, 4)))
        right = acb(known.end(3), known.end(4))
        step = right - turned(turn) * left
        return StartFrame(phi, psi, origin, own, precession, turn, step, self._passes)

    # --- in balls --------------------------------------------------------------------------

    @arguments_checked
    def rigorous(self, time: Written, digits: int = 30) -> tuple[Any, ...]:
        """The lifted state at one time as balls that contain the exact one.

        Raises
        ------
        InputError
            If more digits are needed than the start is carried with.
        """
        work = needed(time, digits, 1 if self.course.periodic else 2, self.pace)
        with ctx.workprec(working_bits(work)):
            frame = self._frame(work)
            at = self.course.place(balls_of(time), work)
            count, sigma = at.periods, at.phase
            phi, psi, x, y = at.values
            place = walk(count, frame.turn, frame.step) + turned(count * frame.turn) * acb(x, y)
            sine, cosine = self._halves(BALLS, sigma)
            lean = -self.course.chart.lean(BALLS, sigma) * at.rate
            if at.beyond != 0:
                end = self.course.tails[1 if at.beyond > 0 else 0]
                own, precession = self.course.limits(work, end)
                place = place + turned(psi) * glide(
                    at.beyond, precession, path_speed(self.level, self._near(end, sigma))
                )
                phi, psi = phi + own * at.beyond, psi + precession * at.beyond
                sine = sine.union(((1 - end.place) / 2).sqrt() * sine.sgn())
                cosine = cosine.union(((1 + end.place) / 2).sqrt() * cosine.sgn())
                lean = lean.union(arb(0))
            if count % 2:
                sine, cosine = (
                    -half if passed else half
                    for half, passed in zip((sine, cosine), self._passes, strict=True)
                )
                lean = -lean if sum(self._passes) == 1 else lean
            phi, psi = (
                frame.phi + count * frame.own + phi,
                frame.psi + count * frame.precession + psi,
            )
            spin = self._spin(cosine * cosine - sine * sine, 2 * sine * cosine)
            place = frame.origin + turned(frame.psi) * place
            return tuple(assembled(BALLS, (sine, cosine), (lean, spin), (phi, psi), place))

    def _near(self, end: Any, sigma: Any) -> Any:
        """Everything between the edge of the integrals and a double root, in the tail."""
        return acb(end.place.union(self.course.chart.place(BALLS, sigma)))

    def _spin(self, u: Any, across: Any) -> Any:
        """ω₃/sin θ."""
        if self.level.K == 0:
            return arb(0)
        return self.level.K / (self.level.body.A(acb(u)).real * across)

    # --- in double precision ---------------------------------------------------------------

    @arguments_checked
    def states(self, times: Numbers) -> Any:
        """Lifted states at `times` (n,), as an array (n, 12)."""
        return self._fast(np.asarray(times, dtype=float))

    @cached_property
    def _fast(self) -> FastRevolution:
        with ctx.workprec(working_bits(FAST)):
            return FastRevolution(self.level, self.course, self._frame(FAST), FAST)


class SteadySolution(Solution):
    """A permanent rotation: θ rests, the contact runs along a circle or a line.

    Attributes
    ----------
    level : Level
    rest : Steady
        With its stability.
    """

    def __init__(
        self,
        system: System,
        parameters: Mapping[sp.Symbol, Any],
        level: Level,
        begin: Begin,
        rest: Equilibrium,
    ) -> None:
        self.system, self.parameters, self.rest = system, parameters, rest
        u = begin.normal[2].max(arb(-1)).min(arb(1))
        sine, cosine = ((1 - u) / 2).sqrt(), ((1 + u) / 2).sqrt()
        self._halves = (sine, cosine)
        self._angles = angles_of(begin, self._halves, arb(0))
        self._origin = acb(*begin.place)
        own, precession = (rate.real for rate in turning_rates(level)(acb(u), acb(0)))
        self._rates = (own, precession)
        self._speed = turned(self._angles[1]) * path_speed(level, acb(u))
        self._spin = own * 2 * sine * cosine
        self._form = steady_form(level, rest, self._rates)

    @property
    def pace(self) -> float:
        """The faster one of φ̇ and ψ̇."""
        return max(abs(float(rate)) for rate in self._rates)

    @property
    def form(self) -> ClosedForm:
        """The equilibrium of θ and its rates."""
        return self._form

    @arguments_checked
    def rigorous(self, time: Written, digits: int = 30) -> tuple[Any, ...]:
        """The lifted state at one time as balls that contain the exact one."""
        with ctx.workprec(working_bits(needed(time, digits, 1, self.pace))):
            t = balls_of(time)
            phi, psi = (a + w * t for a, w in zip(self._angles, self._rates, strict=True))
            place = self._origin + glide(t, self._rates[1], self._speed)
            rates = (arb(0), self._spin)
            return tuple(assembled(BALLS, self._halves, rates, (phi, psi), place))

    @arguments_checked
    def states(self, times: Numbers) -> Any:
        """Lifted states at `times` (n,), as an array (n, 12)."""
        moments = np.asarray(times, dtype=float)
        phi, psi = (
            LinearPhase.of(w, a)(moments) for a, w in zip(self._angles, self._rates, strict=True)
        )
        origin = complex(float(self._origin.real), float(self._origin.imag))
        place = origin + glides(moments, self._rates[1], self._speed)
        sine, cosine = (float(half) for half in self._halves)
        rates = (0.0, float(self._spin))
        columns = assembled(DOUBLES, (sine, cosine), rates, (phi, psi), place)
        return np.stack([column + 0 * moments for column in columns], axis=1)
