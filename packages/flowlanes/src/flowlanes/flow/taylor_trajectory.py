"""One motion with all recorded quantities of a System, by Taylor series."""

from __future__ import annotations

import itertools
import math
import time as clock
from dataclasses import replace

import sympy as sp

from ..arguments import Numbers, Parameters
from ..errors import InputError, InterruptionError, RunError
from ..system.parameters import parameter_values, require_admissible, require_finite
from ..system.system import System
from ..system.tolerance import TOLERANCE
from .integration_method import IntegrationMethod, MotionRequest
from .sign_branches import sign_branches
from .taylor.compiled_system import SignedOutputs, compile_system
from .taylor.working_numbers import Direction, WorkingNumber, number_type
from .taylor_run import RunLog, StoppedError, TaylorRun, decimal_text
from .trajectory import Statistics, Trajectory


class TaylorSeries(IntegrationMethod):
    """Taylor series for any tolerance."""

    name = "taylor"
    options = frozenset({"tolerance", "time_limit", "dense"})

    def motion(self, request: MotionRequest) -> Trajectory:
        """Motion in steps that end where an argument of an absolute value vanishes."""
        return taylor_motion(request)


def taylor_motion(request: MotionRequest) -> Trajectory:
    """Motion of a system by Taylor series.

    See :func:`flowlanes.flow.integrator.integrate`.
    """
    system, precision = request.system, request.precision
    tolerance = request.tolerance
    values = _values(system, request.parameters)
    kind = number_type(precision)
    moments = _moments(request.times, kind)
    direction: Direction = "forward" if moments[0] < moments[-1] else "backward"
    if tolerance is None:
        tolerance = TOLERANCE[precision]
    code = compile_system(system, tolerance, precision, direction)
    lifted = system.lifted() if system.reconstruction else system
    branches = sign_branches(lifted)
    if branches is not None:
        own = compile_system(branches.system, tolerance, precision, direction)
        guards = own.variable_guards
        signed = SignedOutputs(own.outputs, branches.arguments)
        code = replace(code, series=own.series, variable_guards=guards, signed=signed)
    run = TaylorRun(lifted, len(system.symbols), code, kind, values, precision)
    run.begin(request.start, moments[0], request.keep_integrals)
    began = clock.perf_counter()
    log = RunLog()
    failure = None
    error: type[RunError] = RunError
    try:
        for done in run.walk(
            moments, log, request.on_liftoff, request.dense, began, request.time_limit
        ):
            if request.progress is not None:
                request.progress(done)
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
    """Times in the working precision, increasing or decreasing."""
    moments = [kind(decimal_text(t)) for t in times]
    if len(moments) < 2:
        raise InputError(f"{len(moments)} time(s) given: at least a first and a last are needed")
    if not all(math.isfinite(float(t)) for t in moments):
        raise InputError("times: all of them must be finite numbers")
    pairs = list(itertools.pairwise(moments))
    if not (all(s < t for s, t in pairs) or all(s > t for s, t in pairs)):
        raise InputError("times: they must be all increasing or all decreasing")
    return moments
