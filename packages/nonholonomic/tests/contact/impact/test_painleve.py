"""Painlevé: the least friction for known bodies, and one body resolved by impact."""

from __future__ import annotations

import numpy as np
import pytest

from contact.colliding_bodies import collision
from flowlanes.system.arrays import FloatArray
from nonholonomic.contact.impact.impact import impact, normal_response
from nonholonomic.contact.impact.mobility import Mobility, mobility
from nonholonomic.contact.impact.painleve import (
    least_painleve_friction,
    least_painleve_friction_of_body,
    painleve_margin,
)

#: Half axes, and angle of the long axis above the plane.
AXES, LEAN = np.array([0.2, 0.2, 1.0]), 1.1621


def spheroid_contact(axes: FloatArray, gamma: FloatArray) -> FloatArray:
    return -(axes**2) * gamma / np.linalg.norm(axes * gamma)


def spheroid(lean: float) -> tuple[Mobility, FloatArray]:
    """The spheroid 5:1, and the projection of its axis on the plane."""
    gamma = np.array([0, np.cos(lean), np.sin(lean)])
    inertia = (AXES @ AXES - AXES**2) / 5
    along = np.array([0, -np.sin(lean), np.cos(lean)])
    return mobility(1.0, inertia, spheroid_contact(AXES, gamma), gamma), along


@pytest.mark.parametrize(
    ("inertia", "contact", "least", "accuracy"),
    [
        pytest.param(
            [1 / 3, 1 / 3, 1e-3],
            lambda g: np.array([0, 0, -np.sign(g[2])]),
            4 / 3,
            1e-12,
            id="rod",
        ),
        pytest.param(
            [0.25, 0.25, 0.5],
            lambda g: -np.array([g[0], g[1], 0]) / np.hypot(g[0], g[1]),
            np.sqrt(5) / 2,
            1e-12,
            id="disk",
        ),
        pytest.param(
            [0.5, 0.5, 1],
            lambda g: -np.array([g[0], g[1], 0]) / np.hypot(g[0], g[1]),
            np.sqrt(3),
            1e-12,
            id="hoop",
        ),
        *(
            pytest.param(
                [(k * k + 1) / 5, (k * k + 1) / 5, 2 / 5],
                lambda g, k=k: spheroid_contact(np.array([1, 1, k]), g),
                least,
                6e-6,
                id=f"spheroid {k}:1",
            )
            for k, least in ((3, 1.05683), (5, 1.00679), (10, 0.98648))
        ),
    ],
)
def test_least_friction(inertia, contact, least, accuracy) -> None:  # type: ignore[no-untyped-def]
    mu, gamma = least_painleve_friction_of_body(1.0, inertia, contact)
    assert mu == pytest.approx(least, rel=accuracy)
    body = mobility(1.0, inertia, contact(gamma), gamma)
    assert least_painleve_friction(body) == pytest.approx(mu, rel=1e-12)


def test_the_rod_by_hand() -> None:
    """m A_nn = 1 + cos²θ/κ, m A_nt = −sinθ cosθ/κ for a lean θ: least 2√(κ(1+κ))."""
    for kappa in (1 / 3, 1 / 4, 1 / 2, 0.7):
        lean = np.arctan(np.sqrt((1 + kappa) / kappa))
        gamma = np.array([np.cos(lean), 0, np.sin(lean)])
        body = mobility(2.0, [2 * kappa, 2 * kappa, 1.0], [0, 0, -1], gamma)
        least = 2 * np.sqrt(kappa * (1 + kappa))
        assert least_painleve_friction(body) == pytest.approx(least, rel=1e-14)
        slides = np.array([np.sin(lean), 0, -np.cos(lean)])
        margin = 1 + np.cos(lean) ** 2 / kappa - 2 * np.sin(lean) * np.cos(lean) / kappa
        found = painleve_margin(body, 3 * slides, 2.0)
        assert found == pytest.approx(margin / 2, rel=1e-13)


def test_the_least_friction_is_where_some_margin_vanishes() -> None:
    rng = np.random.default_rng(1)
    for _ in range(20):
        m = collision(rng).mobility
        mu = least_painleve_friction(m)
        angles = np.linspace(0, 2 * np.pi, 2001)
        directions = np.stack([np.cos(angles), np.sin(angles)], axis=1) @ m.tangents
        margins = [painleve_margin(m, e, mu) for e in directions]
        assert -1e-13 < min(margins) / max(margins) < 1e-5
        e = directions[7]
        assert painleve_margin(m, e, 0.3) == pytest.approx(normal_response(m, e, 0.3), rel=1e-12)


def test_the_spheroid_that_no_force_can_carry() -> None:
    m, along = spheroid(LEAN)
    mu, against = 1.9, -along
    assert painleve_margin(m, against, mu) == pytest.approx(-1.50335, abs=1e-4)
    assert 9.81 / painleve_margin(m, along, mu) == pytest.approx(2.00517, abs=1e-4)

    result = impact(m, against, mu=mu)
    assert [phase.mode for phase in result.phases] == ["sliding", "sticking"]
    assert np.abs(result.contact_velocity).max() < 1e-15
    # By hand: the impulse that stops the contact.
    np.testing.assert_allclose(
        result.impulse, -np.linalg.solve(m.A, against), rtol=1e-13, atol=1e-15
    )
    horizontal, vertical = result.impulse @ along, result.impulse @ m.gamma
    assert (horizontal, vertical) == pytest.approx((0.293505, 0.291526), abs=3e-5)
    before = 9.81 * -(m.r @ m.gamma) + 0.5
    assert before == pytest.approx(9.5358, abs=1e-4)
    assert before - result.energy_lost == pytest.approx(9.3891, abs=2e-4)
    # The stop by hand: the sliding stops after P = 1/(μ A_ee − A_en).
    rate = mu * (along @ m.A @ along) + along @ m.A @ m.gamma
    assert result.phases[0].end == pytest.approx(1 / rate, rel=1e-13)


def test_no_impulse_where_the_contact_can_last() -> None:
    gamma = np.array([0.0, 0.6, 0.8])
    m = mobility(1.0, [0.4, 0.4, 0.4], -gamma, gamma)
    result = impact(m, [1.0, 0, 0], mu=0.5)
    assert np.abs(result.impulse).max() < 1e-15


def test_restitution_gives_the_impact_without_collision_a_rebound() -> None:
    m, along = spheroid(LEAN)
    for law in ("stronge", "poisson"):
        result = impact(m, -along, mu=1.9, restitution=0.5, law=law)
        assert result.contact_velocity @ m.gamma > 0.05
        assert result.energy_lost > 0
    still = impact(m, -along, mu=1.9, restitution=0.5, law="newton")
    assert abs(still.contact_velocity @ m.gamma) < 1e-15


def test_a_homogeneous_ball_has_no_least_friction() -> None:
    least, _ = least_painleve_friction_of_body(1.0, [0.4, 0.4, 0.4], lambda gamma: -gamma)
    assert least == np.inf
