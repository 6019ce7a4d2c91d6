"""The special operators of inertia: the equations, and their laws in several dimensions."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.formulas.array_evaluation import values
from flowlanes.system.matrices import Skew
from lawproof.proof.prover import prove
from nonholonomic.catalogue import entry, from_catalogue

FACTORS = {
    "special-veselova-nd": (0.7, 1.2, 1.9, 2.3),
    "special-rubber-ball-nd": (1.1, 1.4, 1.9, 2.3),
    "special-chaplygin-ball-nd": (0.3, 0.5, 0.8, 1.1),
}


def point(n, seed):
    """p and γ on the phase space."""
    rng = np.random.default_rng(seed)
    p, gamma = rng.normal(size=(2, n))
    gamma /= np.linalg.norm(gamma)
    return p - (p @ gamma) * gamma, gamma


def rates(system, state):
    return values(system, list(system.rates), np.array([state]))[0]


@pytest.mark.parametrize(
    ("special", "general", "moment"),
    [
        ("special-veselova-nd", "veselova-nd", lambda product: product),
        ("special-rubber-ball-nd", "rubber-chaplygin-ball-nd", lambda product: product - 1.0),
    ],
)
def test_closed_formulas_are_the_general_equations(special, general, moment):
    factors = FACTORS[special]
    moments = [moment(a * b) for a, b in combinations(factors, 2)]
    one = from_catalogue(special, factors=factors)
    other = from_catalogue(general, moments=moments)
    for seed in range(3):
        state = np.concatenate(point(4, seed))
        assert rates(one, state) == pytest.approx(rates(other, state), abs=1e-13)


def test_the_level_of_the_ball_is_invariant_and_has_its_equations():
    """k = p ∧ γ in the equations of the ball: ω and γ̇ agree, and k̇ is that of p ∧ γ."""
    factors = FACTORS["special-chaplygin-ball-nd"]
    moments = [a * b / (1.0 - a * b) for a, b in combinations(factors, 2)]
    one = from_catalogue("special-chaplygin-ball-nd", factors=factors)
    ball = from_catalogue("chaplygin-ball-nd", moments=moments)
    names = list(Skew("omega", 4).symbols)
    for seed in range(3):
        p, gamma = point(4, seed)
        places = list(combinations(range(4), 2))
        k = np.array([p[i] * gamma[j] - p[j] * gamma[i] for i, j in places])
        whole = np.concatenate([k, gamma])
        state = np.concatenate([p, gamma])
        omega = values(one, names, np.array([state]))
        assert omega == pytest.approx(values(ball, names, np.array([whole])), abs=1e-13)
        reduced, full = rates(one, state), rates(ball, whole)
        assert reduced[4:] == pytest.approx(full[6:], abs=1e-13)
        change = [
            reduced[i] * gamma[j] + p[i] * reduced[4 + j] - reduced[j] * gamma[i]
            - p[j] * reduced[4 + i]
            for i, j in places
        ]  # fmt: skip
        assert change == pytest.approx(full[:6], abs=1e-13)


@pytest.mark.parametrize("name", FACTORS)
@pytest.mark.parametrize("n", [3, pytest.param(5, marks=pytest.mark.slow)])
def test_every_law_is_proven(name, n):
    system = from_catalogue(name, dimension=n)
    assert len(system.laws) == n + 5
    for law in system.laws:
        assert prove(system, law).decision == "proven", law.name


@pytest.mark.parametrize("name", FACTORS)
def test_n_minus_one_integrals_are_independent(name):
    """The rank of the gradients on the phase space, by differences at a random point."""
    n, step = 4, 1e-6
    system = entry(name).system()
    laws = [law.value for law in system.integrals]
    p, gamma = point(n, 7)
    state = np.concatenate([p, gamma])
    tangents = np.linalg.svd(
        np.array([np.concatenate([0 * p, gamma]), np.concatenate([gamma, p])])
    )[2][2:]
    slopes = [
        (values(system, laws, np.array([state + step * t]))
        - values(system, laws, np.array([state - step * t])))[0] / (2 * step)
        for t in tangents
    ]  # fmt: skip
    assert np.linalg.matrix_rank(np.array(slopes), tol=1e-6) == n - 1


@pytest.mark.parametrize(
    "name",
    ["special-veselova-nd", "special-rubber-ball-nd", "special-rubber-ball-on-sphere-nd"],
)
def test_a_start_may_give_the_angular_velocity(name):
    system = from_catalogue(name)
    gamma = np.array([0.0, 0.0, 0.6, 0.8])
    u = np.array([0.3, -0.5, 0.8, -0.6])
    omega = (np.outer(u, gamma) - np.outer(gamma, u))[np.triu_indices(4, 1)]
    motion = integrate(system, {"omega": omega, "gamma": gamma}, [0.0, 1.0])
    assert motion["omega"][0] == pytest.approx(omega, abs=1e-14)
    with pytest.raises(InputError, match="constraint"):
        integrate(system, {"omega": omega + 0.1, "gamma": gamma}, [0.0, 1.0])
