"""Random bodies at a contact, and the equations of Routh in another form."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

from flowlanes.system.arrays import FloatArray
from nonholonomic.contact.impact.impact import Impact
from nonholonomic.contact.impact.mobility import Mobility, mobility


@dataclass(frozen=True)
class Collision:
    """A body about to collide: everything in body axes."""

    mass: float
    inertia: FloatArray
    r: FloatArray
    gamma: FloatArray
    velocity: FloatArray
    omega: FloatArray

    @property
    def mobility(self) -> Mobility:
        return mobility(self.mass, self.inertia, self.r, self.gamma)

    @property
    def contact_velocity(self) -> FloatArray:
        return self.velocity + np.cross(self.omega, self.r)

    @property
    def spin(self) -> float:
        return float(self.omega @ self.gamma)


def rotation(rng: np.random.Generator) -> FloatArray:
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    return q * np.sign(np.linalg.det(q))


def collision(rng: np.random.Generator) -> Collision:
    """An asymmetric body with an oblique contact arm, approaching."""
    q, parts = rotation(rng), rng.uniform(0.2, 1, 3)
    moments = (parts.sum() - parts) * rng.uniform(0.1, 0.6)
    gamma = rotation(rng)[0]
    r = rng.normal(size=3)
    r *= -np.sign(r @ gamma)
    omega, velocity = rng.normal(size=3), rng.normal(size=3)
    approach = gamma @ (velocity + np.cross(omega, r))
    velocity = velocity - (approach + abs(rng.normal()) + 0.1) * gamma
    inertia = q @ np.diag(moments) @ q.T
    return Collision(rng.uniform(0.5, 2), (inertia + inertia.T) / 2, r, gamma, velocity, omega)


def kinetic_energy(c: Collision, velocity: FloatArray, omega: FloatArray) -> float:
    return float(c.mass * velocity @ velocity + omega @ c.inertia @ omega) / 2


def implicit_steps(
    m: Mobility, u: FloatArray, spin: float, mu: float, arm: float, impulse: float, steps: int
) -> tuple[FloatArray, float]:
    """Contact velocity and spin at a given normal impulse, by implicit steps of first order.

    No modes: each step's friction impulse and couple are the fixed point of the projection on
    the disk and the interval, which is what the multivalued law says of a backward step.
    """
    axes = np.vstack([m.tangents, m.gamma])
    c = axes @ m.spin_force
    G = np.block([[axes @ m.A @ axes.T, c[:, None]], [c, np.array([m.spin])]])
    x = np.append(axes @ u, spin)
    h = impulse / steps
    moving = [0, 1, 3]
    rate = 1 / np.linalg.eigvalsh(G[np.ix_(moving, moving)])[-1]
    f = np.zeros(3)
    for _ in range(steps):
        free = x + G[:, 2] * h
        for _ in range(2000):
            new = f - rate * (free + G[:, moving] @ f)[moving]
            size = np.hypot(new[0], new[1])
            new[:2] *= min(1.0, mu * h / size) if size else 1.0
            new[2] = np.clip(new[2], -arm * h, arm * h)
            change = np.abs(new - f).max()
            f = new
            if change <= 1e-12 * h:
                break
        x = free + G[:, moving] @ f
    return x[:3] @ axes, float(x[3])


def cartesian_slide(
    c: Collision, mu: float, arm: float, impulse: float
) -> tuple[FloatArray, FloatArray]:
    """Velocity and angular velocity while the contact slides and spins, from Newton and Euler."""
    gamma, sign = c.gamma, np.sign(c.spin)

    def rates(_: float, y: FloatArray) -> FloatArray:
        u = y[:3] + np.cross(y[3:], c.r)
        u = u - (u @ gamma) * gamma
        force = gamma - mu * u / np.linalg.norm(u)
        moment = np.cross(c.r, force) - arm * sign * gamma
        return np.append(force / c.mass, np.linalg.solve(c.inertia, moment))

    y = np.append(c.velocity, c.omega)
    found = solve_ivp(rates, (0, impulse), y, method="DOP853", rtol=1e-13, atol=1e-14)
    return found.y[:3, -1], found.y[3:, -1]


def after(c: Collision, result: Impact) -> tuple[FloatArray, FloatArray]:
    return c.velocity + result.velocity_jump, c.omega + result.angular_velocity_jump
