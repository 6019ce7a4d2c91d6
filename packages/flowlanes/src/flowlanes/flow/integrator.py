"""Integration of a System from one start through given times, with all recorded quantities."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from ..arguments import Numbers, Parameters, Start, arguments_checked
from ..errors import InputError
from ..system.system import System
from ..system.tolerance import Precision
from .initial_states import whole_start
from .integration_method import MotionRequest
from .methods import method_named, require_options
from .trajectory import Trajectory


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
    method: str = "taylor",
) -> Trajectory:
    """Integrate a system from `start` through `times`.

    Parameters
    ----------
    system : System
        If it has a reconstruction, that is integrated with it.
    start : sequence of numbers, or mapping of str to number or numbers
        State at ``times[0]`` in flat order, with the reconstruction behind it or without; or by
        name (the variables of the state, or what the system's conventions take for them).  A
        reconstruction that is left out begins where the conventions say, usually at zero.
    times : sequence of numbers
        At least two times in s, increasing or decreasing (backward integration).
    parameters : mapping of Symbol or name to number, optional
        Values that replace the defaults of the system.
    tolerance, precision
        See :mod:`flowlanes.system.tolerance`; the default is 1e-15, and 1e-30 with the 34 digits
        of precision "quad".
    on_liftoff : ``"stop"`` or ``"warn"``
        Whether the run ends or goes on when a guard with ``lift_off`` changes sign.  Leaving the
        domain of the equations, which the other guards bound, always ends it.
    keep_integrals : bool
        Restore the integrals, besides the relations, to their initial values after every step.
    time_limit : float, optional
        Maximum computing time in seconds.
    dense : bool
        Keep the continuous trajectory.
    progress : callable, optional
        Function that is called with the completed fraction.
    method : str
        One of :func:`flowlanes.flow.methods.methods`: ``"taylor"`` or ``"gauss"``.  Taylor series
        work for any tolerance, with steps that end where the argument of an absolute value or a
        sign is zero.  Gauss–Legendre collocation gives all digits of a double (30 digits at
        precision "quad") and is about ten times faster; see
        :func:`flowlanes.flow.gauss_trajectory.collocate`.  It always conserves the integrals and
        has no tolerance, time limit or continuous trajectory.

    Returns
    -------
    Trajectory
        Up to the last of `times`, or up to the moment at which a guard ended it.

    Raises
    ------
    InputError
        If times, parameters or start are not valid.
    RunError
        If the integration fails; the error holds the last valid time and the trajectory up to it.
        An InterruptionError if it is interrupted.

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
    chosen = method_named(method)
    if time_limit is not None and not time_limit > 0:
        raise InputError(f"time_limit = {time_limit}: it must be a positive number of seconds")
    if not system.state:
        raise InputError(f"{system.name}: a system without state has no motion")
    start = whole_start(system, start, parameters)
    request = MotionRequest(
        system,
        start,
        times,
        parameters,
        tolerance,
        precision,
        on_liftoff,
        keep_integrals,
        time_limit,
        dense,
        progress,
    )
    require_options(chosen, request)
    return chosen.motion(request)
