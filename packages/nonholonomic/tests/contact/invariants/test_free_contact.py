"""What any force at the contact keeps, against Newton's and Euler's equations in space axes."""

from __future__ import annotations

import numpy as np
import pytest

import lawproof
import nonholonomic
from flowlanes.errors import InputError
from flowlanes.system.laws import Integral
from flowlanes.system.vectors import Diagonal, Vector, constant, dot, real_symbol
from nonholonomic.contact.invariants.free_contact import (
    ANY_COUPLE,
    couple_on_jellett,
    free_contact,
    jellett,
    power,
)

TOP = nonholonomic.Body(
    0.006, (8e-7, 8e-7, 7e-7), nonholonomic.Ball(0.015, centre=(0.0, 0.0, 0.003))
)
ROTOR_TOP = nonholonomic.Body(
    1.0, (0.4, 0.4, 0.3), nonholonomic.Ball(1.0, centre=(0, 0, -0.2)), (0.0, 0.0, 0.3)
)
BODIES = pytest.mark.parametrize("body", [TOP, ROTOR_TOP], ids=["top", "with rotor"])


@BODIES
def test_jellett_is_kept_by_any_force(body: nonholonomic.Body) -> None:
    assert lawproof.prove(free_contact(body), jellett(body)).decision == "proven"


@pytest.mark.parametrize(
    "body",
    [pytest.param(TOP, marks=pytest.mark.slow), ROTOR_TOP],
    ids=["top", "with rotor"],
)
def test_what_a_couple_does_to_jellett(body: nonholonomic.Body) -> None:
    system = free_contact(body, couple=ANY_COUPLE)
    assert lawproof.prove(system, couple_on_jellett(body)).decision == "proven"
    assert lawproof.prove(system, jellett(body)).decision == "refuted"


def test_a_wrong_sign_in_jellett_is_refuted_at_a_rational_point() -> None:
    omega, r = Vector("omega"), Vector("r")
    mirrored = 2 * real_symbol("c_3") * constant([0, 0, 1]) - r
    # (Iω, Rγ + c e) for (Iω, Rγ − c e)
    wrong = Integral("wrong", dot(Diagonal("I") * omega, mirrored), level=jellett(TOP).level)
    verdict = lawproof.prove(free_contact(TOP), wrong)
    assert verdict.decision == "refuted"
    assert verdict.witness is not None
    point = verdict.witness["point"]
    assert {"omega_1", "gamma_3", "c_3"} <= set(point)
    assert all(set(str(value)) <= set("-0123456789/") for value in point.values())


@pytest.mark.parametrize("moments", [(0.4, 0.5, 0.3)])
def test_jellett_needs_a_body_of_revolution(moments: tuple[float, float, float]) -> None:
    body = nonholonomic.Body(1.0, moments, nonholonomic.Ball(1.0, centre=(0.0, 0.0, 0.2)))
    law = Integral("jellett", jellett(body).value)
    assert lawproof.prove(free_contact(body), law).decision == "refuted"


@pytest.mark.parametrize("seed", range(20))
def test_jellett_in_space_axes(seed: int) -> None:
    """d/dt (L, Rγ − c e) with L̇ = r×F and ė = ω×e, for a vertical γ."""
    random = np.random.default_rng(seed)
    across, about, radius, offset = random.uniform(0.2, 1.0, 4)
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    axis, omega, force = turn[:, 2], random.normal(size=3), random.normal(size=3)
    inertia = across * (np.eye(3) - np.outer(axis, axis)) + about * np.outer(axis, axis)
    up = np.array([0.0, 0.0, 1.0])
    lever = offset * axis - radius * up
    momentum, torque = inertia @ omega, np.cross(lever, force)
    rate = -torque @ lever - momentum @ (offset * np.cross(omega, axis))
    assert abs(rate) < 1e-14


@pytest.mark.parametrize(
    "shape",
    [
        nonholonomic.Ball(1.0),
        pytest.param(nonholonomic.Ball(1.0, centre=(0.1, 0.2, 0.3)), marks=pytest.mark.slow),
        pytest.param(nonholonomic.Disk(1.0), marks=pytest.mark.slow),
        pytest.param(nonholonomic.Torus(1.0, 0.2), marks=pytest.mark.slow),
        pytest.param(nonholonomic.Ellipsoid((3.0, 2.0, 1.0), turn=0.3), marks=pytest.mark.slow),
    ],
    ids=lambda shape: type(shape).__name__,
)
def test_the_energy_changes_by_the_power_at_the_contact(shape: nonholonomic.Ball) -> None:
    inertia = ((1.0, 0.1, 0.2), (0.1, 1.5, 0.1), (0.2, 0.1, 2.0))
    body = nonholonomic.Body(1.0, inertia, shape, gyrostat=(0.1, 0.2, 0.3))
    system = free_contact(body, couple=ANY_COUPLE)
    assert lawproof.prove(system, power(body)).decision == "proven"
    without_couple = power(body, couple=constant([0, 0, 0]))
    assert lawproof.prove(system, without_couple).decision == "refuted"


def test_mistakes() -> None:
    x, y, z = nonholonomic.ImplicitShape.coordinates
    quartic = nonholonomic.Body(
        1.0, (1.0, 1.0, 1.0), nonholonomic.ImplicitShape(x**4 + y**4 + z**4 - 1)
    )
    with pytest.raises(InputError, match="an implicit surface has no formula"):
        free_contact(quartic)
    with pytest.raises(InputError, match="a body with a spherical surface"):
        jellett(nonholonomic.Body(1.0, (1.0, 1.0, 1.0), nonholonomic.Disk(1.0)))
    tilted = ((1.0, 0.1, 0.2), (0.1, 1.5, 0.1), (0.2, 0.1, 2.0))
    with pytest.raises(InputError, match="needs principal axes"):
        jellett(nonholonomic.Body(1.0, tilted, nonholonomic.Ball(1.0)))
