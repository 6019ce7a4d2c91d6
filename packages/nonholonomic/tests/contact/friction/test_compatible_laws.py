"""Every law of friction: its force and couple, the power lost to it, and what it refuses."""

from __future__ import annotations

import doctest
import math
from dataclasses import dataclass
from importlib import import_module

import numpy as np
import pytest

from contact.friction_formulas import ContactState, reaction
from contact.law_values import law_values, random_contact_state
from flowlanes.errors import InputError
from flowlanes.system.vectors import zero
from nonholonomic.contact.friction.compatible_laws import require_compatible
from nonholonomic.contact.friction.contensou import range_of
from nonholonomic.contact.friction.dry_friction import ContensouErismann, Coulomb, SpinFriction
from nonholonomic.contact.friction.friction_law import Reaction
from nonholonomic.contact.friction.modes import Mode
from nonholonomic.contact.friction.rolling_friction import (
    ContourResistance,
    RollingResistance,
    ViscousRolling,
)
from nonholonomic.contact.friction.symbols import gamma, slip, slip_speed, spin
from nonholonomic.contact.friction.user_friction import UserFriction
from nonholonomic.contact.friction.viscous_friction import NormalViscous, PowerFriction, Viscous

LAWS = (
    Coulomb(0.3),
    Coulomb(0.0),
    SpinFriction(0.02),
    ContensouErismann(0.4, 0.7),
    ContensouErismann(0.4, 0.02),
    Viscous(0.5, 0.3),
    NormalViscous(0.2),
    PowerFriction(0.2, 0.5),
    PowerFriction(0.2, 3.0),
    PowerFriction(0.2, 2.0),
    RollingResistance(0.1),
    ViscousRolling(0.6),
    ContourResistance(0.05),
)
every_law = pytest.mark.parametrize("law", LAWS, ids=str)
seeds = pytest.mark.parametrize("seed", range(8))


def moving(law, at):
    """The mode of a contact that slides, spins and rolls."""
    patch = law.patch_radius
    return Mode(range=range_of(float(np.linalg.norm(at.slip)), at.spin, patch) if patch else "")


def differs(law, at, formulas=reaction):
    """The greatest difference of a law from its formulas."""
    found = law_values(law, moving(law, at), at)
    parts = (found.p, found.q, found.force, found.couple)
    return max(np.abs(a - b).max() for a, b in zip(parts, formulas(law, at), strict=True))


@every_law
@seeds
def test_force_and_couple(law, seed):
    assert differs(law, random_contact_state(np.random.default_rng(seed))) < 1e-14


@every_law
@seeds
def test_power_is_lost(law, seed):
    at, N = random_contact_state(np.random.default_rng(seed)), 2.5
    found = law_values(law, moving(law, at), at, N)
    force, couple = N * found.p + found.force, N * found.q + found.couple
    turning = at.spin * at.gamma + at.rolling
    assert found.power == pytest.approx(-(force @ at.slip) - couple @ turning, rel=1e-13)
    assert found.power > 0 or law == Coulomb(0.0)


@seeds
def test_power_of_each_law_in_closed_form(seed):
    at = random_contact_state(np.random.default_rng(seed))
    speed, turn = np.linalg.norm(at.slip), np.linalg.norm(at.rolling)
    path = np.linalg.norm(at.spread @ np.cross(at.gamma, at.rolling))
    expected = {
        Coulomb(0.3): 0.3 * speed,
        SpinFriction(0.02): 0.02 * abs(at.spin),
        Viscous(0.5, 0.3): 0.5 * speed**2 + 0.3 * at.spin**2,
        NormalViscous(0.2): 0.2 * speed**2,
        RollingResistance(0.1): 0.1 * turn,
        ViscousRolling(0.6): 0.6 * turn**2,
        ContourResistance(0.05): 0.05 * path,
    }
    for law, power in expected.items():
        assert law_values(law, Mode(), at).power == pytest.approx(power, rel=1e-13)


@seeds
def test_contour_on_a_ball_is_resistance_to_rolling(seed):
    at = random_contact_state(np.random.default_rng(seed))
    ball = ContactState(at.slip, at.spin, at.rolling, at.gamma, 0.6 * np.eye(3))
    contour, rolling = (
        law_values(law, Mode(), ball).q
        for law in (ContourResistance(0.05), RollingResistance(0.05 * 0.6))
    )
    np.testing.assert_allclose(contour, rolling, rtol=1e-13)


# ---------------------------------------------------------------------------------------------
# Thresholds


HELD = Mode(sliding=False)


@pytest.mark.parametrize(("size", "sign"), [(0.299, 1), (0.301, -1)])
def test_dry_friction_holds_up_to_its_limit(size, sign):
    at = random_contact_state(np.random.default_rng(1))
    friction = 2.0 * size * at.slip / np.linalg.norm(at.slip)
    found = law_values(Coulomb(0.3), HELD, at, 2.0, friction)
    assert np.sign(found.guards["slip"]) == sign
    assert not found.p.any()


@pytest.mark.parametrize(("couple", "sign"), [(0.0399, 1), (-0.0399, 1), (0.0401, -1)])
def test_spin_friction_holds_up_to_its_limit(couple, sign):
    at = random_contact_state(np.random.default_rng(1))
    held = Mode(spinning=False)
    found = law_values(SpinFriction(0.02), held, at, 2.0, holding_couple=couple)
    assert np.sign(found.guards["spin start"]) == sign
    assert not found.q.any()


def test_motion_ends_where_its_guard_vanishes():
    at = random_contact_state(np.random.default_rng(3))
    slow = ContactState(1e-10 * at.slip, at.spin, 1e-10 * at.rolling, at.gamma, at.spread)
    guards = {"stick": Coulomb(0.3), "rolling stop": RollingResistance(0.1)}
    for name, law in guards.items():
        assert law_values(law, Mode(), at).guards[name] > 0
        assert law_values(law, Mode(), slow).guards[name] < 0
    assert law_values(SpinFriction(0.1), Mode(), at).guards["spin stop"] == abs(at.spin)


def test_what_a_law_holds():
    held = [(law.static_mu, law.spin_arm, law.patch_radius, law.holds_rolling) for law in LAWS]
    assert held == [
        (0.3, 0, 0, False),
        (0.0, 0, 0, False),
        (None, 0.02, 0, False),
        (0.4, 0, 0.7, False),
        (0.4, 0, 0.02, False),
        *[(None, 0, 0, False)] * 5,
        (None, 0, 0, True),
        (None, 0, 0, False),
        (None, 0, 0, True),
    ]
    assert all(law.kinetic_mu == law.static_mu for law in LAWS)
    assert not RollingResistance(0.0).holds_rolling
    assert Coulomb(math.inf).static_mu == math.inf
    assert not Coulomb(math.inf).guards(HELD)


# ---------------------------------------------------------------------------------------------
# Mistakes are seen


@dataclass(frozen=True)
class Mistaken(Coulomb):
    """A law with another reaction than Coulomb's."""

    p: object = zero
    q: object = zero

    def reaction(self, mode):
        return Reaction(self.p, self.q)


MISTAKES = {
    "sign": Mistaken(0.3, 0.3 * slip / slip_speed),
    "not of unit length": Mistaken(0.3, -0.3 * slip),
    "a couple besides": Mistaken(0.3, -0.3 * slip / slip_speed, -1e-9 * spin * gamma),
    "another coefficient": Mistaken(0.3, -0.3000001 * slip / slip_speed),
}


@pytest.mark.parametrize("law", MISTAKES.values(), ids=MISTAKES)
def test_a_mistaken_law_is_found(law):
    at = random_contact_state(np.random.default_rng(0))
    right = Mistaken(0.3, -0.3 * slip / slip_speed)

    def coulomb(_, contact_state):
        return reaction(Coulomb(0.3), contact_state)

    assert differs(right, at, coulomb) < 1e-15
    assert differs(law, at, coulomb) > 1e-12


# ---------------------------------------------------------------------------------------------
# What is refused


@pytest.mark.parametrize(
    ("law", "arguments", "message"),
    [
        (Coulomb, (-0.1,), "mu -0.1: it must be a number not below zero, or inf"),
        (Coulomb, (math.nan,), "mu nan: it must be a number not below zero, or inf"),
        (SpinFriction, (-1.0,), "spin_arm -1.0: it must be a finite number not below zero"),
        (ContensouErismann, (0.3, 0.0), "patch 0.0: with a patch of contact it must be a positive"),
        (ContensouErismann, (math.inf, 0.1), "mu inf: with a patch of contact it must be a pos"),
        (Viscous, (-1.0,), "viscous -1.0: it must be"),
        (Viscous, (1.0, math.inf), "spin_viscous inf: it must be"),
        (NormalViscous, (-1.0,), "slip -1.0: it must be"),
        (PowerFriction, (-1.0, 0.5), "slip -1.0: it must be"),
        (PowerFriction, (1.0, 0.0), "slip_order 0.0: it must be a positive finite number"),
        (RollingResistance, (-1.0,), "rolling -1.0: it must be"),
        (ViscousRolling, (-1.0,), "rolling_viscous -1.0: it must be"),
        (ContourResistance, (math.nan,), "contour nan: it must be"),
        (Coulomb, ("much",), "Coulomb: mu must be a number, not the text 'much'"),
    ],
)
def test_a_coefficient_that_is_none_is_refused(law, arguments, message):
    with pytest.raises(InputError) as caught:
        law(*arguments)
    assert str(caught.value).startswith(message)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("laws", "message"),
    [
        ((Coulomb(0.1), Coulomb(0.2)), "friction: the law 'coulomb' is given twice"),
        ((ContensouErismann(0.1, 0.1), Coulomb(0.2)), "it excludes the law 'coulomb'"),
        ((SpinFriction(0.1), ContensouErismann(0.1, 0.1)), "it excludes the law 'spin'"),
        (
            (Coulomb(0.1), UserFriction("0.1")),
            "friction: the laws 'coulomb' and 'user' both hold a contact without slip; give one",
        ),
        (
            (UserFriction("0.1*slip_speed", couple="0.1"), SpinFriction(0.1)),
            "friction: the laws 'user' and 'spin' both hold a contact without spin; give one",
        ),
        (
            (ContourResistance(0.1), RollingResistance(0.1)),
            "friction: resistance to rolling excludes resistance along the contour",
        ),
    ],
)
def test_laws_that_exclude_each_other(laws, message):
    with pytest.raises(InputError, match=message):
        require_compatible(laws)
    require_compatible(laws[:1])


@pytest.mark.parametrize(
    "module",
    [
        "friction.contensou",
        "friction.dry_friction",
        "equations.equations_of_motion",
        "equations.free_body",
        "friction.friction_law",
        "friction.modes",
        "friction.prescribed_friction",
        "equations.reaction",
        "friction.rolling_friction",
        "equations.situation",
        "friction.user_friction",
        "friction.viscous_friction",
    ],
)
def test_examples_give_what_they_show(module):
    outcome = doctest.testmod(import_module(f"nonholonomic.contact.{module}"))
    assert outcome.failed == 0
