"""Vectors, bodies and supports of the reference for bodies in contact."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from contact.power_series import Number, Series, root, solution

Array = npt.NDArray[np.float64]
Vector = Sequence[Number]
Matrix = Sequence[Sequence[Number]]

UP = (0.0, 0.0, 1.0)
AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
ZERO = (0.0, 0.0, 0.0)


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
            # a disk is an ellipsoid without thickness
            flat = [float(shape.get("radius", 0.0))] * 2 + [0.0]
            axes = flat if shape["kind"] == "disk" else shape["axes"]
            c, s = math.cos(turn), math.sin(turn)
            frame = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
            squares = np.diag(np.array(axes, dtype=float) ** 2)
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
