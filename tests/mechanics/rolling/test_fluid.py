"""Rolling bodies with fluid in cavities, against the unreduced equations and in their limits."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st

from chaplygin.errors import InputError
from chaplygin.flow.integrator import integrate
from chaplygin.mechanics.rolling.body import Body
from chaplygin.mechanics.rolling.cavity import Cavity
from chaplygin.mechanics.rolling.equations import Forces, Rolling
from chaplygin.mechanics.rolling.initial_state import initial_state
from chaplygin.mechanics.rolling.shapes import Ball, Ellipsoid
from chaplygin.mechanics.rolling.surfaces import Plane, Sphere
from fluid_reference import Chamber, Filled

GAMMA = np.array([0.2, -0.3, 0.93]) / np.linalg.norm([0.2, -0.3, 0.93])
FULL = ((0.5, 0.05, -0.03), (0.05, 0.6, 0.04), (-0.03, 0.04, 0.7))
CENTRED = Cavity((0.5, 0.4, 0.3), 0.8)
TURNED = Cavity((0.5, 0.4, 0.3), 0.8, (0.9, 0.1, 0.3, -0.2), (0.1, -0.2, 0.05))
SMALL = Cavity((0.2, 0.3, 0.25), 0.3, (0.3, -0.5, 0.2, 0.8), (-0.55, 0.3, -0.25))
UNTIL = 10.0

BODIES = {
    "ball": Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), cavity=CENTRED),
    "ball, turned cavity off its centre": Body(
        1.0, FULL, Ball(1.0, centre=(0.05, 0.1, -0.1)), (0.1, 0.2, -0.3), TURNED
    ),
    "ellipsoid": Body(1.0, (0.4, 0.5, 0.6), Ellipsoid((1.0, 0.9, 0.8)), cavity=CENTRED),
    "ellipsoid, two cavities": Body(
        1.0,
        FULL,
        Ellipsoid((1.2, 1.0, 0.9), 0.3, centre=(0.05, 0.1, -0.1)),
        cavity=(TURNED, SMALL),
    ),
}
CASES = [
    (name, contact, gravity)
    for name in BODIES
    for contact in ("marble", "rubber")
    for gravity in (0.0, 2.0)
]


def reference_of(rolling: Rolling) -> Filled:
    """The unreduced equations of a body."""
    body = rolling.body
    shape = body.shape
    if isinstance(shape, Ball):
        squares = shape.radius**2 * np.eye(3)
    else:
        c, s = np.cos(shape.turn), np.sin(shape.turn)
        Q = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        squares = Q @ np.diag(np.square(shape.axes)) @ Q.T
    chambers = [
        Chamber(c.mass, np.array(c.axes), np.array(c.centre), np.array(c.turn))
        for c in body.cavities
    ]
    return Filled(
        body.mass,
        body.tensor,
        chambers,
        np.array(shape.centre),
        squares,
        rolling.contact == "rubber",
        rolling.field.gravity,
        np.array(body.gyrostat),
        0.0 if isinstance(rolling.surface, Plane) else 1 / rolling.surface.signed_radius,
    )


def start_of(rolling: Rolling) -> tuple[np.ndarray, list[np.ndarray]]:
    """Angular velocity and motion of the fluids at the start."""
    omega = np.array([0.7, 0.4, 1.1])
    if rolling.contact == "rubber":
        omega = omega - omega @ GAMMA * GAMMA
    xi = [np.array([0.5, -0.8, 1.2]), np.array([-0.3, 0.6, 0.4])]
    return omega, xi[: len(rolling.body.cavities)]


def end_of(rolling: Rolling, until: float = UNTIL) -> dict[str, np.ndarray]:
    """The end of a motion, by the package."""
    omega, xi = start_of(rolling)
    system = rolling.system()
    state = initial_state(system, tuple(omega), tuple(GAMMA), fluid=[tuple(x) for x in xi])
    run = integrate(system, state, [0.0, until], on_liftoff="warn")
    fluids = [o.name for o in system.observables if o.name.startswith("fluid")]
    state_names = set(map(str, system.state))
    values = {
        name: np.array(run[name] if name in state_names else run.recorded[name])[-1]
        for name in ("omega", "gamma", "centre", *fluids)
    }
    return values | {"fluid": np.array([values.pop(name) for name in fluids])}


def largest_difference(rolling: Rolling) -> float:
    """Between the package and the unreduced equations, at the end."""
    reference = reference_of(rolling)
    omega, xi = start_of(rolling)
    theirs, ours = reference.motion(reference.start(omega, GAMMA, xi), UNTIL), end_of(rolling)
    return max(float(np.abs(theirs[name] - ours[name]).max()) for name in theirs)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "contact", "gravity"), CASES)
def test_the_motion_is_that_of_the_unreduced_equations(name, contact, gravity):
    rolling = Rolling(BODIES[name], Plane(), contact, Forces(gravity))
    assert largest_difference(rolling) < 1e-10
