"""The Lagrange top at any time: a holonomic check of the quadratures of §5 (§4.1).

With u = Γ₃ = cos θ, s = M₃, c = (M, Γ) and the energy h,

    I₁ u̇² = (2(h − Pu) − s²/I₃)(1 − u²) − (c − su)²/I₁,
    φ̇ = (1/I₃ − 1/I₁)s + (s − cu)/(I₁(1 − u²)),

so that u is an elliptic function of the time, and M₁, M₂ follow from θ̇ and c − su.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from flint import acb, arb, ctx

from flowlanes.arguments import NumberOrText
from flowlanes.errors import InputError
from flowlanes.formulas.relative_zero import START_TOLERANCE, vanishes
from flowlanes.system.system import System

from ...catalogue.fixed_point.lagrange_top import I_1, I_3, P
from ..base.solution import Solution
from ..one_degree import Equilibrium, MotionSample, QuadratureMotion, motion_chart
from ..one_degree.frames import BodyFrame, Inclination, intrinsic_angle
from ..one_degree.functions import BALLS, Count, Functions, T
from ..one_degree.solution import QuadratureSolution
from ..one_degree.uniform import Rotation, UniformSolution
from ..one_degree.working_precision import exact_time
from ..revolution.body import BITS
from .closed_form import form_of, steady_form
from .top import Top, Vector, level_of


def solve_top(
    system: System,
    start: Sequence[NumberOrText],
    parameters: Mapping[sp.Symbol, NumberOrText] | None = None,
) -> Solution | None:
    """Solve the Lagrange top; None if the System is another one.

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
    if system.name != "lagrange-top":
        return None
    values = {**system.defaults, **(parameters or {})}
    if len(start) != len(system.symbols):
        raise InputError(f"start has {len(start)} numbers: {len(system.symbols)} are needed")
    with ctx.workprec(BITS):
        numbers = [exact_time(x) for x in start]
        length = sum((x * x for x in numbers[3:]), arb(0)).sqrt()
        if not vanishes(length - 1, arb(1), START_TOLERANCE):
            raise InputError(
                f"start: |Gamma| is {float(length):.9g}, and must be 1, the length of the vertical"
            )
        momentum, vertical = numbers[:3], [x / length for x in numbers[3:]]
        top = level_of([exact_time(values[symbol]) for symbol in (I_1, I_3, P)], momentum, vertical)
        u, rate = vertical[2], (vertical[0] * momentum[1] - vertical[1] * momentum[0]) / top.across
        chart = motion_chart(top.equation, u, rate)
        if not isinstance(chart, Equilibrium):
            motion = QuadratureMotion(chart, u, rate, top.rates)
            frame = TopFrame(top, momentum, vertical)
            return QuadratureSolution(
                system, values, motion, frame, lambda: form_of(top, chart, motion)
            )
        axis, spin = [arb(0), arb(0), arb(1)], top.rates(acb(u), acb(0))[0].real
        return UniformSolution(
            system,
            values,
            vectors=(momentum, vertical),
            spin=Rotation(axis, spin),
            precession=Rotation([arb(0)] * 3, arb(0)),
            closed_form=steady_form(top, chart),
        )


@dataclass(frozen=True)
class TopFrame(BodyFrame):
    """M and Γ of a top as a function of cos θ.

    Attributes
    ----------
    top : Top
    momentum, vertical : three arb
        At time 0.
    """

    top: Top
    momentum: Vector
    vertical: Vector
    angles = 1

    def start_angles(self, motion: QuadratureMotion) -> list[arb]:
        """φ at time 0."""
        halves = motion.half_angles(BALLS, motion.start)
        return [intrinsic_angle(*halves, self.vertical, self.momentum)]

    def inclination(
        self, F: Functions[T], motion: QuadratureMotion, sample: MotionSample[T, Count]
    ) -> Inclination[T]:
        """θ, and M and Γ in the nodal frame."""
        sine, cosine, rate = motion.half_angles(F, sample)
        across, u = 2 * sine * cosine, cosine * cosine - sine * sine
        s, c = F.number(self.top.s), F.number(self.top.c)
        down, up = self.top.upright
        if down and up:
            side = 0 * across
        elif up:
            side = s * sine / cosine
        elif down:
            side = -s * cosine / sine
        else:
            side = (c - s * u) / across
        momentum = (F.number(self.top.across) * rate, side, s + 0 * u)
        return Inclination(sine, cosine, (momentum, (0 * u, across, u)))
