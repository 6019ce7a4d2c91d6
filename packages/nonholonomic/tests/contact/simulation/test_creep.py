"""Creeping: slips that friction determines at once, against other computations."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import nonholonomic
from flowlanes.system.arrays import FloatArray
from nonholonomic.contact import (
    Coulomb,
    FrictionalContact,
    NormalViscous,
    PowerFriction,
    Viscous,
    contact_motion,
)
from nonholonomic.contact.simulation.creep import creep_law

G, R, DOME = 9.81, 0.1, 1.0
BALL = nonholonomic.Body(1.0, (0.004, 0.004, 0.004), nonholonomic.Ball(R))


@pytest.mark.parametrize(
    "laws",
    [
        (Coulomb(0.2), PowerFriction(0.3, 0.4)),
        (PowerFriction(0.3, 0.5),),
        (Coulomb(0.2), NormalViscous(0.7)),
        (Coulomb(0.2), Viscous(0.7)),
    ],
)
def test_speed_and_force_are_inverse(laws: tuple[Coulomb | Viscous, ...]) -> None:
    law = creep_law(FrictionalContact(BALL, laws=laws))
    assert law is not None
    N = np.array([2.0])
    for speed in (1e-6, 1e-2, 3.0):
        force = law.force(speed, 2.0)
        found, slope = law.speed(np.array([force]), N)
        assert found[0] == pytest.approx(speed, rel=1e-9)
        ends = law.speed(np.array([force * (1 - 1e-7), force * (1 + 1e-7)]), N.repeat(2))[0]
        assert slope[0] == pytest.approx(np.diff(ends)[0] / (2e-7 * force), rel=1e-3)
    assert law.speed(np.array([0.9 * law.mu]), N)[0][0] == 0


def dome(laws: tuple[Coulomb | PowerFriction, ...]) -> FrictionalContact:
    return FrictionalContact(BALL, nonholonomic.Sphere(DOME), laws, nonholonomic.Forces(gravity=G))


def rolling_on_the_dome(theta: float) -> FloatArray:
    """The state of a ball that has rolled from rest at the top to an angle."""
    L = DOME + R
    v = math.sqrt(10 / 7 * G * L * (1 - math.cos(theta)))
    out = np.array([math.sin(theta), 0.0, math.cos(theta)])
    along = np.array([math.cos(theta), 0.0, -math.sin(theta)])
    return np.concatenate([[1, 0, 0, 0], L * out, v * along, [0, v / R, 0], out])


def sliding_on_the_dome(theta: float, mu: float, nu: float, p: float, until: float) -> FloatArray:
    """Angle, velocity and slip by SciPy, from where rolling needs more than μN."""

    def friction_of_rolling(x: float) -> float:
        return 2 / 7 * G * math.sin(x) - mu * G * (math.cos(x) - 10 / 7 * (1 - math.cos(x)))

    low, high = theta, 1.0
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (low, middle) if friction_of_rolling(middle) > 0 else (middle, high)
    L = DOME + R
    # the time until then, for dθ/dt = 2 √(5g/7L) sin(θ/2)
    rate = math.sqrt(5 * G / (7 * L))
    begin = (math.log(math.tan(low / 4)) - math.log(math.tan(theta / 4))) / rate
    v = math.sqrt(10 / 7 * G * L * (1 - math.cos(low)))

    def rates(_: float, y: FloatArray) -> list[float]:
        x, v, u = y
        N = G * math.cos(x) - v * v / L
        friction = N * (mu + nu * max(u, 0.0) ** p)
        return [v / L, G * math.sin(x) - friction, G * math.sin(x) - 3.5 * friction]

    # any small slip is soon the right one, as greater ones lose more
    start = [low, v, 1e-14]
    found = solve_ivp(rates, (begin, until), start, method="Radau", rtol=1e-12, atol=1e-15)
    return np.append(found.y[:, -1], begin)


@pytest.mark.slow
@pytest.mark.parametrize(("order", "nu"), [(0.3, 0.5), (0.5, 2.0), (0.8, 0.5)])
def test_sliding_begins_gently_under_a_power(order: float, nu: float) -> None:
    laws = (Coulomb(0.2), PowerFriction(nu, order))
    start = rolling_on_the_dome(0.1)
    motion = contact_motion(dome(laws), start, [0.0, 0.85])
    assert [event.kind for event in motion.events] == ["slip"]
    angle, v, slip, begin = sliding_on_the_dome(0.1, 0.2, nu, order, 0.85)
    assert motion.events[0].time == pytest.approx(begin, abs=1e-12)
    x, _, z = motion.end_state[4:7]
    assert math.atan2(x, z) == pytest.approx(angle, abs=2e-10)
    values = motion
    assert np.linalg.norm(values["velocity"][-1]) == pytest.approx(v, abs=1e-9)
    assert np.linalg.norm(values["slip"][-1]) == pytest.approx(slip, abs=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("law", [Viscous(1e7), NormalViscous(1e6)])
def test_a_ball_creeps_on_a_turntable(law: Viscous | NormalViscous) -> None:
    # x in the complex plane, v its velocity, s that of the rolling surface: linear equations
    turn, c = 1.5, 1e7 if isinstance(law, Viscous) else 1e6 * G
    matrix = np.array(
        [[0, 1, 0], [1j * turn * c, -c, c], [-2.5j * turn * c, 2.5 * c, -2.5 * c]], dtype=complex
    )
    rates, modes = np.linalg.eig(matrix)
    first = np.array([0.5, 0.2j, -0.2 + 0.1j])
    # the mode that decays at once, and its part in the start, are stiff
    last = modes @ (np.exp(rates * 2.0) * np.linalg.solve(modes, first))
    table = FrictionalContact(
        BALL, nonholonomic.Plane(turntable=turn), (law,), nonholonomic.Forces(gravity=G)
    )
    omega = [-first[2].imag / R, first[2].real / R, 0.0]
    start = np.concatenate([[1, 0, 0, 0], [0.5, 0, R], [0, 0.2, 0], omega, [0, 0, 1]])
    motion = contact_motion(table, start, [0.0, 2.0])
    assert motion.reason == ""
    x, y, _ = motion.end_state[4:7]
    assert complex(x, y) == pytest.approx(last[0], abs=1e-8)
    assert motion.steps < 20_000


@pytest.mark.slow
def test_a_slip_that_dies_away_gently_ends_where_friction_can_hold() -> None:
    """Friction like the square root of the slip, so strong that the slip ends like the square."""
    inertia = ((0.0756, 0.0008, -0.0072), (0.0008, 0.0708, -0.0057), (-0.0072, -0.0057, 0.0824))
    shape = nonholonomic.Ellipsoid(
        (0.706, 0.628, 1.073), turn=0.889, centre=(-0.026, -0.038, 0.037)
    )
    body = nonholonomic.Body(1.524, inertia, shape, gyrostat=(0.182, 0.091, -0.032))
    laws = (Coulomb(0.413), PowerFriction(0.225, 0.5))
    contact = FrictionalContact(body, laws=laws, field=nonholonomic.Forces(gravity=G))
    attitude = [-0.22871372241977406, 0.6868041055851767, 0.3135698281291395, -0.6145438280670451]
    velocity = [-2.737690552618978, -1.0177101617392077, 0.7141521702845255]
    place = [-0.293949889361814, 0.25264189324286596, 0.6746166364078]
    start = nonholonomic.initial_state(
        contact, [-1.331, 4.574, -0.336], position=place, attitude=attitude, velocity=velocity
    )
    motion = contact_motion(contact, start, [0.0, 1.0])
    assert motion.reason == ""
    assert "stick" in [event.kind for event in motion.events]
    for event in motion.events:
        if event.kind == "stick":
            held = contact_motion(contact, event.after, [0.0, 1e-9])
            force = np.linalg.norm(held["friction_force"][0])
            assert force <= 0.413 * held["normal_force"][0] * (1 + 1e-9)
    energies = motion["energy"] + motion.states[:, 16:].sum(axis=1)
    assert np.ptp(energies) < 1e-12 * abs(energies[0])


def test_a_slip_begins_from_zero_without_dry_friction() -> None:
    law = PowerFriction(0.4, 1.4)
    contact = FrictionalContact(
        BALL, nonholonomic.Sphere(DOME), (law,), nonholonomic.Forces(gravity=G)
    )
    motion = contact_motion(contact, rolling_on_the_dome(0.3), [0.0, 0.2])
    assert motion.reason == ""
    assert np.linalg.norm(motion["slip"][-1]) > 1e-3
