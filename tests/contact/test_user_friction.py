"""Laws of friction by formulas of the user."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp

from chaplygin.contact.friction import Coulomb, NormalViscous, SpinFriction, UserFriction
from chaplygin.contact.modes import Mode
from chaplygin.errors import InputError
from contact.friction_formulas import Touch
from contact.law_values import law_values, random_touch
from contact.test_viscous_friction import GRAVITY, slip_of_ball

STRIBECK = UserFriction(
    "mu*(1 + 0.3*exp(-slip_speed/v))", mu_static=0.3, values={"mu": 0.2, "v": 0.1}
)
seeds = pytest.mark.parametrize("seed", range(4))


@seeds
def test_force_and_couple_are_those_of_the_formulas(seed):
    at = random_touch(np.random.default_rng(seed))
    law = UserFriction(
        "(a + slip_speed)/(1 + spin)", couple="b + spin**3", values={"a": 0.0, "b": 0.1}
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
    at = random_touch(np.random.default_rng(seed))
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
    at = random_touch(np.random.default_rng(1))
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
    ids=lambda x: x.words if isinstance(x, UserFriction) else "",
)
def test_guards(law, sliding, held):
    assert {guard.name for guard in law.guards(Mode())} == sliding
    assert {guard.name for guard in law.guards(Mode(sliding=False))} == held


def test_couple_that_holds_the_spin():
    law = UserFriction("0.3", couple="0.02 + spin")
    at = random_touch(np.random.default_rng(1))
    for couple, sign in ((0.0399, 1), (-0.0401, -1)):
        found = law_values(law, Mode(spinning=False), at, 2.0, holding_couple=couple)
        assert np.sign(found.guards["spin start"]) == sign
        assert not found.q.any()


def test_a_polynomial_force_is_defined_at_rest():
    at = random_touch(np.random.default_rng(1))
    rest = Touch(np.zeros(3), at.spin, at.rolling, at.gamma, at.spread)
    assert not law_values(UserFriction("2*slip_speed + slip_speed**3"), Mode(), rest).p.any()


def test_it_is_a_value():
    one, other = (UserFriction("0.3*slip_speed + a", values={"a": 0.1}) for _ in range(2))
    assert one == other and hash(one) == hash(other)
    assert one != UserFriction("0.3*slip_speed + a", values={"a": 0.2})
    v = sp.Symbol("slip_speed")
    assert UserFriction(sp.Rational(3, 10) * v + 1) == UserFriction("0.3*slip_speed + 1")
    assert [p.default for p in one.parameters] == [0.1, 0.1]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"force": "mu*2"}, "force: unknown name 'mu'; allowed: slip_speed, spin"),
        ({"force": "0.3 +"}, "force: "),
        ({"force": "__import__('os')"}, "force: "),
        ({"force": sp.Symbol("nu")}, "force: nu is not known; it may use slip_speed, spin"),
        ({"force": "normal_force"}, "force: "),
        (
            {"force": "-0.3"},
            "force: at slip_speed = 1e-06 and spin = 1e-06 it is -0.3; it must be a",
        ),
        ({"force": "0.3 - slip_speed"}, "force: at slip_speed = 0.3"),
        ({"force": "0.3", "couple": "-spin"}, "couple: at slip_speed = 1e-06 and spin = 1e-06 it"),
        ({"force": "sqrt(slip_speed - 1)"}, "force: at slip_speed"),
        ({"force": "1/slip_speed"}, "force: at zero slip it has no finite value; write it so"),
        ({"force": "0.3 + spin"}, "force: at zero slip it depends on spin; there it must be one"),
        ({"force": "0.3", "couple": "slip_speed"}, "couple: at zero spin it depends on slip_speed"),
        ({"force": "0.3", "mu_static": 0.2}, "mu_static 0.2: it must be a finite number and at"),
        ({"force": "slip_speed", "mu_static": 0.2}, "mu_static 0.2: it must be a finite number"),
        ({"force": "0.3", "mu_static": math.inf}, "mu_static inf: it must be a finite number"),
        ({"force": "a", "values": {"a": math.nan}}, "values: a = nan: it must be a finite number"),
        ({"force": "0.3", "values": {"spin": 1.0}}, "values: 'spin' is no free name"),
        ({"force": "0.3", "values": {"sin": 1.0}}, "values: 'sin' is no free name"),
        ({"force": [1]}, "UserFriction: force must be a name, a formula in quotes or a SymPy"),
    ],
    ids=str,
)
def test_what_is_refused(arguments, message):
    with pytest.raises(InputError) as caught:
        UserFriction(**arguments)
    assert str(caught.value).startswith(message)
