"""Laws of friction as plain formulas of NumPy, written down apart from the package."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.special import hyp2f1

from nonholonomic.contact.friction.dry_friction import ContensouErismann, Coulomb, SpinFriction
from nonholonomic.contact.friction.friction_law import FrictionLaw
from nonholonomic.contact.friction.rolling_friction import (
    ContourResistance,
    RollingResistance,
    ViscousRolling,
)
from nonholonomic.contact.friction.viscous_friction import NormalViscous, PowerFriction, Viscous


@dataclass(frozen=True)
class ContactState:
    """Slip u, spin, rolling ω_t, normal γ, and the spread W of the body as a matrix."""

    slip: Any
    spin: float
    rolling: Any
    gamma: Any
    spread: Any


def hertz_factors(k: float) -> tuple[float, float]:
    """F and M from the hypergeometric forms for any exponent of the pressure, here 1/2."""
    if k <= 1:
        force = 3 * np.pi / 8 * k * hyp2f1(0.5, -1.0, 2.0, k**2)
        return force, 3 * np.pi / 16 * hyp2f1(0.5, -2.0, 1.0, k**2)
    return hyp2f1(-0.5, 0.5, 2.5, k**-2), hyp2f1(0.5, 0.5, 3.5, k**-2) / (5 * k)


def reaction(law: FrictionLaw, at: ContactState) -> tuple[Any, Any, Any, Any]:
    """Force and couple per normal force, and those without it."""
    u, speed = at.slip, np.linalg.norm(at.slip)
    sign = np.sign(at.spin)
    none = np.zeros(3)
    match law:
        case Coulomb():
            return -law.mu * u / speed, none, none, none
        case SpinFriction():
            return none, -law.arm * sign * at.gamma, none, none
        case ContensouErismann():
            force, couple = hertz_factors(speed / (law.patch * abs(at.spin)))
            q = -law.mu * law.patch * couple * sign * at.gamma
            return -law.mu * force * u / speed, q, none, none
        case Viscous():
            return none, none, -law.coefficient * u, -law.spin * at.spin * at.gamma
        case NormalViscous():
            return -law.coefficient * u, none, none, none
        case PowerFriction():
            return -law.coefficient * speed**law.order * u / speed, none, none, none
        case RollingResistance():
            return none, -law.arm * at.rolling / np.linalg.norm(at.rolling), none, none
        case ViscousRolling():
            return none, -law.coefficient * at.rolling, none, none
        case ContourResistance():
            wandering = -at.spread @ np.cross(at.gamma, at.rolling)
            direction = wandering / np.linalg.norm(wandering)
            return none, -law.coefficient * np.cross(at.gamma, at.spread @ direction), none, none
    raise NotImplementedError(law)
