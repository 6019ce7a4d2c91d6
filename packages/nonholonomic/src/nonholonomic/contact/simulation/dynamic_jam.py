"""Dynamic jam: the normal force grows without bound in a finite time, as B tends to zero.

B is the normal acceleration of the contact per unit of normal force.  Since N ∝ 1/B, the square of
B decreases linearly in time, and the remaining impulse ∫N dt is finite.
"""

from __future__ import annotations

import math

import numpy as np

from flowlanes.system.arrays import FloatArray

from ..equations.equations_of_motion import JAM
from .compiled import OMEGA, VELOCITY, WORK, ContactNumbers
from .mode_integrator import ModeIntegrator

#: If integration fails while B is below this fraction of its frictionless value, B is taken to
#: vanish there.
_JAMMING = 1e-3


def ends_in_jam(integrator: ModeIntegrator, numbers: ContactNumbers, state: FloatArray) -> bool:
    """Whether integration failed because B tends to zero faster than the time step can resolve.

    Parameters
    ----------
    integrator : ModeIntegrator
    numbers : ContactNumbers
        At `state`.
    state : array (size,)
    """
    response = normal_response(integrator, numbers, state)
    mobility = numbers.mobility
    least = _JAMMING * float(mobility.gamma @ mobility.A @ mobility.gamma)
    return bool(np.isfinite(state).all()) and response < least


def state_after_jam(
    integrator: ModeIntegrator,
    numbers: ContactNumbers,
    state: FloatArray,
    speed: float,
    part: float,
) -> tuple[FloatArray, float] | None:
    """State at which B vanishes, and the time until then; None if B does not decrease.

    B ∝ √(T − t) gives the remaining time T − t = B/(2|Ḃ|), and ∫N dt with N ∝ 1/B is twice the
    present N times T − t.  So a quantity that is changed by the force changes by twice its present
    rate times the remaining time.

    Parameters
    ----------
    integrator : ModeIntegrator
    numbers : ContactNumbers
        At `state`.
    state : array (size,)
    speed : float
        A typical speed (m/s).
    part : float
        1, or 2 for a B that is negative by as much as it was positive.
    """
    response = normal_response(integrator, numbers, state)
    rates = integrator.rates(state)
    short = 1e-9 * speed / float(np.linalg.norm(rates[VELOCITY]))
    later = normal_response(integrator, numbers, state + short * rates)
    if not 0 < later < response < math.inf:
        return None
    lasting = 0.5 * response * short / (response - later)
    pushed = 2 * part * lasting * rates
    pushed[: VELOCITY.start] = lasting * rates[: VELOCITY.start]
    pushed[OMEGA.stop : WORK] = lasting * rates[OMEGA.stop : WORK]
    return state + pushed, lasting


def normal_response(
    integrator: ModeIntegrator, numbers: ContactNumbers, state: FloatArray
) -> float:
    """B at a state; infinite in a mode whose friction is not proportional to the normal force.

    Parameters
    ----------
    integrator : ModeIntegrator
    numbers : ContactNumbers
        At `state`.
    state : array (size,)
    """
    names = [guard.name for guard in integrator.system.guards]
    if "paradox" not in names:
        return math.inf
    margin = float(integrator.guard_values(state)[names.index("paradox")])
    mobility = numbers.mobility
    return margin + JAM * float(mobility.gamma @ mobility.A @ mobility.gamma)
