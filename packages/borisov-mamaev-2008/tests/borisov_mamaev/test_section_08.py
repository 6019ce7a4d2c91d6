"""The corrected formulas of §8 against the rolled ball, in numbers and by other ways."""

from __future__ import annotations

import numpy as np
import pytest

from evaluation import numeric
from nonholonomic.catalogue import from_catalogue
from nonholonomic.catalogue.ball_on_sphere import (
    ball_around_sphere_chaplygin as chart,
    ball_around_sphere_hamiltonian as e3,
)

INERTIA, MASS, RADIUS = np.array([1.0, 1.5, 2.1]), 1.0, 2.0
SHIFT = MASS * RADIUS**2
J = INERTIA + SHIFT
A = J.sum() / 2 - J
ROLLED = from_catalogue("ball-around-sphere", m=MASS, R=RADIUS, a=RADIUS / 2)


def tensor(n):
    """I_Q."""
    return np.diag(J) - SHIFT * np.outer(n, n)


def states(count, seed=5):
    """Random (M, n) with |n| = 1 and (AM, n) = 0, as columns."""
    rng = np.random.default_rng(seed)
    n = rng.normal(size=(3, count))
    n /= np.linalg.norm(n, axis=0)
    momentum = rng.normal(size=(3, count))
    lever = A[:, None] * n
    momentum -= lever * (momentum * lever).sum(axis=0) / (lever**2).sum(axis=0)
    return np.concatenate([momentum, n])


def rolled_rates(state):
    return numeric(ROLLED, ROLLED.rates)(state)


def multiplier(n):
    """𝒩 = (n, Bn)/(2 (An, Bn) √det I_Q)."""
    drawn = tensor(n) @ (A * n)
    return n @ drawn / (2 * (A * n) @ drawn * np.sqrt(np.linalg.det(tensor(n))))


def separated(n):
    """x₁, x₂ from the roots ζ of Σ A_i² I_i n_i²/(I_i − ζ) = 0."""
    polynomial = np.zeros(3)
    for i in range(3):
        others = np.delete(INERTIA, i)
        polynomial += A[i] ** 2 * INERTIA[i] * n[i] ** 2 * np.poly(others)
    zeta = np.sort(np.roots(polynomial).real)
    half = (INERTIA.sum() + SHIFT) / 2
    cubic = np.prod(INERTIA[:, None] - zeta, axis=0)
    square = (half - zeta) ** 2
    return zeta * (cubic + (zeta + SHIFT) * square) / (cubic + zeta * square)


def branches(x):
    """S(x) of (8.12), corrected, times −det J/8, for both signs of the root."""
    epsilon, gamma = J.sum(), J.prod()
    beta = 2 * (J**2).sum() - epsilon**2
    alpha = -np.prod(epsilon - 2 * J)
    middle = 4 * beta * gamma + SHIFT * beta**2 - 2 * SHIFT * alpha * (epsilon - 2 * SHIFT)
    delta = x**2 * (beta**2 + 8 * alpha * SHIFT) + 2 * x * middle + (4 * gamma + SHIFT * beta) ** 2
    cubic = 8 * x**3 + 8 * (SHIFT - epsilon) * x**2 - 4 * gamma - SHIFT * beta
    cubic += (2 * epsilon**2 - beta - 4 * SHIFT * epsilon) * x
    roots = np.sqrt(delta) * np.array([[1.0], [-1.0]])
    return -delta * (cubic + roots) / (4 * (2 * x - epsilon + 2 * SHIFT) ** 2)


@pytest.mark.parametrize("state", states(12).T)
def test_the_separated_equations_hold_on_the_rolled_ball(state):
    """(x₁ − x₂)² (dx/dτ)² = 4 S(x) (xH − F), with the rate of x by a central difference."""
    momentum, n = state[:3], state[3:]
    rate, step = rolled_rates(state)[3:6], 1e-5
    x = separated(n)
    speed = (separated(n + step * rate) - separated(n - step * rate)) / (2 * step)
    left = (x[0] - x[1]) ** 2 * (speed / multiplier(n)) ** 2
    omega = np.linalg.solve(tensor(n), momentum)
    right = 4 * branches(x) * (x * (momentum @ omega) / 2 - momentum @ momentum / 2)
    assert np.abs(left).max() > 1e-3
    nearest = right[np.abs(right - left).argmin(axis=0), [0, 1]]
    np.testing.assert_allclose(nearest, left, rtol=1e-6, atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("state", states(4, seed=6).T)
def test_the_flow_on_e3_is_that_of_the_rolled_ball(state):
    """m = −𝒩 (M − Bn (n, M)/(n, Bn)), differentiated along the ball by a central difference."""

    def mapped(point):
        momentum, n = point[:3], point[3:]
        drawn = tensor(n) @ (A * n)
        turning = momentum - drawn * (n @ momentum) / (n @ drawn)
        return np.concatenate([-multiplier(n) * turning, n])

    target = e3.build({"J_1": J[0], "J_2": J[1], "J_3": J[2], "d": SHIFT})
    rate, step = rolled_rates(state)[:6], 1e-5
    pushed = (mapped(state + step * rate) - mapped(state - step * rate)) / (2 * step)
    there = mapped(state)
    found = numeric(target, target.rates)(there) * multiplier(state[3:])
    np.testing.assert_allclose(found, pushed, rtol=1e-6, atol=1e-8)
    omega = np.linalg.solve(tensor(state[3:]), state[:3])
    energy, second = (law.value for law in target.integrals if law.name in ("energy", "second"))
    found = numeric(target, [energy, second])(there)
    np.testing.assert_allclose(found, [state[:3] @ omega / 2, state[:3] @ state[:3]], rtol=1e-10)


@pytest.mark.parametrize("seed", range(4))
def test_the_momenta_are_derivatives_of_the_energy_by_the_rates(seed):
    """(8.6): P_u, P_v from T(u, v, u̇, v̇), built out of (8.5) and (8.4)."""
    rng = np.random.default_rng(seed)
    place = np.array([rng.uniform(J[0], J[1]), rng.uniform(J[1], J[2])])

    def normal(point):
        weights = [np.prod(J[i] - np.delete(J, i)) for i in range(3)]
        return np.sqrt((J - point[0]) * (J - point[1]) / weights)

    def energy(rates):
        step = 1e-6
        swing = (normal(place + step * rates) - normal(place - step * rates)) / (2 * step)
        n = normal(place)
        drawn = tensor(n) @ (A * n)
        omega = np.cross(drawn, swing) / (n @ drawn)
        return omega @ tensor(n) @ omega / 2

    made = chart.reduced_system()
    values = dict(zip((*chart.J.symbols, chart.d), (*J, SHIFT), strict=True))
    rates = rng.normal(size=2)
    # T is quadratic, so that differences of any step are its derivatives
    momenta = [(energy(rates + e) - energy(rates - e)) / 2 for e in np.eye(2)]
    state = np.array([*place, *momenta])
    found = numeric(made, [*made.rates[:2], chart.energy()], values)(state)
    np.testing.assert_allclose(found, [*rates, energy(rates)], rtol=1e-6)
