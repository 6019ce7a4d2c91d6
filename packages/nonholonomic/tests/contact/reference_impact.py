"""Impact with friction, integrated over the normal impulse."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
from scipy.optimize import brentq

from contact.power_series import logarithm, root, solution
from contact.reference_bodies import (
    UP,
    ZERO,
    Array,
    Vector,
    applied,
    cross,
    dot,
    minus,
    plus,
    tangents,
    times,
    transposed,
)
from contact.reference_forces import Problem
from contact.reference_integration import run


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
    spin = dot(omega, n) - surface.turntable * n[2]

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

    def ratio(
        e: Array | None, state: Array, slide_held: bool, spin_held: bool, way: float
    ) -> Array:
        """Impulses (1, 2, couple) for a unit normal impulse."""
        g = np.zeros(3, dtype=z.dtype)
        if not slide_held:
            if law.pointed and e is not None:
                g[:2] = -law.against_slip(np.hypot(state[1], state[2]), 0.0, 1.0) * e
            elif law.slip:
                speed = np.hypot(state[1], state[2])
                g[:2] -= law.slip * speed ** (law.slip_order - 1.0) * state[1:3]
        if not spin_held:
            g[2] = -law.spin_arm * way
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

    def after_stop(at_rest: bool, sign: float) -> tuple[bool, Array | None, bool, float]:
        """Whether sliding is held, else its direction; whether spinning is, else its sign."""
        spins = [(True, sign), (False, 1.0), (False, -1.0)] if at_rest else [(False, sign)]
        for slide_held, (spin_held, way) in itertools.product((True, False), spins):
            e = None if slide_held else leaving(spin_held, way)
            if e is None and not slide_held:
                continue
            g = ratio(e, z * 0.0, slide_held, spin_held, way)
            grows = float(mobility[2] @ np.array([*g, 1.0]))
            fits = not slide_held or math.hypot(g[0], g[1]) <= law.mu
            if spin_held:
                fits = fits and abs(g[2]) <= law.spin_arm
            elif at_rest:
                fits = fits and way * grows > 0.0
            if fits:
                return slide_held, e, spin_held, way
        raise ArithmeticError("no direction of sliding after a stop in an impact")

    def leaving(spin_held: bool, way: float) -> Array | None:
        """Direction in which sliding starts anew after it has stopped."""

        def x_of(angle: float) -> tuple[Array, Array]:
            e = np.array([math.cos(angle), math.sin(angle)])
            g = ratio(e, z * 0.0, False, spin_held, way)
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

    state_kind = "sliding" if law.pointed else "free"
    fixed: Array | None = None
    if law.mu and math.hypot(z[1], z[2]) < 1e-12:
        state_kind = "stopped"
    if law.spin_arm and abs(spin) < 1e-12:
        e = z[1:3] / math.hypot(z[1], z[2]) if state_kind == "sliding" else None
        couple = ratio(e, z, False, True, sign)[2]
        held_spin = state_kind == "stopped" or abs(couple) <= law.spin_arm
        sign = -math.copysign(1.0, couple)
    for _ in range(50):
        if level(z) <= 0.0:
            if compressing:
                compressing = False
                done = {"work": z[5].item(), "impulse": z[0].item()}
                if law.restitution > 0.0:
                    continue
            break
        if state_kind == "stopped":
            held_slide, fixed, held_spin, sign = after_stop(held_spin, sign)
            state_kind = "held" if held_slide else "restarted"
            if state_kind == "restarted" and (law.slip or law.force):
                # friction that grows with the speed turns it: no direction lasts
                z[1:3], state_kind = math.exp(-40.0) * np.array(fixed), "sliding"
        blown = state_kind == "sliding"
        if blown:
            speed = root((z[1] * z[1] + z[2] * z[2]).item())
            z[9:] = [logarithm(speed), z[1] / speed, z[2] / speed]

        now = (held_slide, held_spin, sign)

        def rate(
            tau: float,
            state: Array,
            blown: bool = blown,
            fixed: Array | None = fixed,
            now: tuple[bool, bool, float] = now,
        ) -> Array:
            e = state[10:12] / np.sqrt(state[10:12] @ state[10:12]) if blown else fixed
            g = ratio(e, state, *now)
            change = mobility @ np.array([*g, 1.0])
            out = np.concatenate([[1.0], change, [state[4]], g, [0.0, 0.0, 0.0]])
            if blown:
                grows = e @ change[:2]
                out *= np.exp(state[9])
                out[9] = grows
                out[10:] = change[:2] - grows * e
            return out

        def watch(
            tau: float,
            state: Array,
            blown: bool = blown,
            now: tuple[bool, bool, float] = now,
            spinning: float = 0.0 if held_spin else sign * law.spin_arm,
        ) -> list[float]:
            values = [level(state), 1.0, 1.0, 1.0]
            if blown:
                values[1] = float(state[9]) + 45.0
                if now[1] and law.spin_arm:
                    e = state[10:12] / np.sqrt(state[10:12] @ state[10:12])
                    values[3] = law.spin_arm - abs(float(ratio(e, state, *now)[2]))
            if spinning:
                values[2] = math.copysign(1.0, spinning) * float(state[3])
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
            g = ratio(z[10:12] if blown else fixed, z, held_slide, True, sign)
            if abs(g[2]) <= law.spin_arm:
                held_spin = True
            else:
                sign = -sign
            if state_kind in ("held", "restarted"):
                state_kind = "stopped" if state_kind == "held" else "sliding"
        if which == 3:  # friction that turns asks for more than the couple that holds the spin
            g = ratio(z[10:12], z, held_slide, True, sign)
            held_spin, sign = False, -math.copysign(1.0, g[2])
    impulse = plus(times(z[6].item(), t1), times(z[7].item(), t2), times(z[0].item(), n))
    y[7:10] = plus(y[7:10], times(1.0 / body.mass, impulse))
    y[10:13] = plus(y[10:13], cross(arm, impulse), times(z[8].item(), n))
    leaves = law.restitution > 0.0
    if not leaves:  # the normal velocity is exactly zero
        y[7:10] = minus(y[7:10], times(normal_velocity(problem, y), n))
    return held_slide, held_spin, leaves


def normal_velocity(problem: Problem, y: list[Any]) -> Any:
    """Velocity of the nearest particle of the body away from the support."""
    _, n, _, arm, omega = problem.geometry(y)
    return dot(n, plus(y[7:10], cross(omega, arm)))
