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
    known: ContactNumbers, state: FloatArray, rolling: FloatArray, slips: bool
) -> FloatArray:
    """The state with another angular velocity of rolling, the slip unchanged.

    Parameters
    ----------
    known : ContactNumbers
        At `state`.
    state : array (size,)
    rolling : array (3,)
        ω_t, body axes.
    slips : bool
        Whether the velocity of the centre of mass is left alone, and not the slip.
    """
    result = state.copy()
    change = rolling - known.rolling
    result[OMEGA] += change
    jump = np.cross(change, known.r)
    result[VELOCITY] -= (jump @ known.gamma) * known.gamma if slips else jump
    return result


def rolling_restart(
    integrator: ModeIntegrator,
    known: ContactNumbers,
    state: FloatArray,
    size: float,
    slips: bool,
) -> tuple[FloatArray, float] | None:
    """Direction (3,) and rate H > 0 with which rolling begins again; None if it has ended.

    Parameters
    ----------
    integrator : ModeIntegrator
        Of the mode with rolling.
    known : ContactNumbers
        At `state`.
    state : array (size,)
    size : float
        An angular velocity that is small (rad/s).
    slips : bool
        Whether the contact slides.
    """
    tangents = known.mobility.tangents
    gammadot = known.gammadot

    def rate(n: FloatArray) -> FloatArray:
        there = state_with_rolling(known, state, size * (n @ tangents), slips)
        turning = integrator.rates(there)[OMEGA]
        gamma = known.gamma
        along = turning - (turning @ gamma) * gamma
        # ω_t changes with γ too, by the spin
        return tangents @ (along - known.spin * gammadot)

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
