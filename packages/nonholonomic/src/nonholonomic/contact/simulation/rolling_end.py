"""The end of rolling under its resistance: whether it ends for good or begins again.

Near its end, rolling has a small angular velocity ω_t = s n.  While the rest of the state is held
constant, its rate X depends on n alone, as the resistance does.  Rolling begins again along a
direction n with X(n) = H n and H > 0, and ends for good if there is none.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from flowlanes.system.arrays import FloatArray

from ..friction.prescribed_friction import first_direction_values
from ..impact.mobility import Mobility
from .compiled import OMEGA, VELOCITY, ContactNumbers
from .mode_integrator import ModeIntegrator, with_values

#: Number of angular intervals in which invariant directions of rolling are searched.
_ANGLES = 72

#: Relative accuracy to which a direction must be invariant; rounding allows no better at small
#: angular velocities.
_ACCURACY = 1e-6


def state_with_rolling(
    numbers: ContactNumbers, state: FloatArray, rolling: FloatArray, slips: bool
) -> FloatArray:
    """The state with another angular velocity of rolling and the same slip.

    Parameters
    ----------
    numbers : ContactNumbers
        At `state`.
    state : array (size,)
    rolling : array (3,)
        ω_t, body axes.
    slips : bool
        Whether the velocity of the centre of mass is kept instead of the slip.
    """
    result = state.copy()
    change = rolling - numbers.rolling
    result[OMEGA] += change
    jump = np.cross(change, numbers.r)
    result[VELOCITY] -= (jump @ numbers.gamma) * numbers.gamma if slips else jump
    return result


def rolling_rate(numbers: ContactNumbers, turning: FloatArray) -> FloatArray:
    """Rate (3,) of the angular velocity over the support, given that of ω; along γ it is Ω̇.

    Its tangential part is the rate of ω_t where ω_t is small.

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
    """Direction (3,) and rate H > 0 with which rolling begins again; None if it ends for good.

    For a unit tangent vector n at the angle φ let (h, g) be the components of the rate X(n) along
    n and perpendicular to it.  A direction is invariant if g(φ) = 0.  Sign changes of g from plus
    to minus on a uniform grid of angles are refined by root finding; there nearby directions turn
    towards n.  Among those with h > 0 the largest is taken.  Two zeros within one grid interval
    would be missed.

    Parameters
    ----------
    integrator : ModeIntegrator
        Integrator of the mode with rolling.
    numbers : ContactNumbers
        At `state`.
    state : array (size,)
    size : float
        A small angular velocity (rad/s).
    slips : bool
        Whether the contact slides.
    """
    tangents = numbers.mobility.tangents

    def along_and_across(angle: float) -> tuple[float, float]:
        """Components of the rate along the direction at an angle, and perpendicular to it."""
        n = np.array([math.cos(angle), math.sin(angle)])
        there = state_with_rolling(numbers, state, size * (n @ tangents), slips)
        x, y = tangents @ rolling_rate(numbers, integrator.rates(there)[OMEGA])
        return float(n[0] * x + n[1] * y), float(n[0] * y - n[1] * x)

    def across(angle: float) -> float:
        return along_and_across(angle)[1]

    angles = (2 * math.pi * np.arange(_ANGLES + 1) / _ANGLES).tolist()
    values = [across(angle) for angle in angles]
    found: list[tuple[float, float]] = []
    for angle, after, value, next_value in zip(
        angles[:-1], angles[1:], values[:-1], values[1:], strict=True
    ):
        # Where the sign changes from plus to minus, rolling in nearby directions turns towards the
        # zero.
        if value > 0 >= next_value:
            kept = _root(across, angle, after)
            growth, rest = along_and_across(kept)
            if growth > 0 and abs(rest) <= _ACCURACY * growth:
                found.append((growth, kept))
    if not found:
        return None
    growth, angle = max(found)
    return np.array([math.cos(angle), math.sin(angle)]) @ tangents, growth


def direction_of_couple(
    integrator: ModeIntegrator, state: FloatArray, mobility: Mobility, couple: FloatArray
) -> FloatArray:
    """The direction (3,) of rolling for which the resistance is parallel to a given couple.

    Parameters
    ----------
    integrator : ModeIntegrator
        Integrator of the mode with prescribed direction.
    state : array (size,)
    mobility : Mobility
    couple : array (3,)
    """
    start, tangents = np.append(state, 0.0), mobility.tangents
    wanted = tangents @ couple

    def first(angle: float) -> FloatArray:
        return np.array([math.cos(angle), math.sin(angle)]) @ tangents

    def across(angle: float) -> float:
        values = first_direction_values(first(angle)) | {"duration": 1.0}
        x = tangents @ with_values(integrator, values).outputs(start)["friction_couple"]
        return float(x[0] * wanted[1] - x[1] * wanted[0])

    # The angle between resistance and reversed rolling is less than a right angle.
    middle, half = math.atan2(-wanted[1], -wanted[0]), math.pi / 2
    return first(_root(across, middle - half, middle + half))


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    """The zero of a function between points of opposite sign."""
    # Imported on demand: the import takes longer than most motions.
    from scipy.optimize import brentq

    return float(brentq(function, low, high, xtol=1e-16))
