"""Accelerations of a body in contact from the dense linear equations of Newton and Euler.

The conditions of contact are velocities that stay zero; their rates are taken by an imaginary step
through the place of the contact, which is found by Newton's method.  So nothing of the curvature of
body and support is written down here.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from contact.friction_formulas import ContactState, reaction
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.modes import Mode
from nonholonomic.mechanics.shapes.shapes import Ball, Ellipsoid
from nonholonomic.mechanics.shapes.surfaces import Plane

STEP = 1e-30
UP = np.array([0.0, 0.0, 1.0])


def rotation(q: Any) -> Any:
    """Rotation matrix, body to space, of a unit quaternion (w, x, y, z)."""
    w, (x, y, z) = q[0], q[1:]
    hat = np.array([[0 * x, -z, y], [z, 0 * x, -x], [-y, x, 0 * x]])
    return np.eye(3) + 2 * w * hat + 2 * hat @ hat


def form(shape: Ball | Ellipsoid) -> Any:
    """The matrix B of a body whose points are c − Bγ/√(γ, Bγ)."""
    if isinstance(shape, Ball):
        return shape.radius**2 * np.eye(3)
    c, s = np.cos(shape.turn), np.sin(shape.turn)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return turn @ np.diag(np.square(shape.axes)) @ turn.T


def solved(equation: Callable[[Any], Any], guess: Any) -> Any:
    """A root by Newton's method, with derivatives by small real steps."""
    # imaginary parts of the equation pass through
    point = np.array(guess, dtype=complex)
    for _ in range(8):
        columns = [
            (equation(point + 1e-6 * e) - equation(point - 1e-6 * e)) / 2e-6
            for e in np.eye(len(point))
        ]
        point = point - np.linalg.solve(np.array(columns).T, equation(point))
    return point


@dataclass(frozen=True)
class Motion:
    """A situation at a state (attitude, position, velocity in space, ω in body axes)."""

    contact: FrictionalContact
    turn: float = 0.0

    def arm(self, gamma: Any) -> Any:
        """From the centre of mass to the point of the body with the outward normal −γ."""
        shape = self.contact.body.shape
        b = form(shape) @ gamma
        return np.array(shape.centre) - b / np.sqrt(gamma @ b)

    def normal(self, y: Any, guess: Any) -> Any:
        """Normal of the support at the nearest point of the body, body axes."""
        turn, surface = rotation(y[:4]), self.contact.surface
        if isinstance(surface, Plane):
            return turn.T @ UP
        place = turn.T @ y[4:7]

        def defect(unknown: Any) -> Any:
            gamma, far = unknown[:3], unknown[3]
            return np.append(place + self.arm(gamma) - far * gamma, (gamma @ gamma - 1) / 2)

        far = (place + self.arm(guess)).real @ guess
        return solved(defect, np.append(guess, far))[:3]

    def slip(self, y: Any, guess: Any) -> Any:
        """Velocity of the touching particle over the support, space axes."""
        turn, r = rotation(y[:4]), self.arm(self.normal(y, guess))
        support = self.contact.surface.turntable * np.cross(UP, y[4:7] + turn @ r)
        return y[7:10] + turn @ np.cross(y[10:13], r) - support

    def spin(self, y: Any, guess: Any) -> Any:
        """Angular velocity about the normal, relative to the support."""
        gamma = self.normal(y, guess)
        table = self.contact.surface.turntable * (rotation(y[:4]).T @ UP)
        return (y[10:13] - table) @ gamma

    def rate(self, function: Callable[..., Any], y: Any, guess: Any, speed: Any) -> Any:
        """Rate of a function of the state along a velocity of the state."""
        return np.asarray(function(y + 1j * STEP * speed, guess)).imag / STEP


def _quaternion_rate(q: Any, omega: Any) -> Any:
    w, v = q[0], q[1:]
    return np.append(-v @ omega, w * omega + np.cross(v, omega)) / 2


@dataclass(frozen=True)
class Accelerations:
    """Rates of the state, and what the support does to the body."""

    velocity: Any
    omega: Any
    gamma: Any
    normal_force: float
    force: Any
    couple: Any


def accelerations(contact: FrictionalContact, mode: Mode, y: Any, gamma: Any) -> Accelerations:
    """Accelerations in a mode, by one linear system; velocity in space, the rest in body axes.

    Parameters
    ----------
    contact : FrictionalContact
    mode : Mode
    y : array (13,)
        Attitude, position, velocity (space), ω (body).
    gamma : array (3,)
        Normal of the support, body axes.
    """
    motion, body = Motion(contact), contact.body
    mass, inertia = body.mass, np.array(body.tensor, dtype=float)
    turn, omega = rotation(y[:4]), y[10:13]
    r = motion.arm(gamma)
    steady = np.zeros(13)
    steady[:4], steady[4:7] = _quaternion_rate(y[:4], omega), y[7:10]

    weight = -mass * contact.field.gravity * UP
    torque = np.cross(inertia @ omega + np.array(body.gyrostat), omega)
    if not mode.touching:
        speed = np.concatenate([steady[:7], weight / mass, np.linalg.solve(inertia, torque)])
        gammadot = motion.rate(motion.normal, y, gamma, speed)
        return Accelerations(speed[7:10], speed[10:], gammadot, 0.0, np.zeros(3), np.zeros(3))

    table = contact.surface.turntable * (turn.T @ UP)
    slip = turn.T @ motion.slip(y, gamma).real
    spin = motion.spin(y, gamma).real
    rolling = omega - table - ((omega - table) @ gamma) * gamma
    contact_state = ContactState(slip, spin, rolling, gamma, _spread(motion, gamma))
    parts = [reaction(law, contact_state) for law in contact.laws if _acts(law, mode)]
    p, q, force, couple = (sum((part[i] for part in parts), np.zeros(3)) for i in range(4))

    # unknown: V̇ (space), ω̇, then N and what holds
    columns = [(gamma + p, q)]
    if not mode.sliding:
        across = np.linalg.svd(gamma[None])[2][1:]
        columns += [(t, np.zeros(3)) for t in across]
    if not mode.spinning:
        columns.append((np.zeros(3), gamma))
    size = 6 + len(columns)
    matrix, right = np.zeros((size, size)), np.zeros(size)
    matrix[:3, :3], matrix[3:6, 3:6] = mass * np.eye(3), inertia
    for i, (f, c) in enumerate(columns):
        matrix[:3, 6 + i] = -turn @ f
        matrix[3:6, 6 + i] = -np.cross(r, f) - c
    right[:3] = weight + turn @ force
    right[3:6] = torque + np.cross(r, force) + couple

    def upward(state: Any, guess: Any) -> Any:
        normal = rotation(state[:4]) @ motion.normal(state, guess)
        return motion.slip(state, guess) @ normal

    conditions: list[Callable[..., Any]] = [upward]
    if not mode.sliding:
        conditions = [lambda s, g, i=i: motion.slip(s, g)[i] for i in range(3)]
    if not mode.spinning:
        conditions.append(motion.spin)
    for row, condition in enumerate(conditions, 6):
        right[row] = -motion.rate(condition, y, gamma, steady)
        for column in range(6):
            matrix[row, column] = motion.rate(condition, y, gamma, np.eye(13)[7 + column])
    found = np.linalg.solve(matrix, right)
    speed = np.concatenate([steady[:7], found[:6]])
    total = force + sum(x * f for x, (f, _) in zip(found[6:], columns, strict=True))
    moment = couple + sum(x * c for x, (_, c) in zip(found[6:], columns, strict=True))
    gammadot = motion.rate(motion.normal, y, gamma, speed)
    return Accelerations(found[:3], found[3:6], gammadot, found[6], total, moment)


def _spread(motion: Motion, gamma: Any) -> Any:
    """W, by the rates of the contact vector with the normal."""
    across = np.eye(3) - np.outer(gamma, gamma)
    rates = [motion.arm(gamma + 1j * STEP * e).imag / STEP for e in across]
    return -np.array(rates).T


def _acts(law: Any, mode: Mode) -> bool:
    """Whether a law has a force or couple of its own in a mode, beside what holds."""
    if law.name in ("coulomb", "contensou", "slip"):
        return mode.sliding
    return mode.spinning if law.name == "spin" else True


def random_state(
    contact: FrictionalContact, mode: Mode, random: np.random.Generator
) -> tuple[Any, Any]:
    """A state of a mode, and the normal in body axes."""
    motion, surface = Motion(contact), contact.surface
    q = random.normal(size=4)
    q /= np.linalg.norm(q)
    turn = rotation(q)
    if isinstance(surface, Plane):
        gamma = turn.T @ UP
        height = -gamma @ motion.arm(gamma)
        position = np.append(random.normal(size=2), height)
    else:
        gamma = random.normal(size=3)
        gamma /= np.linalg.norm(gamma)
        position = turn @ (surface.signed_radius * gamma - motion.arm(gamma))
    omega, r = random.normal(size=3), motion.arm(gamma)
    table = surface.turntable * (turn.T @ UP)
    if not mode.touching:
        position = position + 0.3 * turn @ gamma
        return np.concatenate([q, position, random.normal(size=3), omega]), gamma
    if not mode.spinning:
        omega -= ((omega - table) @ gamma) * gamma
    slip = random.normal(size=3) if mode.sliding else np.zeros(3)
    slip -= (slip @ gamma) * gamma
    support = surface.turntable * np.cross(UP, position + turn @ r)
    velocity = support + turn @ (slip - np.cross(omega, r))
    return np.concatenate([q, position, velocity, omega]), gamma
