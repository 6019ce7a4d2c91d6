"""§8.2: the quadratures of the ball around a sphere, along a computed motion."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from borisov_mamaev_2008.methods.two_quadratures import f, h, level_factor, moving_root_counts, w
from nonholonomic.catalogue.ball_on_sphere import ball_around_sphere_coordinates as chart

INERTIA, LEVER = np.array([1.0, 1.5, 2.1]), 0.9
J = INERTIA + LEVER
TAU = (INERTIA.sum() + LEVER) / 2
A = TAU - INERTIA
E_3 = A.prod()
E_2 = E_3 * (1 / A).sum()


def spin(momentum, n):
    """ω from M = Jω − d n (n, ω)."""
    share = (n / J) @ momentum / (1 - LEVER * (n / J) @ n)
    return (momentum + LEVER * share * n) / J


def motion(_, state):
    momentum, n = state[:3], state[3:]
    omega = spin(momentum, n)
    return np.concatenate([np.cross(momentum, omega), -np.cross(n, omega)])


def places(n):
    """1/u of the roots of Σ A_i² I_i n_i²/(u − A_i) = 0."""
    total = sum(
        A[i] ** 2 * INERTIA[i] * n[i] ** 2 * np.poly([A[j] for j in range(3) if j != i])
        for i in range(3)
    )
    return np.sort(1 / np.roots(total))


def test_trajectories_solve_the_quadratures():
    n = np.array([2.0, -3.0, 6.0]) / 7
    first = np.array([0.7, -0.4, 0.9])
    momentum = first - (A * n) @ first / ((A * n) @ (A * n)) * (A * n)
    state = np.concatenate([momentum, n])
    values = {
        h: momentum @ spin(momentum, n),
        f: momentum @ momentum,
        chart.tau: TAU,
        chart.d: LEVER,
        **dict(zip(chart.A.symbols, A, strict=True)),
    }
    own = sp.lambdify(w, level_factor().subs(values))

    def curve(place):
        return np.prod([1 - a * place for a in A]) * (E_2 - E_3 * place) * own(place)

    step = 1e-4
    found = solve_ivp(motion, (0, 3), state, "DOP853", rtol=1e-12, atol=1e-13, dense_output=True)
    for t in (0.5, 1.3, 2.2):
        here = places(found.sol(t)[3:])
        rates = (places(found.sol(t + step)[3:]) - places(found.sol(t - step)[3:])) / (2 * step)
        first, second = (rates[i] ** 2 / curve(here[i]) for i in (0, 1))
        assert first == pytest.approx(second, rel=1e-5)


def test_two_roots_depend_on_the_level_and_one_of_chaplygins():
    assert moving_root_counts() == (2, 1)
    numbers = {chart.tau: TAU, chart.d: LEVER, **dict(zip(chart.A.symbols, A, strict=True))}
    roots = [
        np.sort_complex(
            np.roots(sp.Poly(level_factor().subs({**numbers, h: 1, f: value}), w).all_coeffs())
        )
        for value in (2.0, 2.1)
    ]
    assert abs(roots[0] - roots[1]).min() > 1e-3
