"""Situations that are said to share their equations do."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest
import sympy as sp

import nonholonomic
from flowlanes.system.system import System
from nonholonomic.contact import (
    ContensouErismann,
    ContourResistance,
    Coulomb,
    FrictionalContact,
    NormalViscous,
    RollingResistance,
    SpinFriction,
    UserFriction,
    Viscous,
    ViscousRolling,
)
from nonholonomic.contact.equations.equations_of_motion import contact_equations
from nonholonomic.contact.equations.structure import SharedEquations
from nonholonomic.contact.friction.modes import Mode
from nonholonomic.contact.motion import contact_motion
from nonholonomic.contact.simulation.compiled import CompiledContact
from nonholonomic.contact.starts import state_in_contact

INERTIA = (0.2, 0.25, 0.3)
SITUATIONS = {
    "loaded ball": FrictionalContact(
        nonholonomic.Body(1.0, INERTIA, nonholonomic.Ball(1.0, centre=(0.1, 0.05, 0.3))),
        laws=(Coulomb(0.3), SpinFriction(0.01), Viscous(0.1, 0.2)),
        field=nonholonomic.Forces(gravity=9.81),
    ),
    "ball on a patch": FrictionalContact(
        nonholonomic.Body(1.0, INERTIA, nonholonomic.Ball(1.0), gyrostat=(0.1, 0.0, 0.2)),
        nonholonomic.Sphere(5.0, "inside", turntable=0.3),
        (ContensouErismann(0.3, 0.01), RollingResistance(0.01)),
        nonholonomic.Forces(gravity=9.81),
    ),
    "pebble": FrictionalContact(
        nonholonomic.Body(1.0, INERTIA, nonholonomic.Ellipsoid((1.0, 0.8, 0.6), turn=0.3)),
        laws=(NormalViscous(0.3), ViscousRolling(0.1), ContourResistance(0.02)),
        field=nonholonomic.Forces(gravity=9.81),
    ),
    "coin": FrictionalContact(
        nonholonomic.Body(
            1.0,
            ((0.2, 0.01, 0.0), (0.01, 0.25, 0.0), (0.0, 0.0, 0.3)),
            nonholonomic.Torus(1.0, 0.1),
        ),
        laws=(Coulomb(float("inf")),),
        field=nonholonomic.Forces(gravity=9.81),
    ),
    "disk": FrictionalContact(
        nonholonomic.Body(1.0, INERTIA, nonholonomic.Disk(1.0)),
        laws=(Coulomb(0.2),),
        field=nonholonomic.Forces(gravity=9.81),
    ),
}


def varied(value: object, rng: np.random.Generator) -> object:
    """A value with other numbers; those that are zero or infinite stay."""
    if isinstance(value, tuple):
        if value and isinstance(value[0], tuple):
            return tuple(tuple(1.07 * x for x in row) for row in value)
        return tuple(varied(item, rng) for item in value)
    if isinstance(value, float):
        return value * rng.uniform(0.99, 1.01)
    if hasattr(value, "__dataclass_fields__"):
        names = [field.name for field in fields(value)]
        return replace(value, **{name: varied(getattr(value, name), rng) for name in names})
    return value


def formulas(system: System) -> list[object]:
    """All that is compiled of a system."""
    return [
        system.symbols,
        system.scalar_definitions,
        system.rates,
        [sp.srepr(item) for item in system.relations],
        [str(p.symbol) for p in system.parameters],
        [(o.name, o.value) for o in system.observables],
        [(g.name, g.value) for g in system.guards],
    ]


@pytest.mark.slow
@pytest.mark.parametrize("name", SITUATIONS)
def test_equations_are_shared_but_for_their_parameters(name: str) -> None:
    """Were a number built into the formulas, another body would move by the wrong equations."""
    situation = SITUATIONS[name]
    other = varied(situation, np.random.default_rng(1))
    assert other != situation
    assert SharedEquations(other) == SharedEquations(situation)
    coupled = any(isinstance(law, ContensouErismann) for law in situation.laws)
    mode = Mode(sliding=not situation.never_slips, range="outer" if coupled else "")
    assert formulas(contact_equations(other, mode)) == formulas(contact_equations(situation, mode))


def test_what_changes_the_equations() -> None:
    """Zeros, infinite coefficients, formulas and orders are no values of parameters."""
    situation = SITUATIONS["loaded ball"]
    body = situation.body
    others = [
        replace(situation, laws=(Coulomb(0.3),)),
        replace(situation, laws=(Coulomb(float("inf")), *situation.laws[1:])),
        replace(situation, field=nonholonomic.Forces()),
        replace(situation, surface=nonholonomic.Plane(turntable=1.0)),
        replace(situation, body=replace(body, shape=nonholonomic.Ball(1.0))),
        replace(situation, body=replace(body, gyrostat=(0.0, 0.0, 1.0))),
        replace(situation, laws=(UserFriction("0.3 + 0.1*slip_speed"),)),
        replace(situation, laws=(UserFriction("0.3 + 0.2*slip_speed"),)),
    ]
    seen = {SharedEquations(item) for item in (situation, *others)}
    assert len(seen) == len(others) + 1


def test_a_second_body_moves_by_its_own_numbers() -> None:
    """The equations prepared for one body, with the mass and moments of another."""
    table = FrictionalContact(
        nonholonomic.Body(0.2, (2e-4, 2e-4, 2e-4), nonholonomic.Ball(0.05)),
        laws=(Coulomb(0.2),),
        field=nonholonomic.Forces(gravity=9.81),
    )
    for mu, radius in ((0.2, 0.05), (0.35, 0.08)):
        inertia = (0.4 * 0.2 * radius**2,) * 3
        body = nonholonomic.Body(0.2, inertia, nonholonomic.Ball(radius))
        other = replace(table, body=body, laws=(Coulomb(mu),))
        start = state_in_contact(other, omega=(0, 0, 0), gamma=(0, 0, 1), slip=(1.4, 0, 0))
        motion = contact_motion(CompiledContact(other), start, [0.0, 1.0])
        assert motion.events[0].time == pytest.approx(2 * 1.4 / (7 * mu * 9.81), rel=1e-12)
