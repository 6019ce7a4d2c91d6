"""What is proved of a body with friction, by body, support and laws; and what is not claimed."""

from __future__ import annotations

import pytest

import chaplygin as ch
from chaplygin.contact import (
    ContensouErismann,
    Coulomb,
    FrictionalContact,
    FrictionLaw,
    RollingResistance,
    SpinFriction,
    UserFriction,
    Viscous,
)
from chaplygin.contact.invariants.free_contact import jellett
from chaplygin.contact.invariants.provable_laws import provable_laws

BALL = ch.Body(2.0, (0.8, 0.8, 0.8), ch.Ball(1.0))
TOP = ch.Body(1.0, (0.4, 0.4, 0.3), ch.Ball(1.0, centre=(0, 0, 0.2)))
LOADED = ch.Body(1.0, (0.4, 0.5, 0.3), ch.Ball(1.0, centre=(0.1, 0, 0.2)))
EGG = ch.Body(1.0, (0.4, 0.4, 0.3), ch.Ellipsoid((1.0, 1.0, 1.3)))
MOMENTA = ["momentum_x", "momentum_y", "momentum_z"]
DIRECTION = ["direction_x", "direction_y"]


PLANE = ch.Plane()


def names(body: ch.Body, *laws: FrictionLaw, surface: ch.Plane | ch.Sphere = PLANE) -> list[str]:
    contact = FrictionalContact(body, surface, laws, ch.Forces(gravity=9.81))
    return [law.name for _, law in provable_laws(contact)]


def test_laws_follow_from_body_support_and_friction() -> None:
    dry, patch = Coulomb(0.3), ContensouErismann(0.3, 0.1)
    assert names(BALL, dry) == ["jellett", *MOMENTA, *DIRECTION, "power", "coulomb_power"]
    assert names(BALL, patch)[:5] == ["couple_on_jellett", *MOMENTA[:2], *DIRECTION]
    assert names(BALL, dry, SpinFriction(0.1))[1:3] == MOMENTA[:2]
    assert names(BALL, dry, RollingResistance(0.1)) == [
        *("couple_on_jellett", "power", "coulomb_power", "rolling_power")
    ]
    assert names(TOP, dry, Viscous(0.2)) == [
        *("jellett", "power", "coulomb_power", "viscous_power")
    ]
    assert names(LOADED, dry) == names(EGG, dry) == ["power", "coulomb_power"]
    assert names(EGG, dry, surface=ch.Plane(turntable=1.0)) == []
    assert names(BALL, dry, surface=ch.Plane(turntable=1.0)) == ["jellett", *MOMENTA]
    assert names(TOP, dry, surface=ch.Sphere(3.0)) == ["coulomb_power"]


def test_formulas_of_the_user_may_give_energy() -> None:
    assert names(EGG, UserFriction("0.3")) == ["power"]


@pytest.mark.parametrize("body", [BALL, TOP])
@pytest.mark.parametrize("law", [Coulomb(0.3), ContensouErismann(0.3, 0.1)])
def test_they_are_proven(body: ch.Body, law: FrictionLaw) -> None:
    contact = FrictionalContact(body, laws=(law,), field=ch.Forces(gravity=9.81))
    for system, claim in provable_laws(contact):
        if claim.name != "power":
            assert ch.prove(system, claim).decision == "proven", claim.name


def test_jellett_integral_is_refuted_under_a_couple() -> None:
    contact = FrictionalContact(TOP, laws=(ContensouErismann(0.3, 0.1),))
    (system, _), *_ = provable_laws(contact)
    assert ch.prove(system, jellett(TOP)).decision != "proven"
