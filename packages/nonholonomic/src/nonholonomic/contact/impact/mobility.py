"""The response of a contact's velocity to impulses at the contact."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

#: Tolerance for the unit length of a normal.
UNIT = 1e-10


@dataclass(frozen=True, eq=False)
class Mobility:
    """The change of a body's velocity at its contact per impulse there, all in body axes.

    An impulse J at the contact and an impulsive couple K about the normal change the velocity of
    the touching particle by A J + K c and the spin by (c, J) + σ K.

    Attributes
    ----------
    A : (3, 3) array
        E/m − r̂ I⁻¹ r̂: velocity of the touching particle per impulse there; symmetric, positive.
    spin_force : (3,) array
        c = (I⁻¹γ)×r: spin per impulse, and velocity of the touching particle per couple impulse.
    spin : float
        σ = (γ, I⁻¹γ): spin per couple impulse.
    gamma : (3,) array
        The outward unit normal of the support at the contact.
    mass : float
    inverse_inertia : (3, 3) array
        I⁻¹, I about the centre of mass.
    r : (3,) array
        From the centre of mass to the contact.
    """

    A: FloatArray
    spin_force: FloatArray
    spin: float
    gamma: FloatArray
    mass: float
    inverse_inertia: FloatArray
    r: FloatArray

    @cached_property
    def tangents(self) -> FloatArray:
        """Two unit vectors (2, 3) that span the tangent plane, right-handed with the normal."""
        first = np.zeros(3)
        first[np.argmin(np.abs(self.gamma))] = 1.0
        first -= (first @ self.gamma) * self.gamma
        first /= np.linalg.norm(first)
        return np.array([first, np.cross(self.gamma, first)])

    def velocity_jump(self, impulse: FloatArray) -> FloatArray:
        """J/m (3,): how an impulse J at the contact changes the velocity of the centre of mass."""
        return impulse / self.mass

    def angular_velocity_jump(self, impulse: FloatArray, couple_impulse: float) -> FloatArray:
        """I⁻¹(r×J + Kγ) (3,): how an impulse and a couple impulse change the angular velocity."""
        moment = np.cross(self.r, impulse) + couple_impulse * self.gamma
        jump: FloatArray = self.inverse_inertia @ moment
        return jump


def mobility(
    mass: float,
    inertia_tensor: npt.ArrayLike,
    r: npt.ArrayLike,
    gamma: npt.ArrayLike,
) -> Mobility:
    """The change of a body's velocity at its contact per impulse there.

    Parameters
    ----------
    mass : float
    inertia_tensor : (3,) or (3, 3) array
        About the centre of mass, body axes; its principal moments, or a symmetric matrix.
    r : (3,) array
        From the centre of mass to the contact, body axes.
    gamma : (3,) array
        The outward unit normal of the support at the contact, body axes.

    Returns
    -------
    Mobility

    Raises
    ------
    InputError
        If the mass or a principal moment of inertia is not positive, the normal is not a unit
        vector or a number is not finite.

    Examples
    --------
    A homogeneous ball: a tangential impulse moves the contact 7/2 times as much as a normal one.

    >>> from nonholonomic.contact.impact.mobility import mobility
    >>> m = mobility(1.0, [0.4, 0.4, 0.4], [0, 0, -1], [0, 0, 1])
    >>> m.A.diagonal().round(12).tolist()
    [3.5, 3.5, 1.0]
    """
    inertia = np.asarray(inertia_tensor, dtype=float)
    inertia = np.diag(inertia) if inertia.shape == (3,) else inertia
    arm, normal = np.asarray(r, dtype=float), np.asarray(gamma, dtype=float)
    if inertia.shape != (3, 3) or arm.shape != (3,) or normal.shape != (3,):
        raise InputError(
            f"tensor of inertia {inertia.shape}, r {arm.shape} and gamma {normal.shape}: the "
            "shapes must be (3, 3), (3,) and (3,)"
        )
    if not (np.isfinite(mass) and all(np.isfinite(a).all() for a in (inertia, arm, normal))):
        raise InputError("mass, tensor of inertia, r and gamma: all numbers must be finite")
    if mass <= 0:
        raise InputError(f"mass {mass}: it must be positive")
    scale = np.abs(inertia).max()
    symmetric = np.abs(inertia - inertia.T).max() <= UNIT * scale
    if not symmetric or np.linalg.eigvalsh(inertia)[0] <= 0:
        raise InputError("tensor of inertia: it must be a symmetric matrix, positive definite")
    if abs(normal @ normal - 1) > UNIT:
        raise InputError(f"gamma of length {np.linalg.norm(normal)}: it must be a unit vector")
    return mobility_at(float(mass), inverse_of(inertia), arm, normal)


def inverse_of(inertia: FloatArray) -> FloatArray:
    """The inverse (3, 3) of a tensor of inertia, symmetric to the last digit."""
    inverse = np.linalg.inv(inertia)
    result: FloatArray = (inverse + inverse.T) / 2
    return result


def mobility_at(
    mass: float, inverse_inertia: FloatArray, r: FloatArray, gamma: FloatArray
) -> Mobility:
    """As :func:`mobility`, without checks of the arguments.

    Parameters
    ----------
    mass : float
    inverse_inertia : (3, 3) array
    r, gamma : (3,) array
    """
    x, y, z = r.tolist()
    hat = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    answer = np.diag([1 / mass] * 3) - hat @ inverse_inertia @ hat
    turn = inverse_inertia @ gamma
    return Mobility(
        A=(answer + answer.T) / 2,
        spin_force=-hat @ turn,
        spin=float(gamma @ turn),
        gamma=gamma,
        mass=mass,
        inverse_inertia=inverse_inertia,
        r=r,
    )
