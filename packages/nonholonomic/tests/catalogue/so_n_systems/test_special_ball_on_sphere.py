"""The rubber ball on a sphere with products as moments: equations, integrals and multiplier."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
import sympy as sp

from flowlanes.formulas.array_evaluation import values
from flowlanes.system.laws import ConformallyHamiltonian, Measure
from lawproof.proof.prover import prove, prove_all
from nonholonomic.catalogue import from_catalogue

NAME = "special-rubber-ball-on-sphere-nd"
FACTORS = (1.1, 1.4, 1.9, 2.3)
STEP = 1e-6


def point(n, seed):
    """p and γ on the phase space."""
    rng = np.random.default_rng(seed)
    p, gamma = rng.normal(size=(2, n))
    gamma /= np.linalg.norm(gamma)
    return np.concatenate([p - (p @ gamma) * gamma, gamma])


@pytest.mark.parametrize("a", [2.0, -3.0, -0.5])
def test_the_equations_are_those_of_the_ball_with_these_moments(a):
    moments = [x * y - 1.0 for x, y in combinations(FACTORS, 2)]
    one = from_catalogue(NAME, factors=FACTORS, a=a)
    other = from_catalogue("rubber-ball-on-sphere-nd", moments=moments, a=a)
    states = np.array([point(4, seed) for seed in range(3)])
    rates = values(other, list(other.rates), states)
    assert values(one, list(one.rates), states) == pytest.approx(rates, abs=1e-13)


@pytest.mark.parametrize(
    "n", [pytest.param(3, marks=pytest.mark.slow), pytest.param(4, marks=pytest.mark.slow)]
)
def test_every_law_is_proven(n):
    ball = from_catalogue(NAME, dimension=n)
    assert len(ball.laws) == n + 4
    assert {verdict.decision for verdict in prove_all(ball)} == {"proven"}


def test_slips_are_refuted():
    ball = from_catalogue(NAME, dimension=3)
    laws = {law.name: law for law in ball.laws}
    anywhere = replace(laws["quadratic1"], level=())
    assert prove(ball, anywhere).decision == "refuted"
    measure = laws["measure"]
    (base, exponent) = measure.density[0]
    assert prove(ball, Measure("measure", ((base, exponent + 1),))).decision == "refuted"
    form = laws["hamiltonian"]
    W = sp.Symbol("W", real=True)
    other = ConformallyHamiltonian("form", form.multiplier * W, form.structure, form.hamiltonian)
    assert prove(ball, other).decision == "refuted"


@pytest.mark.parametrize("n", [3, 4, 5])
def test_n_minus_one_integrals_are_independent(n):
    ball = from_catalogue(NAME, dimension=n)
    formulas = [law.value for law in ball.laws if law.name.startswith("quadratic")]
    state = point(n, 7)
    moved = np.array([state + s * STEP * e for e in np.eye(2 * n) for s in (1, -1)])
    found = values(ball, formulas, moved)
    slopes = (found[::2] - found[1::2]).T / (2 * STEP)
    p, gamma = state[:n], state[n:]
    # along the cotangent bundle of the sphere
    normals = np.array([[*np.zeros(n), *gamma], [*gamma, *p]])
    tangent = np.linalg.svd(normals)[2][2:]
    sizes = np.linalg.svd(slopes @ tangent.T, compute_uv=False)
    assert sizes[n - 2] > 1e-3
    assert sizes[n - 1] < 1e-6
