"""§10 by Newton and Euler with numbers: the integrals, the direction of a, the missing measure."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from chaplygin.paper.measure_at_rest import curl_of_divergence, divergence_of_spin
from chaplygin.paper.section_10_2 import only_regular_motions
from chaplygin.systems import CATALOGUE, from_catalogue

MASS, RADIUS = 1.3, 0.75
INERTIA = np.array([1.0, 1.5, 2.1])
#: From the centre of mass to the geometric centre.
CENTRE = np.array([0.1, -0.2, 0.3])
PLACE = (Fraction(2, 7), Fraction(-3, 7), Fraction(6, 7))


def hat(vector):
    x, y, z = vector
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def rate(k, rubber):
    """ω̇, γ̇ from the balance of momentum and angular momentum with the reactions N and λγ.

    Unknowns: ω̇, N, λ.  The centre of mass moves by v = r×ω, and r = centre − Rγ.
    """

    def right(_, state):
        omega, gamma = state[:3], state[3:]
        turned = k * np.cross(gamma, omega)
        r, r_rate = CENTRE - RADIUS * gamma, -RADIUS * turned
        velocity = np.cross(r, omega)
        matrix, known = np.zeros((7, 7)), np.zeros(7)
        # m (ṙ×ω + r×ω̇ + ω×v) = N
        matrix[:3, :3], matrix[:3, 3:6] = MASS * hat(r), -np.eye(3)
        known[:3] = -MASS * (np.cross(r_rate, omega) + np.cross(omega, velocity))
        # I ω̇ + ω×Iω = r×N + λγ
        matrix[3:6, :3], matrix[3:6, 3:6] = np.diag(INERTIA), -hat(r)
        matrix[3:6, 6] = -gamma
        known[3:6] = np.cross(INERTIA * omega, omega)
        # (ω, γ) stays, or there is no λ
        if rubber:
            matrix[6, :3], known[6] = gamma, -omega @ turned
        else:
            matrix[6, 6] = 1
        return np.concatenate([np.linalg.solve(matrix, known)[:3], turned])

    return right


def follow(k, rubber):
    gamma = np.array([2.0, -3.0, 6.0]) / 7
    omega = np.array([0.9, -0.5, 1.1])
    if rubber:
        omega -= (omega @ gamma) * gamma
    start = np.concatenate([omega, gamma])
    found = solve_ivp(rate(k, rubber), (0, 20), start, "DOP853", rtol=1e-12, atol=1e-13)
    return found.y[:3].T, found.y[3:].T


def momentum(omega, gamma):
    r = CENTRE - RADIUS * gamma
    return INERTIA * omega + MASS * np.cross(r, np.cross(omega, r)), r


def spread(values):
    return np.ptp(values) / np.abs(values).max()


def dot(a, b):
    return np.sum(a * b, axis=1)


@pytest.mark.parametrize("k", [1.0, 0.7, 1.4, -1.0])
def test_the_marble_integral_on_planes_and_spheres(k):
    omega, gamma = follow(k, rubber=False)
    M, r = momentum(omega, gamma)
    assert spread(dot(M, omega)) < 1e-9
    assert spread(dot(M, M) - MASS * dot(r, r) * dot(M, omega)) < 1e-9
    assert spread(dot(M, M)) > 1e-2


def test_the_rubber_integral_needs_a_towards_the_centre_of_mass():
    omega, gamma = follow(1.0, rubber=True)
    M, _ = momentum(omega, gamma)
    across, energy = np.cross(M, gamma), dot(M, omega)

    def quadratic(a):
        return dot(across, across) - 2 * RADIUS * MASS * (gamma @ a) * energy

    assert spread(energy) < 1e-9
    assert spread(quadratic(-CENTRE)) < 1e-9
    assert spread(quadratic(CENTRE)) > 1e-2


def test_the_rubber_integral_does_not_hold_on_a_sphere():
    omega, gamma = follow(0.7, rubber=True)
    M, r = momentum(omega, gamma)
    across = np.cross(M, gamma)
    assert spread(dot(across, across) - MASS * dot(r, r) * dot(M, omega)) > 1e-3


def test_obstructions_vanish_for_balanced_balls():
    """There the measures (7.3) and (9.3) are smooth at rest."""
    marble = CATALOGUE["chaplygin-ball"].rolling().system()
    rubber = CATALOGUE["rubber-chaplygin-ball"].rolling().system()
    assert divergence_of_spin(marble, PLACE) == 0
    assert curl_of_divergence(rubber, PLACE) == 0


def test_obstructions_of_unbalanced_balls():
    assert divergence_of_spin(from_catalogue("unbalanced-ball"), PLACE) != 0
    assert curl_of_divergence(from_catalogue("unbalanced-rubber-ball"), PLACE) != 0


def test_no_measure_obstruction_on_an_axis_of_symmetry():
    """A ball of revolution has a smooth measure: the obstruction is zero."""
    made = from_catalogue("unbalanced-rubber-ball", I_2=1.0, I_3=1.6, c_1=0.0, c_2=0.0, c_3=0.2)
    assert curl_of_divergence(made, PLACE) == 0


def test_a_flow_on_a_torus_with_a_limit_cycle():
    verdict = only_regular_motions()
    assert verdict.decision == "refuted"
    assert verdict.witness["divergence on the cycle"] == "-1"
