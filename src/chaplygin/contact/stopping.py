"""The last moment of sliding, in the logarithm of the slip."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..core.arrays import FloatArray
from ..errors import InputError, RunError
from .frozen_slip import FrozenSlip, growth_and_turning

#: The logarithm of the slip down to which it is followed; from there on it goes straight.
END = -40.0
#: Turning faster than this, per e-fold of the slip, calls for an implicit method.
STIFF = 100.0
#: Step of the differences that measure it.
STEP = 1e-6


@dataclass(frozen=True, eq=False)
class Stop:
    """The last moment of sliding.

    Attributes
    ----------
    duration : float
        Time until the slip is zero.
    direction : (2,) or (3,) array
        Of the slip at its end.
    normal_impulse : float
        Of the normal force in this time.
    friction_impulse : (2,) array
        Of friction, along the tangents of the mobility.
    couple_impulse : float
        Of the spin couple.
    """

    duration: float
    direction: FloatArray
    normal_impulse: float
    friction_impulse: FloatArray
    couple_impulse: float


def finish_stop(slip: FrozenSlip, direction: FloatArray, size: float) -> Stop:
    """The rest of a sliding that is about to stop, from a slip of a small size.

    In σ = ln s the direction obeys dn/dσ = G/H, and dt/dσ = s/H, which has no singularity at the
    end.  Time and impulses are of first order in `size` ε.  What is neglected is of second
    order: the way of the slip ∫s dt ≈ ε²/2|H|, and the change that the frozen quantities suffer
    in the time ε/|H|, which changes the rates by a part of order ε and the time by one of order
    ε².  The rest of the state moves on by its rate (with the impulses given) times the duration.

    Parameters
    ----------
    slip : FrozenSlip
    direction : (2,) or (3,) array
        Of the slip; any length.
    size : float
        ε: the slip now, in units in which ordinary slips are of order 1.

    Raises
    ------
    RunError
        If the slip ceases to shrink before it is zero.
    InputError
        If the size is not positive.
    """
    if not 0 < size < np.inf:
        raise InputError(f"size {size} of the slip: it must be positive")
    n = np.asarray(direction, dtype=float)
    n = n / np.linalg.norm(n)
    start, width = float(np.log(size)), len(n)
    end = min(END, start)

    def rates(sigma: float, state: FloatArray) -> FloatArray:
        """Direction, and time and impulses in units of the size."""
        now = state[:width] / np.linalg.norm(state[:width])
        growth, turning = growth_and_turning(slip, now)
        pressure, friction, couple = slip.force(now)
        clock = np.exp(sigma - start) / growth
        return np.concatenate([turning / growth, clock * _row(pressure, friction, couple)])

    def shrinking(_: float, direction: FloatArray) -> float:
        now = direction / np.linalg.norm(direction)
        return -growth_and_turning(slip, now)[0]

    if shrinking(start, n) <= 0:
        raise RunError("the slip grows", 0.0)
    state = np.concatenate([n, np.zeros(5)])
    if end < start:
        state = _followed(rates, shrinking, (start, end), state, width)
    last = state[:width] / np.linalg.norm(state[:width])
    growth, _ = growth_and_turning(slip, last)
    rest = np.exp(end - start) / -growth * _row(*slip.force(last))
    duration, normal, *friction, couple = (size * (state[width:] + rest)).tolist()
    return Stop(duration, last, normal, np.array(friction), couple)


def _row(pressure: float, friction: FloatArray, couple: float) -> FloatArray:
    return np.array([1.0, pressure, *friction, couple])


def _followed(
    rates: Callable[[float, FloatArray], FloatArray],
    shrinking: Callable[[float, FloatArray], float],
    span: tuple[float, float],
    state: FloatArray,
    width: int,
) -> FloatArray:
    from scipy.integrate import solve_ivp

    def event(sigma: float, state: FloatArray) -> float:
        return shrinking(sigma, state[:width])

    event.terminal = True  # type: ignore[attr-defined]
    steep = 0.0
    for axis in np.eye(len(state))[:width]:
        ends = [rates(span[0], state + side * STEP * axis)[:width] for side in (1, -1)]
        steep = max(steep, float(np.abs(ends[0] - ends[1]).max()) / (2 * STEP))
    method, tolerance = ("Radau", 1e-10) if steep > STIFF else ("DOP853", 1e-13)
    found = solve_ivp(
        rates, span, state, method=method, rtol=tolerance, atol=tolerance, events=event
    )
    if found.status != 0:
        raise RunError("the slip ceases to shrink", 0.0)
    last: FloatArray = found.y[:, -1]
    return last
