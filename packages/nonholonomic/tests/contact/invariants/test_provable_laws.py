"""What is proved of a body with friction, by body, support and laws; and what is not claimed."""

from __future__ import annotations

import pytest

import lawproof
import nonholonomic
from nonholonomic.contact import (
    ContensouErismann,
    Coulomb,
    FrictionalContact,
    FrictionLaw,
    RollingResistance,
    SpinFriction,
    UserFriction,
    Viscous,
)
from nonholonomic.contact.invariants.free_contact import jellett
from nonholonomic.contact.invariants.provable_laws import provable_laws

BALL = nonholonomic.Body(2.0, (0.8, 0.8, 0.8), nonholonomic.Ball(1.0))
TOP = nonholonomic.Body(1.0, (0.4, 0.4, 0.3), nonholonomic.Ball(1.0, centre=(0, 0, 0.2)))
LOADED = nonholonomic.Body(1.0, (0.4, 0.5, 0.3), nonholonomic.Ball(1.0, centre=(0.1, 0, 0.2)))
EGG = nonholonomic.Body(1.0, (0.4, 0.4, 0.3), nonholonomic.Ellipsoid((1.0, 1.0, 1.3)))
MOMENTA = ["momentum_x", "momentum_y", "momentum_z"]
DIRECTION = ["direction_x", "direction_y"]


PLANE = nonholonomic.Plane()


def names(
    body: nonholonomic.Body,
    *laws: FrictionLaw,
    surface: nonholonomic.Plane | nonholonomic.Sphere = PLANE,
) -> list[str]:
    contact = FrictionalContact(body, surface, laws, nonholonomic.Forces(gravity=9.81))
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
    assert names(EGG, dry, surface=nonholonomic.Plane(turntable=1.0)) == []
    assert names(BALL, dry, surface=nonholonomic.Plane(turntable=1.0)) == ["jellett", *MOMENTA]
    assert names(TOP, dry, surface=nonholonomic.Sphere(3.0)) == ["coulomb_power"]


def test_formulas_of_the_user_may_give_energy() -> None:
    assert names(EGG, UserFriction("0.3")) == ["power"]


@pytest.mark.parametrize("body", [BALL, TOP])
@pytest.mark.parametrize("law", [Coulomb(0.3), ContensouErismann(0.3, 0.1)])
def test_they_are_proven(body: nonholonomic.Body, law: FrictionLaw) -> None:
    contact = FrictionalContact(body, laws=(law,), field=nonholonomic.Forces(gravity=9.81))
    for system, claim in provable_laws(contact):
        if claim.name != "power":
            assert lawproof.prove(system, claim).decision == "proven", claim.name


def test_jellett_integral_is_refuted_under_a_couple() -> None:
    contact = FrictionalContact(TOP, laws=(ContensouErismann(0.3, 0.1),))
    (system, _), *_ = provable_laws(contact)
    assert lawproof.prove(system, jellett(TOP)).decision != "proven"
