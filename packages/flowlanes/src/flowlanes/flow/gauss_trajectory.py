"""One motion with all recorded quantities of a System, by Gauss–Legendre collocation."""

from __future__ import annotations

import time as clock
from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import mpmath
import numpy as np

from ..arguments import Numbers, Parameters
from ..errors import InputError, RunError
from ..system.arrays import BoolArray, FloatArray
from ..system.parameters import parameter_values
from ..system.system import System
from ..system.tolerance import FINEST_TOLERANCE, Precision
from .gauss import GaussIntegrator, GaussTrajectories, gauss_integrator
from .kernel.outcomes import STATUS_MESSAGES
from .machine_code.double_double_conversion import from_pairs
from .recorded_quantities import recorded_values
from .taylor.working_numbers import WorkingArray, WorkingNumber
from .trajectory import Event, Statistics, Trajectory


def collocate(
    system: System,
    start: Sequence[WorkingNumber],
    times: Numbers,
    parameters: Parameters = None,
    *,
    precision: Precision = "double",
    on_liftoff: Literal["stop", "warn"] = "stop",
) -> Trajectory:
    """Integrate a system to full double (or 30-digit) accuracy by collocation.

    See :func:`flowlanes.flow.integrator.integrate`.
    The state is kept on the level of its relations and integrals.  In quad precision the states
    are numbers of mpmath, and recorded quantities have 16 digits.

    Parameters
    ----------
    system : System
        If it has a motion in space, this is integrated too.
    start : sequence of numbers
        State at ``times[0]``, with the motion in space if there is one, in flat order.
    times : sequence of numbers
        At least two times, increasing or decreasing.
    parameters : mapping of Symbol or name to number, optional
    precision : ``"double"`` or ``"quad"``
    on_liftoff : ``"stop"`` or ``"warn"``
        Whether the run ends when a guard with ``lift_off`` changes sign, or passes over it.

    Raises
    ------
    InputError
        If times, parameters or start are not valid.
    RunError
        If the integration fails; the error holds the last valid time and the trajectory up to it.
    """
    lifted = system.lifted() if system.reconstruction else system
    moments = np.asarray(times, dtype=float)
    if len(moments) < 2:
        raise InputError(f"{len(moments)} time(s) given: at least a first and a last are needed")
    watched = lifted
    if on_liftoff == "warn":
        watched = replace(lifted, guards=tuple(g for g in lifted.guards if not g.lift_off))
    began = clock.perf_counter()
    backward = bool(moments[-1] < moments[0])
    constants = parameter_values(system, parameters)
    point = list(start)
    if precision == "quad":
        constants = {symbol: _decimal(value) for symbol, value in constants.items()}
        point = [_decimal(x) for x in start]
    flow = gauss_integrator(watched, point, constants, precision, backward=backward)
    flow.require_reach(point, float(moments[-1] - moments[0]), constants)
    motion = flow.propagate([point], moments - moments[0], constants)
    outcome, reached = int(motion.outcome[0]), float(motion.end_times[0] + moments[0])
    events: tuple[Event, ...] = ()
    if outcome >= len(STATUS_MESSAGES):
        guard = watched.guards[outcome - len(STATUS_MESSAGES)]
        events = (Event(reached, guard, True),)
        earlier = [t for t in moments if abs(t - moments[0]) < abs(reached - moments[0])]
        moments = np.array([*earlier, reached] if reached != moments[0] else [reached])
        motion = flow.propagate([point], moments - moments[0], constants)
    good = np.isfinite(motion.states[0]).all(axis=1)
    states = _states(flow, motion, good)
    doubles = {symbol: float(np.asarray(value, dtype=float)) for symbol, value in constants.items()}
    recorded = recorded_values(lifted, states.astype(float), doubles)
    statistics = Statistics(
        method="Gauss–Legendre collocation",
        steps=int(motion.steps[0]),
        order=16 if precision == "double" else 32,
        tolerance=FINEST_TOLERANCE[precision],
        precision=precision,
        corrections=int(motion.steps[0]) if flow.held_names else 0,
        seconds=clock.perf_counter() - began,
        from_cache=flow.code.from_cache,
    )
    trajectory = Trajectory(lifted, constants, moments[good], states, recorded, events, statistics)
    if 0 < outcome < len(STATUS_MESSAGES):
        raise RunError(f"{system.name}: {flow.status_message(outcome)}", reached, trajectory)
    return trajectory


def _states(flow: GaussIntegrator, motion: GaussTrajectories, good: BoolArray) -> WorkingArray:
    """States (times, size) of one motion, with all digits."""
    states: FloatArray = motion.states[0, good]
    return states if flow.precision == "double" else from_pairs(states, motion.rest[0, good])


def _decimal(number: WorkingNumber) -> mpmath.mpf:
    """Number with all its digits; a float is taken as its shortest decimal representation."""
    with mpmath.workdps(50):
        if isinstance(number, (int, float, np.number)):
            return mpmath.mpf(repr(float(number)))
        return mpmath.mpmathify(number)
