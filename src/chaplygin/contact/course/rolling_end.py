"""The end of rolling under its resistance: whether it lasts, or rolling begins again at once.

Near its end rolling has a small angular velocity ω_t = s n.  With the rest of the state constant
its rate X depends on n alone, as the resistance does: rolling begins again along a direction n
with X(n) = H n, H > 0, and ends for good where there is none.
"""

from __future__ import annotations

import math

import numpy as np

from ...core.arrays import FloatArray
from .compiled import OMEGA, VELOCITY, ContactNumbers
from .mode_integrator import ModeIntegrator

#: Directions from which one is looked for that keeps itself, and steps of the search.
_STARTS, _STEPS = 8, 200

#: A direction keeps itself to this accuracy.
_ACCURACY = 1e-9


def state_with_rolling(
    numbers: ContactNumbers, state: FloatArray, rolling: FloatArray, slips: bool
) -> FloatArray:
    """The state with another angular velocity of rolling, the slip unchanged.

    Parameters
    ----------
    numbers : ContactNumbers
        At `state`.
    state : array (size,)
    rolling : array (3,)
        ω_t, body axes.
    slips : bool
        Whether the velocity of the centre of mass is left alone, and not the slip.
    """
    result = state.copy()
    change = rolling - numbers.rolling
    result[OMEGA] += change
    jump = np.cross(change, numbers.r)
    result[VELOCITY] -= (jump @ numbers.gamma) * numbers.gamma if slips else jump
    return result


def rolling_rate(numbers: ContactNumbers, turning: FloatArray) -> FloatArray:
    """Rate (3,) of the angular velocity over the support, with a rate of ω; it is Ω̇ along γ.

    The part along the support is the rate of ω_t where that is small.

    Parameters
    ----------
    numbers : ContactNumbers
    turning : array (3,)
        ω̇.
    """
    return turning - numbers.support_turn_rate - numbers.spin * numbers.gammadot


def rolling_restart(
    integrator: ModeIntegrator,
    numbers: ContactNumbers,
    state: FloatArray,
    size: float,
    slips: bool,
) -> tuple[FloatArray, float] | None:
    """Direction (3,) and rate H > 0 with which rolling begins again; None if it has ended.

    Parameters
    ----------
    integrator : ModeIntegrator
        Of the mode with rolling.
    numbers : ContactNumbers
        At `state`.
    state : array (size,)
    size : float
        An angular velocity that is small (rad/s).
    slips : bool
        Whether the contact slides.
    """
    tangents = numbers.mobility.tangents

    def rate(n: FloatArray) -> FloatArray:
        there = state_with_rolling(numbers, state, size * (n @ tangents), slips)
        turning = integrator.rates(there)[OMEGA]
        return tangents @ rolling_rate(numbers, turning)

    for angle in 2 * math.pi * np.arange(_STARTS) / _STARTS:
        n = np.array([math.cos(angle), math.sin(angle)])
        for _ in range(_STEPS):
            X = rate(n)
            length = float(np.hypot(*X))
            if not length:
                break
            aim = X / length
            if float(np.abs(aim - n).max()) <= _ACCURACY:
                return n @ tangents, length
            n = n + 0.7 * (aim - n)
            norm = float(np.hypot(*n))
            if norm < 1e-3:
                break
            n = n / norm
    return None
