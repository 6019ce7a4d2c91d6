"""Integrating a System: one start, chosen times, everything the system records."""

from __future__ import annotations

import itertools
import math
import time as clock
from collections.abc import Callable
from dataclasses import replace
from typing import Literal

import sympy as sp

from ..arguments import Numbers, Parameters, Start, arguments_checked
from ..errors import InputError, InterruptionError, RunError
from ..system.parameters import parameter_values, require_admissible, require_finite
from ..system.system import System
from .gauss_trajectory import collocate
from .initial_states import whole_start
from .sign_branches import sign_branches
from .taylor.compiled_system import SignedOutputs, compile_system
from .taylor.working_numbers import Direction, Precision, WorkingNumber, number_type
from .taylor_run import RunLog, StoppedError, TaylorRun, decimal_text
from .trajectory import Statistics, Trajectory

#: Tolerances by default.
DEFAULT_TOLERANCE = {"double": 1e-15, "quad": 1e-30}


@arguments_checked
def integrate(
    system: System,
    start: Start,
    times: Numbers,
    *,
    parameters: Parameters = None,
    tolerance: float | None = None,
    precision: Precision = "double",
    on_liftoff: Literal["stop", "warn"] = "stop",
    keep_integrals: bool = False,
    time_limit: float | None = None,
    dense: bool = False,
    progress: Callable[[float], None] | None = None,
    method: Literal["taylor", "gauss"] = "taylor",
) -> Trajectory:
    """Integrate a system from `start` through `times`.

    Parameters
    ----------
    system : System
        If it has a motion in space, that is integrated with it.
    start : sequence of numbers, or mapping of str to number or numbers
        State at ``times[0]`` in flat order, with the motion in space behind it or without; or by
        name (ω and γ, or the variables of the state).  The motion in space begins at zero where it
        is left out, with γ pointing upward.
    times : sequence of numbers
        At least two, all increasing or all decreasing (backward integration), in s.
    parameters : mapping of Symbol or name to number, optional
        Values that replace the system's defaults.
    tolerance, precision
        See :func:`flowlanes.flow.taylor.compiled_system.compile_system`; the tolerance is 1e-15 in
        double precision and 1e-30 with 34 digits unless another one is given.
    on_liftoff : ``"stop"`` or ``"warn"``
        Whether the run ends or goes on when the normal force changes sign.  Leaving the domain
        of the equations (a body lying flat, a contact on a non-convex part) always ends it.
    keep_integrals : bool
        Restore the integrals to their initial values after every step, besides the relations.
    time_limit : float, optional
        Seconds of computing after which to give up.
    dense : bool
        Keep the continuous trajectory.
    progress : callable, optional
        Called with the fraction done.
    method : ``"taylor"`` or ``"gauss"``
        Taylor series of any tolerance, with steps that end where the argument of an absolute value
        or a sign is zero; or Gauss–Legendre collocation with all digits of a double
        (30 digits at precision "quad"), some ten times faster; see
        :func:`flowlanes.flow.gauss_trajectory.collocate`.  The second always holds the integrals
        and has no tolerance, time limit or continuous trajectory.

    Returns
    -------
    Trajectory
        Up to the last of `times`, or to where a guard ended it (that moment is its last sample).

    Raises
    ------
    InputError
        If times, parameters or start cannot be used.
    RunError
        If the integration fails; it carries the last good time and the trajectory so far.  An
        InterruptionError if it is interrupted.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> energy = flowlanes.Integral("energy", v**2 / 2 + x**4 / 4)
    >>> quartic = flowlanes.System("quartic", "Quartic", {x: v, v: -(x**3)}, laws=(energy,))
    >>> motion = flowlanes.integrate(quartic, {"x": 1.0, "v": 0.5}, [0.0, 5.0, 10.0])
    >>> motion["x"].shape
    (3,)
    >>> drift = motion["law_energy"] - 0.375
    >>> bool(abs(drift).max() < 1e-13)
    True
    """
    if time_limit is not None and not time_limit > 0:
        raise InputError(f"time_limit = {time_limit}: it must be a positive number of seconds")
    if not system.state:
        raise InputError(f"{system.name}: a system without state has no motion")
    start = whole_start(system, start, parameters)
    if method == "gauss":
        for name, value in (
            ("tolerance", tolerance),
            ("time_limit", time_limit),
            ("dense", dense or None),
        ):
            if value is not None:
                raise InputError(f"{name}: method 'gauss' has none; use method 'taylor'")
        return collocate(
            system,
            start,
            times,
            parameters,
            digits=16 if precision == "double" else 30,
            on_liftoff=on_liftoff,
        )
    if method != "taylor":
        raise InputError(f"method {method!r}: it must be 'taylor' or 'gauss'")
    values = _values(system, parameters)
    kind = number_type(precision)
    moments = _moments(times, kind)
    direction: Direction = "forward" if moments[0] < moments[-1] else "backward"
    if tolerance is None:
        tolerance = DEFAULT_TOLERANCE[precision]
    code = compile_system(system, tolerance, precision, direction)
    lifted = system.lifted() if system.reconstruction else system
    branches = sign_branches(lifted)
    if branches is not None:
        own = compile_system(branches.system, tolerance, precision, direction)
        guards = own.variable_guards
        signed = SignedOutputs(own.outputs, branches.arguments)
        code = replace(code, series=own.series, variable_guards=guards, signed=signed)
    run = TaylorRun(lifted, len(system.symbols), code, kind, values, precision)
    run.begin(start, moments[0], keep_integrals)
    began = clock.perf_counter()
    log = RunLog()
    failure = None
    error: type[RunError] = RunError
    try:
        for done in run.walk(moments, log, on_liftoff, dense, began, time_limit):
            if progress is not None:
                progress(done)
    except StoppedError as stop:
        failure = str(stop)
    except KeyboardInterrupt:
        if not log.times:
            raise
        failure, error = "interrupted", InterruptionError
    if failure is not None:
        run.keep_last(log)
    seconds = clock.perf_counter() - began
    trajectory = run.finish(
        log,
        Statistics(
            method="Taylor series",
            steps=log.steps,
            order=code.series.order,
            tolerance=tolerance,
            precision=precision,
            corrections=log.corrections,
            seconds=seconds,
            from_cache=code.from_cache,
        ),
    )
    if failure is not None:
        last = float(log.times[-1])
        raise error(f"{system.name}: {failure}", last, trajectory)
    return trajectory


def _values(system: System, parameters: Parameters) -> dict[sp.Symbol, WorkingNumber]:
    values: dict[sp.Symbol, WorkingNumber] = parameter_values(system, parameters)
    if parameters:
        require_finite(system, values)
        require_admissible(system, {s: float(value) for s, value in values.items()}, values)
    return values


def _moments(times: Numbers, kind: type[WorkingNumber]) -> list[WorkingNumber]:
    """Times in the working precision, all increasing or all decreasing."""
    moments = [kind(decimal_text(t)) for t in times]
    if len(moments) < 2:
        raise InputError(f"{len(moments)} time(s) given: at least a first and a last are needed")
    if not all(math.isfinite(float(t)) for t in moments):
        raise InputError("times: all of them must be finite numbers")
    pairs = list(itertools.pairwise(moments))
    if not (all(s < t for s, t in pairs) or all(s > t for s, t in pairs)):
        raise InputError("times: they must be all increasing or all decreasing")
    return moments
