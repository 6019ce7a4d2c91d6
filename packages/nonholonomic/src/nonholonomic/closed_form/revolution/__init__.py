"""The heavy rubber body of revolution at any time (§5).

θ(t) follows from (5.2); the angle of intrinsic rotation φ, the precession ψ = −∫ cos θ dφ and the
path on the plane are quadratures along it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp
from flint import acb, arb, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.system import System

from ...mechanics.rolling.equations import RollingBody
from ..base.solution import Solution
from ..one_degree import FAST, Equilibrium, QuadratureMotion, motion_chart
from ..one_degree.frames import euler_quaternion
from ..one_degree.functions import BALLS
from ..one_degree.solution import QuadratureSolution
from ..one_degree.uniform import Rotation, UniformSolution
from ..one_degree.uniformisation import Uniformisation
from ..one_degree.vectors import conjugate, product
from ..one_degree.working_precision import exact_time
from .body import BITS, Level, body_of
from .closed_form import form_of, steady_form
from .state import (
    RevolutionFrame,
    StartState,
    path_parities,
    path_rates,
    path_speed,
    start_angles,
    start_state,
    turning_rates,
)

__all__ = ["solve_rolling"]


@arguments_checked
def solve_rolling(
    rolling: RollingBody,
    system: System,
    start: Sequence[NumberOrText],
    parameters: Mapping[sp.Symbol, NumberOrText] | None = None,
) -> Solution | None:
    """Solve a rubber body of revolution on a plane; None for any other body.

    The contact is two-sided, as in the equations: the motion continues if the normal force becomes
    negative.

    Parameters
    ----------
    rolling : RollingBody
        The body, the surface and the forces; their numbers are not used.
    system : System
        ``rolling.system()`` or that of a catalogue entry, not lifted.
    start : sequence of 12 numbers
        ω, γ, attitude and position at time 0; see :func:`nonholonomic.initial_state`.  Numbers are
        read to fifty digits: a number that vanishes to these is zero.
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
    if body is None or system.reconstruction is None:
        return None
    lifted = system.lifted()
    if len(start) != len(lifted.symbols):
        raise InputError(f"start has {len(start)} numbers: {len(lifted.symbols)} are needed")
    with ctx.workprec(BITS):
        state = start_state([exact_time(x) for x in start])
        level = state.level(body)
        chart = _chart(level, state)
        if isinstance(chart, Equilibrium):
            body.require_convex(chart.x, chart.x)
            return _steady_solution(lifted, values, level, state, chart)
        a, b = chart.first.x, chart.second.x
        body.require_convex(*((a, b) if a < b else (b, a)))
        length = abs(float(body.p(acb(state.normal[2])).real))
        motion = QuadratureMotion(
            chart,
            state.normal[2],
            state.rate,
            turning_rates(level),
            path_rates(level),
            path_parities(chart),
            (1.0, 1.0, length, length),
        )
        frame = RevolutionFrame(level, state, state.position)
        solution = QuadratureSolution(lifted, values, motion, frame, lambda: form_of(level, motion))
        # A singular quadrature is rejected here.
        motion.integrals(FAST)
        return solution


def _steady_solution(
    system: System,
    parameters: Mapping[sp.Symbol, NumberOrText],
    level: Level,
    start: StartState,
    equilibrium: Equilibrium,
) -> UniformSolution:
    """A permanent rotation: θ is constant, and the contact moves along a circle or a line."""
    normal = start.normal
    u = normal[2].max(arb(-1)).min(arb(1))
    sine, cosine = ((1 - u) / 2).sqrt(), ((1 + u) / 2).sqrt()
    phi, psi = start_angles(start, sine, cosine, arb(0))
    own, precession = (rate.real for rate in turning_rates(level)(acb(u), acb(0)))
    attitude = euler_quaternion(BALLS, sine, cosine, phi, psi)
    speed = path_speed(level, acb(u)).real
    velocity = product(conjugate(attitude), [speed * psi.cos(), speed * psi.sin(), arb(0)])
    omega = [precession * x for x in normal[:2]] + [own + precession * normal[2]]
    return UniformSolution(
        system,
        parameters,
        vectors=(omega, normal),
        spin=Rotation([arb(0), arb(0), arb(1)], own),
        precession=Rotation(normal, precession),
        closed_form=steady_form(level, equilibrium, (own, precession)),
        attitude=attitude,
        velocity=velocity,
        position=start.position,
    )


def _chart(level: Level, start: StartState) -> Uniformisation | Equilibrium:
    flat = level.body.flat
    if flat and not abs(start.normal[2]) < 1 - arb(5e-13):
        raise InputError("the body lies flat, where the equations of a body on its edge end")
    try:
        return motion_chart(level.equation, start.normal[2], start.rate)
    except InputError as mistake:
        if flat and level.K == 0:
            raise InputError(
                "the body falls flat in finite time, where the equations of a body on its edge "
                "end: it needs a rotation about its axis, omega_3 not zero"
            ) from mistake
        raise
