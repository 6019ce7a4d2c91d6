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
              {kind: "sphere", radius, side: "outside" | "inside", turntable} about the origin
    contact   mu; spin_arm; patch; viscous; spin_viscous; slip; rolling; rolling_viscous; contour;
              restitution; impact_law ("stronge", "poisson", "newton"); absent means none
    gravity   acceleration, along -z
    start     position (centre of mass), attitude (quaternion w, x, y, z, body to space),
              velocity (of the centre of mass, space axes), omega (body axes)

Kinds of event: ``stick`` (sliding has ended and the contact holds), ``slip`` (a held contact begins
to slide), ``spin stop``, ``spin start``, ``lift-off``, ``landing`` (state after the impact),
``rest`` (rolling has ended too, nothing moves), ``direct restart`` (sliding has ended and goes on
at once in another direction).

A spin that passes through zero without being held (independent spin couple) is no event, nor is a
coupled slip that passes from slower to faster than the rim of its patch. An impact takes a coupled
patch as a point, with the whole of Coulomb's friction, and knows no rolling resistance. Not
followed: bounces that accumulate (the end must come before), rolling that ends under ``contour``,
and states in which no force agrees with the laws (Painleve); each raises ArithmeticError, or is to
be kept out by the choice of the motion.

Forces, with ``n`` the normal of the support, ``u`` the velocity of the touching particle against
the support, ``Omega`` and ``w`` the parts of the angular velocity against the support about the
normal and along the support, and ``N`` the normal force:

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
contour                                                                  power ``-contour N |r'|``
===================  ==================================================  =========================

where ``r'`` is the velocity of the contact point over the body, with the normal at rest in space.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from contact.power_series import root
from contact.reference_bodies import (
    UP,
    ZERO,
    applied,
    cross,
    dot,
    length,
    minus,
    plus,
    rotation,
    times,
    transposed,
)
from contact.reference_forces import IN_BETWEEN, Mode, Problem
from contact.reference_impact import normal_velocity
from contact.reference_motion import Motion


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
    motion = reference_course(body, surface, contact, start, until, gravity, rtol, number)
    events = []
    for event in motion.events:
        record = {
            "time": float(event.time),
            "kind": event.kind,
            **readable_state(motion.problem, event.after),
        }
        record["before"] = readable_state(motion.problem, event.before)
        events.append(record)
    return events, {"time": float(motion.t), **readable_state(motion.problem, motion.y)}


def reference_course(
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
    _, n, gap, _, _ = problem.geometry(y)
    if gap < -1e-9 * problem.body.size:
        raise ValueError(f"the body starts inside the support: gap {gap}")
    away = normal_velocity(problem, y)
    if gap > 1e-9 * problem.body.size or away > 1e-9:
        motion.go()
        return motion
    if away < -1e-9:
        motion.land()
    else:
        motion.y[:3] = minus(y[:3], times(gap, n))
        motion.y[7:10] = minus(y[7:10], times(away, n))
        motion.mode = Mode()
        found = problem.response(motion.y, Mode(), IN_BETWEEN)
        slip, spin = float(length(found.slip)), abs(found.spin)
        stands = slip < 1e-12 and (not problem.law.coupled or spin < 1e-12)
        if stands:
            motion.without_slip()
        motion.settled(stands, spin < 1e-12, float(length(found.turn)) < 1e-12)
    motion.go()
    return motion


def readable_state(problem: Problem, y: Sequence[float]) -> dict[str, list[float]]:
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
