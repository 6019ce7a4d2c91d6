"""Starts of motions with friction: states in contact or above the support.

A start gives either the normal γ, ω and the slip of a body that touches its support
(`start_in_contact`), or place, attitude and velocities of a body anywhere (`start_in_space`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import mpmath
import numpy as np

from flowlanes.arguments import Finite, arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ..mechanics.rolling.initial_state import DIGITS, attitude_of_normal
from ..mechanics.shapes.gauss_map import contact_points
from ..mechanics.shapes.implicit import Implicit
from ..mechanics.shapes.shapes import Ball, Shape
from ..mechanics.shapes.surfaces import Plane
from .equations.situation import FrictionalContact
from .nearest_point import nearest_normal

#: Relative size of what a start may miss a condition by, since its numbers are decimals: a height
#: over the support, a velocity along the normal, a slip along it or where nothing may slip.
SLACK = 1e-9


@dataclass(frozen=True, eq=False)
class Clearance:
    """The place of a body over its support.

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
    """The place of a body over its support.

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
    if isinstance(surface, Plane):
        gamma = turn[2]
        r = _touching_point(contact, gamma)
        return Clearance(float(gamma @ (seen + r)), gamma, r)
    hollow = isinstance(shape, Ball) and shape.hollow
    outside = surface.side == "outside" and not hollow
    gamma = nearest_normal(_contact_points(shape), seen, outside)
    r = _touching_point(contact, gamma)
    return Clearance(float(gamma @ (seen + r)) - surface.signed_radius, gamma, r)


@arguments_checked
def start_in_contact(
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

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.contact import Coulomb, FrictionalContact
    >>> from nonholonomic.contact.starts import start_in_contact
    >>> ball = FrictionalContact(
    ...     nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0)), laws=(Coulomb(0.2),)
    ... )
    >>> state = start_in_contact(ball, omega=(0, 1, 0), gamma=(0, 0, 1), slip=(2, 0, 0))
    >>> state[4:7].tolist(), state[7:10].tolist()  # centre of mass; its velocity
    ([0.0, 0.0, 1.0], [3.0, 0.0, 0.0])
    """
    spin, up = _vector(omega, "omega"), _direction(gamma, "gamma")
    way, above = _vector(slip, "slip"), _direction(normal, "normal")
    surface = contact.surface
    if isinstance(surface, Plane) and not np.array_equal(above, [0, 0, 1]):
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
    height = 0.0 if isinstance(surface, Plane) else surface.signed_radius
    touching = height * above
    velocity = tangential - np.cross(spin, r) + turn.T @ _support_velocity(contact, touching)
    return _state(contact, attitude, touching - turn @ r, velocity, spin, up, r)


@arguments_checked
def start_in_space(
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

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.contact import Coulomb, FrictionalContact
    >>> from nonholonomic.contact.starts import start_in_space
    >>> ball = FrictionalContact(
    ...     nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0)), laws=(Coulomb(0.2),)
    ... )
    >>> state = start_in_space(ball, (0, 0, 3), (1, 0, 0, 0), (1, 0, 0), (0, 0, 2))
    >>> state[7:10].tolist(), state[13:16].tolist()
    ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0])
    """
    place, moving = _vector(position, "position"), _vector(velocity, "velocity")
    spin = _vector(omega, "omega")
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
    return _state(contact, turned, place, v, spin, known.gamma, known.r)


def _in_contact(
    contact: FrictionalContact,
    v: FloatArray,
    turning: FloatArray,
    gamma: FloatArray,
    support: FloatArray,
) -> FloatArray:
    """The velocity v in contact, without what decimals leave along the normal or as slip.

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
    """The point of the body with outward normal −γ; NaN where a flat face has it."""
    with np.errstate(invalid="ignore", divide="ignore"):
        r: FloatArray = _contact_points(contact.body.shape)(gamma[None])[0]
    return r


@lru_cache(maxsize=64)
def _contact_points(shape: Shape) -> Callable[[FloatArray], FloatArray]:
    """The touching points of a body by normals; many starts have one body."""
    return contact_points(shape)


def _support_velocity(contact: FrictionalContact, touching: FloatArray) -> FloatArray:
    """Velocity of the support at a place, space axes."""
    return np.cross([0.0, 0.0, contact.surface.turntable], touching)


def _state(
    contact: FrictionalContact,
    attitude: FloatArray,
    position: FloatArray,
    v: FloatArray,
    omega: FloatArray,
    gamma: FloatArray,
    r: FloatArray,
) -> FloatArray:
    """The columns of a state in their order."""
    works = 1 + bool(contact.surface.turntable) + len(contact.laws)
    clocks = sum(len(law.clocks) for law in contact.laws)
    contact_columns = r if isinstance(contact.body.shape, Implicit) else gamma
    return np.concatenate([attitude, position, v, omega, contact_columns, np.zeros(works + clocks)])


def _rotation(attitude: Sequence[float] | FloatArray) -> FloatArray:
    """The matrix from body to space components."""
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


def _vector(values: Sequence[float], name: str) -> FloatArray:
    return _numbers(values, name, 3)


def _direction(values: Sequence[float], name: str) -> FloatArray:
    vector = _vector(values, name)
    if not vector.any():
        raise InputError(f"{name} is zero: it must point along the normal")
    # scaled first, so that nothing overflows
    vector = vector / np.abs(vector).max()
    unit: FloatArray = vector / np.linalg.norm(vector)
    return unit


def _vector_text(vector: FloatArray) -> str:
    return f"[{', '.join(repr(float(x)) for x in vector)}]"
