"""A body on a support with laws of friction."""

from __future__ import annotations

import math

import pytest

from flowlanes.errors import InputError
from flowlanes.system.vectors import real_symbol
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.dry_friction import Coulomb, SpinFriction
from nonholonomic.contact.friction.viscous_friction import Viscous
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces
from nonholonomic.mechanics.shapes.shapes import Ball
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere

BODY = Body(0.7, (0.3, 0.4, 0.5), Ball(0.9))


def test_it_is_a_value():
    laws = [Coulomb(0.1), Viscous(0.2)]
    assert FrictionalContact(BODY, laws=laws) == FrictionalContact(BODY, Plane(), tuple(laws))
    assert len({FrictionalContact(BODY), FrictionalContact(BODY)}) == 1


def test_laws_by_their_kind():
    contact = FrictionalContact(BODY, laws=(Coulomb(0.1), SpinFriction(0.2)))
    assert contact.law(Coulomb) == Coulomb(0.1)
    assert contact.law(Viscous) is None
    assert contact.setting == "dry friction, μ = 0.1; friction against spin, arm 0.2 m"
    assert FrictionalContact(BODY).setting == "no friction"


def test_a_contact_that_never_slips():
    assert FrictionalContact(BODY, laws=(Coulomb(math.inf),)).never_slips
    assert not FrictionalContact(BODY, laws=(Coulomb(1e9), SpinFriction(1.0))).never_slips


def test_what_is_refused():
    potential = Forces(potential=real_symbol("gamma_1"))
    FrictionalContact(BODY, field=potential)
    with pytest.raises(InputError, match="potential: with friction on a sphere there may be none"):
        FrictionalContact(BODY, Sphere(3.0), field=potential)
    with pytest.raises(InputError, match="'coulomb' is given twice"):
        FrictionalContact(BODY, laws=(Coulomb(0.1), Coulomb(0.1)))
    with pytest.raises(InputError, match="body must be a Body"):
        FrictionalContact(Ball(1.0))
    with pytest.raises(InputError, match="laws must be a sequence of FrictionLaws"):
        FrictionalContact(BODY, laws=(0.3,))
