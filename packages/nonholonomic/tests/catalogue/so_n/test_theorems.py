"""Laws of n-dimensional systems that rest on a theorem: proven, and slips of them refuted."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Measure
from flowlanes.system.system import System
from lawproof.proof.prover import prove, prove_all
from nonholonomic.catalogue import from_catalogue
from nonholonomic.catalogue.so_n import mass_tensor_identities
from nonholonomic.catalogue.so_n.mass_tensor_identities import rate_of_pencil
from nonholonomic.classification.classifier import classify

NAMES = ("veselova-nd", "rubber-chaplygin-ball-nd", "chaplygin-ball-nd")


def tensor(n: int) -> np.ndarray:
    """A mass tensor in no special axes."""
    matrix = np.diag([0.4 + 0.3 * i for i in range(n)])
    return matrix + np.diag([0.1] * (n - 1), 1) + np.diag([0.1] * (n - 1), -1)


def system_of(name: str, n: int, kind: str) -> System:
    return from_catalogue(name, **({"mass_tensor": tensor(n)} if kind == "J" else {"dimension": n}))


CASES = [(name, n, kind) for name in NAMES for n in (3, 4, 5, 6) for kind in ("I", "J")]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "n", "kind"), CASES)
def test_every_law_is_proven_and_every_slip_refuted(name, n, kind):
    system = system_of(name, n, kind)
    assert {v.decision for v in prove_all(system)} == {"proven"}
    slips = []
    for law in system.laws:
        if isinstance(law, Measure):
            slips.append(replace(law, density=tuple((b, e / 2) for b, e in law.density)))
        elif isinstance(law, Isomorphism):
            slips.append(replace(law, time=sp.Integer(2)))
        else:
            wrong = law.value + system.symbols[0] ** 2 * system.symbols[1] / 1000
            slips.append(replace(law, value=wrong))
    # the theorem speaks of laws by their names, so the slips must not hide behind it
    assert {v.decision for v in prove_all(replace(system, laws=tuple(slips)))} == {"refuted"}


def test_a_theorem_counts_only_with_its_identities(monkeypatch):
    system = from_catalogue("veselova-nd", mass_tensor=tensor(4))
    theorems = tuple(
        replace(t, words="a slip", identities=lambda: (rate_of_pencil(sign=-1),))
        for t in system.theorems
    )
    verdict = prove(replace(system, theorems=theorems), "quadratic2", effort=100_000)
    assert verdict.decision == "undecided"


def test_the_identities_hold_for_every_dimension_at_once():
    assert [v.decision for v in prove_all(rate_of_pencil())] == ["proven", "proven"]
    assert [v.decision for v in prove_all(rate_of_pencil(sign=-1))] == ["proven", "refuted"]


def test_their_numbers_are_those_of_matrices():
    """p = (I(u∧γ))γ of matrices in six dimensions, from the coefficients of the identities."""
    rng = np.random.default_rng(7)
    n, number, D = 6, 40.3, 0.7
    half = rng.normal(size=(n, n))
    J = half @ half.T
    R = np.linalg.inv(number * np.eye(n) - J)
    powers = {"m": np.linalg.inv(R), "o": np.eye(n), "p": R}
    gamma = rng.normal(size=n)
    gamma /= np.linalg.norm(gamma)
    u, q = (x - x @ gamma * gamma for x in rng.normal(size=(2, n)))
    vectors = {"u": u, "q": q, "y": gamma}
    system = rate_of_pencil()
    values = {mass_tensor_identities.lam: number, mass_tensor_identities.D: D}
    for s in system.symbols:
        x, power, y = str(s)
        values[s] = vectors[x] @ powers[power] @ vectors[y]
    for s, formula in system.scalar_definitions:
        values[s] = float(formula.subs(values))
    omega = np.outer(u, gamma) - np.outer(gamma, u)
    # the terms of p in their order: u, γ, R⁻¹u, R⁻¹γ
    order = [(u, "o"), (gamma, "o"), (u, "m"), (gamma, "m")]
    found = sum(
        values[sp.Symbol(f"p_{i}", real=True)] * powers[power] @ x
        for i, (x, power) in enumerate(order, 1)
    )
    assert found == pytest.approx((J @ omega + omega @ J + D * omega) @ gamma, abs=1e-12)


@pytest.mark.slow
def test_a_rigid_body_of_four_dimensions_has_three_integrals_and_a_measure():
    place = classify(from_catalogue("veselova-nd", mass_tensor=tensor(4)))
    assert (place.dimension, place.count) == (6, 3)
    assert [density.sign for density in place.measures] == ["kept"]
