"""Impact with friction: the contact is followed through the collision, over the normal impulse.

After Routh (1860) and Keller (1986): during an impact positions are constant, and the contact
velocity changes with the impulse P of the normal force,

    d(u, Ω, u_n)/dP = 𝒜 (f, τ, 1),

where 𝒜 is the mobility of (tangent plane, spin, normal), f = −μ u/|u| and τ = −μ_s sgn Ω.  The slip
may turn, stop, reverse or give way to sticking.  In the metric 𝒜⁻¹, (u, Ω) follows the descent of a
convex function, so the motion is unique and depends continuously on its start.  Since 𝒜 is positive
definite, the normal velocity rises in the end, and every impact ends.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from .friction_response import response_while_spinning
from .impact_course import ImpactCourse, ImpactPhase
from .impact_law import ImpactLaw
from .impact_slide import SlidingFriction
from .mobility import Mobility

#: Relative energy gain (compared with impulse times velocity) that is attributed to rounding.
ENERGY_ROUNDING = 1e-13


@dataclass(frozen=True, eq=False)
class Impact:
    """The result of an impact of a body, in body axes.

    Attributes
    ----------
    impulse : (3,) array
        Impulse J of normal force and friction.
    couple_impulse : float
        Impulse K of the couple about the normal.
    velocity_jump : (3,) array
        J/m, the velocity change of the centre of mass.
    angular_velocity_jump : (3,) array
        I⁻¹(r×J + Kγ).
    contact_velocity : (3,) array
        Of the touching particle relative to the support, after the impact; exactly without
        tangential part if the impact ended sticking.
    spin : float
        (ω, γ) relative to the support, after the impact; exactly 0 if it ended held.
    compression_impulse, normal_impulse : float
        Normal impulse while the bodies approach, and in total.
    energy_lost : float
        Kinetic energy lost, in the frame of the support.
    energy_grew : bool
        Whether energy was gained beyond rounding, as Newton's law allows.
    phases : tuple of ImpactPhase
        The phases of the contact, in order.
    """

    impulse: FloatArray
    couple_impulse: float
    velocity_jump: FloatArray
    angular_velocity_jump: FloatArray
    contact_velocity: FloatArray
    spin: float
    compression_impulse: float
    normal_impulse: float
    energy_lost: float
    energy_grew: bool
    phases: tuple[ImpactPhase, ...]


def impact(
    mobility: Mobility,
    velocity: npt.ArrayLike,
    spin: float = 0.0,
    *,
    mu: float,
    spin_arm: float = 0.0,
    viscous: float = 0.0,
    order: float = 1.0,
    force: sp.Expr | None = None,
    restitution: float = 0.0,
    law: ImpactLaw = "stronge",
) -> Impact:
    """The impact of a body on its support with friction at a point.

    A contact that slides without approaching (normal velocity 0) suffers an impact without
    collision if B = (γ, A(γ + p)) + τ(γ, c) is negative (Painlevé), and no impulse otherwise.

    Parameters
    ----------
    mobility : Mobility
    velocity : (3,) array
        Of the touching particle relative to the support, body axes; it must not recede.
    spin : float
        (ω, γ) relative to the support.
    mu : float
        Coefficient of friction; infinite for the limit μ → ∞, in which the sliding is stopped
        before any normal impulse, or the friction of stopping it lifts the body off.
    spin_arm : float
        Greatest couple of spin friction per normal force (a length).
    viscous, order : float
        ν and p of the friction ν|u|ᵖ per normal force, besides μ.
    force : sympy.Expr, optional
        Friction per normal force as a formula in the slip speed, in place of μ, its limit at rest.
    restitution : float
        Between 0 and 1.
    law : str
        Definition of the coefficient of restitution e: e² is the fraction of the work of
        compression that is given back (`stronge`, never gains energy), or e is the ratio of normal
        impulses (`poisson`) or of normal velocities (`newton`). Where sliding that turns compresses
        the contact a second time, work and impulse of both compressions count.

    Returns
    -------
    Impact

    Raises
    ------
    InputError
        If a number is out of its range, or the bodies recede from each other.

    Examples
    --------
    A ball that falls on rough ground without turning over rolls off with 5/7 of its velocity.

    >>> from nonholonomic.contact.impact.impact import impact
    >>> from nonholonomic.contact.impact.mobility import mobility
    >>> ball = mobility(1.0, [0.4, 0.4, 0.4], [0, 0, -1], [0, 0, 1])
    >>> result = impact(ball, [0.7, 0, -1], mu=0.5)
    >>> result.impulse.round(12).tolist()
    [-0.2, 0.0, 1.0]
    >>> [phase.mode for phase in result.phases]
    ['sliding', 'sticking']
    """
    u = _checked_input(velocity, spin, mu, spin_arm, restitution, law)
    friction_law = _sliding_friction(mu, viscous, order, force)
    approach = float(mobility.gamma @ u)
    scale = float(np.linalg.norm(u))
    if approach > 1e-14 * scale:
        raise InputError(
            f"normal velocity {approach}: the contact recedes, an impact needs one that does not"
        )
    tangents = mobility.tangents
    course = ImpactCourse(
        mobility,
        friction_law,
        spin_arm,
        tangents @ u,
        float(spin),
        min(approach, 0.0),
        restitution,
        law,
    )
    course.run()
    friction = course.friction @ tangents
    impulse = course.normal_impulse * mobility.gamma + friction
    couple = course.couple_impulse
    after = course.slip @ tangents + course.normal * mobility.gamma
    # Kelvin's theorem: kinetic energy grows by impulse times mean velocity, ½(J, u + u′).  So a
    # small loss is not computed as a difference of large energies.
    gain = float(impulse @ (u + after) + couple * (spin + course.spin)) / 2
    force = float(np.linalg.norm(impulse) * (scale + np.linalg.norm(after)))
    terms = force + abs(couple) * (abs(spin) + abs(course.spin))
    return Impact(
        impulse=impulse,
        couple_impulse=couple,
        velocity_jump=mobility.velocity_jump(impulse),
        angular_velocity_jump=mobility.angular_velocity_jump(impulse, couple),
        contact_velocity=after,
        spin=course.spin,
        compression_impulse=course.compression_impulse,
        normal_impulse=course.normal_impulse,
        energy_lost=-gain,
        energy_grew=bool(gain > ENERGY_ROUNDING * terms),
        phases=tuple(course.phases),
    )


def normal_response(
    mobility: Mobility, direction: npt.ArrayLike | None, mu: float, couple: float = 0.0
) -> float:
    """B: the change of the normal velocity per normal impulse while the contact slides.

    Parameters
    ----------
    mobility : Mobility
    direction : (3,) array or None
        Direction of sliding, of any length; None without friction.
    mu : float
    couple : float
        Spin couple per normal force: −μ_s sgn Ω.
    """
    response = response_while_spinning(mobility, couple)
    if direction is None:
        return response.normal[0]
    tangential = mobility.tangents @ np.asarray(direction, dtype=float)
    e = tangential / np.hypot(*tangential)
    return response.normal[0] - mu * float(response.normal[1] @ e)


def _sliding_friction(
    mu: float, viscous: float, order: float, force: sp.Expr | None
) -> SlidingFriction:
    if not (0 <= viscous < np.inf and 0 < order < np.inf):
        raise InputError(
            f"viscous {viscous}, order {order}: the first must be zero or positive and finite, the "
            "second positive and finite"
        )
    return SlidingFriction(mu, viscous, order, force)


def _checked_input(
    velocity: npt.ArrayLike,
    spin: float,
    mu: float,
    spin_arm: float,
    restitution: float,
    law: str,
) -> FloatArray:
    u = np.asarray(velocity, dtype=float)
    if u.shape != (3,) or not np.isfinite(u).all() or not np.isfinite(spin):
        raise InputError(f"velocity {u.tolist()}, spin {spin}: three finite numbers and one")
    if not mu >= 0:
        raise InputError(f"mu {mu}: it must be zero, positive or inf")
    if not 0 <= spin_arm < np.inf:
        raise InputError(f"spin_arm {spin_arm}: it must be zero or a positive finite number")
    if not 0 <= restitution <= 1:
        raise InputError(f"restitution {restitution}: it must lie between 0 and 1")
    if law not in ("stronge", "poisson", "newton"):
        raise InputError(f"impact law '{law}'; allowed: stronge, poisson, newton")
    return u
