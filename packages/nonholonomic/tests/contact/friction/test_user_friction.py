"""Laws of friction by formulas of the user."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from contact.dense_motion import Motion, accelerations, random_state, rotation
from contact.friction.test_viscous_friction import GRAVITY, slip_of_ball
from contact.friction_formulas import ContactState
from contact.law_values import law_values, random_contact_state
from evaluation import numeric
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.vectors import real_symbol, to_components
from nonholonomic.contact.equations.equations_of_motion import contact_equations
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.dry_friction import Coulomb, SpinFriction
from nonholonomic.contact.friction.modes import Mode
from nonholonomic.contact.friction.symbols import gamma, normal_response, spin
from nonholonomic.contact.friction.user_friction import UserFriction
from nonholonomic.contact.friction.viscous_friction import NormalViscous
from nonholonomic.contact.motion import contact_motion
from nonholonomic.contact.simulation.compiled import CompiledContact
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces
from nonholonomic.mechanics.shapes.shapes import Ball

STRIBECK = UserFriction(
    "mu*(1 + 0.3*exp(-slip_speed/v))", mu_static=0.3, parameters={"mu": 0.2, "v": 0.1}
)
seeds = pytest.mark.parametrize("seed", range(4))


@seeds
def test_force_and_couple_are_those_of_the_formulas(seed):
    at = random_contact_state(np.random.default_rng(seed))
    law = UserFriction(
        "(a + slip_speed)/(1 + spin)", couple="b + spin**3", parameters={"a": 0.0, "b": 0.1}
    )
    speed, turn = np.linalg.norm(at.slip), abs(at.spin)
    found = law_values(law, Mode(), at)
    force = -speed / (1 + turn) * at.slip / speed
    np.testing.assert_allclose(found.p, force, rtol=1e-14)
    couple = -(0.1 + turn**3) * np.sign(at.spin) * at.gamma
    np.testing.assert_allclose(found.q, couple, rtol=1e-14)
    assert found.power == pytest.approx(speed**2 / (1 + turn) + (0.1 + turn**3) * turn, rel=1e-13)
    assert not found.force.any() and not found.couple.any()


@seeds
def test_known_laws_written_as_formulas(seed):
    at = random_contact_state(np.random.default_rng(seed))
    for law, known in (
        (UserFriction("0.3"), Coulomb(0.3)),
        (UserFriction("0.3*slip_speed"), NormalViscous(0.3)),
    ):
        found, expected = (law_values(x, Mode(), at) for x in (law, known))
        np.testing.assert_allclose(found.p, expected.p, rtol=1e-15)
    turning = UserFriction("slip_speed", couple=sp.Rational(1, 50))
    found, expected = (law_values(x, Mode(), at) for x in (turning, SpinFriction(0.02)))
    np.testing.assert_allclose(found.q, expected.q, rtol=1e-15)
    assert found.guards["spin stop"] == expected.guards["spin stop"]


def test_stribeck():
    assert STRIBECK.kinetic_mu == pytest.approx(0.26, rel=1e-15)
    assert STRIBECK.static_mu == 0.3
    first, mu, v, more = 1.2, 0.2, 0.1, 0.3
    # ∫du/(1 + δe^(−u/v)) = v ln(e^(u/v) + δ)
    rate = 3.5 * GRAVITY * mu / v
    end = (math.log(math.exp(first / v) + more) - math.log(1 + more)) / rate
    times = np.linspace(0, 0.99 * end, 5)
    exact = v * np.log((math.exp(first / v) + more) * np.exp(-rate * times) - more)
    slip = slip_of_ball(STRIBECK, first, times)
    np.testing.assert_allclose(slip, exact, atol=1e-10)


@pytest.mark.parametrize(("size", "sign"), [(0.299, 1), (0.301, -1)])
def test_static_friction_holds(size, sign):
    at = random_contact_state(np.random.default_rng(1))
    friction = 2.0 * size * at.slip / np.linalg.norm(at.slip)
    found = law_values(STRIBECK, Mode(sliding=False), at, 2.0, friction)
    assert np.sign(found.guards["slip"]) == sign
    assert not found.p.any()


def test_limits_at_rest():
    assert UserFriction("0.3/(1 + slip_speed)").static_mu == pytest.approx(0.3, rel=1e-15)
    for viscous in ("0.3*slip_speed", "tanh(slip_speed)", "slip_speed/(slip_speed + 0.1*spin)"):
        law = UserFriction(viscous)
        assert law.static_mu is None and law.kinetic_mu is None
    assert UserFriction("0.1", couple="0.2 + spin*slip_speed").spin_arm == pytest.approx(0.2)


@pytest.mark.parametrize(
    ("law", "sliding", "held"),
    [
        (UserFriction("0.3"), {"stick"}, {"slip"}),
        (UserFriction("0.3 + spin*slip_speed"), {"stick", "spin stop"}, {"slip", "spin stop"}),
        (UserFriction("0.3 + spin**2*slip_speed"), {"stick"}, {"slip"}),
        (UserFriction("0.3*slip_speed + slip_speed**3"), set(), set()),
        (UserFriction("tanh(slip_speed)"), {"creep"}, set()),
        (UserFriction("0.3*slip_speed", couple="0.1*spin"), set(), set()),
        (UserFriction("0.3*slip_speed", couple="0.1"), {"spin stop"}, {"spin stop"}),
    ],
    ids=lambda x: x.description if isinstance(x, UserFriction) else "",
)
def test_guards(law, sliding, held):
    assert {guard.name for guard in law.guards(Mode())} == sliding
    assert {guard.name for guard in law.guards(Mode(sliding=False))} == held


def test_couple_that_holds_the_spin():
    law = UserFriction("0.3", couple="0.02 + spin")
    at = random_contact_state(np.random.default_rng(1))
    for couple, sign in ((0.0399, 1), (-0.0401, -1)):
        found = law_values(law, Mode(spinning=False), at, 2.0, holding_couple=couple)
        assert np.sign(found.guards["spin start"]) == sign
        assert not found.q.any()


@pytest.mark.parametrize("turn", [0.0, 0.4, -0.4])
def test_couple_at_rest_besides_its_threshold(turn):
    law = UserFriction("0.3", couple="b + spin**2 + spin*slip_speed", parameters={"b": 0.02})
    q = to_components(law.reaction_at_rest.q)
    given = {spin: turn} | dict(zip(gamma.symbols, (0.6, 0.0, 0.8), strict=True))
    found = [float(x.xreplace(given)) for x in q]
    np.testing.assert_allclose(found, -turn * abs(turn) * np.array([0.6, 0, 0.8]), atol=1e-17)
    for other in (Coulomb(0.3), SpinFriction(0.1), UserFriction("0.2"), UserFriction("0.3", "0.1")):
        assert not to_components(other.reaction_at_rest.q).as_explicit().free_symbols


def test_a_polynomial_force_is_defined_at_rest():
    at = random_contact_state(np.random.default_rng(1))
    rest = ContactState(np.zeros(3), at.spin, at.rolling, at.gamma, at.spread)
    assert not law_values(UserFriction("2*slip_speed + slip_speed**3"), Mode(), rest).p.any()


def test_it_is_a_value():
    one, other = (UserFriction("0.3*slip_speed + a", parameters={"a": 0.1}) for _ in range(2))
    assert one == other and hash(one) == hash(other)
    assert one != UserFriction("0.3*slip_speed + a", parameters={"a": 0.2})
    v = sp.Symbol("slip_speed")
    assert UserFriction(sp.Rational(3, 10) * v + 1) == UserFriction("0.3*slip_speed + 1")
    assert [p.default for p in one.parameters] == [0.1, 0.1]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"force": "mu*2"}, "force: unknown name 'mu'; allowed: slip_speed, spin, normal_force"),
        ({"force": "0.3 +"}, "force: "),
        ({"force": "__import__('os')"}, "force: "),
        (
            {"force": sp.Symbol("nu")},
            "force: nu is not known; it may use slip_speed, spin, normal_force",
        ),
        (
            {"force": "0.3 + normal_force"},
            "force: at zero slip it depends on normal_force; there it must be one number",
        ),
        (
            {"force": "0.3", "couple": "0.1*normal_force"},
            "couple: unknown name 'normal_force'; allowed: slip_speed, spin, abs, acos",
        ),
        (
            {"force": "-0.3"},
            "force: at slip_speed = 1e-06, spin = 1e-06, normal_force = 1e-06 it is -0.3; it",
        ),
        ({"force": "0.3 - slip_speed"}, "force: at slip_speed = 0.3"),
        (
            {"force": "0.3", "couple": "-spin"},
            "couple: at slip_speed = 1e-06, spin = 1e-06 it is -1e-06; it must be",
        ),
        ({"force": "sqrt(slip_speed - 1)"}, "force: at slip_speed"),
        ({"force": "1/slip_speed"}, "force: at zero slip it has no finite value; write it so"),
        ({"force": "0.3 + spin"}, "force: at zero slip it depends on spin; there it must be one"),
        ({"force": "0.3", "couple": "slip_speed"}, "couple: at zero spin it depends on slip_speed"),
        ({"force": "0.3", "mu_static": 0.2}, "mu_static 0.2: it must be a finite number and at"),
        ({"force": "slip_speed", "mu_static": 0.2}, "mu_static 0.2: it must be a finite number"),
        ({"force": "0.3", "mu_static": math.inf}, "mu_static inf: it must be a finite number"),
        (
            {"force": "a", "parameters": {"a": math.nan}},
            "parameter a = nan: it must be a finite number",
        ),
        ({"force": "0.3", "parameters": {"spin": 1.0}}, "parameter 'spin': this is no free name"),
        ({"force": "0.3", "parameters": {"sin": 1.0}}, "parameter 'sin': this is no free name"),
        ({"force": [1]}, "UserFriction: force must be a name, a formula in quotes or a SymPy"),
    ],
    ids=str,
)
def test_what_is_refused(arguments, message):
    with pytest.raises(InputError) as caught:
        UserFriction(**arguments)
    assert str(caught.value).startswith(message)


HERSEY = UserFriction("0.2 + 0.3*slip_speed/(slip_speed + 0.1*normal_force)", couple="0.02")
LOADED = Body(0.7, (1.2, 1.5, 2.1), Ball(0.9, centre=(0.1, -0.2, 0.15)))


def pressed_state(contact, system, mode, random):
    """A state that spins to the left, in the order of the dense equations and of the system."""
    while True:
        y, gamma = random_state(contact, mode, random)
        if not mode.spinning or Motion(contact).spin(y, gamma).real > 0:
            state = np.zeros(len(system.symbols))
            state[:16] = [*y[:7], *(rotation(y[:4]).T @ y[7:10]), *y[10:13], *gamma]
            return y, gamma, state


@pytest.mark.parametrize(
    "mode", [Mode(), pytest.param(Mode(spinning=False), marks=pytest.mark.slow)]
)
def test_force_that_depends_on_the_normal_force(mode):
    contact = FrictionalContact(LOADED, laws=(HERSEY,), field=Forces(gravity=GRAVITY))
    system = contact_equations(contact, mode)
    (guard,) = (guard.value for guard in system.guards if guard.name == "normal force")
    found = numeric(system, [*system.rates[10:13], real_symbol("N"), guard])
    random = np.random.default_rng(8)
    for _ in range(4):
        y, gamma, state = pressed_state(contact, system, mode, random)
        *omega_rate, N, margin = found(state)
        # dry friction of the coefficient that belongs to this normal force
        speed = np.linalg.norm(Motion(contact).slip(y, gamma).real)
        mu = 0.2 + 0.3 * speed / (speed + 0.1 * N)
        laws = (Coulomb(mu), SpinFriction(0.02))
        expected = accelerations(replace(contact, laws=laws), mode, y, gamma)
        assert expected.normal_force == pytest.approx(N, rel=1e-12)
        np.testing.assert_allclose(omega_rate, expected.omega, atol=1e-11)
        assert margin > 0


@pytest.mark.slow
def test_the_answer_to_a_unit_of_normal_force_knows_of_the_dependence():
    contact = FrictionalContact(LOADED, laws=(HERSEY,), field=Forces(gravity=GRAVITY))
    system = contact_equations(contact, Mode())
    heavier = {real_symbol("g"): GRAVITY + 1e-4}
    lighter = {real_symbol("g"): GRAVITY - 1e-4}
    _, _, state = pressed_state(contact, system, Mode(), np.random.default_rng(3))
    forces = [numeric(system, [real_symbol("N")], g)(state)[0] for g in (heavier, lighter)]
    response = float(numeric(system, [normal_response])(state)[0])
    assert 2e-4 / (forces[0] - forces[1]) == pytest.approx(response, rel=1e-8)


@pytest.mark.slow
def test_the_integrator_of_the_package_follows_stribeck():
    contact = FrictionalContact(
        Body(0.7, (0.4 * 0.7 * 0.81,) * 3, Ball(0.9)),
        laws=(STRIBECK,),
        field=Forces(gravity=GRAVITY),
    )
    system = contact_equations(contact, Mode())
    first, rate = 1.2, 3.5 * GRAVITY * 0.2 / 0.1
    state = np.zeros(len(system.symbols))
    state[[0, 6, 7, 15]] = 1.0, 0.9, first, 1.0
    end = 0.9 * math.log((math.exp(first / 0.1) + 0.3) / 1.3) / rate
    last = integrate(system, state, [0.0, end]).states[-1]
    slip = np.linalg.norm(last[7:10] + np.cross(last[10:13], -0.9 * last[13:16]))
    exact = 0.1 * math.log((math.exp(first / 0.1) + 0.3) * math.exp(-rate * end) - 0.3)
    assert slip == pytest.approx(exact, rel=1e-13)


# ---------------------------------------------------------------------------------------------
# Through stops and starts

#: A loaded ball that stops, rolls and slides again.
ROCKING = Body(1.0, (0.3, 0.3, 0.3), Ball(0.5, centre=(0.2, 0.0, 0.1)))


def motion_of(law, body, first, end):
    """A motion from an upright body with a velocity, ω = 0."""
    contact = CompiledContact(FrictionalContact(body, laws=(law,), field=Forces(gravity=GRAVITY)))
    state = np.zeros(contact.size)
    lowest = body.shape.radius - body.shape.centre[2]
    state[[0, 6, 15]] = 1.0, lowest, 1.0
    state[7:9] = first
    return contact, contact_motion(contact, state, np.linspace(0.0, end, 5))


@pytest.mark.slow
def test_a_constant_formula_moves_like_coulomb():
    one, other = (
        motion_of(law, ROCKING, (0.9, 0.4), 2.0)[1] for law in (UserFriction("0.12"), Coulomb(0.12))
    )
    assert [event.kind for event in one.events] == [event.kind for event in other.events]
    assert {"stick", "slip"} <= {event.kind for event in one.events}
    for a, b in zip(one.events, other.events, strict=True):
        assert a.time == pytest.approx(b.time, abs=1e-11)
    np.testing.assert_allclose(one.states, other.states, atol=1e-10)


@pytest.mark.slow
def test_the_ball_sticks_when_stribeck_says():
    first, v = 1.2, 0.1
    ball = Body(0.7, (0.4 * 0.7 * 0.81,) * 3, Ball(0.9))
    _, motion = motion_of(STRIBECK, ball, (first, 0.0), 0.5)
    rate = 3.5 * GRAVITY * 0.2 / v
    end = (math.log(math.exp(first / v) + 0.3) - math.log(1.3)) / rate
    assert [event.kind for event in motion.events] == ["stick"]
    assert motion.events[0].time == pytest.approx(end, rel=1e-12)


@pytest.mark.slow
def test_a_contact_slips_where_static_friction_ends():
    law = UserFriction("0.12", mu_static=0.125)
    contact, motion = motion_of(law, ROCKING, (0.9, 0.4), 2.0)
    slips = [event for event in motion.events if event.kind == "slip"]
    assert slips
    held = contact.mode(Mode(sliding=False))
    for event in slips:
        values = held.outputs(event.before)
        size = np.linalg.norm(values["friction_force"])
        assert size == pytest.approx(0.125 * values["normal_force"], rel=1e-10)
    balance = motion["energy"] + motion.states[:, 16:].sum(axis=1)
    np.testing.assert_allclose(balance, balance[0], atol=1e-12)
