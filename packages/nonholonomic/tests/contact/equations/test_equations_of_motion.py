"""Systems of the modes: their columns, guards, works, and what they share with known motions."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from contact.dense_motion import accelerations, random_state, rotation
from evaluation import numeric
from flowlanes.system.vectors import real_symbol
from nonholonomic.contact.equations.equations_of_motion import JAM, contact_equations
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.dry_friction import ContensouErismann, Coulomb, SpinFriction
from nonholonomic.contact.friction.modes import FLIGHT, Mode
from nonholonomic.contact.friction.rolling_friction import RollingResistance
from nonholonomic.contact.friction.symbols import height
from nonholonomic.contact.friction.viscous_friction import NormalViscous, Viscous
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.shapes import Ball, Ellipsoid
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere

X, Y, Z = sp.symbols("x y z")
BALL = Body(0.7, (0.3, 0.3, 0.3), Ball(0.9))
LAWS = (Coulomb(0.3), SpinFriction(0.02))
GRAVITY = Forces(gravity=9.81)
MODES = (Mode(), Mode(spinning=False), Mode(sliding=False), Mode(sliding=False, spinning=False))


def state_of(system, y, gamma):
    turn = rotation(y[:4])
    state = np.zeros(len(system.symbols))
    state[:16] = [*y[:7], *(turn.T @ y[7:10]), *y[10:13], *gamma]
    return state


def test_all_modes_have_the_same_columns():
    columns = {
        contact_equations(FrictionalContact(BALL, laws=LAWS, field=GRAVITY), mode).symbols
        for mode in (*MODES, Mode(sliding=False, spinning=False, rolling=False))
    }
    (names,) = columns
    flight = contact_equations(FrictionalContact(BALL, laws=LAWS, field=GRAVITY), FLIGHT)
    assert flight.symbols == (*names, height)
    assert [str(s) for s in names[4:]] == [
        *(f"position_{i}" for i in (1, 2, 3)),
        *(f"v_{i}" for i in (1, 2, 3)),
        *(f"omega_{i}" for i in (1, 2, 3)),
        *(f"gamma_{i}" for i in (1, 2, 3)),
        "work_impact",
        "work_coulomb",
        "work_spin",
    ]


def test_a_turning_support_does_work():
    situation = FrictionalContact(BALL, Plane(turntable=1.0), LAWS, GRAVITY)
    assert "work_support" in map(str, contact_equations(situation, Mode()).symbols)


def test_an_implicit_shape_is_placed_by_its_contact_vector():
    body = Body(0.7, (0.3, 0.4, 0.5), ImplicitShape(X**2 + 2 * Y**2 + Z**2 - 1))
    system = contact_equations(FrictionalContact(body, laws=LAWS, field=GRAVITY), Mode())
    assert [str(s) for s in system.symbols[13:16]] == ["r_1", "r_2", "r_3"]


@pytest.mark.parametrize(
    ("laws", "mode", "names"),
    [
        (LAWS, Mode(), {"lift-off", "stick", "spin stop", "paradox"}),
        (LAWS, Mode(spinning=False), {"lift-off", "stick", "spin start", "paradox"}),
        (LAWS, Mode(sliding=False), {"lift-off", "slip", "spin stop"}),
        (LAWS, Mode(sliding=False, spinning=False), {"lift-off", "slip", "spin start"}),
        (LAWS, FLIGHT, {"landing"}),
        (
            (*LAWS, RollingResistance(0.1)),
            Mode(sliding=False, spinning=False, rolling=False),
            {"lift-off", "slip", "spin start", "rolling start"},
        ),
        ((Viscous(1.0),), Mode(), {"lift-off"}),
        ((NormalViscous(1.0),), Mode(), {"lift-off", "paradox"}),
        ((RollingResistance(0.1),), Mode(), {"lift-off", "rolling stop", "paradox"}),
        ((RollingResistance(0.1),), Mode(rolling=False), {"lift-off", "rolling start"}),
        ((Coulomb(math.inf),), Mode(sliding=False), {"lift-off"}),
        (
            (ContensouErismann(0.3, 0.1),),
            Mode(range="inner"),
            {"stop", "range", "lift-off", "paradox"},
        ),
    ],
)
def test_guards_of_a_mode(laws, mode, names):
    system = contact_equations(FrictionalContact(BALL, laws=laws, field=GRAVITY), mode)
    assert {guard.name for guard in system.guards} == names


def test_billiard_ball_slides_along_a_parabola():
    system = contact_equations(FrictionalContact(BALL, laws=LAWS, field=GRAVITY), Mode())
    sliding = numeric(system, [*system.rates, real_symbol("N")])
    identity, omega = np.array([1.0, 0, 0, 0]), np.array([0.3, -0.8, 0.5])
    y = np.concatenate([identity, [0, 0, 0.9], [1.2, -0.4, 0], omega])
    u = np.array([1.2, -0.4, 0]) + np.cross(omega, [0, 0, -0.9])
    e = u / np.linalg.norm(u)
    found = sliding(state_of(system, y, [0.0, 0.0, 1.0]))
    N = 0.7 * 9.81
    assert found[-1] == pytest.approx(N, rel=1e-15)
    space_rate = found[7:10] + np.cross(omega, y[7:10])
    np.testing.assert_allclose(space_rate, -0.3 * 9.81 * e, atol=1e-14)
    couple = np.cross([0, 0, -0.9], -0.3 * N * e) - [0, 0, 0.02 * N]
    np.testing.assert_allclose(found[10:13], couple / 0.3, atol=1e-13)
    works = found[16:19]
    lost = [0, 0.3 * N * np.linalg.norm(u), 0.02 * N * 0.5]
    np.testing.assert_allclose(works, lost, rtol=1e-14)


def test_a_potential_keeps_the_balance_of_energy():
    gamma = [real_symbol(f"gamma_{i}") for i in (1, 2, 3)]
    field = Forces(gravity=2.0, potential=gamma[0] * gamma[1] / 2 + gamma[2] ** 2 / 4)
    body = Body(0.7, (0.3, 0.4, 0.5), Ball(0.9, centre=(0.1, 0.2, -0.1)))
    situation = FrictionalContact(body, laws=LAWS, field=field)
    system = contact_equations(situation, Mode())
    rates = numeric(system, system.rates)
    balance = numeric(system, [system.integrals[0].value])
    random = np.random.default_rng(2)
    for _ in range(4):
        y, normal = random_state(situation, Mode(), random)
        # the sign of the spin is a parameter, 1 unless set
        y[10:13] *= np.sign(y[10:13] @ normal)
        y[7:10] -= rotation(y[:4]) @ normal * _rising(situation, y, normal)
        state = state_of(system, y, normal)
        change = balance(state + 1e-30j * rates(state)).imag / 1e-30
        assert abs(change[0]) < 1e-13


def _rising(situation, y, normal):
    """Normal velocity of the touching particle."""
    b = situation.body.shape.radius * normal
    r = np.array(situation.body.shape.centre) - b
    return normal @ (rotation(y[:4]).T @ y[7:10] + np.cross(y[10:13], r))


@pytest.mark.parametrize("mode", [Mode(), Mode(spinning=False)])
def test_the_guard_against_the_paradox_is_the_answer_to_a_unit_of_normal_force(mode):
    body = Body(0.7, (0.05, 0.06, 0.07), Ellipsoid((1.0, 0.4, 0.6), centre=(0.1, 0.2, -0.1)))
    laws = (Coulomb(2.5), SpinFriction(0.05))
    light, heavy = (FrictionalContact(body, laws=laws, field=Forces(gravity=g)) for g in (2.0, 3.0))
    system = contact_equations(light, mode)
    guard = next(g.value for g in system.guards if g.name == "paradox")
    value = numeric(system, [guard])
    random = np.random.default_rng(4)
    signs = set()
    for _ in range(20):
        y, gamma = random_state(light, mode, random)
        if (y[10:13] @ gamma) < 0:
            continue
        # N = −b/B, and b falls by as much as the gravity rises
        forces = [accelerations(c, mode, y, gamma).normal_force for c in (light, heavy)]
        found = float(value(state_of(system, y, gamma))[0])
        smooth = replace(light, laws=())
        free = accelerations(smooth, Mode(), y, gamma).normal_force
        heavier = replace(smooth, field=Forces(gravity=3.0))
        margin = JAM / (accelerations(heavier, Mode(), y, gamma).normal_force - free)
        assert 1 / (forces[1] - forces[0]) - margin == pytest.approx(found, rel=1e-8)
        signs.add(np.sign(found))
    assert signs == {1.0, -1.0}


def test_rest_needs_no_motion():
    situation = FrictionalContact(BALL, laws=LAWS, field=GRAVITY)
    system = contact_equations(situation, Mode(sliding=False, spinning=False, rolling=False))
    assert all(rate == 0 for rate in system.rates)
    wanted = {item.name: item.value for item in system.observables}
    found = numeric(system, [wanted["normal_force"], wanted["power_lost"]])
    state = state_of(system, np.array([1.0, *[0] * 12]), [0.0, 0.0, 1.0])
    state[6] = 0.9
    np.testing.assert_allclose(found(state), [0.7 * 9.81, 0.0], rtol=1e-15)


@pytest.mark.parametrize("surface", [Plane(), Sphere(3.0), Sphere(3.0, side="inside")])
def test_the_gap_of_a_body_in_flight(surface):
    situation = FrictionalContact(BALL, surface, LAWS, GRAVITY)
    system = contact_equations(situation, FLIGHT)
    value = next(item.value for item in system.observables if item.name == "gap")
    gap = numeric(system, [value])
    random = np.random.default_rng(6)
    y, gamma = random_state(situation, FLIGHT, random)
    assert float(gap(state_of(system, y, gamma))[0]) == pytest.approx(0.3, rel=1e-13)
