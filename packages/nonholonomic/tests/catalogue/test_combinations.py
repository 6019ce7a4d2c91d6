"""Rotors, Bruns' field, two balls and two constraints, against independent derivations."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from flowlanes.formulas.array_formulas import Formulas
from flowlanes.system.system import System
from nonholonomic import from_catalogue

ROTORS = {"k_1": 0.6, "k_2": 0.4, "k_3": -0.8}
NUMBERS = {"I_1": 1.0, "I_2": 1.6, "I_3": 2.3, "K": 3.0, **ROTORS}
INERTIA = np.diag([1.0, 1.6, 2.3])
SPINNING = np.array([0.6, 0.4, -0.8])


def rates(system: System, state: np.ndarray) -> np.ndarray:
    """The field at a state."""
    numbers = {str(s): float(v) for s, v in system.defaults.items()}
    values: Any = Formulas(system, list(system.rates))(state[None], numbers)
    return np.asarray(values)[0]


def frame(seed: int) -> np.ndarray:
    """A rotation; its rows are three orthonormal directions in body axes."""
    q, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return np.asarray(q * np.linalg.det(q))


def torque(axis: np.ndarray) -> np.ndarray:
    """That of the potential ½·3(a, Ia)."""
    return np.asarray(3.0 * np.cross(axis, INERTIA @ axis))


@pytest.mark.parametrize("seed", range(4))
def test_two_equal_balls_at_right_angles_are_a_ball_bearing(seed: int) -> None:
    rng = np.random.default_rng(seed)
    alpha, beta, gamma = frame(seed)
    momentum = rng.normal(size=3)
    bearing = from_catalogue("ball-bearing-gyrostat-bruns", D_1=0.8, D_2=0.8, D_3=0.0, **NUMBERS)
    balls = from_catalogue("ball-on-two-balls", D=0.8, **NUMBERS)
    whole = rates(bearing, np.concatenate([momentum, alpha, beta, gamma]))
    part = rates(balls, np.concatenate([momentum, gamma]))
    np.testing.assert_allclose(part, whole[[0, 1, 2, 9, 10, 11]], atol=1e-13)


@pytest.mark.parametrize("seed", range(4))
def test_two_constraints_by_their_reactions(seed: int) -> None:
    """Iω̇ = (Iω + k)×ω + torque + λ₁n₁ + λ₂n₂ with (ω̇, n₁) = (ω̇, n₂) = 0."""
    rng = np.random.default_rng(seed)
    first, second, gamma = frame(seed)
    a, b, w = rng.normal(size=3)
    d = float(np.hypot(a, b))
    alpha = (a * first + b * second) / d
    omega = d * alpha + w * gamma
    load = np.cross(INERTIA @ omega + SPINNING, omega) + torque(alpha)
    normals = np.array([first, second])
    whole = np.block([[INERTIA, -normals.T], [normals, np.zeros((2, 2))]])
    turning = np.linalg.solve(whole, np.concatenate([load, [0.0, 0.0]]))[:3]
    system = from_catalogue("two-veselova-constraints", d=d, **NUMBERS)
    found = rates(system, np.concatenate([[w], alpha, gamma]))
    np.testing.assert_allclose(found[0], turning @ gamma, atol=1e-12)
    np.testing.assert_allclose(found[1:4], np.cross(alpha, omega), atol=1e-12)
    np.testing.assert_allclose(found[4:], np.cross(gamma, omega), atol=1e-12)


@pytest.mark.parametrize("name", ["veselova-gyrostat-bruns", "veselova-spinning-gyrostat-bruns"])
@pytest.mark.parametrize("seed", range(3))
def test_veselova_by_its_reaction(name: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    gamma, omega = frame(seed)[2], rng.normal(size=3)
    if "spinning" not in name:
        omega = omega - (omega @ gamma) * gamma
    load = np.cross(INERTIA @ omega + SPINNING, omega) + torque(gamma)
    whole = np.block([[INERTIA, -gamma[:, None]], [gamma[None], np.zeros((1, 1))]])
    turning = np.linalg.solve(whole, np.append(load, 0.0))[:3]
    found = rates(from_catalogue(name, **NUMBERS), np.concatenate([omega, gamma]))
    np.testing.assert_allclose(found, [*turning, *np.cross(gamma, omega)], atol=1e-12)
