"""Slip near zero: its rates while everything but its direction is held constant.

Near the end or the start of sliding, the slip x = s n has a small magnitude s, while its direction
n matters at every magnitude.  With the rest of the state constant its rate X depends on n alone,
and

    ẋ = X(n),   ṡ = H = (n, X),   s ṅ = G = X − H n,

where the normal force N(n) follows from the condition that the contact lasts.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Protocol

import numpy as np

from flowlanes.system.arrays import FloatArray

from ..impact.friction_response import (
    FrictionResponse,
    response_while_spinning,
    response_with_spin_at_rest,
)
from ..impact.mobility import Mobility


class FrozenSlip(Protocol):
    """A friction law near zero slip, with everything constant except the direction of the slip."""

    def force(self, n: FloatArray) -> tuple[float, FloatArray, float]:
        """Normal force, friction force (2,) and couple for the slip direction n."""
        ...

    def rate(self, n: FloatArray) -> FloatArray:
        """X(n): the rate of the slip."""
        ...


def growth_and_turning(slip: FrozenSlip, n: FloatArray) -> tuple[float, FloatArray]:
    """H = (n, X), the growth of the slip, and G = X − H n, its turning."""
    rate = slip.rate(n)
    growth = float(n @ rate)
    return growth, rate - growth * n


@dataclass(frozen=True, eq=False)
class PointSlip:
    """Coulomb friction at a point: n is a tangential direction, along the tangents of the mobility.

    Attributes
    ----------
    response : FrictionResponse
    mu : float
    tangential : (2,) array
        Acceleration of the contact without contact force, along the tangents.
    normal : float
        b_n, the normal acceleration of the contact without contact force.
    couple : float
        Part of the spin couple that is independent of the normal force.
    """

    response: FrictionResponse
    mu: float
    tangential: FloatArray
    normal: float
    couple: float = 0.0

    def force(self, n: FloatArray) -> tuple[float, FloatArray, float]:
        """Normal force, friction force (2,) and couple for the slip direction n."""
        friction = -self.mu * n
        response = self.response
        # The contact lasts: the normal acceleration b_n + N (…) with the friction −μN n vanishes.
        pressure = -self.normal / (response.normal[0] + float(response.normal[1] @ friction))
        couple = response.couple[0] + float(response.couple[1] @ friction)
        return pressure, pressure * friction, pressure * couple + self.couple

    def rate(self, n: FloatArray) -> FloatArray:
        """X(n): the rate of the slip."""
        pressure, friction, _ = self.force(n)
        beta, A = self.response.tangential
        return self.tangential + pressure * beta + A @ friction


def point_slip(
    mobility: Mobility,
    acceleration: FloatArray,
    mu: float,
    couple: float = 0.0,
    resistance: FloatArray | None = None,
) -> PointSlip:
    """Slip under Coulomb friction while the spin has a sign, or without spin friction.

    Parameters
    ----------
    mobility : Mobility
    acceleration : (3,) array
        Acceleration b of the contact without contact force, body axes; its normal part is b_n.
    mu : float
    couple : float
        Spin couple per normal force: −μ_s sgn Ω.
    resistance : (3,) array, optional
        Further couple per normal force, as of resistance to rolling; body axes.
    """
    response = response_while_spinning(mobility, couple, resistance)
    normal = float(mobility.gamma @ acceleration)
    return PointSlip(response, mu, mobility.tangents @ acceleration, normal)


def point_slip_with_spin_at_rest(
    mobility: Mobility,
    acceleration: FloatArray,
    spin_acceleration: float,
    mu: float,
    resistance: FloatArray | None = None,
) -> PointSlip:
    """Slip under Coulomb friction while a spin friction couple holds the spin at zero.

    The couple has a part proportional to the normal force, and a part −b_Ω/σ.

    Parameters
    ----------
    mobility, acceleration, mu, resistance
        As of :func:`point_slip`.
    spin_acceleration : float
        b_Ω: acceleration of the spin without contact force.
    """
    holding = -spin_acceleration / mobility.spin
    held = acceleration + holding * mobility.spin_force
    response = response_with_spin_at_rest(mobility, resistance)
    return PointSlip(response, mu, mobility.tangents @ held, float(mobility.gamma @ held), holding)


@dataclass(frozen=True, eq=False)
class CoupledSlip:
    """Coupled sliding and spinning on a round patch: n is on the unit sphere of slips (u₁, u₂, aΩ).

    Attributes
    ----------
    mobility : Mobility
    mu, patch : float
        Coefficient of friction, and radius a of the patch.
    force_factor, couple_factor : callable
        𝓕(k) and 𝓜(k), k = |u|/(a|Ω|) in [0, ∞]: the friction force is μN𝓕 against the sliding,
        the couple μNa𝓜 against the spin.
    acceleration : (3,) array
        Acceleration b of the contact without contact force, body axes; its normal part is b_n.
    spin_acceleration : float
        b_Ω, the acceleration of the spin without contact force.
    resistance : (3,) array
        Further couple per normal force, as of resistance to rolling; body axes.
    """

    mobility: Mobility
    mu: float
    patch: float
    force_factor: Callable[[float], float]
    couple_factor: Callable[[float], float]
    acceleration: FloatArray
    spin_acceleration: float = 0.0
    resistance: FloatArray = field(default_factory=lambda: np.zeros(3))

    def force(self, n: FloatArray) -> tuple[float, FloatArray, float]:
        """Normal force, friction force (2,) and couple for the slip direction n."""
        sliding = float(np.hypot(n[0], n[1]))
        k = sliding / abs(n[2]) if n[2] else np.inf
        friction = np.zeros(2)
        if sliding:
            friction = -self.mu * float(self.force_factor(k)) / sliding * n[:2]
        couple = 0.0
        if n[2]:
            sign = float(np.sign(n[2]))
            couple = -self.mu * self.patch * sign * float(self.couple_factor(k))
        row = self.matrix[2]
        lift = float(row[:2] @ friction) + row[2] + row[3] * couple
        pressure = -self.free[2] / lift
        return pressure, pressure * friction, pressure * couple

    def rate(self, n: FloatArray) -> FloatArray:
        """X(n): the rate of the slip."""
        pressure, friction, couple = self.force(n)
        rate = self.free + self.matrix @ np.array([*friction, pressure, couple])
        return np.array([rate[0], rate[1], self.patch * rate[3]])

    @cached_property
    def matrix(self) -> FloatArray:
        """The mobility (4, 4) of tangents, normal (including the additional couple) and spin."""
        m = self.mobility
        axes = np.vstack([m.tangents, m.gamma])
        c = axes @ m.spin_force
        result = np.block([[axes @ m.A @ axes.T, c[:, None]], [c, np.array([m.spin])]])
        turn = m.inverse_inertia @ self.resistance
        result[:, 2] += np.append(axes @ np.cross(turn, m.r), m.gamma @ turn)
        return result

    @cached_property
    def free(self) -> FloatArray:
        """Accelerations (4,) of tangents, normal and spin without contact force."""
        axes = np.vstack([self.mobility.tangents, self.mobility.gamma])
        return np.append(axes @ self.acceleration, self.spin_acceleration)
