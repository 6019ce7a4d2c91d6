"""Invariant measures of any inertia in n dimensions: proven, and as numbers show them."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
import sympy as sp

from flowlanes.system.laws import Measure
from lawproof.proof.prover import prove
from nonholonomic.catalogue import from_catalogue
from nonholonomic.catalogue.so_n import any_inertia
from nonholonomic.catalogue.so_n.invariants import invariants_of_ball

IDENTITIES = (any_inertia.chaplygin_ball, any_inertia.veselova)
STEP = 1e-30


@pytest.mark.parametrize("identity", IDENTITIES)
@pytest.mark.parametrize(
    "n", [3, pytest.param(4, marks=pytest.mark.slow), pytest.param(5, marks=pytest.mark.slow)]
)
def test_the_measure_of_any_inertia_is_proven(identity, n):
    assert prove(identity(n), "measure").decision == "proven"


@pytest.mark.parametrize(
    "n", [3, 4, pytest.param(5, marks=pytest.mark.slow), pytest.param(6, marks=pytest.mark.slow)]
)
@pytest.mark.parametrize("identity", [any_inertia.energy_of_ball, any_inertia.energy_of_veselova])
def test_the_energy_is_constant_for_any_inertia(identity, n):
    assert prove(identity(n), "energy").decision == "proven"


@pytest.mark.parametrize(
    "n", [3, 4, pytest.param(5, marks=pytest.mark.slow), pytest.param(6, marks=pytest.mark.slow)]
)
def test_invariants_of_the_momentum_are_constant_for_any_inertia(n):
    system = invariants_of_ball(n)
    assert len(system.laws) == n - 1
    for law in system.laws:
        assert prove(system, law).decision == "proven"


@pytest.mark.parametrize("identity", IDENTITIES)
@pytest.mark.parametrize("exponent", [sp.Rational(1, 2), -1, sp.Rational(-1, 3)])
def test_another_exponent_is_refuted(identity, exponent):
    assert prove(identity(3, sp.Rational(exponent)), "measure").decision == "refuted"


def pairs(n):
    return tuple(combinations(range(n), 2))


def skew(entries, n):
    matrix = np.zeros((n, n), dtype=complex)
    for value, (i, j) in zip(entries, pairs(n), strict=True):
        matrix[i, j], matrix[j, i] = value, -value
    return matrix


def above(matrix):
    return np.array([matrix[i, j] for i, j in pairs(len(matrix))])


def random_operator(size, rng):
    """A symmetric positive operator on so(n), of no kind in particular."""
    root = rng.normal(size=(size, size))
    return root @ root.T / size + 0.3 * np.eye(size)


def operator(n, image):
    return np.array([above(image(skew(unit, n))) for unit in np.eye(len(pairs(n)))]).T


def ball(n, inertia, state):
    """ρ v of the Chaplygin ball in k and γ, ρ = det(ω ↦ k)^(−1/2), at complex points."""
    count = len(pairs(n))
    k, gamma = skew(state[:count], n), state[count:]
    around = np.outer(gamma, gamma)
    whole = inertia + 0.7 * operator(n, lambda omega: omega @ around + around @ omega)
    omega = skew(np.linalg.solve(whole, state[:count]), n)
    rates = np.concatenate([above(k @ omega - omega @ k), -omega @ gamma])
    return rates / np.sqrt(np.linalg.det(whole))


def veselova(n, inertia, state):
    """ρ v of the Veselova system in p and γ, at complex points."""
    p, gamma = state[:n], state[n:]
    turns = np.array([above(np.outer(e, gamma) - np.outer(gamma, e)) for e in np.eye(n)])
    B = turns @ inertia @ turns.T + np.outer(gamma, gamma)
    u = np.linalg.solve(B, p)
    return np.concatenate([(u @ p) * gamma, -u]) / np.sqrt(np.linalg.det(B))


def divergence(flow, state):
    """Exact but for rounding, by complex steps."""
    total = 0.0
    for index in range(len(state)):
        moved = state.astype(complex)
        moved[index] += 1j * STEP
        total += flow(moved)[index].imag / STEP
    return total


@pytest.mark.parametrize("n", [3, 4, 5])
def test_numbers_agree_for_a_random_operator(n):
    rng = np.random.default_rng(n)
    inertia = random_operator(len(pairs(n)), rng)
    gamma = rng.normal(size=n)
    gamma /= np.linalg.norm(gamma)
    k, p = rng.normal(size=len(pairs(n))), rng.normal(size=n)
    p -= (p @ gamma) * gamma
    for flow, state in (
        (ball, np.concatenate([k, gamma])),
        (veselova, np.concatenate([p, gamma])),
    ):
        terms = np.abs(flow(n, inertia, state.astype(complex))).max()
        assert abs(divergence(lambda x, f=flow: f(n, inertia, x), state)) < 1e-12 * (1 + terms)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["veselova-nd", "chaplygin-ball-nd", "rubber-chaplygin-ball-nd"])
def test_the_measure_of_the_catalogue_is_proven_by_itself(name):
    system = replace(from_catalogue(name, dimension=3), theorems=())
    assert prove(system, "measure").decision == "proven"
    law = next(law for law in system.laws if law.name == "measure")
    wrong = Measure("measure", tuple((base, -exponent) for base, exponent in law.density))
    assert prove(system, wrong).decision == "refuted"


@pytest.mark.parametrize("n", [3, 4, 5])
def test_suslov_has_a_measure_with_a_principal_axis_alone(n):
    system = from_catalogue("suslov-nd", dimension=n)
    volume = next(law for law in system.laws if law.name == "volume")
    assert prove(system, volume).decision == "proven"
    free = Measure("volume", {sp.S.One: sp.S.One}, "volume", source=volume.source)
    verdict = prove(system, free)
    assert verdict.decision == "refuted" and verdict.witness["point"]
    assert prove(system, "monotone").decision == "proven"
