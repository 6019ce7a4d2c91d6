"""§6 derived a second time: Lagrange's equations with a multiplier, and motions compared."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from borisov_mamaev_2008.methods.veselova_in_angles import T_0, psi, psidot
from borisov_mamaev_2008.section_06.section_06_2 import s_printed, s_right
from flowlanes import lambdify
from nonholonomic.catalogue import CATALOGUE, from_catalogue
from nonholonomic.catalogue.angles import in_angles, phi, phidot, theta, thetadot

MOMENTS = {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1}
STATE = (0.8, 0.5, 0.7, -0.4)
ANGLES, RATES = (theta, phi, psi), (thetadot, phidot, psidot)


def numbers():
    at = {sp.Symbol(name, real=True): value for name, value in MOMENTS.items()}
    at |= dict(zip((theta, phi, thetadot, phidot), STATE, strict=True))
    return at | {psi: 0.3, psidot: -np.cos(STATE[0]) * STATE[3]}


def accelerations():
    """θ̈, φ̈, ψ̈ and λ of d/dt ∂T₀/∂q̇ − ∂T₀/∂q = λ ∂f/∂q̇ with f = ψ̇ + cos θ φ̇."""
    at = numbers()
    f = psidot + sp.cos(theta) * phidot
    turn = [sp.diff(f, rate) for rate in RATES]
    matrix, right = sp.zeros(4, 4), sp.zeros(4, 1)
    for i, (q, rate) in enumerate(zip(ANGLES, RATES, strict=True)):
        momentum = sp.diff(T_0, rate)
        drift = sum(sp.diff(momentum, x) * v for x, v in zip(ANGLES, RATES, strict=True))
        for j, other in enumerate(RATES):
            matrix[i, j] = sp.diff(momentum, other)
        matrix[i, 3] = -turn[i]
        right[i] = sp.diff(T_0, q) - drift
    for j in range(3):
        matrix[3, j] = turn[j]
    right[3] = -sum(sp.diff(f, x) * v for x, v in zip(ANGLES, RATES, strict=True))
    solved = matrix.subs(at).evalf().LUsolve(right.subs(at).evalf())
    return [float(value) for value in solved]


def test_the_multiplier_gives_the_same_accelerations():
    system = in_angles(from_catalogue("veselova", **MOMENTS))
    rates = lambdify(system)(0.0, np.array(STATE))
    assert rates[2:] == pytest.approx(accelerations()[:2], rel=1e-12)


def test_the_right_hand_side_is_minus_the_multiplier_force():
    """S of (6.7) is −sin θ ∂T₀/∂ψ̇; the printed one is far from it."""
    at = numbers()
    vertical = float(sp.diff(T_0, psidot).subs(at))
    value = -np.sin(STATE[0]) * vertical
    assert float(s_right().subs(at)) == pytest.approx(value, rel=1e-12)
    assert abs(float(s_printed().subs(at)) - value) > 0.1 * abs(value)
    assert abs(vertical - value) > 0.1 * abs(value)


def test_the_veselova_system_moves_as_the_neumann_system():
    """Theorem 8, with the new time computed along."""
    system = from_catalogue("veselova", **MOMENTS)
    inertia = np.array(list(MOMENTS.values()))
    gamma = np.array([2.0, -3.0, 6.0]) / 7
    omega = np.array([0.9, -0.5, -0.55])
    omega -= (omega @ gamma) * gamma
    field = lambdify(system)

    def density(normal):
        return np.sqrt(normal**2 @ (1 / inertia))

    def with_time(t, x):
        return np.append(field(t, x[:6]), 1 / density(x[3:6]))

    motion = solve_ivp(
        with_time, (0.0, 12.0), np.concatenate([omega, gamma, [0.0]]), rtol=1e-12, atol=1e-13
    )
    strength = float(omega**2 @ inertia / np.prod(inertia))
    target = CATALOGUE["neumann"].system({**MOMENTS, "c": strength})
    first = np.concatenate([density(gamma) * omega, gamma])
    own = solve_ivp(
        lambdify(target),
        (0.0, motion.y[6, -1]),
        first,
        t_eval=motion.y[6],
        rtol=1e-12,
        atol=1e-13,
    )
    there = motion.y[:6].copy()
    there[:3] *= np.array([density(normal) for normal in motion.y[3:6].T])
    assert own.y == pytest.approx(there, abs=1e-8)
    assert np.ptp(own.y[3:], axis=1).min() > 0.5
