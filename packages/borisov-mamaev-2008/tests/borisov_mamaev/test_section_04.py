"""§4 beyond its claims: what they rest on, derived a second time or followed numerically."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from borisov_mamaev_2008.methods.tori import (
    F_1,
    F_2,
    canonical_in,
    not_hamiltonian,
    theta_1,
    theta_2,
)
from borisov_mamaev_2008.section_04 import section_04_3
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import System
from lawproof.proof.prover import prove
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.mechanisms import chaplygin_sleigh as sleigh


def follow(system, state, times):
    return integrate(system, np.asarray(state, dtype=float), times)


# --- tori ----------------------------------------------------------------------------------


def test_straightened_angle_grows_evenly():
    """ζ = 0.3 + 0.5 cos θ₁ − 0.2 sin 2θ₁, ω₁ = 0.7: the series of Theorem 4 by hand."""
    omega = 0.7
    zeta = 0.3 + 0.5 * sp.cos(theta_1) - 0.2 * sp.sin(2 * theta_1)
    system = System(name="one", title="one", field={theta_1: sp.Float(omega), theta_2: zeta})
    times = np.linspace(0.0, 30.0, 61)
    motion = follow(system, [0.4, 0.1], times)
    angle = motion["theta_1"]
    straight = motion["theta_2"] - (0.5 * np.sin(angle) + 0.2 * np.cos(2 * angle) / 2) / omega
    np.testing.assert_allclose(straight - straight[0], 0.3 * times, atol=1e-11)


def test_bracket_of_angles_and_frequencies():
    """{θ_i, ω_j} = δ_ij for ω = (F₁ + F₂², F₁F₂)."""
    frequencies = (F_1 + F_2**2, F_1 * F_2)
    matrix = canonical_in(frequencies, (sp.S.One, sp.S.One))
    slopes = sp.Matrix(2, 2, lambda j, k: sp.diff(frequencies[j], (F_1, F_2)[k]))
    assert sp.simplify(matrix[0:2, 2:4] * slopes.T - sp.eye(2)) == sp.zeros(2)
    assert matrix + matrix.T == sp.zeros(4)


def test_no_poisson_structure_for_a_varying_rotation_number():
    """The mean of the Jacobi identity over the torus, with a trigonometric polynomial a(θ)."""
    assert not_hamiltonian().decision == "proven"
    grid = np.linspace(0.0, 2 * np.pi, 16, endpoint=False)
    first, second = np.meshgrid(grid, grid)
    F = 0.37
    # ∂a/∂θ₁ + F ∂a/∂θ₂ for a = sin(θ₁ − 2θ₂) + cos 3θ₁
    along = np.cos(first - 2 * second) * (1 - 2 * F) - 3 * np.sin(3 * first)
    assert abs(along.mean()) < 1e-14


def test_a_factor_of_angles_alone_may_leave_the_periods_equal():
    """Φ = 2 + cos θ₁ on λ₁ = λ₂: the period is 4π from everywhere."""
    spread = 2 + sp.cos(theta_1)
    system = System(name="even", title="even", field={theta_1: 1 / spread, theta_2: 1 / spread})
    for start in ([0.0, 0.0], [1.0, 0.3], [2.0, 5.0]):
        motion = follow(system, start, np.array([0.0, 4 * np.pi]))
        assert motion["theta_1"][-1] - start[0] == pytest.approx(2 * np.pi, abs=1e-11)


# --- the Lagrange top ----------------------------------------------------------------------


def test_both_forms_of_the_lagrange_top_run_together():
    angles, body = (CATALOGUE[n].system() for n in ("lagrange-top-angles", "lagrange-top"))
    times = np.linspace(0.0, 10.0, 21)
    theta, phi, psi, p_theta, p_phi, p_psi = 0.6, 0.3, 0.0, 0.2, 2.5, 2.3
    across = (p_psi - p_phi * np.cos(theta)) / np.sin(theta)
    M = [
        p_theta * np.cos(phi) + across * np.sin(phi),
        across * np.cos(phi) - p_theta * np.sin(phi),
        p_phi,
    ]
    Gamma = [np.sin(theta) * np.sin(phi), np.sin(theta) * np.cos(phi), np.cos(theta)]
    first = follow(angles, [theta, phi, psi, p_theta, p_phi, p_psi], times)
    second = follow(body, [*M, *Gamma], times)
    np.testing.assert_allclose(np.cos(first["theta"]), second["Gamma"][:, 2], atol=1e-12)
    turned = np.unwrap(np.arctan2(second["Gamma"][:, 0], second["Gamma"][:, 1]))
    np.testing.assert_allclose(turned - turned[0], first["phi"] - first["phi"][0], atol=1e-11)


def test_steady_precession_of_the_top():
    """I₁ψ̇² cos θ − p_φψ̇ + P = 0 when θ stays constant."""
    I_1, I_3, P, theta, rate = 1.0, 0.6, 1.5, 0.8, 0.9
    p_phi = I_1 * rate * np.cos(theta) + P / rate
    p_psi = I_1 * rate * np.sin(theta) ** 2 + p_phi * np.cos(theta)
    system = CATALOGUE["lagrange-top-angles"].system({"I_1": I_1, "I_3": I_3, "P": P})
    times = np.linspace(0.0, 3.0, 7)
    motion = follow(system, [theta, 0.0, 0.0, 0.0, p_phi, p_psi], times)
    np.testing.assert_allclose(motion["theta"], theta, atol=1e-11)
    np.testing.assert_allclose(motion["psi"], rate * times, atol=1e-11)
    own = p_phi / I_3 - rate * np.cos(theta)
    np.testing.assert_allclose(motion["phi"], own * times, atol=1e-11)


# --- the Chaplygin sleigh ------------------------------------------------------------------


def test_sleigh_from_newtons_laws():
    """The reaction is across the blade: m r̈_C = λn, Iφ̈ = its moment about the centre of mass."""
    c, s = sp.cos(sleigh.phi), sp.sin(sleigh.phi)
    X, Y = sp.symbols("X Y", real=True)
    quantities = {
        X: sleigh.x + sleigh.a * c - sleigh.b * s,
        Y: sleigh.y + sleigh.a * s + sleigh.b * c,
    }
    along = Rate(Rate(X)) * c + Rate(Rate(Y)) * s
    across = sleigh.m * (Rate(Rate(Y)) * c - Rate(Rate(X)) * s)
    moment = sleigh.I * Rate(sleigh.Omega) + sleigh.a * across
    system = CATALOGUE["chaplygin-sleigh"].system()
    assert prove(system, Identity("newton", (along, moment), quantities=quantities))
    wrong = (along, moment - along - across)
    assert not prove(system, Identity("newton", wrong, quantities=quantities))


def test_sleigh_ends_up_going_straight_on():
    system = CATALOGUE["chaplygin-sleigh"].system()
    motion = follow(system, [0.0, 0.0, 0.4, -1.0, 0.3], np.linspace(0.0, 60.0, 13))
    assert abs(motion["Omega"][-1]) < 1e-6
    assert motion["v"][-1] > 0


def test_balanced_sleigh_in_the_new_time_has_no_gyroscopic_force():
    """With a = 0, dτ = cos φ dt: d/dτ ∂L̄/∂q′ = ∂L̄/∂q, and Ω stays constant."""
    system = CATALOGUE["chaplygin-sleigh"].system({"a": 0.0})
    motion = follow(system, [0.0, 0.0, 0.1, 0.8, 0.3], np.linspace(0.0, 3.0, 7))
    assert np.ptp(motion["Omega"]) < 1e-14
    assert np.ptp(motion["v"]) < 1e-14


@pytest.mark.parametrize(
    ("parameters", "message"),
    [({"I": 0.0}, "centre of mass I = 0.0"), ({"m": -1.0}, "mass m = -1.0")],
)
def test_impossible_sleighs_are_refused(parameters, message):
    with pytest.raises(InputError, match=message):
        CATALOGUE["chaplygin-sleigh"].system(parameters)


# --- Chaplygin systems ---------------------------------------------------------------------


def test_old_time_by_new_time():
    """d/dt is N d/dτ: a wrong factor in (4.5) is noticed."""
    system, identity = section_04_3.new_time()
    assert prove(system, identity)
    doubled = tuple(value + section_04_3.N * section_04_3.u[0] for value in identity.value)
    assert not prove(system, type(identity)("wrong", doubled))
