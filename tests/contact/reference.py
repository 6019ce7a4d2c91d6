"""Rigid body in unilateral contact with friction, by Newton and Euler in space axes.

A second road to motions that slide, hold, roll, spin, leave the ground, fly and land. It shares no
code with the package and goes about it differently:

* the state is the position of the centre of mass, the attitude, the velocity and the **angular
  momentum, all in space axes**; the place of contact is found from them at each instant;
* the angular acceleration and the forces are found together from one dense linear system: Euler's
  equations, the law of friction, and the differentiated conditions of contact;
* smooth pieces are integrated by SciPy's DOP853 and events are found by root finding on its dense
  output, then polished by integrating again to the supposed moment;
* where sliding dies away, or begins after a stop, the direction ``e`` of the slip velocity and the
  logarithm of its size are integrated in the time ``dtau = dt/size`` **together with the whole
  motion**, so that the end of sliding is regular and lies at ``tau = infinity``;
* where a held contact begins to slide, the motion is started with its **Taylor series in time**,
  whose coefficients, those of the direction of sliding among them, follow order by order from the
  condition that friction opposes the sliding which it produces.

Use
---
``simulate(body, surface, contact, start, until)`` takes plain dictionaries, as in
``reference_cases.json``, and returns the events and the final state::

    body      mass, inertia (3 x 3 or three numbers, about the centre of mass, body axes),
              gyrostat (3, optional), shape:
              {kind: "ball", radius, centre} or
              {kind: "ellipsoid", axes, turn (of the first semi-axis about body axis 3), centre},
              centre: from the centre of mass to the centre of the shape
    surface   {kind: "plane", turntable: rate about z} or
              {kind: "sphere", radius, side: "outside" | "inside"} about the origin
    contact   mu; spin_arm; patch; viscous; spin_viscous; slip; rolling; rolling_viscous; contour;
              restitution; impact_law ("stronge", "poisson", "newton"); absent means none
    gravity   acceleration, along -z
    start     position (centre of mass), attitude (quaternion w, x, y, z, body to space),
              velocity (of the centre of mass, space axes), omega (body axes)

Kinds of event: ``stick`` (sliding has ended and the contact holds), ``slip`` (a held contact begins
to slide), ``spin stop``, ``spin start``, ``lift-off``, ``landing`` (state after the impact),
``rest`` (rolling has ended too, nothing moves), ``direct restart`` (sliding has ended and goes on
at once in another direction).

Forces, with ``n`` the normal of the support, ``u`` the velocity of the touching particle against
the support, ``Omega`` the spin against the support, ``w`` the part of omega along the support, and
``N`` the normal force:

===================  ==================================================  =========================
key                  force                                               couple
===================  ==================================================  =========================
mu                   ``-mu N u/|u|``
slip                 ``-slip N u``
viscous              ``-viscous u``
spin_arm                                                                 ``-spin_arm N sgn Omega n``
spin_viscous                                                             ``-spin_viscous Omega n``
patch (with mu)      Coulomb's law under Hertz' pressure on a round      (the same)
                     patch of this radius, integrated over the patch
rolling                                                                  ``-rolling N w/|w|``
rolling_viscous                                                          ``-rolling_viscous N w``
contour                                                                  of power ``-contour N |r'|``
===================  ==================================================  =========================

where ``r'`` is the velocity of the contact point over the body, with the normal at rest in space.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from contact.power_series import Number, Series, arcsine, exponential, logarithm, root, solution
from scipy.integrate import DOP853
from scipy.optimize import brentq, minimize_scalar

Array = npt.NDArray[np.float64]
Vector = Sequence[Number]
Matrix = Sequence[Sequence[Number]]

UP = (0.0, 0.0, 1.0)
AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
ZERO = (0.0, 0.0, 0.0)

SMALL = 0.01
"""Slip speed (m/s; rad/s for rolling) below which direction and size are integrated apart."""

LAST = -42.0
"""Logarithm of the slip speed, against `SMALL`, at which sliding counts as ended."""

TERMS = 18
"""Number of terms of the Taylor series with which sliding begins."""


# ---------------------------------------------------------------------------------------------
# Vectors of numbers or series


def dot(a: Vector, b: Vector) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> list[Any]:
    return [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]


def plus(*vectors: Vector) -> list[Any]:
    return [sum(entries[1:], entries[0]) for entries in zip(*vectors, strict=True)]


def minus(a: Vector, b: Vector) -> list[Any]:
    return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]


def times(s: Number, a: Vector) -> list[Any]:
    return [s * a[0], s * a[1], s * a[2]]


def applied(m: Matrix, a: Vector) -> list[Any]:
    return [dot(m[0], a), dot(m[1], a), dot(m[2], a)]


def transposed(m: Matrix, a: Vector) -> list[Any]:
    return [m[0][i] * a[0] + m[1][i] * a[1] + m[2][i] * a[2] for i in range(3)]


def length(a: Vector) -> Any:
    return root(dot(a, a))


def rotation(q: Vector) -> list[list[Any]]:
    """Rotation matrix, body to space, of a quaternion (w, x, y, z) of any length."""
    w, x, y, z = q
    s = 2.0 / (w * w + x * x + y * y + z * z)
    return [
        [1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
        [s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)],
        [s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)],
    ]


def tangents(n: Vector, near: Vector | None = None) -> tuple[list[Any], list[Any]]:
    """Two unit vectors across `n`, the first as near as possible to `near`."""
    if near is None:
        near = AXES[min(range(3), key=lambda i: abs(float(n[i])))]
    first = minus(near, times(dot(near, n), n))
    first = times(1.0 / length(first), first)
    return first, cross(n, first)


# ---------------------------------------------------------------------------------------------
# Bodies and supports


class Body:
    """Mass, inertia, gyrostat and shape, from the dictionary of a case."""

    def __init__(self, data: Mapping[str, Any], number: type = float) -> None:
        self.mass = float(data["mass"])
        inertia = np.array(data["inertia"], dtype=float)
        self.inertia = np.diag(inertia) if inertia.ndim == 1 else inertia
        inverse = np.linalg.inv(self.inertia).astype(number)
        for _ in range(2):
            inverse = inverse + inverse @ (np.eye(3) - self.inertia @ inverse)
        self.inverse = inverse.tolist()
        self.gyrostat = [float(k) for k in data.get("gyrostat", ZERO)]
        shape = data["shape"]
        self.centre = [float(c) for c in shape.get("centre", ZERO)]
        self.is_ball = shape["kind"] == "ball"
        if self.is_ball:
            self.radius = float(shape["radius"])
            self.form = (np.eye(3) * self.radius**2).tolist()
        else:
            turn = float(shape.get("turn", 0.0))
            c, s = math.cos(turn), math.sin(turn)
            frame = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
            squares = np.diag(np.array(shape["axes"], dtype=float) ** 2)
            self.form = (frame @ squares @ frame.T).tolist()
        self.size = math.sqrt(max(np.linalg.eigvalsh(np.array(self.form))))

    def arm(self, gamma: Vector) -> list[Any]:
        """From the centre of mass to the lowest point, for an upward direction in body axes."""
        if self.is_ball:
            return minus(self.centre, times(self.radius / length(gamma), gamma))
        b = applied(self.form, gamma)
        return minus(self.centre, times(1.0 / root(dot(gamma, b)), b))

    def arm_rate(self, gamma: Vector, rate: Vector) -> list[Any]:
        """Derivative of `arm` at a unit vector `gamma` along `rate`, which is across it."""
        if self.is_ball:
            return times(-self.radius, rate)
        b = applied(self.form, gamma)
        h = root(dot(gamma, b))
        return minus(times(dot(b, rate) / (h * h * h), b), times(1.0 / h, applied(self.form, rate)))

    def momentum(self, q: Vector, omega: Vector) -> list[float]:
        """Angular momentum in space axes of an angular velocity in body axes."""
        inner = [
            sum(float(i) * w for i, w in zip(row, omega, strict=True)) + k
            for row, k in zip(self.inertia.tolist(), self.gyrostat, strict=True)
        ]
        return applied(rotation(q), inner)


class Surface:
    """Plane z = 0, which may turn, or sphere about the origin, from the dictionary of a case."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.is_plane = data["kind"] == "plane"
        self.turntable = float(data.get("turntable", 0.0))
        self.radius = 0.0
        if not self.is_plane:
            sign = {"outside": 1.0, "inside": -1.0}[data.get("side", "outside")]
            self.radius = sign * float(data["radius"])

    def normal_and_gap(
        self, body: Body, position: Vector, turn: Matrix, guess: Vector | None
    ) -> tuple[list[Any], Any]:
        """Normal where the body is nearest to the support, and the distance there."""
        if self.is_plane:
            return list(UP), position[2] + dot(UP, applied(turn, body.arm(turn[2])))
        if body.is_ball:
            centre = plus(position, applied(turn, body.centre))
            far = length(centre)
            sign = math.copysign(1.0, self.radius)
            return times(sign / far, centre), sign * far - self.radius - body.radius
        n: Vector = guess if guess is not None else self._first_guess(body, position, turn)
        gap: Number = 0.0
        series = any(isinstance(x, Series) for x in position)
        for turn_of_newton in range(40):
            gamma = transposed(turn, n)
            b = applied(body.form, gamma)
            h = root(dot(gamma, b))
            far = self.radius + gap
            miss = [
                *minus(plus(position, applied(turn, body.arm(gamma))), times(far, n)),
                0.5 * (dot(n, n) - 1.0),
            ]
            columns = []
            for axis in AXES:
                g = transposed(turn, axis)
                rate = minus(
                    times(dot(b, g) / (h * h * h), b), times(1.0 / h, applied(body.form, g))
                )
                columns.append(applied(turn, rate))
            rows: list[list[Number]] = [
                [columns[j][i] - (far if i == j else 0.0) for j in range(3)] + [-n[i]]
                for i in range(3)
            ]
            rows.append([*n, 0.0])
            step = solution(rows, miss)
            n = minus(n, step[:3])
            gap = gap - step[3]
            last = max(abs(float(x)) for x in step)
            if last < 1e-15 * (1.0 + abs(self.radius)) and (not series or turn_of_newton >= 6):
                break
            if not series and turn_of_newton > 3 and last < 1e-14 * (1.0 + abs(self.radius)):
                break
        return list(n), gap

    def _first_guess(self, body: Body, position: Vector, turn: Matrix) -> list[float]:
        """Normal by bisection between directions: the point of the body nearest to the support."""
        sign = math.copysign(1.0, self.radius)
        here = np.array([float(x) for x in position])
        matrix = np.array([[float(x) for x in row] for row in turn])
        grid = np.array(
            [
                [math.sin(t) * math.cos(p), math.sin(t) * math.sin(p), math.cos(t)]
                for t in np.linspace(0.01, 3.13, 60)
                for p in np.linspace(0.0, 6.28, 120)
            ]
        )
        form = np.array([[float(x) for x in row] for row in body.form])
        centre = np.array([float(x) for x in body.centre])
        bodily = grid @ matrix
        b = bodily @ form
        points = here + (centre - b / np.sqrt(np.sum(bodily * b, axis=1))[:, None]) @ matrix.T
        alike = sign * np.sum(points * grid, axis=1) / np.linalg.norm(points, axis=1)
        best: list[float] = grid[int(np.argmax(alike))].tolist()
        return best


# ---------------------------------------------------------------------------------------------
# Laws of friction


@dataclass(frozen=True)
class Law:
    """Coefficients of friction and impact; see the table at the head of the module."""

    mu: float = 0.0
    spin_arm: float = 0.0
    patch: float = 0.0
    viscous: float = 0.0
    spin_viscous: float = 0.0
    slip: float = 0.0
    rolling: float = 0.0
    rolling_viscous: float = 0.0
    contour: float = 0.0
    restitution: float = 0.0
    impact_law: str = "stronge"

    @property
    def coupled(self) -> bool:
        """Whether sliding and spinning friction come from one patch."""
        return self.patch > 0.0 and self.mu > 0.0


def hypergeometric(a: float, b: float, c: float, x: Number) -> Any:
    """Sum of Gauss' series, for x up to about 1/4."""
    term = 1.0
    coefficients = [term]
    for k in range(30):
        term *= (a + k) * (b + k) / ((c + k) * (k + 1.0))
        coefficients.append(term)
    total: Number = coefficients[-1]
    for value in reversed(coefficients[:-1]):
        total = total * x + value
    return total


def patch_friction(slip: Vector, spin: Number) -> tuple[list[Any], Any]:
    """Force over mu N and couple over mu N a of a round patch under Hertz' pressure.

    Parameters
    ----------
    slip, spin
        Slip velocity (3,) and spin times the radius of the patch, up to a common factor.
    """
    slip_square, spin_square = dot(slip, slip), spin * spin
    if slip_square <= spin_square:
        size = abs(spin)
        q = slip_square / spin_square
        force = times(-(3.0 * math.pi / 8.0) * (1.0 - 0.25 * q) / size, slip)
        couple = -(3.0 * math.pi / 16.0) * (1.0 - q + 0.375 * q * q) * (spin / size)
        return force, couple
    speed = root(slip_square)
    j = spin / speed
    q = j * j
    if q < 0.25:
        f = hypergeometric(-0.5, 0.5, 2.5, q)
        m = 0.2 * j * hypergeometric(0.5, 0.5, 3.5, q)
    else:
        k = 1.0 / abs(j)
        s = root(k * k - 1.0) if k * k > 1.0 else 0.0 * k
        alpha = arcsine(1.0 / k)
        f = (3.0 / 16.0) * ((4.0 * k - k * k * k) * alpha + (k + 2.0 / k) * s)
        quartic = 8.0 - 8.0 * (k * k) + 3.0 * (k * k) * (k * k)
        m = (3.0 / 64.0) * (quartic * alpha + 3.0 * (2.0 - k * k) * s)
        if j < 0.0:
            m = -m
    return times(-f / speed, slip), -m


# ---------------------------------------------------------------------------------------------
# Motion


@dataclass(frozen=True)
class Mode:
    """What the contact does: which of sliding, spinning and turning over are held at zero.

    `sign` is the sign of the spin where an independent spin couple needs it.
    """

    contact: bool = True
    slide_held: bool = False
    spin_held: bool = False
    turn_held: bool = False
    sign: float = 1.0


class Direction(NamedTuple):
    """Directions given to the laws where the velocities themselves vanish.

    `slip` and `spin` up to a common factor; `spin` counts under the coupled law only.
    """

    slip: Vector | None = None
    spin: Number = 0.0
    turn: Vector | None = None


class Response(NamedTuple):
    """Accelerations and forces at one instant, in space axes."""

    acceleration: list[Any]
    torque: list[Any]
    normal: Any
    friction: list[Any]
    spin_couple: Any
    turn_couple: list[Any]
    slip: list[Any]
    slip_rate: list[Any]
    spin: Any
    spin_rate: Any
    turn: list[Any]
    turn_rate: list[Any]
    n: list[Any]
    omega: list[Any]


class Problem:
    """Body, support, law and gravity, with the forces and accelerations that follow."""

    def __init__(
        self,
        body: Mapping[str, Any],
        surface: Mapping[str, Any],
        contact: Mapping[str, Any],
        gravity: float,
        number: type = float,
    ) -> None:
        self.body = Body(body, number)
        self.surface = Surface(surface)
        self.law = Law(**contact)
        self.gravity = gravity
        self.guess: list[float] | None = None

    def geometry(self, y: Vector) -> tuple[Any, list[Any], Any, list[Any], list[Any]]:
        """Rotation, normal, gap, arm and angular velocity (space axes) of a state."""
        turn = rotation(y[3:7])
        n, gap = self.surface.normal_and_gap(self.body, y[:3], turn, self.guess)
        if not self.surface.is_plane and not self.body.is_ball:
            self.guess = [float(x) for x in n]
        arm = applied(turn, self.body.arm(transposed(turn, n)))
        inner = minus(transposed(turn, y[10:13]), self.body.gyrostat)
        omega = applied(turn, applied(self.body.inverse, inner))
        return turn, n, gap, arm, omega

    def response(self, y: Vector, mode: Mode, given: Direction = Direction()) -> Response:
        """Forces and accelerations of a body in contact, from one dense linear system.

        Unknowns: angular acceleration (body components), then the normal force, or the three
        components of the whole force where sliding is held, and the couples that hold.
        """
        body, law, surface = self.body, self.law, self.surface
        turn, n, _, arm, omega = self.geometry(y)
        velocity = y[7:10]
        point_velocity = plus(velocity, cross(omega, arm))
        gamma = transposed(turn, n)

        def spread(rate: Vector) -> list[Any]:
            return applied(turn, body.arm_rate(gamma, transposed(turn, rate)))

        turning = cross(omega, n)
        if surface.is_plane:
            n_rate: list[Any] = [0.0, 0.0, 0.0]
        else:
            drift = transposed(turn, minus(point_velocity, spread(turning)))
            columns = [body.arm_rate(gamma, axis) for axis in AXES]
            rows = [
                [(surface.radius if i == j else 0.0) - columns[j][i] for j in range(3)]
                for i in range(3)
            ]
            n_rate = applied(turn, solution(rows, drift))
        arm_rate = plus(cross(omega, arm), spread(minus(n_rate, turning)))
        swing = cross(omega, arm_rate)

        support_velocity: list[Any] = [0.0, 0.0, 0.0]
        support_rate: list[Any] = [0.0, 0.0, 0.0]
        if surface.turntable:
            axis = times(surface.turntable, UP)
            support_velocity = cross(axis, plus(y[:3], arm))
            support_rate = cross(axis, plus(velocity, arm_rate))
        slip = minus(point_velocity, support_velocity)
        upright = dot(omega, n)
        spin = upright - surface.turntable
        over = minus(omega, times(upright, n))

        force, couple = self._per_normal_force(slip, spin, over, n, spread, mode, given)
        steady_force = times(-law.viscous, slip) if law.viscous else [0.0, 0.0, 0.0]
        steady_couple = times(-law.spin_viscous * spin, n)

        # columns: (force, couple about the centre of mass) of each unknown multiplier
        columns_of: list[tuple[Vector, Vector]] = []
        if mode.slide_held:
            for i, axis_i in enumerate(AXES):
                columns_of.append((axis_i, plus(cross(arm, axis_i), times(n[i], couple))))
        else:
            columns_of.append((plus(n, force), plus(cross(arm, plus(n, force)), couple)))
        if mode.spin_held:
            columns_of.append((ZERO, n))
        t1, t2 = tangents(n)
        if mode.turn_held:
            columns_of.extend([(ZERO, t1), (ZERO, t2)])

        m = body.mass
        known_acceleration = plus(times(1.0 / m, steady_force), [0.0, 0.0, -self.gravity])
        known_torque = plus(cross(arm, steady_force), steady_couple)
        inertia = body.inertia.tolist()
        matrix: list[list[Any]] = []
        right: list[Any] = []
        bodily = [transposed(turn, c) for _, c in columns_of]
        euler = transposed(turn, minus(known_torque, cross(omega, y[10:13])))
        for i in range(3):
            matrix.append([*inertia[i], *[-c[i] for c in bodily]])
            right.append(euler[i])

        def condition(linear: Vector, angular: Vector, value: Any) -> None:
            """Row: linear.V' + angular.omega' = value."""
            forces = [dot(linear, f) / m for f, _ in columns_of]
            matrix.append([*transposed(turn, angular), *forces])
            right.append(value - dot(linear, known_acceleration))

        if mode.slide_held:
            for i, axis_i in enumerate(AXES):
                condition(axis_i, cross(arm, axis_i), support_rate[i] - swing[i])
        else:
            condition(n, cross(arm, n), -dot(n, swing) - dot(n_rate, point_velocity))
        if mode.spin_held:
            condition(ZERO, n, -dot(omega, n_rate))
        if mode.turn_held:
            for t in (t1, t2):
                condition(ZERO, t, upright * dot(n_rate, t))

        found = solution(matrix, right)
        omega_rate = applied(turn, found[:3])
        multipliers = found[3:]
        total_force: list[Any] = list(steady_force)
        total_torque: list[Any] = list(known_torque)
        for x, (f, c) in zip(multipliers, columns_of, strict=True):
            total_force = plus(total_force, times(x, f))
            total_torque = plus(total_torque, times(x, c))
        normal = dot(total_force, n)
        held = multipliers[3 if mode.slide_held else 1 :]
        spin_couple = held[0] if mode.spin_held else 0.0
        acceleration = plus(times(1.0 / m, total_force), [0.0, 0.0, -self.gravity])
        upright_rate = dot(omega_rate, n) + dot(omega, n_rate)
        return Response(
            acceleration,
            total_torque,
            normal,
            minus(total_force, times(normal, n)),
            spin_couple,
            plus(times(held[-2], t1), times(held[-1], t2)) if mode.turn_held else list(ZERO),
            slip,
            minus(plus(acceleration, cross(omega_rate, arm), swing), support_rate),
            spin,
            upright_rate,
            over,
            minus(omega_rate, plus(times(upright_rate, n), times(upright, n_rate))),
            n,
            omega,
        )

    def _per_normal_force(
        self,
        slip: Vector,
        spin: Any,
        over: Vector,
        n: Vector,
        spread: Callable[[Vector], list[Any]],
        mode: Mode,
        given: Direction,
    ) -> tuple[list[Any], list[Any]]:
        """Friction force and couple for a unit normal force, where the contact moves."""
        law = self.law
        force: list[Any] = [0.0, 0.0, 0.0]
        couple: list[Any] = [0.0, 0.0, 0.0]
        if not mode.slide_held:
            if law.coupled:
                f, c = (
                    patch_friction(slip, law.patch * spin)
                    if given.slip is None
                    else patch_friction(given.slip, given.spin)
                )
                force = times(law.mu, f)
                couple = times(law.mu * law.patch * c, n)
            elif law.mu:
                e = slip if given.slip is None else given.slip
                force = times(-law.mu / length(e), e)
            if law.slip:
                force = minus(force, times(law.slip, slip))
        if law.spin_arm and not mode.spin_held:
            couple = minus(couple, times(law.spin_arm * mode.sign, n))
        if law.rolling and not mode.turn_held:
            e = over if given.turn is None else given.turn
            couple = minus(couple, times(law.rolling / length(e), e))
        if law.rolling_viscous:
            couple = minus(couple, times(law.rolling_viscous, over))
        if law.contour:
            path = spread(cross(n, over))
            couple = plus(couple, times(law.contour / length(path), cross(n, spread(path))))
        return force, couple

    def rate(self, y: Vector, mode: Mode, given: Direction = Direction()) -> list[Any]:
        """Derivative of the state."""
        if mode.contact:
            found = self.response(y, mode, given)
            acceleration, torque, omega = found.acceleration, found.torque, found.omega
        else:
            turn = rotation(y[3:7])
            inner = minus(transposed(turn, y[10:13]), self.body.gyrostat)
            omega = applied(turn, applied(self.body.inverse, inner))
            acceleration, torque = [0.0, 0.0, -self.gravity], [0.0, 0.0, 0.0]
        return [*y[7:10], *quaternion_rate(omega, y[3:7]), *acceleration, *torque]

    def energy(self, y: Vector) -> float:
        """Kinetic and potential energy."""
        turn = rotation(y[3:7])
        inner = minus(transposed(turn, y[10:13]), self.body.gyrostat)
        omega = applied(self.body.inverse, inner)
        kinetic = self.body.mass * dot(y[7:10], y[7:10]) + dot(inner, omega)
        return float(0.5 * kinetic + self.body.mass * self.gravity * y[2])


def quaternion_rate(omega: Vector, q: Vector) -> list[Any]:
    """Half the product of `omega` (space axes) with the quaternion."""
    a, b, c = omega
    w, x, y, z = q
    return [
        -0.5 * (a * x + b * y + c * z),
        0.5 * (a * w + b * z - c * y),
        0.5 * (b * w + c * x - a * z),
        0.5 * (c * w + a * y - b * x),
    ]


# ---------------------------------------------------------------------------------------------
# Integration with events


Watch = Callable[[float, Array], list[float]]


class Extrapolation:
    """Integration in the arithmetic of the state, to any precision, with the face of `DOP853`.

    The modified midpoint rule with 2, 4, ..., 20 substeps, extrapolated to none (Gragg, Bulirsch
    and Stoer). Every coefficient is a ratio of whole numbers, so that long double states keep their
    nineteen digits.
    """

    columns = 10

    def __init__(
        self,
        rate: Callable[[float, Array], Array],
        start: float,
        state: Array,
        end: float,
        rtol: float,
        scales: Array,
        first_step: float | None = None,
    ) -> None:
        self.rate, self.t, self.y, self.end = rate, start, state, end
        self.rtol, self.scales = rtol, scales
        speed = float(np.max(np.abs(rate(start, state)) / scales))
        self.h = first_step if first_step is not None else min(end - start, 0.3 / max(speed, 1e-9))
        self.status = "running"
        self.last = (self.t, self.y)

    def advanced(self, t: float, y: Array, h: float) -> tuple[Array, Array]:
        """State after one step and the difference of the two best extrapolations."""
        slope = self.rate(t, y)
        row: list[Array] = []
        for k in range(1, self.columns + 1):
            n = 2 * k
            small = h / n
            older, newer = y, y + small * slope
            for i in range(1, n):
                older, newer = newer, older + 2.0 * small * self.rate(t + i * small, newer)
            new = [0.5 * (older + newer + small * self.rate(t + h, newer))]
            for j, previous in enumerate(row, start=1):
                ratio = (
                    (k * k) / (k - j) ** 2
                    if y.dtype != np.longdouble
                    else (np.longdouble(k * k) / (k - j) ** 2)
                )
                new.append(new[-1] + (new[-1] - previous) / (ratio - 1))
            row = new
        return row[-1], row[-1] - row[-2]

    def step(self) -> str | None:
        """Advance by one accepted step."""
        while True:
            h = min(self.h, self.end - self.t)
            y, difference = self.advanced(self.t, self.y, h)
            sizes = self.scales + np.abs(y)
            error = float(np.sqrt(np.mean((difference / sizes).astype(float) ** 2))) / self.rtol
            factor = 0.9 * max(error, 1e-8) ** (-1.0 / (2 * self.columns - 1))
            self.h = h * min(3.0, max(0.2, factor))
            if math.isfinite(error) and error <= 1.0:
                break
            if not math.isfinite(error):
                self.h = 0.2 * h
            if self.h < 1e-12 * abs(self.end - self.t) and self.h < 1e-12 * abs(self.t):
                self.status = "failed"
                return "step too small"
        self.last = (self.t, self.y)
        done = h == self.end - self.t
        self.t, self.y = self.end if done else self.t + h, y
        if done:
            self.status = "finished"
        return None

    def dense_output(self) -> Callable[[float], Array]:
        """State within the last step, by a shorter step from its beginning."""
        t0, y0 = self.last

        def at(t: float) -> Array:
            return y0 if t == t0 else self.advanced(t0, y0, t - t0)[0]

        return at


def integration(
    rate: Callable[[float, Array], Array],
    start: float,
    state: Array,
    end: float,
    rtol: float,
    scales: Array,
    first_step: float | None = None,
) -> DOP853 | Extrapolation:
    """DOP853 for floats, extrapolation for long double."""
    if state.dtype == np.longdouble:
        return Extrapolation(rate, start, state, end, rtol, scales, first_step)
    return DOP853(rate, start, state, end, rtol=rtol, atol=rtol * scales, first_step=first_step)


def run(
    rate: Callable[[float, Array], Array],
    start: float,
    state: Array,
    end: float,
    watch: Watch,
    rtol: float,
    scales: Array,
) -> tuple[float, Array, int | None]:
    """Integrate until one of the watched values falls from above to zero, or until `end`.

    Returns
    -------
    tuple
        Time, state and index of the value that fell to zero (None at the end).
    """
    solver = integration(rate, start, state, end, rtol, scales)
    before = np.array(watch(start, state))
    while solver.status == "running":
        t0, z0 = solver.t, solver.y.copy()
        message = solver.step()
        if solver.status == "failed":
            raise ArithmeticError(f"integration failed at {t0}: {message}")
        dense = solver.dense_output()
        samples = [t0, *(t0 + (solver.t - t0) * np.array([0.25, 0.5, 0.75])), solver.t]
        values = [before, *(np.array(watch(s, dense(s))) for s in samples[1:-1])]
        values.append(np.array(watch(solver.t, solver.y)))
        table = np.array(values)
        first: tuple[float, int] | None = None
        for i in range(table.shape[1]):
            moment = _fall(lambda s, i=i: watch(s, dense(s))[i], samples, table[:, i])
            if moment is not None and (first is None or moment < first[0]):
                first = (moment, i)
        if first is not None:
            t, z = _polished(rate, t0, z0, first, watch, rtol, scales)
            return t, z, first[1]
        before = values[-1]
    return solver.t, solver.y, None


def _fall(value: Callable[[float], float], times_: list[float], values: Array) -> float | None:
    """First moment at which a value falls from above to zero, by samples and root finding."""
    for j in range(len(times_) - 1):
        if values[j] > 0.0 >= values[j + 1]:
            if values[j + 1] == 0.0:
                return times_[j + 1]
            return float(brentq(value, times_[j], times_[j + 1], xtol=1e-300, rtol=1e-15))
        if 0 < j < len(times_) - 1 and values[j - 1] > values[j] < values[j + 1]:
            second = values[j - 1] - 2.0 * values[j] + values[j + 1]
            dip = values[j] - (values[j + 1] - values[j - 1]) ** 2 / (8.0 * second)
            if values[j] > 0.0 and dip < 0.5 * values[j]:
                bounds = (times_[j - 1], times_[j + 1])
                lowest = minimize_scalar(value, bounds=bounds, method="bounded")
                if lowest.fun < 0.0:
                    return float(brentq(value, times_[j - 1], lowest.x, xtol=1e-300, rtol=1e-15))
    return None


def _polished(
    rate: Callable[[float, Array], Array],
    t0: float,
    z0: Array,
    found: tuple[float, int],
    watch: Watch,
    rtol: float,
    scales: Array,
) -> tuple[float, Array]:
    """Integrate anew to a supposed event, correct its time by the value found there, twice."""
    moment, i = found
    for _ in range(3):
        if moment <= t0:
            return t0, z0
        z, dense = _carried(rate, t0, z0, moment, rtol, scales)
        value = watch(moment, z)[i]
        h = 1e-4 * (moment - t0)
        slope = (value - watch(moment - h, dense(moment - h))[i]) / h
        if not math.isfinite(slope) or slope >= 0.0:
            break
        step = -value / slope
        if abs(step) <= 2.0 * np.finfo(z0.dtype).eps * abs(moment):
            break
        moment += step
    return moment, _carried(rate, t0, z0, moment, rtol, scales)[0]


def _carried(
    rate: Callable[[float, Array], Array],
    t0: float,
    z0: Array,
    end: float,
    rtol: float,
    scales: Array,
) -> tuple[Array, Callable[[float], Array]]:
    """State at `end`, and the dense output of the last step."""
    solver = integration(rate, t0, z0, end, rtol, scales, end - t0)
    while solver.status == "running":
        solver.step()
    if solver.status == "failed":
        raise ArithmeticError(f"integration failed at {solver.t}")
    return solver.y, solver.dense_output()


# ---------------------------------------------------------------------------------------------
# Simulation


@dataclass(frozen=True)
class Event:
    """Change of mode: time, kind, states (13,) before and after."""

    time: float
    kind: str
    before: list[float]
    after: list[float]


@dataclass(frozen=True)
class Dying:
    """Vanishing velocity: `kind` "slide" or "turn", logarithm of its size, its direction.

    The direction has three components in space, under the coupled law a fourth, the spin times the
    radius of the patch.
    """

    kind: str
    log: float
    direction: list[float]


class Motion:
    """One motion with all its changes of mode."""

    def __init__(self, problem: Problem, y: list[float], until: float, rtol: float) -> None:
        self.problem, self.until, self.rtol = problem, until, rtol
        self.t, self.y = type(y[0])(0.0), y
        self.tiny = 2e-16 if isinstance(y[0], float) else 1e-19
        self.mode = Mode(contact=False)
        self.dying: Dying | None = None
        self.events: list[Event] = []
        self.at_rest = False
        self.remarks: list[str] = []
        body, g = problem.body, max(problem.gravity, 1e-3)
        self.speed = math.sqrt(g * body.size)
        self.momentum = float(np.linalg.norm(body.inertia)) * math.sqrt(g / body.size)

    # -- small things ----------------------------------------------------------------------

    def scales(self, y: Sequence[float]) -> Array:
        """Sizes against which errors of the state are measured."""
        x = max(float(length(y[:3])), self.problem.body.size)
        v = max(float(length(y[7:10])), self.speed)
        m = max(float(length(y[10:13])), self.momentum)
        return np.array([x] * 3 + [1.0] * 4 + [v] * 3 + [m] * 3)

    def record(self, kind: str, before: list[float]) -> None:
        """Add an event at the present time."""
        self.events.append(Event(self.t, kind, before, list(self.y)))

    def vanishing(self, found: Response, kind: str) -> tuple[list[Any], list[Any]]:
        """The velocity that may vanish, and its rate."""
        if kind == "turn":
            return found.turn, found.turn_rate
        if self.problem.law.coupled:
            a = self.problem.law.patch
            return [*found.slip, a * found.spin], [*found.slip_rate, a * found.spin_rate]
        return found.slip, found.slip_rate

    def given(self, kind: str, e: Sequence[Any]) -> Direction:
        """Direction `e` as the laws of friction take it."""
        if kind == "turn":
            return Direction(turn=e)
        return Direction(slip=e[:3], spin=e[3] if len(e) == 4 else 0.0)

    def without_slip(self) -> None:
        """Make the slip velocity exactly zero."""
        found = self.problem.response(self.y, self.mode, Direction((1.0, 0.1, 0.2), 1.0, UP))
        self.y[7:10] = minus(self.y[7:10], found.slip)

    # -- what holds, what goes on ------------------------------------------------------------

    def limits(self, found: Response, mode: Mode) -> list[float]:
        """Distances of the holding forces from their limits, over the weight."""
        law, weight = self.problem.law, self.problem.body.mass * max(self.problem.gravity, 1e-3)
        values = []
        if mode.slide_held:
            if law.coupled:
                values.append(self.coupled_limit(found)[0] * found.normal / weight)
            else:
                values.append((law.mu * found.normal - float(length(found.friction))) / weight)
        if mode.spin_held and not law.coupled:
            values.append((law.spin_arm * found.normal - abs(found.spin_couple)) / weight)
        if mode.turn_held:
            held = float(length(found.turn_couple))
            values.append((law.rolling * found.normal - held) / weight)
        return values

    def coupled_limit(self, found: Response) -> tuple[float, float]:
        """Distance of the held force and couple from the limit curve; angle of sliding there."""
        law = self.problem.law
        f = float(length(found.friction)) / (law.mu * abs(found.normal))
        c = abs(found.spin_couple) / (law.mu * law.patch * abs(found.normal))

        def on_curve(angle: float) -> tuple[float, float]:
            force, couple = patch_friction((math.sin(angle), 0.0, 0.0), math.cos(angle))
            return -force[0], -couple

        def mismatch(angle: float) -> float:
            x, y = on_curve(angle)
            return x * c - y * f

        angle = 0.5 * math.pi
        if mismatch(angle) > 0.0:
            angle = float(brentq(mismatch, 0.0, angle, xtol=1e-300, rtol=1e-15))
        return math.hypot(*on_curve(angle)) - math.hypot(f, c), angle

    def settled(self, slide_zero: bool, spin_zero: bool, turn_zero: bool) -> None:
        """Choose the mode of a contact, some of whose velocities are zero."""
        law = self.problem.law
        probe = self.problem.response(
            self.y, Mode(), Direction((1.0, 0.1, 0.2), 1.0, (1.0, 0.2, 0.1))
        )
        slide_zero = slide_zero and law.mu > 0.0
        spins: list[tuple[bool, float]] = [(False, math.copysign(1.0, probe.spin))]
        if law.spin_arm and spin_zero:
            spins = [(True, 1.0), (False, 1.0), (False, -1.0)]
        turns = [True, False] if law.rolling and turn_zero else [False]
        for turn, slide in itertools.product(turns, [True, False] if slide_zero else [False]):
            for spin_held, sign in spins:
                held = spin_held or (law.coupled and slide)
                mode = Mode(True, slide, held, turn, sign)
                dying = None
                given = Direction()
                if slide_zero and not slide:
                    e = self.exit(mode, "slide")
                    if e is None:
                        continue
                    dying, given = Dying("slide", LAST + math.log(SMALL), e), self.given("slide", e)
                elif law.rolling and turn_zero and not turn:
                    e = self.exit(mode, "turn")
                    if e is None:
                        continue
                    dying, given = Dying("turn", LAST + math.log(SMALL), e), self.given("turn", e)
                found = self.problem.response(self.y, mode, given)
                if found.normal <= 0.0 or any(x < 0.0 for x in self.limits(found, mode)):
                    continue
                if law.spin_arm and spin_zero and not held and sign * found.spin_rate < 0.0:
                    continue
                self.mode, self.dying = mode, dying
                return
        free = (
            probe
            if not slide_zero
            else self.problem.response(
                self.y, Mode(), Direction((1.0, 0.1, 0.2), 1.0, (1.0, 0.2, 0.1))
            )
        )
        if free.normal <= 0.0:
            self.mode, self.dying = Mode(contact=False), None
            self.record("lift-off", list(self.y))
            return
        raise ArithmeticError(f"no mode is consistent at t = {self.t}")

    def exit(self, mode: Mode, kind: str) -> list[float] | None:
        """Attracting direction in which a zero velocity grows, with the motion frozen."""
        found = self.problem.response(self.y, mode, self.given(kind, [1.0, 0.1, 0.2, 0.3]))
        t1, t2 = tangents(found.n)
        four = kind == "slide" and self.problem.law.coupled

        def velocity_rate(w: Array) -> Array:
            e = plus(times(w[0], t1), times(w[1], t2))
            e = [*e, w[2]] if four else e
            rate = self.vanishing(self.problem.response(self.y, mode, self.given(kind, e)), kind)[1]
            flat = [dot(rate[:3], t1), dot(rate[:3], t2)]
            return np.array([*flat, rate[3]] if four else flat)

        for start in itertools.product((-1.0, 0.3, 0.9), (-0.8, 0.2, 1.0), (-0.7, 0.6)):
            w = np.array(start[:3] if four else start[:2])
            w /= np.linalg.norm(w)
            size = 0.2 / max(float(np.linalg.norm(velocity_rate(w))), 1e-12)
            for _ in range(4000):
                x = velocity_rate(w)
                across = x - (x @ w) * w
                if np.linalg.norm(across) < 1e-13 * np.linalg.norm(x):
                    break
                middle = w + 0.5 * size * across
                x2 = velocity_rate(middle / np.linalg.norm(middle))
                step = size * (x2 - (x2 @ w) * w)
                if np.linalg.norm(step) > 0.3:
                    size *= 0.5
                    continue
                w = w + step
                w /= np.linalg.norm(w)
            x = velocity_rate(w)
            if x @ w > 0.0 and np.linalg.norm(x - (x @ w) * w) < 1e-6 * np.linalg.norm(x):
                e = plus(times(w[0], t1), times(w[1], t2))
                return [*e, float(w[2])] if four else e
        return None

    # -- pieces --------------------------------------------------------------------------------

    def go(self) -> None:
        """Run until the end."""
        for _ in range(10_000):
            if self.t >= self.until or self.at_rest:
                return
            if not self.mode.contact:
                self.fly()
            elif self.dying is not None:
                self.die_away()
            else:
                self.move()
        raise ArithmeticError("too many events")

    def fly(self) -> None:
        """Free flight to the next landing."""
        problem, mode = self.problem, Mode(contact=False)
        armed = [False]

        def rate(t: float, z: Array) -> Array:
            return np.array(problem.rate(z.tolist(), mode))

        def watch(t: float, z: Array) -> list[float]:
            gap = problem.geometry(z.tolist())[2]
            if gap > 1e-9 * problem.body.size:
                armed[0] = True
            return [gap if armed[0] else 0.0]

        y = np.array(self.y)
        t, z, which = run(rate, self.t, y, self.until, watch, self.rtol, self.scales(self.y))
        self.t, self.y = t, z.tolist()
        if which is not None:
            self.land()

    def land(self) -> None:
        """Impact, and what follows it."""
        before = list(self.y)
        stuck, spin_stopped, leaves = impact(self.problem, self.y, self.rtol)
        self.dying = None
        self.mode = Mode(contact=not leaves)
        self.record("landing", before)
        if leaves:
            return
        _, n, gap, _, _ = self.problem.geometry(self.y)
        self.y[:3] = minus(self.y[:3], times(gap, n))
        if stuck:
            self.without_slip()
        self.settled(stuck, spin_stopped, False)
        self.events[-1] = replace(self.events[-1], after=list(self.y))

    def kink(self) -> Callable[[Response], list[float]]:
        """Watched values for equal slip and rim speed of a patch, where its law is not analytic."""
        a = self.problem.law.patch
        armed = [False, False]

        def values(found: Response) -> list[float]:
            slip, rim = float(length(found.slip)), abs(a * found.spin)
            excess = (slip - rim) / (slip + rim)
            for i, value in enumerate((excess, -excess)):
                armed[i] = armed[i] or value > 1e-6
            return [excess if armed[0] else 0.0, -excess if armed[1] else 0.0]

        return values

    def move(self) -> None:
        """Contact with no velocity about to vanish."""
        problem, law, mode = self.problem, self.problem.law, self.mode
        names = ["lift-off"]
        sliding = law.mu > 0.0 and not mode.slide_held
        turning = law.rolling > 0.0 and not mode.turn_held
        spinning = law.spin_arm > 0.0 and not mode.spin_held
        if sliding:
            names.append("slide")
        if turning:
            names.append("turn")
        if spinning:
            names.append("spin stop")
        if mode.slide_held:
            names.append("slip")
        if mode.spin_held and not law.coupled:
            names.append("spin start")
        if mode.turn_held:
            names.append("turn start")
        kinked = sliding and law.coupled
        if kinked:
            names.extend(["kink", "kink"])
        kink = self.kink()

        def rate(t: float, z: Array) -> Array:
            return np.array(problem.rate(z.tolist(), mode))

        def watch(t: float, z: Array) -> list[float]:
            found = problem.response(z.tolist(), mode)
            values = [found.normal]
            if sliding:
                x = np.array(self.vanishing(found, "slide")[0])
                values.append(float(np.linalg.norm(x)) - SMALL)
            if turning:
                values.append(float(length(found.turn)) - SMALL)
            if spinning:
                values.append(mode.sign * found.spin)
            values += self.limits(found, mode)
            return values + kink(found) if kinked else values

        if sliding or turning:
            found = problem.response(self.y, mode)
            for kind in (["slide"] if sliding else []) + (["turn"] if turning else []):
                x = np.array(self.vanishing(found, kind)[0])
                size = root((x @ x).item())
                if size <= SMALL:
                    self.dying = Dying(kind, logarithm(size), (x / size).tolist())
                    return
        y = np.array(self.y)
        t, z, which = run(rate, self.t, y, self.until, watch, self.rtol, self.scales(self.y))
        self.t, self.y = t, z.tolist()
        if which is not None:
            self.change(names[which])

    def change(self, name: str) -> None:
        """What follows when a watched value has fallen to zero."""
        law, mode, before = self.problem.law, self.mode, list(self.y)
        if name in ("slide", "turn"):
            found = self.problem.response(self.y, mode)
            x = np.array(self.vanishing(found, name)[0])
            size = root((x @ x).item())
            self.dying = Dying(name, logarithm(size), (x / size).tolist())
        elif name == "lift-off":
            _, n, gap, _, _ = self.problem.geometry(self.y)
            self.y[:3] = minus(self.y[:3], times(gap, n))
            self.mode, self.dying = Mode(contact=False), None
            self.record("lift-off", before)
        elif name == "spin stop":
            given = (
                Direction()
                if self.dying is None
                else self.given(self.dying.kind, self.dying.direction)
            )
            held = replace(mode, spin_held=True)
            found = self.problem.response(self.y, held, given)
            if abs(found.spin_couple) <= law.spin_arm * found.normal:
                self.mode = held
                self.record("spin stop", before)
            else:
                self.mode = replace(mode, sign=-mode.sign)
                self.remarks.append(f"spin passes through zero at {self.t!r}")
        elif name == "spin start":
            found = self.problem.response(self.y, mode, self.present())
            sign = -math.copysign(1.0, found.spin_couple)
            self.mode = replace(mode, spin_held=False, sign=sign)
            self.record("spin start", before)
        elif name in ("slip", "turn start"):
            self.record("slip" if name == "slip" else "turn start", before)
            self.start_by_series("slide" if name == "slip" else "turn")

    def present(self) -> Direction:
        """Direction of the velocity that is about to vanish."""
        if self.dying is None:
            return Direction()
        return self.given(self.dying.kind, self.dying.direction)

    def die_away(self) -> None:
        """Integrate direction and logarithm of a small velocity apart, in ``dtau = dt/size``."""
        assert self.dying is not None
        problem, law, mode, kind = self.problem, self.problem.law, self.mode, self.dying.kind
        spinning = law.spin_arm > 0.0 and not mode.spin_held
        names = ["end", "grown", "until", "lift-off"]
        if spinning:
            names.append("spin stop")
        if kind == "turn" and mode.slide_held:
            names.append("slip")
        if mode.spin_held and not law.coupled:
            names.append("spin start")
        if kind == "slide" and mode.turn_held:
            names.append("turn start")
        kinked = kind == "slide" and law.coupled
        if kinked:
            names.extend(["kink", "kink"])
        armed = [False, False]
        start = self.t

        def unit(z: list[float]) -> list[float]:
            """Direction without the parts that rounding has put along the normal.

            While the velocity dies away they would grow as fast as it decays.
            """
            n = problem.geometry(z[1:14])[1]
            e = [*minus(z[15:18], times(dot(z[15:18], n), n)), *z[18:]]
            far = root(sum(x * x for x in e))
            return [x / far for x in e]

        def response(z: list[float]) -> Response:
            return problem.response(z[1:14], mode, self.given(kind, unit(z)))

        def rate(tau: float, state: Array) -> Array:
            z = state.tolist()
            size = exponential(z[14]) if z[14] < 5.0 else 150.0
            e = unit(z)
            found = problem.response(z[1:14], mode, self.given(kind, e))
            x = self.vanishing(found, kind)[1]
            grows = sum(a * b for a, b in zip(e, x, strict=True))
            y_rate = [
                *z[8:11],
                *quaternion_rate(found.omega, z[4:8]),
                *found.acceleration,
                *found.torque,
            ]
            return np.array(
                [size, *(size * r for r in y_rate), grows]
                + [a - grows * b for a, b in zip(x, e, strict=True)]
            )

        def watch(tau: float, state: Array) -> list[float]:
            z = state.tolist()
            found = response(z)
            values = [
                z[14] - (LAST + math.log(SMALL)) + 1e-9,
                math.log(2.0 * SMALL) - z[14],
                (self.until - start) - z[0],
                found.normal,
            ]
            if spinning:
                values.append(mode.sign * found.spin)
            values += self.limits(found, mode)
            if kinked:
                e = unit(z)
                excess = float(length(e[:3])) - abs(e[3])
                for i, value in enumerate((excess, -excess)):
                    armed[i] = armed[i] or value > 1e-6
                    values.append(value if armed[i] else 0.0)
            return values

        y = np.array([0.0, *self.y, self.dying.log, *self.dying.direction])
        ones = [1.0] * len(self.dying.direction)
        scales = np.concatenate([[1e-2], self.scales(self.y), [1.0], ones])
        if self.dying.log <= LAST + math.log(SMALL):
            y[14] += 1e-6
        tau, z, which = run(rate, 0.0, y, 1e12, watch, self.rtol, scales)
        assert which is not None
        name = names[which]
        self.t = self.until if name == "until" else start + z[0]
        self.y = z[1:14].tolist()
        self.dying = Dying(kind, z[14].item(), z[15:].tolist())
        if name == "kink":
            return
        if name == "grown" or name == "until":
            self.dying = None
        elif name == "end":
            self.dying = None
            self.stopped(kind)
        else:
            self.change(name)

    def stopped(self, kind: str) -> None:
        """Sliding, or rolling, has come to its end."""
        law, before = self.problem.law, list(self.y)
        if kind == "slide":
            self.without_slip()
            spin_zero = law.coupled or self.mode.spin_held
            self.settled(True, spin_zero, self.mode.turn_held)
            held = self.mode.slide_held
        else:
            spin_zero = self.mode.spin_held
            self.settled(self.mode.slide_held, spin_zero, True)
            held = self.mode.turn_held
        if not self.mode.contact:
            return
        omega = self.problem.geometry(self.y)[4]
        still = held and length(omega) < 1e-9 and length(self.y[7:10]) < 1e-9
        if still:
            rate = self.problem.rate(self.y, self.mode)
            still = max(abs(r) for r in rate[7:]) < 1e-9 * self.problem.body.mass
        if still:
            self.record("rest", before)
            self.at_rest = True
        elif not held:
            self.record("direct restart", before)
        else:
            self.record("stick" if kind == "slide" else "turn stop", before)

    # -- a held contact begins to move -------------------------------------------------------

    def start_by_series(self, kind: str) -> None:
        """Begin to slide (or to roll) with the Taylor series of the motion.

        The direction w(t) of the velocity x is a series, unknown but for w(0), which is opposite
        to the holding force. If w is known to order k - 1, the motion to order k is an affine
        function of the next coefficient, which is found from ``x parallel to w``.
        """
        mode = self.mode
        found = self.problem.response(self.y, mode)
        coupled = kind == "slide" and self.problem.law.coupled
        if kind == "turn":
            first = times(-1.0 / length(found.turn_couple), found.turn_couple)
            mode = replace(mode, turn_held=False)
        else:
            first = times(-1.0 / length(found.friction), found.friction)
            mode = replace(mode, slide_held=False, spin_held=mode.spin_held and not coupled)
        size = 3 if coupled else 2
        dtype = type(self.y[0])
        zero_w = np.zeros((TERMS, size), dtype=dtype)
        zero_w[0, 0] = 1.0
        if coupled:
            angle = self.coupled_limit(found)[1]
            spin = -math.copysign(math.cos(angle), found.spin_couple)
            zero_w[0] = [math.sin(angle), 0.0, spin]
        across = np.linalg.svd(zero_w[:1].astype(float))[2][1:]  # directions across w(0)
        w = zero_w.copy()
        motion = np.zeros((13, TERMS), dtype=dtype)
        motion[:, 0] = self.y

        def pass_with(w: Array) -> tuple[Array, Array]:
            """Rate of the motion and the velocity x along the basis, as coefficients."""
            y = [Series(row.copy()) for row in motion]
            turn = rotation(y[3:7])
            n, _ = self.problem.surface.normal_and_gap(
                self.problem.body, y[:3], turn, self.problem.guess
            )
            n = [x if isinstance(x, Series) else Series.constant(x, TERMS) for x in n]
            t1, t2 = tangents(n, first)
            parts = [Series(w[:, i].copy()) for i in range(size)]
            far = root(sum((p * p for p in parts[1:]), parts[0] * parts[0]))
            parts = [p / far for p in parts]
            e = plus(times(parts[0], t1), times(parts[1], t2))
            given = self.given(kind, [*e, parts[2]] if coupled else e)
            response = self.problem.response(y, mode, given)
            x_rate = self.vanishing(response, kind)[1]
            x = [r.integral(0.0) for r in x_rate]
            for entry in x:
                entry.c[1] = 0.0
            flat = [dot(x[:3], t1), dot(x[:3], t2)]
            if coupled:
                flat.append(x[3])
            y_rate = [
                *y[7:10],
                *quaternion_rate(response.omega, y[3:7]),
                *response.acceleration,
                *response.torque,
            ]
            rates = np.array(
                [
                    r.c if isinstance(r, Series) else np.eye(1, TERMS, dtype=dtype)[0] * r
                    for r in y_rate
                ]
            )
            return rates, np.array([f.c for f in flat])

        slopes = np.zeros((size - 1, size - 1))
        for k in range(TERMS - 1):
            if k == 0:
                rates, _ = pass_with(w)
            else:

                def excess(trial: Array, k: int = k) -> tuple[Array, Array]:
                    rates, x = pass_with(trial)
                    along = zero_w[0] @ x
                    parallel = np.array(
                        [
                            sum(along[j] * trial[k + 1 - j, i] for j in range(2, k + 2))
                            for i in range(size)
                        ]
                    )
                    return across @ (x[:, k + 1] - parallel), rates

                base, _ = excess(w)
                if k == 1:  # the same at every order, but for the division by k + 1
                    for i, direction in enumerate(across):
                        trial = w.copy()
                        trial[k] = direction
                        slopes[:, i] = 2.0 * (excess(trial)[0] - base)
                w[k] = -(k + 1) * np.linalg.solve(slopes, base.astype(float)) @ across
                rates, _ = pass_with(w)
            motion[:, k + 1] = rates[:, k] / (k + 1)
        # the last coefficients tell how far the series may be trusted
        scales = self.scales(self.y)
        reach = math.inf
        for k in range(TERMS - 4, TERMS - 1):
            term = max(float(np.max(np.abs(motion[:, k]) / scales)), float(np.max(np.abs(w[k]))))
            if term > 0.0:
                reach = min(reach, (self.tiny / term) ** (1.0 / k))
        _, x = pass_with(w)
        along = zero_w[0] @ x
        if along[2] <= 0.0:
            raise ArithmeticError(f"sliding that begins at t = {self.t} does not grow")
        growing = Series(along[: TERMS - 2])
        for k in range(TERMS - 5, TERMS - 2):
            if along[k] != 0.0:
                reach = min(reach, (self.tiny * abs(along[2] / along[k])) ** (1.0 / (k - 2)))
        h = min(0.7 * reach * self.reach_factor, self.until - self.t)
        coefficients = w[: TERMS - 2]
        direction = np.array([np.polynomial.polynomial.polyval(h, c) for c in coefficients.T])
        far = root((direction @ direction).item())
        size_now = growing.at(h).item() * far
        direction /= far
        self.y = [np.polynomial.polynomial.polyval(h, row[:-1]).item() for row in motion]
        n = self.problem.geometry(self.y)[1]
        t1, t2 = tangents(n, first)
        e = plus(times(direction[0].item(), t1), times(direction[1].item(), t2))
        if coupled:
            e.append(direction[2].item())
        self.t += h
        self.mode = mode
        self.dying = Dying(kind, logarithm(size_now), e)

    reach_factor = 1.0
    """Part of the trusted reach of the series that is used; to be varied in checks."""


# ---------------------------------------------------------------------------------------------
# Impact


def impact(problem: Problem, y: list[float], rtol: float) -> tuple[bool, bool, bool]:
    """Change velocity and angular momentum of a state `y` by the impulses of an impact.

    The normal impulse P plays the part of time: sliding goes on against Coulomb friction, may stop,
    and then holds or begins anew. A coupled patch counts as a point.

    Returns
    -------
    tuple
        Whether sliding is held at the end, whether spinning is, and whether the body leaves.
    """
    law, body, surface = problem.law, problem.body, problem.surface
    turn, n, _, arm, omega = problem.geometry(y)
    t1, t2 = tangents(n)
    slip = plus(y[7:10], cross(omega, arm))
    if surface.turntable:
        slip = minus(slip, cross(times(surface.turntable, UP), plus(y[:3], arm)))
    spin = dot(omega, n) - surface.turntable

    def answer(impulse: Vector, couple: Vector) -> list[float]:
        """Change of (slip along t1, t2, spin, normal velocity) by an impulse at the contact."""
        torque = plus(cross(arm, impulse), couple)
        change = applied(turn, applied(body.inverse, transposed(turn, torque)))
        moved = plus(times(1.0 / body.mass, impulse), cross(change, arm))
        return [dot(moved, t1), dot(moved, t2), dot(change, n), dot(moved, n)]

    mobility = np.array([answer(t1, ZERO), answer(t2, ZERO), answer(ZERO, n), answer(n, ZERO)]).T
    # z: P, slip 1, slip 2, spin, normal velocity, work, impulses 1, 2, angular impulse, log, e1, e2
    z = np.zeros(12, dtype=type(y[0]))
    z[1:5] = [dot(slip, t1), dot(slip, t2), spin, dot(slip, n)]
    first_normal = z[4].item()
    done: dict[str, Any] = {}
    held_slide = held_spin = False
    sign = math.copysign(1.0, spin)
    compressing = True

    def ratio(e: Array | None, state: Array, slide_held: bool, spin_held: bool) -> Array:
        """Impulses (1, 2, couple) for a unit normal impulse."""
        g = np.zeros(3, dtype=z.dtype)
        if not slide_held:
            if law.mu and e is not None:
                g[:2] = -law.mu * e
            g[:2] -= law.slip * state[1:3]
        if not spin_held:
            g[2] = -law.spin_arm * sign
        rows = ([0, 1] if slide_held else []) + ([2] if spin_held else [])
        if rows:
            rest = mobility[:3, 3] + mobility[:3, :3] @ g
            g[rows] = solution(mobility[np.ix_(rows, rows)].tolist(), (-rest[rows]).tolist())
        return g

    def level(state: Array) -> Any:
        """Positive until the present phase (compression, restitution) is over."""
        if compressing:
            return (-state[4]).item()
        e = law.restitution
        if law.impact_law == "stronge":
            return (done["work"] * (1.0 - e * e) - state[5]).item()
        if law.impact_law == "poisson":
            return ((1.0 + e) * done["impulse"] - state[0]).item()
        return (-e * first_normal - state[4]).item()

    def leaving(spin_held: bool) -> Array | None:
        """Direction in which sliding starts anew after it has stopped."""

        def x_of(angle: float) -> tuple[Array, Array]:
            e = np.array([math.cos(angle), math.sin(angle)])
            g = ratio(e, z * 0.0, False, spin_held)
            return e, mobility[:2, 3] + mobility[:2, :3] @ g

        def turning(angle: float) -> float:
            e, x = x_of(angle)
            return float(x[1] * e[0] - x[0] * e[1])

        grid = np.linspace(0.0, 2.0 * math.pi, 2001)
        values = [turning(a) for a in grid]
        for a, b, u, v in zip(grid, grid[1:], values, values[1:], strict=False):
            if u > 0.0 >= v:
                e, x = x_of(float(brentq(turning, a, b, xtol=1e-300, rtol=1e-15)))
                if x @ e > 0.0:
                    return e
        return None

    state_kind = "sliding" if law.mu else "free"
    fixed: Array | None = None
    if law.mu and math.hypot(z[1], z[2]) < 1e-12:
        state_kind = "stopped"
    for _ in range(50):
        if level(z) <= 0.0:
            if compressing:
                compressing = False
                done = {"work": z[5].item(), "impulse": z[0].item()}
                if law.restitution > 0.0:
                    continue
            break
        if state_kind == "stopped":
            g = ratio(None, z, True, held_spin)
            held_slide = math.hypot(g[0], g[1]) <= law.mu
            if held_slide:
                state_kind = "held"
            else:
                fixed = leaving(held_spin)
                if fixed is None:
                    raise ArithmeticError("no direction of sliding after a stop in an impact")
                state_kind = "restarted"
        blown = state_kind == "sliding"
        if blown:
            speed = root((z[1] * z[1] + z[2] * z[2]).item())
            z[9:] = [logarithm(speed), z[1] / speed, z[2] / speed]

        def rate(tau: float, state: Array) -> Array:
            e = state[10:12] / np.sqrt(state[10:12] @ state[10:12]) if blown else fixed
            g = ratio(e, state, held_slide, held_spin)
            change = mobility @ np.array([*g, 1.0])
            out = np.concatenate([[1.0], change, [state[4]], g, [0.0, 0.0, 0.0]])
            if blown:
                grows = e @ change[:2]
                out *= np.exp(state[9])
                out[9] = grows
                out[10:] = change[:2] - grows * e
            return out

        def watch(tau: float, state: Array) -> list[float]:
            values = [level(state), 1.0, 1.0]
            if blown:
                values[1] = float(state[9]) + 45.0
            if law.spin_arm and not held_spin:
                values[2] = sign * float(state[3])
            return values

        scales = np.array(
            [body.mass, *[max(abs(first_normal), 1e-3)] * 4, 1.0, *[body.mass] * 3, 1.0, 1.0, 1.0]
        )
        _, z, which = run(rate, 0.0, z, 1e12, watch, rtol, scales)
        if which == 0:
            z[4] = 0.0 if compressing else z[4]
            if compressing:
                compressing = False
                done = {"work": z[5].item(), "impulse": z[0].item()}
                if law.restitution > 0.0:
                    continue
            break
        if which == 1:
            z[1:3] = 0.0
            state_kind = "stopped"
        if which == 2:
            g = ratio(z[10:12] if blown else fixed, z, held_slide, True)
            if abs(g[2]) <= law.spin_arm:
                held_spin = True
            else:
                sign = -sign
            if state_kind in ("held", "restarted"):
                state_kind = "stopped" if state_kind == "held" else "sliding"
    impulse = plus(times(z[6].item(), t1), times(z[7].item(), t2), times(z[0].item(), n))
    y[7:10] = plus(y[7:10], times(1.0 / body.mass, impulse))
    y[10:13] = plus(y[10:13], cross(arm, impulse), times(z[8].item(), n))
    leaves = law.restitution > 0.0
    if not leaves:  # the normal velocity is exactly zero
        y[7:10] = minus(y[7:10], times(_normal_velocity(problem, y), n))
    return held_slide, held_spin, leaves


def _normal_velocity(problem: Problem, y: list[Any]) -> Any:
    """Velocity of the nearest particle of the body away from the support."""
    _, n, _, arm, omega = problem.geometry(y)
    return dot(n, plus(y[7:10], cross(omega, arm)))


# ---------------------------------------------------------------------------------------------
# The public face


def simulate(
    body: Mapping[str, Any],
    surface: Mapping[str, Any],
    contact: Mapping[str, Any],
    start: Mapping[str, Any],
    until: float,
    gravity: float = 9.81,
    rtol: float = 1e-13,
    number: type = float,
) -> tuple[list[dict[str, Any]], dict[str, Any]]:
    """Events and final state of a motion; see the head of the module for the dictionaries.

    With ``number=numpy.longdouble`` and a tolerance such as 1e-17 the computation is done with
    nineteen digits and another method of integration, several times slower.

    Returns
    -------
    tuple
        Events, each with time, kind, position, attitude, velocity, omega (after it) and before
        (the same, before it); final state with its time.
    """
    motion = moved(body, surface, contact, start, until, gravity, rtol, number)
    events = []
    for event in motion.events:
        told = {
            "time": float(event.time),
            "kind": event.kind,
            **described(motion.problem, event.after),
        }
        told["before"] = described(motion.problem, event.before)
        events.append(told)
    return events, {"time": float(motion.t), **described(motion.problem, motion.y)}


def moved(
    body: Mapping[str, Any],
    surface: Mapping[str, Any],
    contact: Mapping[str, Any],
    start: Mapping[str, Any],
    until: float,
    gravity: float = 9.81,
    rtol: float = 1e-13,
    number: type = float,
) -> Motion:
    """The whole `Motion`, run to its end."""
    problem = Problem(body, surface, contact, gravity, number)
    q = [number(x) for x in start["attitude"]]
    far = root(sum(x * x for x in q))
    q = [x / far for x in q]
    momentum = problem.body.momentum(q, [number(x) for x in start["omega"]])
    y = [*map(number, start["position"]), *q, *map(number, start["velocity"]), *momentum]
    motion = Motion(problem, y, until, rtol)
    _, n, gap, _, omega = problem.geometry(y)
    if gap < -1e-9 * problem.body.size:
        raise ValueError(f"the body starts inside the support: gap {gap}")
    away = _normal_velocity(problem, y)
    if gap > 1e-9 * problem.body.size or away > 1e-9:
        motion.go()
        return motion
    if away < -1e-9:
        motion.land()
    else:
        motion.y[:3] = minus(y[:3], times(gap, n))
        motion.y[7:10] = minus(y[7:10], times(away, n))
        motion.mode = Mode()
        found = problem.response(motion.y, Mode(), Direction((1.0, 0.1, 0.2), 1.0, (1.0, 0.2, 0.1)))
        slip, spin = float(length(found.slip)), abs(found.spin)
        stands = slip < 1e-12 and (not problem.law.coupled or spin < 1e-12)
        if stands:
            motion.without_slip()
        motion.settled(stands, spin < 1e-12, float(length(found.turn)) < 1e-12)
    motion.go()
    return motion


def described(problem: Problem, y: Sequence[float]) -> dict[str, list[float]]:
    """State as position, attitude, velocity (space axes) and omega (body axes)."""
    turn = rotation(y[3:7])
    far = math.sqrt(sum(x * x for x in y[3:7]))
    inner = minus(transposed(turn, y[10:13]), problem.body.gyrostat)
    return {
        "position": [float(x) for x in y[:3]],
        "attitude": [float(x) / far for x in y[3:7]],
        "velocity": [float(x) for x in y[7:10]],
        "omega": [float(x) for x in applied(problem.body.inverse, inner)],
    }


def placed(
    body: Mapping[str, Any],
    surface: Mapping[str, Any],
    attitude: Sequence[float],
    omega: Sequence[float],
    slip: Sequence[float] = ZERO,
    at: Sequence[float] = ZERO,
    height: float = 0.0,
) -> dict[str, list[float]]:
    """Start of a body that touches the support, from its attitude and its slip velocity.

    Parameters
    ----------
    attitude
        Quaternion (w, x, y, z), body to space, of any length.
    omega
        Angular velocity, body axes.
    slip
        Velocity of the touching particle against the support, space axes; across the normal.
    at
        Point of contact in space; on a sphere any vector along it.
    height
        Distance by which the body is lifted off along the normal.
    """
    problem = Problem(body, surface, {}, 1.0)
    q = [float(x) for x in attitude]
    far = math.sqrt(sum(x * x for x in q))
    q = [x / far for x in q]
    turn = rotation(q)
    if problem.surface.is_plane:
        n: list[float] = list(UP)
        touch = [float(at[0]), float(at[1]), 0.0]
    else:
        reach = float(length(at))
        n = times(math.copysign(1.0, problem.surface.radius) / reach, at)
        touch = times(problem.surface.radius, n)
    arm = applied(turn, problem.body.arm(transposed(turn, n)))
    carried = cross(times(problem.surface.turntable, UP), touch)
    across = minus(slip, times(dot(slip, n), n))
    velocity = minus(plus(across, carried), cross(applied(turn, omega), arm))
    return {
        "position": plus(minus(touch, arm), times(height, n)),
        "attitude": q,
        "velocity": velocity,
        "omega": [float(x) for x in omega],
    }
