"""Laws of friction, and the forces and accelerations of a body in contact."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

from contact.power_series import Number, Series, arcsine, exponential, root, solution
from contact.reference_bodies import (
    AXES,
    UP,
    ZERO,
    Body,
    Surface,
    Vector,
    applied,
    cross,
    dot,
    length,
    minus,
    plus,
    rotation,
    tangents,
    times,
    transposed,
)


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
    slip_order: float = 1.0
    force: str = ""
    couple: str = ""
    mu_static: float = 0.0
    values: Mapping[str, float] = field(default_factory=dict)
    air: float = 0.0
    restitution: float = 0.0
    impact_law: str = "stronge"

    @property
    def coupled(self) -> bool:
        """Whether sliding and spinning friction come from one patch."""
        return self.patch > 0.0 and self.mu > 0.0

    @property
    def pointed(self) -> bool:
        """Whether friction at a point is taken as a size times a direction, not as smooth."""
        return bool(self.mu or self.force or self.slip_order < 1.0)

    @property
    def static(self) -> float:
        """Coefficient up to which friction holds the contact."""
        return max(self.mu, self.mu_static)

    def formula(self, text: str, speed: Number, spin: Number = 0.0, normal: Number = 1.0) -> Any:
        """Value of a formula of the user at a slip speed, a spin and a normal force."""
        names = {"slip_speed": speed, "spin": abs(spin), "normal_force": normal}
        functions = {"exp": exponential, "sqrt": root}
        return eval(text, {"__builtins__": {}}, {**functions, **self.values, **names})

    def with_limits(self) -> Law:
        """The law with what its formulas are at rest as coefficients."""
        mu = float(self.formula(self.force, 0.0)) if self.force else self.mu
        arm = float(self.formula(self.couple, 0.0)) if self.couple else self.spin_arm
        return replace(self, mu=mu, spin_arm=arm)

    def against_slip(self, speed: Number, spin: Number, normal: Number) -> Any:
        """Force against the slip for a unit normal force, at a point."""
        size = self.formula(self.force, speed, spin, normal) if self.force else self.mu
        if self.slip:
            size = size + self.slip * power_of_speed(speed, self.slip_order)
        return size

    def against_spin(self, speed: Number, spin: Number) -> Any:
        """Couple against the spin for a unit normal force, besides that of a patch."""
        return self.formula(self.couple, speed, spin) if self.couple else self.spin_arm


def power_of_speed(speed: Number, order: float) -> Any:
    """Power of a slip speed, which as a series begins with the square of the time."""
    if not isinstance(speed, Series):
        return speed**order
    if order == 1.0:
        return speed
    if 2.0 * order != int(2.0 * order):
        raise ArithmeticError("this power of a slip that begins has no Taylor series")
    if not speed.c[2] > 0.0:
        return 0.0 * speed
    return (speed.shifted(-2) ** order).shifted(int(2.0 * order))


def speed_of(slip: Vector) -> Any:
    """Size of a slip velocity, which as a series begins with the square of the time."""
    square = dot(slip, slip)
    if not isinstance(square, Series):
        return root(square)
    inner = square.shifted(-4)
    return root(inner).shifted(2) if inner.c[0] > 0.0 else 0.0 * square


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


BY_VELOCITY = Direction()
"""Directions are those of the velocities."""

IN_BETWEEN = Direction((1.0, 0.1, 0.2), 1.0, (1.0, 0.2, 0.1))
"""Some direction, where friction is not asked for but only the velocities are."""


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
        self.law = Law(**contact).with_limits()
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

    def response(self, y: Vector, mode: Mode, given: Direction = BY_VELOCITY) -> Response:
        """Forces and accelerations of a body in contact.

        Friction that is not in proportion to the normal force is that of the normal force which
        follows from it.
        """
        if "normal_force" not in self.law.force or mode.slide_held:
            return self.response_with(y, mode, given, 1.0)
        before: Number = self.body.mass * self.gravity
        found = self.response_with(y, mode, given, before)
        if isinstance(found.normal, Series):
            # the friction of a slip that begins depends on the normal force from its square on
            for _ in range(len(found.normal.c)):
                found = self.response_with(y, mode, given, found.normal)
            return found
        last = found.normal - before
        now: Number = found.normal
        for _ in range(60):
            found = self.response_with(y, mode, given, now)
            miss = found.normal - now
            if abs(miss) <= 4e-16 * abs(now) or miss == last:
                return found
            now, before, last = now - miss * (now - before) / (miss - last), now, miss
        return found

    def response_with(self, y: Vector, mode: Mode, given: Direction, supposed: Number) -> Response:
        """Forces and accelerations of a body in contact, from one dense linear system.

        `supposed` is the normal force in the formula of the user.

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
        axis = times(surface.turntable, UP)
        if surface.turntable:
            support_velocity = cross(axis, plus(y[:3], arm))
            support_rate = cross(axis, plus(velocity, arm_rate))
        slip = minus(point_velocity, support_velocity)
        against_support = minus(omega, axis)
        spin = dot(against_support, n)
        over = minus(against_support, times(spin, n))

        force, couple = self._per_normal_force(slip, spin, over, n, spread, mode, given, supposed)
        steady_force = times(-law.viscous, slip) if law.viscous else [0.0, 0.0, 0.0]
        steady_couple = times(-law.spin_viscous * spin, n)
        if law.air and not mode.turn_held:
            radius = body.size
            tilt = root(gamma[0] * gamma[0] + gamma[1] * gamma[1])
            film = 0.25 * math.pi * law.air * radius**3 / (tilt * tilt * tilt)
            steady_couple = minus(steady_couple, times(film, over))

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
            condition(ZERO, n, -dot(against_support, n_rate))
        if mode.turn_held:
            for t in (t1, t2):
                condition(ZERO, t, spin * dot(n_rate, t))

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
        spin_rate = dot(omega_rate, n) + dot(against_support, n_rate)
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
            spin_rate,
            over,
            minus(omega_rate, plus(times(spin_rate, n), times(spin, n_rate))),
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
        supposed: Number,
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
                if law.slip:
                    ratio = law.slip * power_of_speed(length(slip), law.slip_order - 1.0)
                    force = minus(force, times(ratio, slip))
            elif law.pointed:
                e = slip if given.slip is None else given.slip
                size = law.against_slip(speed_of(slip), spin, supposed)
                force = times(-size / length(e), e)
            elif law.slip:
                size = law.slip * length(slip) ** (law.slip_order - 1.0)
                force = times(-size, slip)
        if (law.spin_arm or law.couple) and not mode.spin_held:
            speed = 0.0 if mode.slide_held else speed_of(slip)
            sign = mode.sign if law.spin_arm else math.copysign(1.0, spin)
            couple = minus(couple, times(law.against_spin(speed, spin) * sign, n))
        if law.rolling and not mode.turn_held:
            e = over if given.turn is None else given.turn
            couple = minus(couple, times(law.rolling / length(e), e))
        if law.rolling_viscous:
            couple = minus(couple, times(law.rolling_viscous, over))
        if law.contour:
            path = spread(cross(n, over))
            couple = plus(couple, times(law.contour / length(path), cross(n, spread(path))))
        return force, couple

    def rate(self, y: Vector, mode: Mode, given: Direction = BY_VELOCITY) -> list[Any]:
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
