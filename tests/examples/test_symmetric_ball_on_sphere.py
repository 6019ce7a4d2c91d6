"""The rubber ball on a sphere with an inertia of the symmetry SO(r)×SO(n − r)."""

import sys
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import chaplygin as ch


@pytest.fixture(scope="module")
def integrals():
    examples = str(Path(__file__).parents[2] / "examples")
    sys.path.insert(0, examples)
    try:
        import symmetric_ball_on_sphere

        yield symmetric_ball_on_sphere.integrals
    finally:
        sys.path.remove(examples)


@pytest.mark.slow
@pytest.mark.parametrize(("n", "r"), [(4, 2), (4, 3)])
def test_the_linear_integrals_are_proven(integrals, n, r):
    assert ch.prove(*integrals(n, r)).decision == "proven"


@pytest.mark.slow
def test_another_power_is_refuted(integrals):
    assert ch.prove(*integrals(4, 2, slip=sp.Rational(1, 5))).decision == "refuted"


def test_the_integrals_are_constant_and_the_energy_gives_the_rate_of_s():
    A, C, B, a = 0.7, 1.3, 2.1, -0.4
    moments = [A, C, C, C, C, B]
    system = ch.from_catalogue("rubber-ball-on-sphere-nd", moments=moments, a=a)
    gamma = np.array([0.3, -0.5, 0.4, 0.7])
    gamma /= np.linalg.norm(gamma)
    u = np.array([0.4, 0.9, -0.3, 0.6])
    u -= u @ gamma * gamma
    omega = np.outer(u, gamma) - np.outer(gamma, u)
    motion = ch.integrate(
        system,
        {"gamma": gamma.tolist(), "omega": omega[np.triu_indices(4, 1)].tolist()},
        np.linspace(0, 20, 41),
    )
    epsilon = a / (1 + a)
    A, B, C = A + 1, B + 1, C + 1
    p, gamma = motion["p"], motion["gamma"]
    s = (gamma[:, :2] ** 2).sum(axis=1)
    wedges = [p[:, i] * gamma[:, i + 1] - p[:, i + 1] * gamma[:, i] for i in (0, 2)]
    forms = [A * s + C * (1 - s), B * (1 - s) + C * s]
    for wedge, form in zip(wedges, forms, strict=True):
        constant = wedge * form ** (1 / (2 * epsilon) - 1)
        assert np.ptp(constant) < 1e-12
    assert np.ptp(s) > 0.05
    # sigma = (u', gamma') = (p', gamma')/C, as p' = phi' u' - (A - C) sigma gamma'
    squares = [(wedge / form) ** 2 for wedge, form in zip(wedges, forms, strict=True)]
    sigma = (p[:, :2] * gamma[:, :2]).sum(axis=1) / C
    energy = A * squares[0] + B * squares[1]
    energy += C * ((1 - s) * squares[0] / s + s * squares[1] / (1 - s) + sigma**2 / (s * (1 - s)))
    assert np.ptp(energy) < 1e-12
