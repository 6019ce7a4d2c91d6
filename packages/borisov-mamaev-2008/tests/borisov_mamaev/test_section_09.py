"""§9 by other routes than the proofs: numbers along motions, by hand, and what must fail."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from borisov_mamaev_2008.methods.independence import independent, rational_point
from borisov_mamaev_2008.methods.quadratic_integrals import C_11, C_22, J, conditions, s
from borisov_mamaev_2008.section_09 import section_09_3, section_09_4
from flowlanes.system.vectors import dot, norm_squared
from nonholonomic.catalogue.ball_on_sphere import (
    rubber_ball_ratio as ratio,
    rubber_ball_sphero_conical as conical,
)

TENSOR = np.array([0.5, 0.9, 1.35])


def rates(tensor, k):
    """(9.2) by solving for ω̇ and λ together, (ω, n) = 0 being differentiated."""

    def rate(_, state):
        omega, n = state[:3], state[3:]
        turned = k * np.cross(n, omega)
        matrix = np.zeros((4, 4))
        matrix[:3, :3], matrix[:3, 3], matrix[3, :3] = np.diag(tensor), -n, n
        right = np.append(np.cross(tensor * omega, omega), -omega @ turned)
        return np.concatenate([np.linalg.solve(matrix, right)[:3], turned])

    return rate


def follow(k, until=6.0):
    n = np.array([2.0, -3.0, 6.0]) / 7
    omega = np.array([0.9, -0.5, -0.55])
    times = np.linspace(0.0, until, 601)
    start = np.concatenate([omega, n])
    found = solve_ivp(rates(TENSOR, k), (0, until), start, "DOP853", times, rtol=1e-12, atol=1e-13)
    return times, found.y[:3], found.y[3:]


def quadratic_roots(total, product):
    apart = np.sqrt(total**2 - 4 * product)
    return (total - apart) / 2, (total + apart) / 2


def sphero_conical(n):
    """The roots of (9.5), from sum and product."""
    total = TENSOR.sum() - TENSOR @ n**2
    return quadratic_roots(total, TENSOR.prod() * ((1 / TENSOR) @ n**2))


def cubic(z):
    return np.prod([j - z for j in TENSOR], axis=0)


def slope(values, times):
    """Derivative by a five-point formula, where it is known: without two points at each end."""
    step = times[1] - times[0]
    return (values[:-4] - 8 * values[1:-3] + 8 * values[3:-1] - values[4:]) / (12 * step)


@pytest.mark.parametrize("k", [1.0, -1.0, 0.5, 0.7])
def test_kinetic_energy_in_sphero_conical_coordinates(k):
    """(9.7) with its sign corrected, along a motion; as printed it has the wrong sign."""
    times, omega, n = follow(k)
    xi, eta = sphero_conical(n)
    assert np.all((TENSOR[0] < xi) & (xi < TENSOR[1]) & (TENSOR[1] < eta) & (eta < TENSOR[2]))
    xidot, etadot = slope(xi, times), slope(eta, times)
    xi, eta = xi[2:-2], eta[2:-2]
    share = eta * xidot**2 / cubic(xi) - xi * etadot**2 / cubic(eta)
    found = (xi - eta) / (8 * k**2) * share
    energy = (TENSOR @ omega**2)[2:-2] / 2
    away = np.abs(cubic(xi) * cubic(eta)) > 1e-4
    assert away.sum() > 200
    np.testing.assert_allclose(found[away], energy[away], rtol=2e-4)
    printed = sp.lambdify(
        (conical.xi, conical.eta, conical.xidot, conical.etadot, k_, *J_), PRINTED
    )
    assert printed(0.7, 1.1, 0.3, 0.2, k, *TENSOR) < 0


k_, J_ = ratio.k, ratio.J.symbols
PRINTED = conical.kinetic(-1)


def test_separated_equation_along_a_motion():
    """y² = A(u)(2hu(tr J − u) − F) for the hollow ball, u from its own definition."""
    times, omega, n = follow(-1.0)
    rho2 = (1 / TENSOR) @ n**2
    weights = n**2 / TENSOR[:, None] / rho2
    total = TENSOR.sum() - TENSOR @ weights
    u, v = quadratic_roots(total, TENSOR.prod() * ((1 / TENSOR) @ weights))
    np.testing.assert_allclose(1 / rho2, TENSOR.sum() - u - v, rtol=1e-10)
    h = TENSOR @ omega**2 / 2
    spread = TENSOR.prod() * 2 * h * np.sum((n / TENSOR[:, None]) ** 2, axis=0)
    F = (np.sum((TENSOR[:, None] * omega) ** 2, axis=0) + spread) / rho2
    assert np.ptp(F) < 1e-9 * F[0]
    for z in (u, v):
        y = (np.sqrt(TENSOR.prod() * rho2) * (u - v) / 2)[2:-2] * slope(z, times)
        inner = z[2:-2]
        right = cubic(inner) * (2 * h[0] * inner * (TENSOR.sum() - inner) - F[0])
        np.testing.assert_allclose(y**2, right, atol=1e-6)


@pytest.mark.parametrize("power", [1, -1])
def test_braden_and_neumann_satisfy_the_conditions(power):
    """C = J⁻¹ for s = 1 and C = J for s = −1, each less its last entry times E."""
    entries = [j ** (-power) for j in J.symbols]
    known = {C_11: entries[0] - entries[2], C_22: entries[1] - entries[2], s: power}
    diagonal = [c.subs(known) for c in conditions() if c.free_symbols & {C_11, C_22}]
    assert len(diagonal) > 3
    assert all(sp.simplify(c) == 0 for c in diagonal)


def test_sphero_conical_coordinates_meet_their_bounds_on_a_great_circle():
    """The inequalities after (9.5) are strict for n₁n₂n₃ ≠ 0 alone: here ξ = J₁."""
    z = sp.Symbol("z")
    moments, normal = (1, 2, 3), (sp.Integer(0), sp.Rational(3, 5), sp.Rational(4, 5))
    quadric = sum(
        sp.prod(moment - z for moment in moments if moment != own) * x**2
        for own, x in zip(moments, normal, strict=True)
    )
    assert min(sp.roots(sp.Poly(quadric, z))) == moments[0]
    (claim,) = (c for c in section_09_3.CLAIMS if c.printed is section_09_3.interlaced)
    assert "n₁n₂n₃ ≠ 0" in claim.where


def test_dependent_functions_are_not_called_independent():
    made = ratio.rolling()
    state = {"n_1": "2/7", "n_2": "-3/7", "n_3": "6/7"}
    point = rational_point(made, state | {"omega_1": 9, "omega_2": -5, "omega_3": "-11/2"})
    energy = dot(ratio.J * ratio.omega, ratio.omega)
    verdict = independent(made, (norm_squared(ratio.n), energy, energy**2), point)
    assert verdict.decision == "undecided"
    assert "rank 2" in verdict.reason


@pytest.mark.parametrize("module", [section_09_3, section_09_4])
def test_every_correction_says_what_was_wrong(module):
    for claim in module.CLAIMS:
        if claim.corrected is not None:
            assert claim.correction and claim.note
