"""A rolling body with fluid by Newton, Euler and Helmholtz, with the contact force as an unknown.

A second road to the motion, which shares no formula with the package. The fluid in a cavity is
described by its absolute vorticity w (body axes), which is uniform. Its velocity relative to the
body is Gx with the matrix G that keeps the wall, so that Helmholtz's equation is w' = Gw, and its
angular momentum is the integral of x × velocity over the cavity, by second moments. The full
position of the body is integrated: attitude matrix, place and velocity of the centre of mass of the
solid, angular velocity. Accelerations, contact force and spin torque follow together, at each
instant, from one linear system:

* the momentum of solid and fluids together,
* the angular momentum of solid and fluids about the centre of mass of the solid,
* the velocity of the touching particle stays zero,
* (omega, gamma)' = 0 for a rubber contact.

Lengths from the centre of mass of the solid, body axes; the gravity acts along -z of space.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.integrate import solve_ivp

Array = npt.NDArray[np.float64]


def hat(u: Array) -> Array:
    """The matrix of u ×."""
    x, y, z = u
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def axial(B: Array) -> Array:
    """The vector of B - B^T: the curl of the velocity Bx."""
    return np.array([B[2, 1] - B[1, 2], B[0, 2] - B[2, 0], B[1, 0] - B[0, 1]])


def turn_of(quaternion: Array) -> Array:
    """The matrix of a quaternion (w, x, y, z), by its exponential form."""
    w, *v = quaternion / np.linalg.norm(quaternion)
    return np.eye(3) + 2 * w * hat(np.array(v)) + 2 * hat(np.array(v)) @ hat(np.array(v))


@dataclass
class Chamber:
    """An ellipsoidal cavity full of fluid."""

    mass: float
    axes: Array
    centre: Array
    turn: Array

    def __post_init__(self) -> None:
        Q = turn_of(self.turn)
        self.A = Q @ np.diag(self.axes) @ Q.T
        self.inverse = np.linalg.inv(self.A)
        #: integral of x x^T over the fluid
        self.moments = self.mass / 5 * self.A @ self.A
        basis = np.eye(3)
        self.curl = np.array([axial(self.flow(e)) for e in basis]).T
        self.of_omega = np.array([self.spin(hat(e)) for e in basis]).T
        self.of_xi = np.array([self.spin(self.flow(e)) for e in basis]).T

    def flow(self, xi: Array) -> Array:
        """G of the relative velocity Gx."""
        return self.A @ hat(xi) @ self.inverse

    def spin(self, B: Array) -> Array:
        """The angular momentum about the centre of fluid that moves with Bx."""
        P = B @ self.moments
        return axial(P)

    def xi(self, omega: Array, vorticity: Array) -> Array:
        """The relative motion that goes with a vorticity."""
        return np.linalg.solve(self.curl, vorticity - 2 * omega)


@dataclass
class Filled:
    """A body with fluid on a plane, or a ball on a sphere."""

    mass: float
    inertia: Array
    chambers: list[Chamber]
    centre: Array
    #: squared semi-axes of its surface, as a matrix
    squares: Array
    rubber: bool = False
    gravity: float = 0.0
    rotors: Array | None = None
    #: 1/a of the supporting sphere
    curvature: float = 0.0

    def contact(self, gamma: Array, gammadot: Array) -> tuple[Array, Array]:
        """The contact point from the solid's centre of mass, and its rate."""
        turned = self.squares @ gamma
        h = np.sqrt(gamma @ turned)
        rate = self.squares @ gammadot / h - turned * (turned @ gammadot) / h**3
        return self.centre - turned / h, -rate

    def normal(self, turn: Array, X: Array) -> Array:
        """The outward normal of the support, body axes."""
        if not self.curvature:
            return turn[2]
        n = turn.T @ X + self.centre
        return n / np.linalg.norm(n)

    def normal_rate(self, gamma: Array, omega: Array) -> Array:
        """Its rate for a body that does not slip; on a sphere for a ball alone."""
        R = np.sqrt(self.squares[0, 0])
        return np.cross(gamma, omega) / (1 + R * self.curvature)

    def start(self, omega: Array, gamma: Array, xi: list[Array]) -> Array:
        """The flat state that begins so."""
        e = np.array([0.0, 0.0, 1.0])
        v = np.cross(gamma, e)
        turn = np.eye(3) + hat(v) + hat(v) @ hat(v) / (1 + gamma @ e)
        r, _ = self.contact(gamma, np.zeros(3))
        top = e / self.curvature if self.curvature else np.zeros(3)
        w = [2 * omega + c.curl @ x for c, x in zip(self.chambers, xi, strict=True)]
        X = top - turn @ r
        return np.concatenate([turn.ravel(), X, np.cross(r, omega), omega, *w])

    def rates(self, _: float, state: Array) -> Array:
        """The rates of attitude, place, velocity (body axes), omega and the vorticities."""
        turn, X, v, omega = state[:9].reshape(3, 3), state[9:12], state[12:15], state[15:18]
        vorticities = state[18:].reshape(-1, 3)
        gamma, weight = self.normal(turn, X), -self.gravity * turn[2]
        gammadot = self.normal_rate(gamma, omega)
        r, rdot = self.contact(gamma, gammadot)
        E, O = np.eye(3), np.zeros((3, 3))
        whirl = hat(omega) @ hat(omega)
        mass, drag = self.mass * E, O.copy()
        force = self.mass * weight
        torque = -np.cross(omega, self.inertia @ omega)
        inertia = self.inertia.copy()
        if self.rotors is not None:
            torque = torque - np.cross(omega, self.rotors)
        rates = []
        for c, w in zip(self.chambers, vorticities, strict=True):
            xi = c.xi(omega, w)
            wdot = c.flow(xi) @ w
            rates.append(wdot)
            # xi = curl^-1 (w - 2 omega), so that the momentum is linear in omega and w
            of_w = c.of_xi @ np.linalg.inv(c.curl)
            of_spin = c.of_omega - 2 * of_w
            spin = of_spin @ omega + of_w @ w
            mass = mass + c.mass * E
            drag = drag - c.mass * hat(c.centre)
            centripetal = c.mass * whirl @ c.centre
            force = force + c.mass * weight - centripetal
            torque = torque + np.cross(c.centre, c.mass * weight - centripetal)
            torque = torque - np.cross(omega, spin) - of_w @ wdot
            inertia = inertia + of_spin - c.mass * hat(c.centre) @ hat(c.centre)
        # unknowns: acceleration of the solid's centre (3), omega' (3), force (3), spin torque
        matrix, right = np.zeros((10, 10)), np.zeros(10)
        matrix[:3, :3], matrix[:3, 3:6], matrix[:3, 6:9] = mass, drag, -E
        right[:3] = force
        matrix[3:6, :3], matrix[3:6, 3:6], matrix[3:6, 6:9] = -drag, inertia, -hat(r)
        matrix[3:6, 9] = -gamma
        right[3:6] = torque
        # (v + omega x r)' = 0 with v' = acceleration - omega x v
        matrix[6:9, :3], matrix[6:9, 3:6] = E, -hat(r)
        right[6:9] = np.cross(omega, v) - np.cross(omega, rdot)
        if self.rubber:
            matrix[9, 3:6] = gamma
            right[9] = -omega @ gammadot
        else:
            matrix[9, 9] = 1.0
        solution = np.linalg.solve(matrix, right)
        return np.concatenate(
            [
                (turn @ hat(omega)).ravel(),
                turn @ v,
                solution[:3] - np.cross(omega, v),
                solution[3:6],
                *rates,
            ]
        )

    def motion(self, start: Array, until: float) -> dict[str, Array]:
        """Omega, gamma, the fluids' motion and the place of the common centre at the end."""
        field: Callable[[float, Array], Array] = self.rates
        end = solve_ivp(field, (0.0, until), start, "DOP853", rtol=3e-14, atol=1e-15).y[:, -1]
        turn, X, omega = end[:9].reshape(3, 3), end[9:12], end[15:18]
        whole = self.mass + sum(c.mass for c in self.chambers)
        common = sum((c.mass * c.centre for c in self.chambers), np.zeros(3)) / whole
        vorticities = end[18:].reshape(-1, 3)
        return {
            "omega": omega,
            "gamma": self.normal(turn, X),
            "fluid": np.array(
                [c.xi(omega, w) for c, w in zip(self.chambers, vorticities, strict=True)]
            ),
            "centre": X + turn @ common,
        }


@dataclass
class FilledTop:
    """A body with fluid about a fixed point, free or with (omega, n) = 0 for a direction n.

    n is gamma, the vertical in body axes, or a direction of the body. The centres of the cavities
    are measured from the fixed point; a fluid's own momentum about it is that about its centre and
    that of a point of its mass there.
    """

    inertia: Array
    chambers: list[Chamber]
    #: n in body axes; "vertical" or "free"
    axis: Array | str = "vertical"

    def rates(self, _: float, state: Array) -> Array:
        """The rates of gamma, omega and the vorticities."""
        gamma, omega, *vorticities = state.reshape(-1, 3)
        free = isinstance(self.axis, str) and self.axis == "free"
        matrix, momentum, right = self.inertia.copy(), self.inertia @ omega, np.zeros(3)
        wdots = []
        for c, w in zip(self.chambers, vorticities, strict=True):
            wdot = c.flow(c.xi(omega, w)) @ w
            wdots.append(wdot)
            of_w = c.of_xi @ np.linalg.inv(c.curl)
            of_spin = c.of_omega - 2 * of_w - c.mass * hat(c.centre) @ hat(c.centre)
            matrix += of_spin
            momentum = momentum + of_spin @ omega + of_w @ w
            right -= of_w @ wdot
        right -= np.cross(omega, momentum)
        if free:
            omegadot = np.linalg.solve(matrix, right)
        else:
            n = gamma if isinstance(self.axis, str) else self.axis
            bordered = np.zeros((4, 4))
            bordered[:3, :3], bordered[:3, 3], bordered[3, :3] = matrix, -n, n
            # (omega, gamma') = 0 for the vertical, too
            omegadot = np.linalg.solve(bordered, [*right, 0.0])[:3]
        return np.concatenate([np.cross(gamma, omega), omegadot, *wdots])

    def end(self, omega: Array, gamma: Array, xis: list[Array], until: float) -> list[Array]:
        """Omega, gamma and every xi at the end of a motion."""
        vorticities = [2 * omega + c.curl @ xi for c, xi in zip(self.chambers, xis, strict=True)]
        start = np.concatenate([gamma, omega, *vorticities])
        end = solve_ivp(self.rates, (0.0, until), start, "DOP853", rtol=3e-14, atol=1e-15)
        gamma, omega, *last = end.y[:, -1].reshape(-1, 3)
        return [omega, gamma, *(c.xi(omega, w) for c, w in zip(self.chambers, last, strict=True))]
