"""One motion with everything that a System records, by Gauss–Legendre collocation."""

from __future__ import annotations

import time as clock
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, Literal

import mpmath
import numpy as np
import sympy as sp

from ..core.parameters import parameter_values
from ..core.system import System
from ..core.vectors import to_components
from ..errors import InputError, RunError
from ..formulas.evaluate import values
from .gauss import GaussIntegrator, gauss_integrator
from .kernel.double_double import unpaired
from .kernel.runge_kutta import STATUS_MESSAGES
from .trajectory import Event, Statistics, Trajectory

__all__ = ["collocate"]


def collocate(
    system: System,
    start: Sequence[Any],
    times: Sequence[float],
    parameters: Mapping[Any, Any] | None = None,
    *,
    digits: Literal[16, 30] = 16,
    on_liftoff: Literal["stop", "warn"] = "stop",
) -> Trajectory:
    """Integrate a system with all digits; see :func:`chaplygin.flow.integrator.integrate`.

    The state is held on the level of its relations and integrals.  With 30 digits the states are
    numbers of mpmath and what is recorded has 16.

    Parameters
    ----------
    system : System
        If it has a motion in space, that is integrated with it.
    start : sequence of numbers
        State at ``times[0]``, reduced and (where there is one) lifted, in flat order.
    times : sequence of numbers
        At least two, all increasing or all decreasing.
    parameters : mapping of Symbol or name to number, optional
    digits : 16 or 30
    on_liftoff : ``"stop"`` or ``"warn"``
        Whether the run ends when the normal force changes sign, or passes over it.

    Raises
    ------
    InputError
        If times, parameters or start cannot be used.
    RunError
        If the integration fails; it carries the last good time and the trajectory so far.
    """
    lifted = system.lifted() if system.motion else system
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
    if digits == 30:
        constants = {symbol: _decimal(value) for symbol, value in constants.items()}
        point = [_decimal(x) for x in start]
    flow = gauss_integrator(watched, point, constants, digits, backward=backward)
    flow.require_reach(point, float(moments[-1] - moments[0]), constants)
    found = flow.until([point], moments - moments[0], constants)
    outcome, reached = int(found.outcome[0]), float(found.ended[0] + moments[0])
    events: tuple[Event, ...] = ()
    if outcome >= len(STATUS_MESSAGES):
        guard = watched.guards[outcome - len(STATUS_MESSAGES)]
        events = (Event(reached, guard, True),)
        earlier = [t for t in moments if abs(t - moments[0]) < abs(reached - moments[0])]
        moments = np.array([*earlier, reached] if reached != moments[0] else [reached])
        found = flow.until([point], moments - moments[0], constants)
    good = np.isfinite(found.states[0]).all(axis=1)
    trajectory = _recorded(lifted, constants, moments[good], _states(flow, found, good))
    statistics = Statistics(
        steps=int(found.steps[0]),
        order=16 if digits == 16 else 32,
        tolerance=1e-16 if digits == 16 else 1e-30,
        precision="double" if digits == 16 else "quad",
        corrections=int(found.steps[0]) if flow.held else 0,
        seconds=clock.perf_counter() - began,
        from_cache=flow.code.found,
    )
    trajectory = replace(trajectory, events=events, statistics=statistics)
    if 0 < outcome < len(STATUS_MESSAGES):
        raise RunError(f"{system.name}: {flow.reason(outcome)}", reached, trajectory)
    return trajectory


def _states(flow: GaussIntegrator, found: Any, good: Any) -> Any:
    states = found.states[0, good]
    return states if flow.digits == 16 else unpaired(states, found.rest[0, good])


def _decimal(number: Any) -> Any:
    """A number with all its digits, a float as the decimal that it shows."""
    with mpmath.workdps(50):
        if isinstance(number, (int, float, np.number)):
            return mpmath.mpf(repr(float(number)))
        return mpmath.mpmathify(number)


def _recorded(
    system: System, constants: dict[sp.Symbol, Any], times: Any, states: Any
) -> Trajectory:
    """A trajectory with observables and integrals at its states."""
    items = [(item.name, to_components(item.value)) for item in system.observables]
    items += [(f"law_{law.name}", to_components(law.value)) for law in system.integrals]
    parts = [list(v) if isinstance(v, sp.MatrixBase) else [v] for _, v in items]
    numbers = states.astype(float)
    doubles = {symbol: float(value) for symbol, value in constants.items()}
    rows = values(system, [part for group in parts for part in group], numbers, doubles)
    recorded: dict[str, Any] = {}
    first = 0
    for (name, value), components in zip(items, parts, strict=True):
        block = rows[:, first : first + len(components)]
        recorded[name] = block if isinstance(value, sp.MatrixBase) else block[:, 0]
        first += len(components)
    nothing = Statistics(0, 0, 0.0, "double", 0, 0.0, False)
    return Trajectory(system, constants, times, states, recorded, (), nothing)
