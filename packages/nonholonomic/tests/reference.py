"""Rolling rigid bodies by Newton and Euler, with the contact force as an unknown.

A second road to the motion of a rolling body, against which the package is checked. It shares
no code with the package and derives the motion differently: the acceleration of the centre of
mass, the angular acceleration, the contact force and the spin torque are found together, at each
instant, from one linear system

* ``m V' = N + F``, eliminated at once (momentum of the centre of mass),
* ``I omega' + omega x (I omega + k) = r x N + couple + lambda_0 gamma`` (momentum about it),
* ``(V + omega x r)' = 0`` (no slip),
* ``(omega, gamma)' = 0`` (no spin; rubber contact only),

and the full position of the body is integrated: attitude, centre of mass, its velocity, angular
velocity, and the contact point on the body, whose rate follows from differentiating the
conditions of contact (the point stays on the shape, the two normals stay opposite).

Conventions. Body axes have their origin at the centre of mass. ``gamma`` is the unit normal of the
supporting surface at the contact, out of the support, in body axes. ``r`` goes from the centre of
mass to the contact point, body axes. ``attitude`` is a unit quaternion (w, x, y, z) with
``v_space = R(attitude) v_body``. The supporting sphere has its centre at the origin of space and a
signed radius: positive when the body rolls outside, negative when it rolls inside.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np
import numpy.typing as npt
from scipy.integrate import DOP853

Array = npt.NDArray[np.float64]
Vector = Sequence[float] | Array

IDENTITY = np.eye(3)
E3 = np.array([0.0, 0.0, 1.0])
DIAGONAL = np.diag_indices(3)


# ---------------------------------------------------------------------------------------------
# Small vectors


def cross(a: Array, b: Array) -> Array:
    """Vector product of two 3-vectors (several times faster than `numpy.cross`)."""
    a1, a2, a3 = a.tolist()
    b1, b2, b3 = b.tolist()
    return np.array([a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1])


def hat(a: Array) -> Array:
    """Matrix of the map ``v -> a x v``."""
    a1, a2, a3 = a.tolist()
    return np.array([[0.0, -a3, a2], [a3, 0.0, -a1], [-a2, a1, 0.0]])


def rotation(q: Array) -> Array:
    """Rotation matrix, body to space, of a quaternion (w, x, y, z) of any length."""
    w, x, y, z = q.tolist()
    s = 2.0 / (w * w + x * x + y * y + z * z)
    return np.array(
        [
            [1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
            [s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)],
            [s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)],
        ]
    )


def quaternion_product(p: Vector, q: Vector) -> Array:
    """Product of two quaternions (w, x, y, z)."""
    a, b, c, d = p
    w, x, y, z = q
    return np.array(
        [
            a * w - b * x - c * y - d * z,
            a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x,
            a * z + b * y - c * x + d * w,
        ]
    )


def attitude_with_normal(
    gamma: Vector, normal: Vector = (0.0, 0.0, 1.0), turn: float = 0.0
) -> Array:
    """Attitude that carries a body direction to a space direction.

    Parameters
    ----------
    gamma
        Unit vector in body axes, shape (3,).
    normal
        Unit vector in space to which `gamma` is carried, shape (3,).
    turn
        Angle, in radians, of a further rotation about `normal`.

    Returns
    -------
    Array
        Unit quaternion (w, x, y, z), body to space.
    """
    g = np.asarray(gamma, dtype=float)
    n = np.asarray(normal, dtype=float)
    bisector = g + n
    if bisector @ bisector < 1e-3:  # nearly opposite: half a turn about any axis across `gamma`
        across = cross(g, IDENTITY[int(np.argmin(np.abs(g)))])
        across /= np.linalg.norm(across)
        half_turn = np.concatenate([[0.0], across])
        return quaternion_product(attitude_with_normal(-g, n, turn), half_turn)
    shortest = np.concatenate([[1.0 + g @ n], cross(g, n)])
    shortest /= np.linalg.norm(shortest)
    spin = np.concatenate([[np.cos(turn / 2)], np.sin(turn / 2) * n])
    return quaternion_product(spin, shortest)


# ---------------------------------------------------------------------------------------------
# Shapes


class Shape(Protocol):
    """What the mechanics needs to know of a shape.

    Below, ``s`` is the contact point measured from the geometric centre of the shape, so that
    ``r = centre + s``; ``kappa`` is the curvature ``1/a`` of the supporting sphere, zero for a
    plane.
    """

    @property
    def centre(self) -> Vector:
        """Geometric centre minus centre of mass, body axes, shape (3,)."""

    def touching(self, gamma: Array) -> Array:
        """Point ``s`` at which the shape touches a support with normal `gamma`, shape (3,)."""

    def rate_rows(self, s: Array, gamma: Array, kappa: float) -> tuple[Array, Array]:
        """Matrices A, B (3, 3) of the differentiated contact conditions ``A s' = B drift``.

        The normal moves in the body as ``gamma' = drift + kappa s'``.
        """

    def defects(self, s: Array, gamma: Array) -> Array:
        """Values (3,) of the conditions whose derivatives are ``A s' - B drift``."""


def at_origin(gamma: Array) -> Array:
    """Point inside a shape that surrounds its own centre."""
    return np.zeros(3)


@dataclass(frozen=True)
class ImplicitShape:
    """Body bounded by ``f(s) = 0``, with ``f < 0`` inside.

    Attributes
    ----------
    f, grad, hess
        Function of ``s`` (3,), its gradient (3,) and its matrix of second derivatives (3, 3).
    centre
        Origin of ``s`` minus centre of mass, body axes.
    outwards
        +1 when the body fills ``f < 0``; -1 when it surrounds it and touches with its inner side.
    core
        For a normal `gamma`, a point with ``f < 0`` from which the contact is looked for.
    """

    f: Callable[[Array], float]
    grad: Callable[[Array], Array]
    hess: Callable[[Array], Array]
    centre: Vector = (0.0, 0.0, 0.0)
    outwards: float = 1.0
    core: Callable[[Array], Array] = at_origin

    def touching(self, gamma: Array) -> Array:
        """Point of the surface whose outward normal is ``-gamma``, shape (3,)."""
        s = self.on_ray(self.core(gamma), -self.outwards * gamma)
        first = self.normal(s)
        # The target normal is moved in small steps, so that each Newton search starts close.
        for part in np.linspace(0.0, 1.0, 33)[1:]:
            target = (1.0 - part) * first - part * gamma
            s = self._nearby(s, target / np.linalg.norm(target))
        return s

    def normal(self, s: Array) -> Array:
        """Unit normal out of the body at a point of the surface, shape (3,)."""
        gradient = self.grad(s)
        return self.outwards * gradient / np.linalg.norm(gradient)

    def rate_rows(self, s: Array, gamma: Array, kappa: float) -> tuple[Array, Array]:
        """The point stays on the surface, the body's normal stays opposite to `gamma`."""
        gradient = self.grad(s)
        size = self.outwards * float(np.sqrt(gradient @ gradient))
        n = gradient / size
        along = n[:, None] * n
        across = IDENTITY - along
        shape_operator = across @ self.hess(s) @ across / size
        return along + shape_operator + kappa * across, -across

    def defects(self, s: Array, gamma: Array) -> Array:
        """Distance from the surface along the normal, disagreement of the normals across it."""
        gradient = self.grad(s)
        size = self.outwards * float(np.sqrt(gradient @ gradient))
        n = gradient / size
        return (self.f(s) / size - n @ gamma) * n + gamma

    def on_ray(self, start: Array, direction: Array) -> Array:
        """Point of the surface on the ray from a point inside, shape (3,)."""
        inner, outer = 0.0, 1.0
        while self.f(start + outer * direction) < 0.0:
            outer *= 2.0
        for _ in range(60):
            middle = 0.5 * (inner + outer)
            if self.f(start + middle * direction) < 0.0:
                inner = middle
            else:
                outer = middle
        return start + inner * direction

    def _nearby(self, s: Array, target: Array) -> Array:
        """Solve ``grad f = length * outwards * target``, ``f = 0`` by Newton from near `s`."""
        side = self.outwards * target
        length = float(self.grad(s) @ side)
        best, best_error = s, np.inf
        for _ in range(40):
            gradient = self.grad(s)
            mismatch = np.array([*(gradient - length * side), self.f(s)])
            error = float(np.linalg.norm(mismatch))
            if error >= best_error and best_error < 1e-12 * (1.0 + abs(length)):
                return best
            best, best_error = s, error
            matrix = np.zeros((4, 4))
            matrix[:3, :3] = self.hess(s)
            matrix[:3, 3] = -side
            matrix[3, :3] = gradient
            step = np.linalg.solve(matrix, mismatch)
            s = s - step[:3]
            length -= float(step[3])
        raise ValueError(f"no contact point found for the normal {target}: is the shape convex?")


def ball(radius: float, centre: Vector = (0.0, 0.0, 0.0), hollow: bool = False) -> ImplicitShape:
    """Ball, or hollow ball that rolls with its inner side, as the surface ``s.s = radius**2``."""
    second = 2.0 * IDENTITY
    return ImplicitShape(
        f=lambda s: float(s @ s) - radius * radius,
        grad=lambda s: 2.0 * s,
        hess=lambda s: second,
        centre=centre,
        outwards=-1.0 if hollow else 1.0,
    )


def ellipsoid(axes: Vector, turn: float = 0.0, centre: Vector = (0.0, 0.0, 0.0)) -> ImplicitShape:
    """Ellipsoid with given semi-axes; first along (cos turn, sin turn, 0), third along e3."""
    c, s = np.cos(turn), np.sin(turn)
    frame = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    form = frame.T @ np.diag(1.0 / np.asarray(axes, dtype=float) ** 2) @ frame
    return ImplicitShape(
        f=lambda s: float(s @ form @ s) - 1.0,
        grad=lambda s: 2.0 * (form @ s),
        hess=lambda s: 2.0 * form,
        centre=centre,
    )


def torus(radius: float, tube: float, centre: Vector = (0.0, 0.0, 0.0)) -> ImplicitShape:
    """Torus ``(sqrt(x**2 + y**2) - radius)**2 + z**2 = tube**2``, touching with its outer part.

    `radius` is that of the circle of centres of the tube, whose axis is e3; `tube` that of the
    tube itself.
    """

    def f(s: Array) -> float:
        return float((np.hypot(s[0], s[1]) - radius) ** 2 + s[2] ** 2 - tube * tube)

    def grad(s: Array) -> Array:
        x, y, z = s.tolist()
        factor = 2.0 - 2.0 * radius / math.hypot(x, y)
        return np.array([factor * x, factor * y, 2.0 * z])

    def hess(s: Array) -> Array:
        x, y, _ = s.tolist()
        distance = math.hypot(x, y)
        factor = 2.0 - 2.0 * radius / distance
        more = 2.0 * radius / distance**3
        return np.array(
            [
                [factor + more * x * x, more * x * y, 0.0],
                [more * x * y, factor + more * y * y, 0.0],
                [0.0, 0.0, 2.0],
            ]
        )

    def core(gamma: Array) -> Array:
        flat = np.array([gamma[0], gamma[1], 0.0])
        return -radius * flat / np.linalg.norm(flat)

    return ImplicitShape(f, grad, hess, centre, core=core)


@dataclass(frozen=True)
class Disk:
    """Thin disk with a sharp circular edge of given radius, normal to e3.

    The edge has no normal of its own: it touches where its tangent lies in the support.
    """

    radius: float
    centre: Vector = (0.0, 0.0, 0.0)

    def touching(self, gamma: Array) -> Array:
        """Point of the edge farthest along ``-gamma``, shape (3,)."""
        flat = np.array([gamma[0], gamma[1], 0.0])
        return -self.radius * flat / np.linalg.norm(flat)

    def rate_rows(self, s: Array, gamma: Array, kappa: float) -> tuple[Array, Array]:
        """The point stays on the circle, ``(e3 x s, gamma) = 0`` stays true."""
        tangent = cross(E3, s)
        outwards = np.array([s[0], s[1], 0.0])
        left = np.array([outwards, E3, cross(gamma, E3) + kappa * tangent])
        right = np.zeros((3, 3))
        right[2] = -tangent
        return left, right

    def defects(self, s: Array, gamma: Array) -> Array:
        """Half the excess of the squared radius, height off the plane, slope of the tangent."""
        x, y, z = s.tolist()
        excess = 0.5 * (x * x + y * y - self.radius * self.radius)
        return np.array([excess, z, cross(E3, s) @ gamma])


@dataclass(frozen=True)
class ShapeOfRevolution:
    """Body of revolution ``s = (chi1 gamma1, chi1 gamma2, chi2)``, functions of gamma3.

    Attributes
    ----------
    chi1, chi2, dchi1, dchi2
        The two functions and their derivatives, with
        ``dchi1 (1 - g3**2) - chi1 g3 + dchi2 g3 = 0`` (the normal of the surface is gamma).
    centre
        Origin of ``s`` minus centre of mass, body axes.
    """

    chi1: Callable[[float], float]
    chi2: Callable[[float], float]
    dchi1: Callable[[float], float]
    dchi2: Callable[[float], float]
    centre: Vector = (0.0, 0.0, 0.0)

    def touching(self, gamma: Array) -> Array:
        """Contact point for a given normal, shape (3,)."""
        g1, g2, g3 = gamma.tolist()
        chi1 = self.chi1(g3)
        return np.array([chi1 * g1, chi1 * g2, self.chi2(g3)])

    def rate_rows(self, s: Array, gamma: Array, kappa: float) -> tuple[Array, Array]:
        """Derivative of the relation between the contact point and the normal."""
        g1, g2, g3 = gamma.tolist()
        chi1, slope = self.chi1(g3), self.dchi1(g3)
        jacobian = np.array(
            [[chi1, 0.0, slope * g1], [0.0, chi1, slope * g2], [0.0, 0.0, self.dchi2(g3)]]
        )
        return IDENTITY - kappa * jacobian, jacobian

    def defects(self, s: Array, gamma: Array) -> Array:
        """Difference from the contact point that belongs to the normal."""
        return s - self.touching(gamma)


# ---------------------------------------------------------------------------------------------
# Supports, bodies, forces


class Surface(Protocol):
    """What the body rolls on."""

    @property
    def curvature(self) -> float:
        """One over the signed radius; zero for a plane."""

    def normal(self, turn: Array, position: Array, r: Array) -> Array:
        """Normal at the contact, body axes (3,).

        `turn` is the rotation matrix, `position` the centre of mass in space, `r` the contact
        point in the body.
        """

    def contact(self, turn: Array, gamma: Array) -> Array:
        """Contact point in space (3,) at which a motion begins."""

    def gap(self, turn: Array, position: Array, r: Array) -> float:
        """Signed distance of the contact point from the support, along the normal."""


@dataclass(frozen=True)
class Plane:
    """The plane z = 0, with the body above it."""

    curvature: float = field(default=0.0, init=False)

    def normal(self, turn: Array, position: Array, r: Array) -> Array:
        """The vertical as the body sees it."""
        vertical: Array = turn[2]
        return vertical

    def contact(self, turn: Array, gamma: Array) -> Array:
        """The origin; the attitude must turn `gamma` upright."""
        if float(np.linalg.norm(turn @ gamma - E3)) > 1e-12:
            raise ValueError("start: the attitude must carry gamma to the vertical (0, 0, 1)")
        return np.zeros(3)

    def gap(self, turn: Array, position: Array, r: Array) -> float:
        """Height of the contact point."""
        return float(position[2] + turn[2] @ r)


@dataclass(frozen=True)
class Sphere:
    """Sphere about the origin of space; positive radius: rolling outside, negative: inside."""

    radius: float

    @property
    def curvature(self) -> float:
        """One over the signed radius."""
        return 1.0 / self.radius

    def normal(self, turn: Array, position: Array, r: Array) -> Array:
        """The contact point over the signed radius, from the body's position."""
        return (position @ turn + r) / self.radius

    def contact(self, turn: Array, gamma: Array) -> Array:
        """Signed radius times the normal in space."""
        return self.radius * (turn @ gamma)

    def gap(self, turn: Array, position: Array, r: Array) -> float:
        """Distance from the sphere, counted towards the body's side of it."""
        gamma = self.normal(turn, position, r)
        return self.radius * (math.sqrt(gamma @ gamma) - 1.0)


CONTACTS = ("marble", "rubber")


@dataclass(frozen=True)
class Body:
    """Rigid body: mass, inertia tensor at the centre of mass (3, 3), shape, gyrostat k (3,)."""

    mass: float
    inertia: Array
    shape: Shape
    gyrostat: Vector = (0.0, 0.0, 0.0)


def no_potential(gamma: Array) -> float:
    """The potential of no couple."""
    return 0.0


def no_gradient(gamma: Array) -> Array:
    """The gradient of no potential."""
    return np.zeros(3)


@dataclass(frozen=True)
class Forces:
    """Gravity along -z of space, and a couple with potential U(gamma), gradient dU (3,)."""

    gravity: float = 0.0
    U: Callable[[Array], float] = no_potential
    dU: Callable[[Array], Array] = no_gradient  # noqa: N815 (named as on paper)


# ---------------------------------------------------------------------------------------------
# Mechanics

# Rate, 1/s, at which a violated condition of contact decays. Without it the rounding of one step
# grows exponentially on the outside of a sphere; on the constraint itself it changes nothing.
RESTORING = 4.0

# Layout of the integrated state: attitude, centre of mass and its velocity (space axes), angular
# velocity and contact point from the centre of mass (body axes).
Q, X, V, W, P = slice(0, 4), slice(4, 7), slice(7, 10), slice(10, 13), slice(13, 16)


@dataclass(frozen=True)
class Instant:
    """Everything known at one instant; vectors in body axes, shape (3,)."""

    turn: Array
    gamma: Array
    gamma_rate: Array
    r_rate: Array
    slip: Array
    gap: float
    defects: Array
    omega_rate: Array
    contact_force: Array
    spin_torque: float


class Rolling:
    """Newton–Euler equations of one body on one surface.

    Parameters
    ----------
    body, surface, forces
        What rolls, on what, under what.
    contact
        ``"marble"`` (no slip) or ``"rubber"`` (no slip, no spin).

    Raises
    ------
    ValueError
        If `contact` is neither of the two.
    """

    def __init__(self, body: Body, surface: Surface, contact: str, forces: Forces) -> None:
        if contact not in CONTACTS:
            raise ValueError(f"contact is {contact!r}; allowed: {', '.join(CONTACTS)}")
        self.body, self.surface, self.contact, self.forces = body, surface, contact, forces
        self.inertia = np.asarray(body.inertia, dtype=float)
        self.gyrostat = np.asarray(body.gyrostat, dtype=float)
        self.centre = np.asarray(body.shape.centre, dtype=float)
        self.unknowns = 7 if contact == "rubber" else 6
        self.fixed_part = np.zeros((7, 7))
        self.fixed_part[:3, :3] = self.inertia
        self.fixed_part[3:6, 3:6] = IDENTITY / body.mass

    def state(self, start: Mapping[str, Vector]) -> Array:
        """Full state (16,) of a start given by ``omega``, ``gamma``, ``attitude``.

        Raises
        ------
        ValueError
            If gamma or the attitude is not of unit length, the attitude does not carry gamma to
            the normal of a plane, or a rubber body spins about the normal.
        """
        omega, gamma, q = (np.array(start[key], float) for key in ("omega", "gamma", "attitude"))
        for name, vector in (("gamma", gamma), ("attitude", q)):
            if abs(float(np.linalg.norm(vector)) - 1.0) > 1e-12:
                raise ValueError(f"start: {name} must have unit length")
        if self.contact == "rubber" and abs(float(omega @ gamma)) > 1e-12:
            raise ValueError("start: for a rubber contact omega must be orthogonal to gamma")
        turn = rotation(q)
        r = self.centre + self.body.shape.touching(gamma)
        position = self.surface.contact(turn, gamma) - turn @ r
        return np.concatenate([q, position, turn @ cross(r, omega), omega, r])

    def instant(self, y: Array) -> Instant:
        """Contact kinematics, accelerations and reactions in one state."""
        turn = rotation(y[Q])
        omega, r = y[W], y[P]
        kappa = self.surface.curvature
        gamma = self.surface.normal(turn, y[X], r)
        slip = y[V] @ turn + cross(omega, r)

        # On a sphere a gamma = R^T X + r, whence a (gamma' + omega x gamma) = slip + r'.
        s = r - self.centre
        gap = self.surface.gap(turn, y[X], r)
        defects = self.body.shape.defects(s, gamma)
        left, right = self.body.shape.rate_rows(s, gamma, kappa)
        solved = np.linalg.solve(left, np.column_stack((right, defects)))
        response = solved[:, :3]
        drift = cross(gamma, omega) + kappa * (slip - RESTORING * gap * gamma)
        r_rate = response @ drift - RESTORING * solved[:, 3]
        gamma_rate = drift + kappa * r_rate

        # Without slip gamma' = G omega; the couple does the work -dU/dt for every omega.
        gamma_per_omega = (IDENTITY + kappa * response) @ hat(gamma)
        couple = -(self.forces.dU(gamma) @ gamma_per_omega)

        arm = hat(r)
        matrix = self.fixed_part.copy()
        matrix[:3, 3:6] = -arm
        matrix[3:6, :3] = -arm
        matrix[:3, 6] = -gamma
        matrix[6, :3] = gamma
        known = np.empty(7)
        known[:3] = cross(self.inertia @ omega + self.gyrostat, omega) + couple
        known[3:6] = self.forces.gravity * turn[2] - cross(omega, r_rate + cross(omega, r))
        known[6] = -(omega @ gamma_rate)
        n = self.unknowns
        solution = np.zeros(7)
        solution[:n] = np.linalg.solve(matrix[:n, :n], known[:n])
        return Instant(
            turn=turn,
            gamma=gamma,
            gamma_rate=gamma_rate,
            r_rate=r_rate,
            slip=slip,
            gap=gap,
            defects=defects,
            omega_rate=solution[:3],
            contact_force=solution[3:6],
            spin_torque=float(solution[6]),
        )

    def rate(self, time: float, y: Array) -> Array:
        """Time derivative (16,) of the state."""
        now = self.instant(y)
        omega = y[W]
        out = np.empty(16)
        w, v = y[0], y[1:4]
        out[0] = -0.5 * (v @ omega)
        out[1:4] = 0.5 * (w * omega + cross(v, omega))
        out[X] = y[V] - RESTORING * now.gap * (now.turn @ now.gamma)
        out[V] = now.turn @ now.contact_force / self.body.mass
        out[9] -= self.forces.gravity
        out[W] = now.omega_rate
        out[P] = now.r_rate
        return out

    def energy(self, y: Array) -> float:
        """Kinetic energy, gravity counted from z = 0, and U."""
        omega, velocity = y[W], y[V]
        gamma = self.surface.normal(rotation(y[Q]), y[X], y[P])
        kinetic = 0.5 * self.body.mass * velocity @ velocity + 0.5 * omega @ self.inertia @ omega
        height = self.body.mass * self.forces.gravity * y[6]
        return float(kinetic + height + self.forces.U(gamma))

    def residual(self, y: Array) -> float:
        """Largest violation of any condition the motion must keep."""
        now = self.instant(y)
        spin = abs(float(y[W] @ now.gamma)) if self.contact == "rubber" else 0.0
        return max(
            float(np.linalg.norm(now.slip)),
            abs(now.gap),
            float(np.linalg.norm(now.defects)),
            spin,
        )


def acceleration(
    body: Body, surface: Surface, contact: str, forces: Forces, start: Mapping[str, Vector]
) -> tuple[Array, Array, float]:
    """Angular acceleration and reactions in one state.

    Parameters
    ----------
    body, surface, contact, forces
        As for `integrate`.
    start
        ``omega`` (3,) and ``gamma`` (3,) in body axes, ``attitude`` (4,), as for `integrate`.

    Returns
    -------
    omega_rate
        Time derivative of omega, body axes (3,).
    contact_force
        Force of the support on the body, body axes (3,).
    spin_torque
        lambda_0 of the torque ``lambda_0 gamma``; zero for a marble contact.
    """
    rolling = Rolling(body, surface, contact, forces)
    now = rolling.instant(rolling.state(start))
    return now.omega_rate, now.contact_force, now.spin_torque


def integrate(
    body: Body,
    surface: Surface,
    contact: str,
    forces: Forces,
    start: Mapping[str, Vector],
    times: Vector,
    rtol: float = 5e-14,
    atol: float = 5e-15,
    max_step: float = np.inf,
) -> dict[str, Array]:
    """Motion of a rolling body from time 0.

    Parameters
    ----------
    body, surface, forces
        What rolls, on what, under what.
    contact
        ``"marble"`` or ``"rubber"``.
    start
        ``omega`` (3,) and ``gamma`` (3,) in body axes, ``attitude`` (4,). On a plane the attitude
        carries gamma to (0, 0, 1) and the contact is at the origin of space; on a sphere the
        contact is at ``a R gamma``.
    times
        Increasing times at which the motion is wanted, none before 0, shape (n,).
    rtol, atol, max_step
        Tolerances and longest step of the integrator (DOP853).

    Returns
    -------
    dict
        ``omega``, ``gamma`` (n, 3) in body axes; ``attitude`` (n, 4); ``centre``, ``contact``,
        ``contact_force`` (n, 3) in space; ``normal_force`` (n,), the part of the contact force
        along gamma; ``spin_torque`` (n,); ``energy`` (n,); ``residual`` (n,), the largest
        violation of any constraint.

    Raises
    ------
    ValueError
        If the start is not admissible or the times do not increase from 0.
    RuntimeError
        If the integrator gives up.
    """
    instants = np.asarray(times, dtype=float)
    if instants.size == 0 or instants[0] < 0.0 or np.any(np.diff(instants) <= 0.0):
        raise ValueError("times must increase, and none may be negative")
    rolling = Rolling(body, surface, contact, forces)
    y, now = rolling.state(start), 0.0
    step: float | None = None
    states = []
    for until in instants.tolist():
        # Each wanted time ends a step: the interpolant is less accurate than the steps.
        if until > now:
            first = None if step is None else min(step, until - now)
            solver = DOP853(rolling.rate, now, y, until, max_step, rtol, atol, first_step=first)
            while solver.status == "running":
                message = solver.step()
            if solver.status == "failed":
                raise RuntimeError(f"integration stopped at t = {solver.t:.6g}: {message}")
            y, now, step = solver.y, until, solver.h_abs
        states.append(y)

    found = [rolling.instant(state) for state in states]
    return {
        "omega": np.array([state[W] for state in states]),
        "gamma": np.array([each.gamma for each in found]),
        "attitude": np.array([state[Q] / np.linalg.norm(state[Q]) for state in states]),
        "centre": np.array([state[X] for state in states]),
        "contact": np.array(
            [state[X] + each.turn @ state[P] for state, each in zip(states, found, strict=True)]
        ),
        "normal_force": np.array([each.contact_force @ each.gamma for each in found]),
        "contact_force": np.array([each.turn @ each.contact_force for each in found]),
        "spin_torque": np.array([each.spin_torque for each in found]),
        "energy": np.array([rolling.energy(state) for state in states]),
        "residual": np.array([rolling.residual(state) for state in states]),
    }


# ---------------------------------------------------------------------------------------------
# Random cases

SHAPES = ("ball", "hollow ball", "ellipsoid", "disk", "torus", "revolution", "implicit")
SUPPORTS = ("plane", "outside", "inside")
INERTIAS = ("principal", "turned")


@dataclass(frozen=True)
class Case:
    """One body, its support and a start, drawn at random.

    Attributes
    ----------
    body, surface, contact, forces, start
        Arguments of `integrate`, in this order.
    shape_table
        The shape in words and numbers, with the keys of the ``[body.shape]`` table of an
        experiment file. Texts of functions use the names ``x, y, z`` (from the geometric centre)
        and ``g3``.
    potential
        Text of U in the names ``gamma1, gamma2, gamma3``.
    """

    body: Body
    surface: Surface
    contact: str
    forces: Forces
    start: dict[str, Array]
    shape_table: dict[str, object]
    potential: str

    def run(self, times: Vector) -> dict[str, Array]:
        """Motion at the given times, as `integrate`."""
        return integrate(self.body, self.surface, self.contact, self.forces, self.start, times)


def random_case(
    rng: np.random.Generator,
    shape_kind: str,
    surface_kind: str,
    contact: str,
    inertia_kind: str = "turned",
) -> Case:
    """Admissible body and start with a motion that stays regular to t = 10.

    Parameters
    ----------
    rng
        Source of randomness; the same state gives the same case.
    shape_kind
        One of `SHAPES`.
    surface_kind
        ``"plane"``, ``"outside"`` or ``"inside"`` of a sphere. A hollow ball only goes
        ``"outside"``, around the sphere.
    contact
        ``"marble"`` or ``"rubber"``.
    inertia_kind
        ``"principal"``: diagonal tensor; ``"turned"``: principal axes turned at random.

    Raises
    ------
    ValueError
        For a name that is not in the lists, or a hollow ball not around a sphere.
    """
    for what, name, allowed in (
        ("shape_kind", shape_kind, SHAPES),
        ("surface_kind", surface_kind, SUPPORTS),
        ("contact", contact, CONTACTS),
        ("inertia_kind", inertia_kind, INERTIAS),
    ):
        if name not in allowed:
            raise ValueError(f"{what} is {name!r}; allowed: {', '.join(allowed)}")
    if shape_kind == "hollow ball" and surface_kind != "outside":
        raise ValueError("a hollow ball needs surface_kind 'outside': it goes around the sphere")
    for _ in range(200):
        case = _draw(rng, shape_kind, surface_kind, contact, inertia_kind)
        if _stays_regular(case):
            return case
    raise RuntimeError(f"no regular motion found for {shape_kind}, {surface_kind}, {contact}")


def _draw(
    rng: np.random.Generator, shape_kind: str, surface_kind: str, contact: str, inertia_kind: str
) -> Case:
    shape, table, widest = _random_shape(rng, shape_kind)
    surface = _random_surface(rng, shape_kind, surface_kind, widest)

    mass = rng.uniform(0.7, 1.5)
    spread = mass * rng.uniform(0.1, 0.35, 3)  # integrals of x², y², z²: any positive ones will do
    inertia = np.diag(spread.sum() - spread)
    if inertia_kind == "turned":
        turn = rotation(rng.normal(size=4))
        inertia = turn @ inertia @ turn.T
        inertia = (inertia + inertia.T) / 2
    gyrostat = rng.choice([0.0, 0.4]) * rng.normal(size=3)
    body = Body(mass, inertia, shape, gyrostat)

    forces, potential = _random_forces(rng)

    gamma = rng.normal(size=3)
    omega = 0.7 * rng.normal(size=3)
    if shape_kind in ("disk", "torus"):  # rolling fast on the edge, so as not to fall
        gamma[2] = 0.2 * rng.normal()
        omega[:2] *= 0.5
        omega[2] = rng.choice([-1.0, 1.0]) * rng.uniform(1.5, 3.0)
    gamma /= np.linalg.norm(gamma)
    if contact == "rubber":
        omega -= (omega @ gamma) * gamma
    attitude = attitude_with_normal(gamma, turn=rng.uniform(0.0, 2 * np.pi))
    if surface_kind != "plane":
        attitude = rng.normal(size=4)
        attitude /= np.linalg.norm(attitude)
    start = {"omega": omega, "gamma": gamma, "attitude": attitude}
    return Case(body, surface, contact, forces, start, table, potential)


def _random_surface(
    rng: np.random.Generator, shape_kind: str, surface_kind: str, widest: float
) -> Surface:
    if surface_kind == "plane":
        return Plane()
    if shape_kind == "hollow ball":
        return Sphere(widest / rng.uniform(1.4, 1.9))
    if surface_kind == "outside":
        return Sphere(rng.uniform(1.5, 3.0))
    return Sphere(-widest * rng.uniform(1.5, 2.2))


def _random_forces(rng: np.random.Generator) -> tuple[Forces, str]:
    gravity = rng.uniform(0.5, 1.5)
    if rng.random() < 0.5:
        return Forces(gravity), "0"
    b, c = 0.3 * rng.normal(size=3), 0.3 * rng.normal(size=3)
    terms = [
        f"({linear!r})*gamma{i} + ({square!r})*gamma{i}**2"
        for i, linear, square in zip((1, 2, 3), b.tolist(), c.tolist(), strict=True)
    ]
    forces = Forces(
        gravity,
        U=lambda gamma: float(b @ gamma + c @ (gamma * gamma)),
        dU=lambda gamma: b + 2.0 * c * gamma,
    )
    return forces, " + ".join(terms)


def _random_shape(rng: np.random.Generator, kind: str) -> tuple[Shape, dict[str, object], float]:
    """Shape, its table, and the least radius of a bowl (with no margin) in which it can roll."""
    centre = 0.12 * rng.normal(size=3)
    place: dict[str, object] = {"centre": centre.tolist()}
    if kind in ("ball", "hollow ball"):
        radius = rng.uniform(0.8, 1.2)
        hollow = kind == "hollow ball"
        if hollow:
            radius *= 1.6
        table = {"kind": "ball", "radius": radius} | ({"hollow": True} if hollow else {})
        return ball(radius, centre, hollow), table | place, radius
    if kind == "ellipsoid":
        axes, turn = rng.uniform(0.8, 1.25, 3), rng.uniform(0.0, np.pi)
        table = {"kind": "ellipsoid", "axes": axes.tolist(), "turn": turn}
        return ellipsoid(axes, turn, centre), table | place, max(axes) ** 2 / min(axes)
    if kind == "disk":
        radius = rng.uniform(0.8, 1.2)
        return Disk(radius, centre), {"kind": "disk", "radius": radius} | place, 2.0 * radius
    if kind == "torus":
        radius, tube = rng.uniform(0.7, 1.0), rng.uniform(0.15, 0.3)
        table = {"kind": "torus", "radius": radius, "tube": tube}
        return torus(radius, tube, centre), table | place, 2.0 * (radius + tube)
    if kind == "revolution":
        return _random_egg(rng, centre)
    return _random_quartic(rng, centre)


def _random_egg(rng: np.random.Generator, centre: Array) -> tuple[Shape, dict[str, object], float]:
    """Body of revolution with support function p0 + p2 x**2 + p3 x**3, x = -g3."""
    p0, p2, p3 = rng.uniform(0.8, 1.1), rng.uniform(-0.1, 0.1), rng.uniform(-0.05, 0.05)
    # s = p u + p' (e3 - x u) with u = -gamma, written out in powers of g3.
    chi1 = [-p0, 0.0, p2, -2.0 * p3]
    chi2 = [0.0, -p0 - 2.0 * p2, 3.0 * p3, p2, -2.0 * p3]
    shape = ShapeOfRevolution(
        _polynomial(chi1),
        _polynomial(chi2),
        _polynomial(_derivative(chi1)),
        _polynomial(_derivative(chi2)),
        centre,
    )
    table: dict[str, object] = {
        "kind": "revolution",
        "chi1": _text(chi1),
        "chi2": _text(chi2),
        "centre": centre.tolist(),
    }
    x = np.linspace(-1.0, 1.0, 201)
    parallel = p0 - p2 * x**2 - 2.0 * p3 * x**3
    meridian = parallel + (1.0 - x**2) * (2.0 * p2 + 6.0 * p3 * x)
    return shape, table, float(max(parallel.max(), meridian.max()))


def _polynomial(coefficients: list[float]) -> Callable[[float], float]:
    def value(x: float) -> float:
        total = 0.0
        for each in reversed(coefficients):
            total = total * x + each
        return total

    return value


def _derivative(coefficients: list[float]) -> list[float]:
    return [power * each for power, each in enumerate(coefficients)][1:]


def _text(coefficients: list[float]) -> str:
    return " + ".join(f"({each!r})*g3**{power}" for power, each in enumerate(coefficients))


def _random_quartic(
    rng: np.random.Generator, centre: Array
) -> tuple[Shape, dict[str, object], float]:
    """Strictly convex surface b.s**2 + c.s**4 + d x y z = 1."""
    b, c = rng.uniform(0.6, 1.0, 3), rng.uniform(0.1, 0.3, 3)
    d = rng.uniform(-0.2, 0.2)

    def f(s: Array) -> float:
        x, y, z = s.tolist()
        square = s * s
        return float(b @ square + c @ (square * square) + d * x * y * z - 1.0)

    def grad(s: Array) -> Array:
        x, y, z = s.tolist()
        return 2.0 * b * s + 4.0 * c * s**3 + d * np.array([y * z, z * x, x * y])

    def hess(s: Array) -> Array:
        x, y, z = (d * s).tolist()
        out = np.array([[0.0, z, y], [z, 0.0, x], [y, x, 0.0]])
        out[DIAGONAL] = 2.0 * b + 12.0 * c * s * s
        return out

    shape = ImplicitShape(f, grad, hess, centre)
    terms = [
        f"({b2!r})*{name}**2 + ({b4!r})*{name}**4"
        for name, b2, b4 in zip("xyz", b.tolist(), c.tolist(), strict=True)
    ]
    table: dict[str, object] = {
        "kind": "implicit",
        "surface": " + ".join(terms) + f" + ({d!r})*x*y*z - 1",
        "centre": centre.tolist(),
    }
    # On f = 0 no curvature radius exceeds |grad f| over the least eigenvalue of the Hessian.
    directions = np.random.default_rng(0).normal(size=(60, 3))
    points = [shape.on_ray(np.zeros(3), each / np.linalg.norm(each)) for each in directions]
    widest = max(np.linalg.norm(grad(s)) / np.linalg.eigvalsh(hess(s))[0] for s in points)
    return shape, table, float(widest)


LEAST_LEAN = 0.1
GREATEST_SPIN = 12.0
ROUGH_TOLERANCE = 1e-6
GREATEST_AMPLIFICATION = 20.0


def _stays_regular(case: Case) -> bool:
    """Rough runs show no wild spin, no disk or torus about to fall flat, no great sensitivity.

    A motion that amplifies the errors of the integrator a thousandfold could not be compared to
    ten digits, however right both sides.
    """
    rough = _rough_run(case, ROUGH_TOLERANCE)
    if float(np.linalg.norm(rough["omega"], axis=1).max()) > GREATEST_SPIN:
        return False
    if case.shape_table["kind"] in ("disk", "torus"):
        lean = np.hypot(rough["gamma"][:, 0], rough["gamma"][:, 1])
        if lean.min() < _lean_when_flat(case) + LEAST_LEAN:
            return False
    finer = _rough_run(case, ROUGH_TOLERANCE / 100)
    differences = [np.abs(rough[key] - finer[key]).max() for key in ("omega", "attitude", "centre")]
    return bool(max(differences) < GREATEST_AMPLIFICATION * ROUGH_TOLERANCE)


def _rough_run(case: Case, tolerance: float) -> dict[str, Array]:
    return integrate(
        case.body,
        case.surface,
        case.contact,
        case.forces,
        case.start,
        np.linspace(0.0, 10.0, 51),
        rtol=tolerance,
        atol=tolerance / 10,
    )


def _lean_when_flat(case: Case) -> float:
    """Sine of the angle between gamma and e3 at which the edge touches all around a bowl."""
    if case.surface.curvature >= 0.0:
        return 0.0
    radius, tube = (float(str(case.shape_table.get(key, 0.0))) for key in ("radius", "tube"))
    return radius / (-1.0 / case.surface.curvature - tube)
