"""Friction of an order between Coulomb's and viscous: how it ends."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from contact.friction_formulas import ContactState
from contact.law_values import law_values, random_contact_state
from evaluation import numeric
from nonholonomic.contact.equations.equations_of_motion import contact_equations
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.modes import Mode
from nonholonomic.contact.friction.viscous_friction import NormalViscous, PowerFriction
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces
from nonholonomic.mechanics.shapes.shapes import Ball

GRAVITY = 9.81
#: A homogeneous ball: u̇ = −(7/2) g × the force for each unit of normal force.
BALL = Body(0.7, (0.4 * 0.7 * 0.81,) * 3, Ball(0.9))


def slip_of_ball(law, first, times):
    """The slip of a ball that slides straight on, by an integrator of SciPy's."""
    contact = FrictionalContact(BALL, laws=(law,), field=Forces(gravity=GRAVITY))
    system = contact_equations(contact, Mode())
    rates = numeric(system, system.rates)
    state = np.zeros(len(system.symbols))
    state[[0, 6, 7, 15]] = 1.0, 0.9, first, 1.0
    found = solve_ivp(
        lambda _, y: rates(y), (0, times[-1]), state, "DOP853", times, rtol=1e-12, atol=1e-13
    )
    # along x: v₁ + (ω×r)₁ in body axes that have turned about y, so by its length
    v, omega, gamma = found.y[7:10], found.y[10:13], found.y[13:16]
    return np.linalg.norm(v + np.cross(omega.T, -0.9 * gamma.T).T, axis=0)


def test_below_order_one_the_root_of_the_slip_falls_to_zero_in_finite_time():
    nu, first = 0.3, 1.2
    end = 2 * np.sqrt(first) / (3.5 * GRAVITY * nu)
    times = np.linspace(0, 0.98 * end, 7)
    slip = slip_of_ball(PowerFriction(nu, 0.5), first, times)
    np.testing.assert_allclose(np.sqrt(slip), np.sqrt(first) * (1 - times / end), atol=1e-10)


def test_above_order_one_the_slip_never_ends():
    nu, first = 0.3, 1.2
    times = np.linspace(0, 5.0, 6)
    slip = slip_of_ball(PowerFriction(nu, 3.0), first, times)
    exact = first / np.sqrt(1 + 7 * GRAVITY * nu * first**2 * times)
    np.testing.assert_allclose(slip, exact, rtol=1e-9)


@pytest.mark.parametrize("seed", range(3))
def test_order_one_is_the_viscous_law(seed):
    at = random_contact_state(np.random.default_rng(seed))
    one, other = (law_values(x, Mode(), at) for x in (PowerFriction(0.3, 1.0), NormalViscous(0.3)))
    np.testing.assert_allclose(one.p, other.p, rtol=1e-15)


def test_small_orders_come_near_to_dry_friction():
    at = random_contact_state(np.random.default_rng(1))
    found = law_values(PowerFriction(0.3, 1e-9), Mode(), at)
    assert np.linalg.norm(found.p) == pytest.approx(0.3, rel=1e-7)


@pytest.mark.parametrize(("order", "ends"), [(0.5, True), (1.0, False), (2.0, True), (3.0, False)])
def test_equations_end_where_the_force_is_not_smooth(order, ends):
    at = random_contact_state(np.random.default_rng(1))
    still = ContactState(1e-12 * at.slip, at.spin, at.rolling, at.gamma, at.spread)
    law = PowerFriction(0.3, order)
    assert law.is_smooth != ends
    assert law_values(law, Mode(), at).guards.get("creep", 1.0) > 0
    assert (law_values(law, Mode(), still).guards.get("creep", 1.0) < 0) == ends
    assert not law.guards(Mode(sliding=False))


def test_a_smooth_force_is_defined_at_rest():
    at = random_contact_state(np.random.default_rng(1))
    rest = ContactState(np.zeros(3), at.spin, at.rolling, at.gamma, at.spread)
    for law in (NormalViscous(0.3), PowerFriction(0.3, 1.0), PowerFriction(0.3, 3.0)):
        assert not law_values(law, Mode(), rest).p.any()
