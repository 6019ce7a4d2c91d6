"""The Lyapunov spectrum of a motion: exponents, errors, and exponents that must be zero.

The method is that of Benettin, Galgani, Giorgilli and Strelcyn (1980), with deviations tangent to
relations and integrals, modulo the flow and the symmetries. Zeros that exist in any case are
therefore neither computed nor mistaken for a result. An exponent is a mean over a motion of finite
length and has an error; it is *observed*, never proven.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..arguments import Parameters, Start, arguments_checked
from ..errors import EarlyEndError, InputError, InterruptionError, RunError
from ..flow.batch import BatchIntegrator, batch_integrator
from ..flow.devices.graphics import Device
from ..flow.initial_states import reduced_start
from ..flow.linearisation.state_scales import state_scales
from ..flow.linearisation.tangent_space import propagate
from ..flow.validation import require_on_phase_space
from ..formulas.array_evaluation import parameter_rows, relation_terms
from ..system.system import System
from ..system.tolerance import ENSEMBLE_TOLERANCE
from .averages import average, resolution
from .divergence import NODES, MotionRecord, divergence_average
from .report import Spectrum
from .zero_exponents import TrivialDirections, trivial_directions

if TYPE_CHECKING:
    pass

#: Initial fraction of a motion that is omitted while deviations find their directions.
TRANSIENT = 0.2
#: Number of intervals of a motion, unless deviations separate too fast.
INTERVALS = 400
#: Minimum and maximum number of intervals.
LEAST, MOST = 100, 2_000_000
#: Largest logarithm of the ratio of lengths of deviations within an interval: for the first
#: `FIRST` intervals, in which deviations find their directions, and for the others.
APART = (12.0, 28.0)
FIRST = 8


@arguments_checked
def lyapunov_spectrum(
    system: System,
    start: Start,
    parameters: Parameters = None,
    *,
    t_end: float,
    intervals: int = INTERVALS,
    tolerance: float = ENSEMBLE_TOLERANCE,
    device: Device = "cpu",
    progress: Callable[[float], None] | None = None,
) -> Spectrum:
    """Compute the Lyapunov spectrum of the motion from a start.

    Parameters
    ----------
    system : System
    start : sequence of float, or mapping of str to number or numbers
        State on the phase space, as for :func:`flowlanes.flow.integrator.integrate`; the motion in
        space is omitted.
    parameters : mapping of Symbol or name to number, optional
        Parameters that replace the defaults.
    t_end : float
        Length of the motion (s); the first fifth is omitted from the averages.
    intervals : int
        Minimum number of intervals; it is doubled while deviations separate too far within one.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    device : "cpu" or "gpu"
        Where the motion is computed; a single motion uses one thread of a GPU.
    progress : callable, optional
        Called with the completed fraction.

    Returns
    -------
    Spectrum
        The exponents (1/s) with their errors, largest first.

    Raises
    ------
    InputError
        If the start is not on the phase space, or `t_end` or `intervals` is invalid.
    RunError
        If the motion ends early, or deviations grow too fast.
    InterruptionError
        If interrupted; the error carries the spectrum of the motion so far if it has at least
        `LEAST` intervals.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> u, w = sp.symbols("u w", real=True)
    >>> node = flowlanes.System("node", "Slow node", {u: w**2, w: -u * w / 2})
    >>> spectrum = flowlanes.lyapunov_spectrum(node, [0.0, 1.0], t_end=50.0)
    >>> [float(x) for x in spectrum.values.round(3) + 0.0]
    [0.0, -0.707]
    """
    if not 0 < t_end < np.inf:
        raise InputError(f"t_end = {t_end:g}: it must be positive and finite")
    if not LEAST <= intervals <= MOST:
        raise InputError(f"intervals = {intervals}: there must be from {LEAST} to {MOST}")
    start = [float(x) for x in reduced_start(system, start, parameters)]
    _check(system, start, parameters)
    numerics = (tolerance, device)
    text = progress or (lambda share: None)
    batch_integrator(system, tolerance=tolerance).require_reach(start, t_end, parameters)
    sizes = state_scales(system, np.array([start]), t_end, parameters, tolerance)[0]
    directions = trivial_directions(system, start, parameters, sizes=sizes)
    fading: tuple[str, ...] = ()
    try:
        run = _motion_record(directions, start, (t_end, intervals), parameters, numerics, text)
        fading = _not_forced(directions, run)
        if fading:
            directions = trivial_directions(system, start, parameters, fading, sizes)
            run = _motion_record(directions, start, (t_end, intervals), parameters, numerics, text)
    except _StoppedError as stop:
        run = stop.run
        length = run.interval * len(run.lengths)
        # If more had to be omitted, the motion would have to be integrated again.
        if len(run.lengths) < LEAST or set(_not_forced(directions, run)) - set(fading):
            raise InterruptionError("interrupted", length) from None
        partial = _spectrum(system, directions, run, length, tolerance, parameters, fading)
        raise InterruptionError("interrupted", length, partial) from None
    return _spectrum(system, directions, run, t_end, tolerance, parameters, fading)


class _StoppedError(Exception):
    """Interruption after some intervals of the motion."""

    def __init__(self, run: MotionRecord) -> None:
        super().__init__()
        self.run = run


def _motion_record(
    directions: TrivialDirections,
    start: Sequence[float],
    times: tuple[float, int],
    parameters: Parameters,
    numerics: tuple[float, Device],
    progress: Callable[[float], None],
) -> MotionRecord:
    """Record the motion in intervals short enough to keep deviations apart."""
    space = directions.space
    tolerance, device = numerics
    machine = batch_integrator(
        space.system, tolerance=tolerance, deviations=space.dimension, device=device
    )
    until, count = times
    while (run := _run(machine, directions, start, (until, count), parameters, progress)) is None:
        count *= 2
        if count > MOST:
            raise RunError("deviations grow too fast to be followed", 0.0)
    return run


def _not_forced(directions: TrivialDirections, run: MotionRecord) -> tuple[str, ...]:
    """Names of fields and integrals whose size fades, so that their exponents need not vanish.

    This applies to the flow if the motion comes to rest.
    """
    skipped = round(TRANSIENT * len(run.lengths))
    began, span = (run.interval * n for n in (skipped, len(run.lengths) - skipped))
    bound = 3 * resolution(span, began)
    with np.errstate(invalid="ignore"):
        rates = (run.sizes[-1] - run.sizes[skipped]) / span
    return tuple(
        item.name
        for item, rate in zip(directions.trivial, rates, strict=True)
        if item.kind not in ("relation", "quadrature") and not abs(rate) <= bound
    )


def _check(system: System, start: Sequence[float], parameters: Parameters) -> None:
    points = np.array([start], dtype=np.float64)
    constants = parameter_rows(system, parameters, 1)
    require_on_phase_space(system, relation_terms(system), points, constants)


def _run(
    machine: BatchIntegrator,
    directions: TrivialDirections,
    start: Sequence[float],
    times: tuple[float, int],
    parameters: Parameters,
    progress: Callable[[float], None],
) -> MotionRecord | None:
    """Integrate the motion; None if deviations separate too far within an interval."""
    until, count = times
    interval = until / count
    space = directions.space
    places, _ = np.polynomial.legendre.leggauss(NODES)
    # Gauss nodes of the divergence integral, mapped from [−1, 1] to the interval.
    inner = interval * (1 + places) / 2
    first = np.array([start], dtype=np.float64)
    states, nodes = [first[0]], []
    lengths, sizes = [], [space.excluded_basis(first, parameters, directions.sizes)[1][0]]
    stretches = propagate(
        machine, space, first, interval, parameters, sizes=directions.sizes, nodes=inner, threads=1
    )
    try:
        for k in range(count):
            stretch = next(stretches)
            code = int(stretch.outcome[0])
            if code:
                ended = k * interval + float(stretch.end_times[0])
                raise EarlyEndError(machine.system.name, machine.status_message(code), ended)
            spread = float(np.ptp(stretch.lengths[0])) if space.dimension else 0.0
            if not max(spread, np.abs(stretch.lengths[0]).max(initial=0.0)) <= APART[k >= FIRST]:
                return None
            progress((k + 1) / count)
            states.append(stretch.ends[0])
            nodes.append(stretch.states[0])
            lengths.append(stretch.lengths[0])
            sizes.append(stretch.sizes[0])
    except KeyboardInterrupt:
        # The last entries exist only for complete intervals.
        n = len(sizes) - 1
        if n == 0:
            raise
        parts = nodes[:n], states[: n + 1], lengths[:n], sizes
        raise _StoppedError(MotionRecord(interval, *map(np.array, parts))) from None
    return MotionRecord(interval, *map(np.array, (nodes, states, lengths, sizes)))


def _spectrum(
    system: System,
    directions: TrivialDirections,
    run: MotionRecord,
    t_end: float,
    tolerance: float,
    parameters: Parameters,
    fading: tuple[str, ...],
) -> Spectrum:
    skipped = round(TRANSIENT * len(run.lengths))
    began = skipped * run.interval
    span = (len(run.lengths) - skipped) * run.interval
    counted = run.lengths[skipped:]
    each = [average(column, run.interval, began) for column in counted.T]
    order = sorted(range(len(each)), key=lambda i: -each[i].value)
    rates = (run.sizes[-1] - run.sizes[skipped]) / span
    removed = tuple(
        (item, None if item.kind == "relation" else float(rate))
        for item, rate in zip(directions.trivial, rates, strict=True)
    )
    named = {str(symbol): value for symbol, value in system.defaults.items()}
    values = {
        str(name): float(np.asarray(value, dtype=float))
        for name, value in (parameters or {}).items()
    }
    return Spectrum(
        system,
        named | values,
        run.states[0],
        t_end,
        run.interval,
        began,
        tuple(each[i] for i in order),
        removed,
        directions.dependent,
        fading,
        average(counted.sum(axis=1), run.interval, began),
        divergence_average(system, directions, run, skipped, parameters),
        run.lengths[:, order],
        tolerance,
    )
