"""Rolling bodies as limits: the layer, the limit by the package's rolling bodies, the order."""

from __future__ import annotations

import numpy as np
import pytest

import flowlanes
import nonholonomic
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray
from nonholonomic.contact.rolling_limit.convergence import convergence
from nonholonomic.contact.rolling_limit.dry_limit import DryContact
from nonholonomic.contact.rolling_limit.rolling_limit import ViscousContact, start_of_limit
from nonholonomic.mechanics.rotations import upright

LOADED = nonholonomic.Body(1.0, (0.4, 0.45, 0.5), nonholonomic.Ball(1.0, centre=(0.1, -0.05, 0.2)))
BALANCED = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
OMEGA, NORMAL, SLIP = (0.7, 0.4, 1.1), (0.2, -0.3, 0.93), (0.5, 0.3, 0.0)
FIELD = nonholonomic.Forces(gravity=9.81)


def start(body: nonholonomic.Body, slip: tuple[float, ...]) -> list[float]:
    """A state in contact with a slip, made tangential."""
    gamma = np.array(NORMAL) / np.linalg.norm(NORMAL)
    omega, u = np.array(OMEGA), np.array(slip)
    r = body.shape.contact_points()(gamma[None])[0]
    v = u - (u @ gamma) * gamma - np.cross(omega, r)
    attitude = [float(x) for x in upright(list(map(float, gamma)))]
    return [*attitude, 0.0, 0.0, float(-r @ gamma), *v, *omega, *gamma]


def parts(body: nonholonomic.Body, state: FloatArray) -> tuple[FloatArray, ...]:
    v, omega, gamma = state[7:10], state[10:13], state[13:16]
    return v, omega, gamma, body.shape.contact_points()(gamma[None])[0]


@pytest.mark.parametrize("spinning", [True, False])
def test_the_layer_ends_slip_and_keeps_the_momentum_about_the_contact(spinning: bool) -> None:
    before = np.array(start(LOADED, SLIP))
    after = start_of_limit(LOADED, before, spinning)
    momenta = []
    for state in (before, after):
        v, omega, _, r = parts(LOADED, state)
        momenta.append(LOADED.tensor @ omega - LOADED.mass * np.cross(r, v))
    v, omega, gamma, r = parts(LOADED, after)
    assert np.abs(v + np.cross(omega, r)).max() < 1e-15
    change = momenta[1] - momenta[0]
    if spinning:
        assert np.abs(change).max() < 1e-15
    else:
        assert abs(gamma @ omega) < 1e-15
        assert np.abs(np.cross(change, gamma)).max() < 1e-15 < np.abs(change).max()
    np.testing.assert_array_equal(after[:7], before[:7])


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.0, 0.1])
def test_the_limit_is_the_rolling_body_of_the_package(share: float) -> None:
    family = ViscousContact(LOADED, start(LOADED, SLIP), (100.0, 200.0), share, FIELD)
    begin = start_of_limit(LOADED, family.state, spinning=not share)
    body = nonholonomic.rolling_system(LOADED, contact="rubber" if share else "marble", field=FIELD)
    known = {"omega": list(begin[10:13]), "gamma": list(begin[13:16])}
    motion = flowlanes.integrate(body, known, [0.0, 0.5, 1.0])
    found = family.limit(np.array([0.5, 1.0]))
    np.testing.assert_allclose(found[:, 13:16], motion["gamma"][1:], rtol=0, atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.0, 0.1])
@pytest.mark.parametrize("slip", [(0.0, 0.0, 0.0), SLIP])
def test_viscosity_leads_to_rolling_at_first_order(share: float, slip: tuple[float, ...]) -> None:
    family = ViscousContact(LOADED, start(LOADED, slip), (400.0, 800.0, 1600.0), share, FIELD)
    found = convergence(family, [1.0])
    assert abs(found.orders[-1] - 1) < 0.01
    assert abs(found.orders[-1] - 1) < abs(found.orders[0] - 1)


@pytest.mark.slow
def test_without_the_layer_there_is_no_convergence() -> None:
    """The rolling body that starts with the same ω is not the limit."""
    family = ViscousContact(LOADED, start(LOADED, SLIP), (400.0, 800.0), field=FIELD)
    wrong = np.array(family.state)
    _, omega, _, r = parts(LOADED, wrong)
    wrong[7:10] = -np.cross(omega, r)
    there = np.array([1.0])
    other = ViscousContact(LOADED, tuple(wrong), (400.0, 800.0), field=FIELD).limit(there)
    assert np.abs(family.motion(800.0, there) - other).max() > 0.05


@pytest.mark.slow
def test_dry_friction_leads_to_rolling_at_first_order() -> None:
    found = convergence(DryContact(BALANCED, start(BALANCED, SLIP), (2.0, 4.0, 8.0), FIELD), [1.0])
    assert abs(found.orders[-1] - 1) < 0.01


@pytest.mark.slow
def test_dry_friction_may_not_have_ended_the_slip() -> None:
    family = DryContact(BALANCED, start(BALANCED, SLIP), (0.001, 0.002), FIELD)
    with pytest.raises(InputError, match=r"the body still slides at t = 0\.1"):
        family.motion(0.001, np.array([0.1]))


def test_mistaken_families() -> None:
    with pytest.raises(InputError, match="state: it has 3 numbers; there must be 16"):
        ViscousContact(LOADED, (1.0, 2.0, 3.0), (1.0, 2.0))
    with pytest.raises(
        InputError, match=r"spin_share -1\.0: it must be a finite number, 0 or more"
    ):
        ViscousContact(LOADED, start(LOADED, SLIP), (1.0, 2.0), spin_share=-1.0)
