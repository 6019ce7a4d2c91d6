"""The response of a contact, per unit of normal impulse, to the friction force alone.

The spin couple is eliminated: while the spin has a sign, the couple has its limiting value; while
the spin is zero, it has the value that holds the spin.  The remaining response is linear in the
tangential friction force f, and is the same for impulses (impact) and forces (lasting contact).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flowlanes.system.arrays import FloatArray

from .mobility import Mobility


@dataclass(frozen=True, eq=False)
class FrictionResponse:
    """Rates per unit of normal impulse after elimination of the spin couple; linear in f.

    Every rate consists of a constant and a coefficient of f, the tangential friction force per unit
    of normal impulse.

    Attributes
    ----------
    tangential : (2,) array and (2, 2) array
        Of the tangential velocity: β + A f.
    spin : float and (2,) array
        Of the spin.
    normal : float and (2,) array
        Of the normal velocity.
    couple : float and (2,) array
        The spin couple itself.
    """

    tangential: tuple[FloatArray, FloatArray]
    spin: tuple[float, FloatArray]
    normal: tuple[float, FloatArray]
    couple: tuple[float, FloatArray]


def response_while_spinning(
    mobility: Mobility, couple: float, resistance: FloatArray | None = None
) -> FrictionResponse:
    """The rates for a given spin couple per unit of normal impulse.

    Parameters
    ----------
    mobility : Mobility
    couple : float
        −μ_s while the spin is positive, μ_s while it is negative, 0 without a law of spin friction.
    resistance : (3,) array, optional
        Further couple per unit of normal impulse, as of resistance to rolling; body axes.
    """
    t, A, c = mobility.tangents, mobility.A, mobility.spin_force
    gamma, zero = mobility.gamma, np.zeros(2)
    normal = A @ gamma
    turn = mobility.inverse_inertia @ (np.zeros(3) if resistance is None else resistance)
    given = normal + couple * c + np.cross(turn, mobility.r)
    return FrictionResponse(
        tangential=(t @ given, t @ A @ t.T),
        spin=(float(c @ gamma + couple * mobility.spin + gamma @ turn), t @ c),
        normal=(float(gamma @ given), t @ normal),
        couple=(couple, zero),
    )


def response_with_spin_at_rest(
    mobility: Mobility, resistance: FloatArray | None = None
) -> FrictionResponse:
    """The rates for the spin couple that keeps the spin at zero (a Schur complement)."""
    free = response_while_spinning(mobility, 0.0, resistance)
    c, sigma = mobility.spin_force, mobility.spin
    constant, slope = free.spin
    lift = float(c @ mobility.gamma) / sigma
    return FrictionResponse(
        tangential=(
            free.tangential[0] - slope * constant / sigma,
            free.tangential[1] - np.outer(slope, slope) / sigma,
        ),
        spin=(0.0, np.zeros(2)),
        normal=(free.normal[0] - lift * constant, free.normal[1] - lift * slope),
        couple=(-constant / sigma, -slope / sigma),
    )


def least_motion_force(A: FloatArray, free: FloatArray, limit: float) -> FloatArray:
    """The force f with |f| ≤ limit that minimises the motion free + A f.

    It is the minimum of ½(f, A f) + (free, f) over the disk, with A symmetric and positive definite
    (2, 2).  If possible it holds the contact (free + A f = 0); otherwise it opposes the remaining
    motion, free + A f = −λ f with λ > 0.  This is how a contact at rest begins to slide.

    Parameters
    ----------
    A : (2, 2) array
    free : (2,) array
        The rate of the tangential velocity without friction.
    limit : float
        May be infinite.
    """
    held = _solution(A, -free)
    size = float(np.hypot(*held))
    if size <= limit:
        return held
    if limit == 0:
        return np.zeros(2)
    moments, axes = np.linalg.eigh(A)
    components = axes.T @ free
    # Trust-region subproblem (J. J. Moré, D. C. Sorensen, SIAM J. Sci. Stat. Comput. 4 (1983) 553):
    # 1/|f| is concave and nearly linear in λ, so that Newton's method for 1/|f| = 1/limit rises
    # monotonically from λ = 0 to the root.
    shift = 0.0
    for _ in range(60):
        force = components / (moments + shift)
        length = float(np.hypot(*force))
        step = (length - limit) / limit * length**2 / float(force**2 @ (1 / (moments + shift)))
        shift += step
        if abs(step) <= 1e-15 * shift:
            break
    force = -components / (moments + shift)
    result: FloatArray = axes @ force * (limit / float(np.hypot(*force)))
    return result


def sticking_force(response: FrictionResponse) -> FloatArray:
    """The friction (2,) per normal impulse that keeps the tangential velocity constant."""
    beta, A = response.tangential
    return _solution(A, -beta)


def _solution(A: FloatArray, right: FloatArray) -> FloatArray:
    determinant = A[0, 0] * A[1, 1] - A[0, 1] * A[1, 0]
    adjugate = np.array([[A[1, 1], -A[0, 1]], [-A[1, 0], A[0, 0]]])
    result: FloatArray = adjugate @ right / determinant
    return result


def least_motion(mobility: Mobility, mu: float, spin_arm: float) -> tuple[FloatArray, float]:
    """Friction force (2,) and couple per normal impulse that minimise the motion from rest.

    The pair (f, τ) in the cylinder |f| ≤ μ, |τ| ≤ μ_s that minimises the motion in the metric of
    the kinetic energy.  It is unique, since a strictly convex function is minimised.

    Parameters
    ----------
    mobility : Mobility
    mu : float
        Coefficient of friction; may be infinite.
    spin_arm : float
        Greatest spin couple per normal force (a length).
    """
    for sign in (1, -1):
        # whether the spin becomes positive (or negative) even against the full couple
        against = response_while_spinning(mobility, -sign * spin_arm)
        force = least_motion_force(against.tangential[1], against.tangential[0], mu)
        if sign * (against.spin[0] + against.spin[1] @ force) > 0:
            return force, -sign * spin_arm
    held = response_with_spin_at_rest(mobility)
    force = least_motion_force(held.tangential[1], held.tangential[0], mu)
    return force, held.couple[0] + float(held.couple[1] @ force)
