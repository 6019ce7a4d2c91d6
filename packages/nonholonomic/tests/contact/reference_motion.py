"""A motion with all its changes of mode; see `contact.reference`."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.optimize import brentq

from contact.power_series import Series, exponential, logarithm, root
from contact.reference_bodies import Array, dot, length, minus, plus, rotation, tangents, times
from contact.reference_forces import (
    BY_VELOCITY,
    IN_BETWEEN,
    Direction,
    Mode,
    Problem,
    Response,
    patch_friction,
    quaternion_rate,
)
from contact.reference_impact import impact, normal_velocity
from contact.reference_integration import run

SMALL = 0.01
"""Slip speed (m/s; rad/s for rolling) below which direction and size are integrated apart."""

LAST = -42.0
"""Logarithm of the slip speed, against `SMALL`, at which sliding counts as ended."""

TERMS = 18
"""Number of terms of the Taylor series with which sliding begins."""

_ACCUMULATION = "bounces that accumulate before the end are not followed"


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
        found = self.problem.response(self.y, self.mode, IN_BETWEEN)
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
                held = float(length(found.friction))
                values.append((law.static * found.normal - held) / weight)
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
        probe = self.problem.response(self.y, Mode(), IN_BETWEEN)
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
                given = BY_VELOCITY
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
        self.leave()

    def leave(self) -> None:
        """Fly, if the body without any force of the support rises; else there is no motion."""
        before, h = list(self.y), 1e-5 * math.sqrt(self.problem.body.size / self.problem.gravity)
        rate = self.problem.rate(self.y, Mode(contact=False))
        ahead, behind = (
            normal_velocity(
                self.problem, [a + s * h * b for a, b in zip(self.y, rate, strict=True)]
            )
            for s in (1.0, -1.0)
        )
        if ahead - behind < -2e-6 * h * self.problem.gravity:
            raise ArithmeticError(f"neither contact nor flight is possible at t = {self.t}")
        _, n, gap, _, _ = self.problem.geometry(self.y)
        self.y[:3] = minus(self.y[:3], times(gap, n))
        self.mode, self.dying = Mode(contact=False), None
        self.record("lift-off", before)

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
        # a hop that is shorter than the first step would go unseen
        h = 1e-4 * math.sqrt(problem.body.size / problem.gravity)
        rising = normal_velocity(problem, self.y)
        later = [a + h * b for a, b in zip(self.y, problem.rate(self.y, mode), strict=True)]
        falling = (rising - normal_velocity(problem, later)) / h
        first_step = None
        if falling > 0.0 and rising > 1e-9 and problem.geometry(self.y)[2] < 1e-9:
            first_step = min(0.2 * rising / falling, 0.5 * (self.until - self.t))
        threshold = (1e-9 if first_step is None else 1e-13) * problem.body.size

        def rate(t: float, z: Array) -> Array:
            return np.array(problem.rate(z.tolist(), mode))

        def watch(t: float, z: Array) -> list[float]:
            gap = problem.geometry(z.tolist())[2]
            if gap > threshold:
                armed[0] = True
            elif not armed[0] and gap < -1e-9 * problem.body.size:
                # a hop lower than the threshold has gone unseen
                raise ArithmeticError(_ACCUMULATION)
            return [gap if armed[0] else 0.0]

        y = np.array(self.y)
        scales = self.scales(self.y)
        t, z, which = run(rate, self.t, y, self.until, watch, self.rtol, scales, first_step)
        self.t, self.y = t, z.tolist()
        if which is not None:
            self.land()
        elif problem.geometry(self.y)[2] < -1e-9 * problem.body.size:
            raise ArithmeticError(_ACCUMULATION)

    def land(self) -> None:
        """Impact, and what follows it."""
        before = list(self.y)
        stuck, spin_stopped, leaves = impact(self.problem, self.y, self.rtol)
        self.dying = None
        self.mode = Mode(contact=not leaves)
        _, n, gap, _, _ = self.problem.geometry(self.y)
        self.y[:3] = minus(self.y[:3], times(gap, n))
        self.record("landing", before)
        if leaves:
            return
        if stuck:
            self.without_slip()
        # under the coupled law nothing is held while the body spins
        self.settled(stuck and not self.problem.law.coupled, spin_stopped, False)
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

    def spin_left(self) -> Callable[[Response], float]:
        """Watched value for the end of the spin; one that begins is zero, but for rounding."""
        sign, turns = self.mode.sign, [False]

        def value(found: Response) -> float:
            spin = float(sign * found.spin)
            turns[0] = turns[0] or spin > 1e-12
            return spin if turns[0] else 0.0

        return value

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
        spin_left = self.spin_left()

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
                values.append(spin_left(found))
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
            self.leave()
        elif name == "spin stop" and mode.slide_held:
            # a couple of the other sign may ask for more friction than there is
            self.settled(True, True, mode.turn_held)
            if not self.mode.contact:
                return
            if self.mode.spin_held:
                self.record("spin stop", before)
            elif not self.mode.slide_held:
                self.record("direct restart", before)
            else:
                self.remarks.append(f"spin passes through zero at {self.t!r}")
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
        start, spin_left = self.t, self.spin_left()

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
                values.append(spin_left(found))
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
        _, z, which = run(rate, 0.0, y, 1e12, watch, self.rtol, scales)
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
        mode, law = self.mode, self.problem.law
        found = self.problem.response(self.y, mode)
        coupled = kind == "slide" and law.coupled
        if kind == "turn":
            first = times(-1.0 / length(found.turn_couple), found.turn_couple)
            mode = replace(mode, turn_held=False)
        else:
            first = times(-1.0 / length(found.friction), found.friction)
            mode = replace(mode, slide_held=False, spin_held=mode.spin_held and not coupled)
        if kind == "slide" and law.static > law.mu:
            self.start_at_once(mode, kind)
            return
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
            # slips nearby turn away from this direction, or shrink along it: another grows at once
            self.start_at_once(mode, kind)
            return
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

    def start_at_once(self, mode: Mode, kind: str) -> None:
        """Begin to slide (or to roll) in a direction along which the velocity grows at once."""
        e = self.exit(mode, kind)
        if e is None or self.problem.response(self.y, mode, self.given(kind, e)).normal <= 0.0:
            # nothing slides: it is no slip, but a lift-off if anything
            self.events.pop()
            self.leave()
            return
        self.mode, self.dying = mode, Dying(kind, LAST + math.log(SMALL), e)

    reach_factor = 1.0
    """Part of the trusted reach of the series that is used; to be varied in checks."""
