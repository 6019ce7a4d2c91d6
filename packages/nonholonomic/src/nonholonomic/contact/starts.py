"""Initial states of motions with friction: in contact or above the support.

A start gives either the normal γ, ω and the slip of a body that touches its support
(`state_in_contact`), or the position, attitude and velocities of a body anywhere
(`state_in_space`).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import mpmath
import numpy as np

from flowlanes.arguments import Finite, arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ..mechanics.rolling.initial_state import DIGITS, attitude_of_normal
from .equations.situation import FrictionalContact
from .nearest_point import nearest_normal

#: Relative error allowed in the conditions on a start, whose numbers are decimals: the height above
#: the support, the normal velocity, and the slip along the normal or where no slip is allowed.
SLACK = 1e-9


@dataclass(frozen=True, eq=False)
class Clearance:
    """The position of a body relative to its support.

    Attributes
    ----------
    gap : float
        Distance from the support (m), negative if the body lies in it.
    gamma : array (3,)
        Outward normal of the support at its nearest point, body axes.
    r : array (3,)
        From the centre of mass to the nearest point of the body, body axes (m).
    """

    gap: float
    gamma: FloatArray
    r: FloatArray


def clearance(
    contact: FrictionalContact,
    position: Sequence[float] | FloatArray,
    attitude: Sequence[float] | FloatArray,
) -> Clearance:
    """The position of a body relative to its support.

    Parameters
    ----------
    contact : FrictionalContact
    position : 3 floats
        Centre of mass, space axes (m).
    attitude : 4 floats
        Quaternion w, x, y, z from body to space axes; of any length but zero.

    Raises
    ------
    InputError
        If on a sphere no nearest point is found.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.contact import FrictionalContact
    >>> from nonholonomic.contact.starts import clearance
    >>> ball = FrictionalContact(nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0)))
    >>> clearance(ball, (0.0, 0.0, 1.5), (1.0, 0.0, 0.0, 0.0)).gap
    0.5
    """
    turn = _rotation(attitude)
    shape, surface = contact.body.shape, contact.surface
    seen = turn.T @ np.array(position, dtype=float)
    if surface.is_flat:
        gamma = turn[2]
        r = _touching_point(contact, gamma)
        return Clearance(float(gamma @ (seen + r)), gamma, r)
    radius = surface.signed_radius or 0.0
    gamma = nearest_normal(shape.contact_points(), seen, radius > 0 and not shape.hollow)
    r = _touching_point(contact, gamma)
    return Clearance(float(gamma @ (seen + r)) - radius, gamma, r)


@arguments_checked
def state_in_contact(
    contact: FrictionalContact,
    omega: Sequence[float],
    gamma: Sequence[float],
    slip: Sequence[float] = (0.0, 0.0, 0.0),
    *,
    heading: Finite = 0.0,
    normal: Sequence[float] = (0.0, 0.0, 1.0),
) -> FloatArray:
    """The state of a body that touches its support, with given normal, ω and slip.

    On a plane the contact is at the origin of space.

    Parameters
    ----------
    contact : FrictionalContact
    omega : 3 floats
        Angular velocity, body axes (rad/s).
    gamma : 3 floats
        Outward normal of the support at the contact, body axes; of any length but zero.
    slip : 3 floats
        Velocity of the touching particle of the body over the support, body axes (m/s).
    heading : float
        Angle (rad) by which the body is turned about the normal, from the attitude that takes γ
        to `normal` along the shortest way.
    normal : 3 floats
        The normal in space axes; (0, 0, 1) on a plane.

    Returns
    -------
    array (size,)
        The state, no work lost.

    Raises
    ------
    InputError
        If a vector is unusable, the slip is not tangential, or friction without limit forbids it.
    """
    spin, up = _checked_vector(omega, "omega"), _direction(gamma, "gamma")
    way, above = _checked_vector(slip, "slip"), _direction(normal, "normal")
    surface = contact.surface
    if surface.is_flat and not np.array_equal(above, [0, 0, 1]):
        raise InputError("normal: on a plane it is always (0, 0, 1)")
    across = float(way @ up)
    tangential = way - across * up
    if abs(across) > SLACK * math.hypot(*way):
        raise InputError(
            f"slip: (slip, gamma) = {across:.6g}, and a body in contact slips along the support "
            f"alone; the nearest admissible slip is {_vector_text(tangential)}"
        )
    if contact.never_slips and np.any(tangential):
        raise InputError("slip: with mu = inf the contact cannot slip; it must be zero")
    with mpmath.workdps(DIGITS):
        first, last = ([mpmath.mpf(float(x)) for x in u] for u in (up, above))
        numbers = attitude_of_normal(first, last, mpmath.mpf(heading))
        attitude = np.array([float(x) for x in numbers])
    turn = _rotation(attitude)
    r = _touching_point(contact, up)
    if not np.isfinite(r).all():
        raise InputError("gamma: no single point of the body touches a support with this normal")
    touching = (surface.signed_radius or 0.0) * above
    velocity = tangential - np.cross(spin, r) + turn.T @ _support_velocity(contact, touching)
    return _assembled_state(contact, attitude, touching - turn @ r, velocity, spin, up, r)


@arguments_checked
def state_in_space(
    contact: FrictionalContact,
    position: Sequence[float],
    attitude: Sequence[float],
    velocity: Sequence[float],
    omega: Sequence[float],
) -> FloatArray:
    """The state of a body in contact with its support or above it.

    A body nearer to the support than 1e-9 of its size is put on it.

    Parameters
    ----------
    contact : FrictionalContact
    position : 3 floats
        Centre of mass, space axes (m).
    attitude : 4 floats
        Quaternion w, x, y, z from body to space axes; of any length but zero.
    velocity : 3 floats
        Of the centre of mass, space axes (m/s).
    omega : 3 floats
        Angular velocity, body axes (rad/s).

    Returns
    -------
    array (size,)
        The state, no work lost.

    Raises
    ------
    InputError
        If a vector is unusable, the body lies in the support, or it slips where friction has no
        limit.
    """
    place, moving = _checked_vector(position, "position"), _checked_vector(velocity, "velocity")
    spin = _checked_vector(omega, "omega")
    turned = _numbers(attitude, "attitude", 4)
    if not turned.any():
        raise InputError("attitude is zero: a quaternion of a rotation has a length")
    turned = turned / math.hypot(*turned)
    turn = _rotation(turned)
    known = clearance(contact, place, turned)
    size = float(np.linalg.norm(known.r))
    if known.gap < -SLACK * size:
        raise InputError(
            f"position: the body lies {-known.gap:.6g} m inside the support; move it outwards by "
            "at least that much"
        )
    if not np.isfinite(known.r).all():
        raise InputError("attitude: no single point of the body is the nearest to the support")
    v = turn.T @ moving
    if known.gap <= SLACK * size:
        place = place - known.gap * (turn @ known.gamma)
        support = turn.T @ _support_velocity(contact, place + turn @ known.r)
        v = _in_contact(contact, v, np.cross(spin, known.r), known.gamma, support)
    return _assembled_state(contact, turned, place, v, spin, known.gamma, known.r)


def _in_contact(
    contact: FrictionalContact,
    v: FloatArray,
    turning: FloatArray,
    gamma: FloatArray,
    support: FloatArray,
) -> FloatArray:
    """The velocity v in contact, corrected for decimal errors along the normal or in the slip.

    `turning` is ω×r, `support` the velocity of the support.
    """
    size = SLACK * float(np.linalg.norm(v) + np.linalg.norm(turning) + np.linalg.norm(support))
    normal = float(gamma @ (v + turning))
    if abs(normal) > size:
        return v
    v = v - normal * gamma
    if not contact.never_slips:
        return v
    slip = v + turning - support
    speed = float(np.linalg.norm(slip))
    if speed > size:
        raise InputError(
            f"velocity: the contact would slip with {speed:.6g} m/s, and with mu = inf it cannot"
        )
    return v - slip


def _touching_point(contact: FrictionalContact, gamma: FloatArray) -> FloatArray:
    """The point of the body with outward normal −γ; NaN if a whole flat face has it."""
    with np.errstate(invalid="ignore", divide="ignore"):
        r: FloatArray = contact.body.shape.contact_points()(gamma[None])[0]
    return r


def _support_velocity(contact: FrictionalContact, touching: FloatArray) -> FloatArray:
    """Velocity of the support at a point, space axes."""
    return np.cross([0.0, 0.0, contact.surface.turntable], touching)


def _assembled_state(
    contact: FrictionalContact,
    attitude: FloatArray,
    position: FloatArray,
    v: FloatArray,
    omega: FloatArray,
    gamma: FloatArray,
    r: FloatArray,
) -> FloatArray:
    """The components of a state in their order."""
    works = 1 + bool(contact.surface.turntable) + len(contact.laws)
    clocks = sum(len(law.clocks) for law in contact.laws)
    contact_columns = r if contact.body.shape.by_equation else gamma
    return np.concatenate([attitude, position, v, omega, contact_columns, np.zeros(works + clocks)])


def _rotation(attitude: Sequence[float] | FloatArray) -> FloatArray:
    """The rotation matrix from body to space components."""
    from scipy.spatial.transform import Rotation

    w, x, y, z = attitude
    matrix: FloatArray = Rotation.from_quat([x, y, z, w]).as_matrix()
    return matrix


def _numbers(values: Sequence[float], name: str, count: int) -> FloatArray:
    words = {3: "three", 4: "four"}[count]
    if len(values) != count:
        raise InputError(f"{name}: {words} numbers are needed, not {len(values)}")
    numbers = np.array([float(x) for x in values])
    if not np.isfinite(numbers).all():
        raise InputError(f"{name} {tuple(values)}: all {words} numbers must be finite")
    return numbers


def _checked_vector(values: Sequence[float], name: str) -> FloatArray:
    return _numbers(values, name, 3)


def _direction(values: Sequence[float], name: str) -> FloatArray:
    vector = _checked_vector(values, name)
    if not vector.any():
        raise InputError(f"{name} is zero: it must point along the normal")
    # Scale first, so that nothing overflows.
    vector = vector / np.abs(vector).max()
    unit: FloatArray = vector / np.linalg.norm(vector)
    return unit


def _vector_text(vector: FloatArray) -> str:
    return f"[{', '.join(repr(float(x)) for x in vector)}]"
