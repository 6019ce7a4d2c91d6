"""Skates: their limits in closed form, and the order in which they are reached."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from flowlanes.errors import InputError
from nonholonomic.contact.rolling_limit.convergence import Convergence, convergence
from nonholonomic.contact.rolling_limit.skate import Skate

S = (50.0, 100.0, 200.0, 400.0)


def vakonomic(t: float, y: np.ndarray, nu: float) -> list[float]:
    """ẋ, ẏ, ṗ_x, ṗ_y, φ̇, φ̈ of the limit of added inertia, for m = J = a = 1."""
    e, n = np.array([np.cos(y[4]), np.sin(y[4])]), np.array([-np.sin(y[4]), np.cos(y[4])])
    momentum = y[2:4]
    along, held = momentum @ e, momentum @ n
    return [*(along * e), *(np.array([1.0, 0.0]) - nu * held * n), y[5], -along * held]


@pytest.mark.parametrize("times", [[0.5, 2.0]])
def test_the_nonholonomic_skate_in_closed_form(times: list[float]) -> None:
    t, spin = np.array(times), 2.0
    found = Skate(S, viscosity=1.0).limit(t)
    x = np.sin(spin * t) ** 2 / (2 * spin**2)
    y = (spin * t - np.sin(2 * spin * t) / 2) / (2 * spin**2)
    np.testing.assert_allclose(found[:, :2], np.stack([x, y], axis=1), rtol=0, atol=1e-13)


@pytest.mark.slow
@pytest.mark.parametrize("nu", [0.0, 3.0])
def test_the_limit_of_added_inertia_by_another_integrator(nu: float) -> None:
    found = Skate(S, viscosity=nu, mass=1.0).limit(np.array([2.0]))[0]
    other = solve_ivp(
        vakonomic, (0, 2), [0, 0, 0, 0, 0, 2], "DOP853", args=(nu,), rtol=1e-12, atol=1e-13
    )
    np.testing.assert_allclose(found, other.y[[0, 1, 4, 5], -1], rtol=0, atol=1e-10)


@pytest.mark.slow
@pytest.mark.parametrize("shares", [(1.0, 0.0), (0.0, 1.0), (1.0, 1.0)])
def test_the_order_is_one(shares: tuple[float, float]) -> None:
    found = convergence(Skate(S, *shares), [2.0])
    assert np.all(np.diff(np.abs(found.orders - 1)) < 0)
    assert abs(found.orders[-1] - 1) < 0.01


@pytest.mark.slow
def test_added_inertia_does_not_lead_to_the_nonholonomic_skate() -> None:
    t = np.array([2.0])
    heavy, without_slip = Skate(S, mass=1.0), Skate(S, viscosity=1.0).limit(t)
    distances = [np.abs(heavy.motion(s, t) - without_slip).max() for s in S]
    assert min(distances) > 1


def test_orders_of_a_known_family() -> None:
    s = np.array([1.0, 2.0, 4.0])
    found = Convergence("s^−2", np.array([1.0]), s, 3 / s**2)
    np.testing.assert_allclose(found.orders, 2, rtol=1e-13)
    assert found.order == pytest.approx(2, rel=1e-13)
    assert found.table().splitlines()[-1] == "| 4 | 1.875e-01 | 2.000 |"


@pytest.mark.parametrize(
    ("coefficients", "times", "sentence"),
    [
        ((1.0,), [1.0], "coefficients .1.0.: there must be 2 or more positive numbers"),
        ((2.0, 1.0), [1.0], "coefficients"),
        ((-1.0, 1.0), [1.0], "coefficients"),
        ((1.0, 2.0), [], "times"),
        ((1.0, 2.0), [0.0], "times"),
    ],
)
def test_mistaken_tables(
    coefficients: tuple[float, ...], times: list[float], sentence: str
) -> None:
    with pytest.raises(InputError, match=sentence):
        convergence(Skate(coefficients, viscosity=1.0), times)


def test_a_skate_needs_a_resistance() -> None:
    with pytest.raises(InputError, match="neither may be negative, and one must be positive"):
        Skate(S)
