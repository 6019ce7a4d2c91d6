"""The end of sliding, followed in the logarithm of the slip.

At a point contact, X is a linear function of the direction divided by B = c − μ (d, n), the normal
acceleration per unit of normal force.  In the clock P with dt = B dP the slip turns as in an impact
with the matrix −μ (a dᵀ − b_n A), and the compiled equations of `impact_slide` apply.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flowlanes.errors import InputError, RunError
from flowlanes.system.arrays import FloatArray

from ..impact.impact_slide import LEAST, Ends, Linear, SlidingFriction, slide, slide_integrator
from .frozen_slip import FrozenSlip, PointSlip, growth_and_turning

#: Value of ln s down to which the turning of the slip is followed.
END = -40.0
#: Turning, relative to the whole rate, below which the slip counts as straight.
STRAIGHT = 1e-11
#: If the slip decays more slowly than the first fraction of the largest rate, its direction settles
#: long before it ends; it counts as settled if the turning is below the second fraction.
WEAK, SETTLED = 1e-2, 1e-3
#: Growth of ln s after which a slip is not about to stop.
LARGEST_GROWTH = 5.0
#: Maximum duration in θ, in units of the initial rate.
LONGEST = 1e5
#: Relative tolerance of the integration.
TOLERANCE = 1e-13

#: A slide at a point ends only by its own stop.
_NEVER = Linear(-1.0, 0.0, np.zeros(2))
_NO_ENDS = Ends(True, 0.0, 0.0, 0.0, -1.0, None, None)


@dataclass(frozen=True, eq=False)
class Stop:
    """The end of a slide.

    Attributes
    ----------
    duration : float
        Time until the slip is zero.
    direction : (2,) or (3,) array
        Direction of the slip at its end.
    growth : float
        H, the rate of the size of the slip at the end, negative.
    greatest_rate : float
        Largest rate of the slip in any direction.
    normal_impulse : float
        Impulse of the normal force in this time.
    friction_impulse : (2,) array
        Impulse of friction, along the tangents of the mobility.
    couple_impulse : float
        Impulse of the spin couple.
    """

    duration: float
    direction: FloatArray
    growth: float
    greatest_rate: float
    normal_impulse: float
    friction_impulse: FloatArray
    couple_impulse: float


def finish_stop(slip: FrozenSlip, direction: FloatArray, size: float) -> Stop:
    """Follow a slide that is about to stop, from a slip of small magnitude to its end.

    With dt = s dθ the direction obeys dn/dθ = G and the magnitude d(ln s)/dθ = H, which is regular
    at the end.  The slip is followed until it goes straight or has shrunk to e⁻⁴⁰.  If the
    direction settles slowly, the slip has vanished before, so the equations are never stiff.

    Time and impulses are of first order in `size` = ε.  The neglected terms are of second order:
    the path of the slip ∫s dt ≈ ε²/2|H|, and the effect of the change of the frozen quantities
    during the time ε/|H|, which is of order ε in the rates and ε² in the time.  The rest of the
    state advances by its rate (with the given impulses) times the duration.

    Parameters
    ----------
    slip : FrozenSlip
    direction : (2,) or (3,) array
        Direction of the slip, of any length.
    size : float
        ε, the present slip in units in which ordinary slips are of order 1.

    Returns
    -------
    Stop

    Raises
    ------
    RunError
        If the slip does not shrink to zero.
    InputError
        If the size is not positive.

    Examples
    --------
    A ball with a slip of 1 µm/s on ground with μ = 0.3 loses (7/2) μ g of it in a second.

    >>> import numpy as np
    >>> from nonholonomic.contact.slip.frozen_slip import point_slip
    >>> from nonholonomic.contact.impact.mobility import mobility
    >>> from nonholonomic.contact.slip.stopping import finish_stop
    >>> ball = mobility(1.0, [0.4, 0.4, 0.4], [0, 0, -1], [0, 0, 1])
    >>> slip = point_slip(ball, np.array([0, 0, -9.81]), 0.3)
    >>> stop = finish_stop(slip, np.array([1.0, 0.0]), 1e-6)
    >>> round(stop.duration * 3.5 * 0.3 * 9.81 / 1e-6, 12)
    1.0
    """
    if not 0 < size < np.inf:
        raise InputError(f"size {size} of the slip: it must be positive")
    n = np.asarray(direction, dtype=float)
    n = n / np.linalg.norm(n)
    if isinstance(slip, PointSlip):
        return _stop_at_point(slip, n, size)
    width = len(n)
    state = _slip_integration(slip, n, min(END - float(np.log(size)), 0.0))
    last = state[:width] / np.linalg.norm(state[:width])
    growth, _ = growth_and_turning(slip, last)
    if growth >= 0:
        raise RunError("the slip does not shrink to zero", 0.0)
    rest = np.exp(state[width]) / -growth * _impulse_rates(slip, last)
    duration, normal, *friction, couple = (size * (state[width + 1 :] + rest)).tolist()
    greatest = _greatest_rate(slip, width)
    return Stop(duration, last, growth, greatest, normal, np.array(friction), couple)


def _stop_at_point(slip: PointSlip, n: FloatArray, size: float) -> Stop:
    """The end of a slide at a point contact."""
    beta, A = slip.response.tangential
    constant, slope = slip.response.normal
    pressing = -slip.normal
    unit = _greatest_rate(slip, 2)
    steady = (constant * slip.tangential + pressing * beta) / unit
    matrix = (np.outer(slip.tangential, slope) + pressing * A) / unit
    friction_law = SlidingFriction(slip.mu)
    integrator = slide_integrator(friction_law)
    logarithm, clock, friction = 0.0, 0.0, np.zeros(2)
    last = min(END - float(np.log(size)), 0.0)
    while True:
        growth, turning = growth_and_turning(slip, n)
        if float(np.linalg.norm(turning)) <= STRAIGHT * abs(growth) or logarithm <= last:
            break
        if abs(growth) <= WEAK * unit and float(np.linalg.norm(turning)) <= SETTLED * unit:
            settled = _settled_direction(slip, n)
            if settled is not None:
                n = settled
                growth, _ = growth_and_turning(slip, n)
                break
        if slip.force(n)[0] <= 0:
            raise RunError("the slip does not shrink to zero", 0.0)
        try:
            part = slide(integrator, steady, matrix, friction_law, n, _NEVER, _NO_ENDS)
        except RunError:
            raise RunError("the slip does not shrink to zero", 0.0) from None
        if part.speed > 2 * LEAST:
            raise RunError("the slip does not shrink to zero", 0.0)
        speed = float(np.exp(logarithm))
        clock, friction = clock + speed * part.clock, friction + speed * part.friction
        n, logarithm = part.direction / np.hypot(*part.direction), logarithm + np.log(part.speed)
    if growth >= 0:
        raise RunError("the slip does not shrink to zero", 0.0)
    clock, friction = clock / unit, friction / unit
    rest = np.exp(logarithm) / -growth * _impulse_rates(slip, n)
    duration = constant * clock + float(slope @ friction)
    normal = pressing * clock
    held = slip.response.couple
    couple = held[0] * normal + pressing * float(held[1] @ friction) + slip.couple * duration
    row = size * (rest + np.array([duration, normal, *(pressing * friction), couple]))
    return Stop(float(row[0]), n, growth, unit, float(row[1]), row[2:4], float(row[4]))


def _greatest_rate(slip: FrozenSlip, width: int) -> float:
    """The largest rate of the slip along the coordinate axes."""
    return max(float(np.linalg.norm(slip.rate(axis))) for axis in np.eye(width))


def _settled_direction(slip: PointSlip, n: FloatArray) -> FloatArray | None:
    """The attracting invariant direction near n; None if there is none."""

    def turning(angle: float) -> float:
        x, y = np.cos(angle), np.sin(angle)
        rate = slip.rate(np.array([x, y]))
        return float(x * rate[1] - y * rate[0])

    start = angle = float(np.arctan2(n[1], n[0]))
    slope = 0.0
    for _ in range(20):
        slope = (turning(angle + 1e-6) - turning(angle - 1e-6)) / 2e-6
        step = turning(angle) / slope if slope else np.inf
        if abs(angle - step - start) > 10 * SETTLED:
            return None
        angle -= step
        if abs(step) < 1e-15:
            break
    return np.array([np.cos(angle), np.sin(angle)]) if slope < 0 else None


def _impulse_rates(slip: FrozenSlip, n: FloatArray) -> FloatArray:
    """Rates of time, normal impulse, friction impulse and couple impulse."""
    pressure, friction, couple = slip.force(n)
    return np.array([1.0, pressure, *friction, couple])


def _slip_integration(slip: FrozenSlip, n: FloatArray, end: float) -> FloatArray:
    """Direction, ln(s/ε), time and impulses over ε, when the slip goes straight or ends."""
    from scipy.integrate import solve_ivp

    width, unit = len(n), float(np.linalg.norm(slip.rate(n)))
    whole = _greatest_rate(slip, width)

    def parts(state: FloatArray) -> tuple[FloatArray, float, FloatArray]:
        now = state[:width] / np.linalg.norm(state[:width])
        return now, *growth_and_turning(slip, now)

    def rates(_: float, state: FloatArray) -> FloatArray:
        now, growth, turning = parts(state)
        gain = np.exp(state[width]) * _impulse_rates(slip, now)
        return np.concatenate([turning, [growth], gain]) / unit

    def straight(_: float, state: FloatArray) -> float:
        # On a small patch the spin outlives the slip: the growth is then far below the rates of
        # turning, whose rounding errors must not hide that the direction has settled.
        growth, turning = parts(state)[1:]
        return float(np.linalg.norm(turning)) - STRAIGHT * max(abs(growth), whole)

    def end_of_slip(_: float, state: FloatArray) -> float:
        return float((state[width] - end) * (LARGEST_GROWTH - state[width]))

    state = np.concatenate([n, np.zeros(6)])
    if straight(0.0, state) <= 0 or end == 0:
        return state
    for event in (straight, end_of_slip):
        setattr(event, "terminal", True)  # noqa: B010  (a function has no such attribute)
    solution = solve_ivp(
        rates,
        (0.0, LONGEST),
        state,
        method="DOP853",
        rtol=TOLERANCE,
        atol=TOLERANCE,
        events=(straight, end_of_slip),
    )
    last: FloatArray = solution.y[:, -1]
    if solution.status != 1 or last[width] > 0.5 * LARGEST_GROWTH:
        raise RunError("the slip does not shrink to zero", 0.0)
    return last
