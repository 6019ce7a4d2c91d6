"""Quadratic integrals by weights of the planes: recognised, proven, and refuted if wrong."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
import sympy as sp

from flowlanes.flow.integrator import integrate
from flowlanes.system.laws import Identity
from lawproof.proof.prover import prove, prove_all
from nonholonomic.catalogue import from_catalogue
from nonholonomic.catalogue.so_n.inertia import GENERIC, Moments, labels
from nonholonomic.catalogue.so_n.weighted_integrals import further_weights, lemma

#: I_ij = (b_i − b_j)/(c_i − c_j) with b = (0, 6, 10, 13), c = (0, 2, 5, 10): no rigid body's.
NO_BODY = (3.0, 2.0, 1.3, 4 / 3, 0.875, 0.6)
SYSTEMS = ("veselova-nd", "rubber-chaplygin-ball-nd", "chaplygin-ball-on-level-nd")


def of_body(n: int) -> list[float]:
    tensor = [1.0, 2.0, 4.5, 7.0, 9.0, 11.5][:n]
    return [x + y for x, y in combinations(tensor, 2)]


def moments(values: list[float] | tuple[float, ...], n: int) -> Moments:
    names = (f"I_{label}" for label in labels(n))
    return Moments(n, dict(zip(names, values, strict=True)))


@pytest.mark.parametrize("n", [3, 4, 5, 6])
def test_a_rigid_body_has_n_minus_1_integrals(n):
    assert len(further_weights(moments(of_body(n), n))) == n - 3


def test_generic_moments_have_energy_and_momentum_alone():
    assert further_weights(moments(GENERIC, 4)) == ()


def test_a_third_is_no_decimal():
    # with 4/3 in place of 1.3333333333333333 they would be such
    assert further_weights(moments(NO_BODY, 4)) == ()


@pytest.mark.slow
@pytest.mark.parametrize("name", SYSTEMS)
def test_laws_are_proven_and_a_wrong_weight_is_refuted(name):
    system = from_catalogue(name, moments=of_body(4))
    assert {v.decision for v in prove_all(system)} == {"proven"}
    law = next(law for law in system.laws if law.name == "quadratic2")
    wrong = replace(law, value=law.value + sp.Symbol("omega_12", real=True) ** 2)
    slip = replace(system, laws=tuple(wrong if x is law else x for x in system.laws))
    assert prove(slip, "quadratic2").decision == "refuted"
    free = replace(law, level=())
    loose = replace(system, laws=tuple(free if x is law else x for x in system.laws))
    assert prove(loose, "quadratic2").decision == "refuted"


def test_slips_of_the_lemma_are_refuted():
    system = lemma()
    for law in system.laws:
        wrong = Identity(law.name, law.value + system.symbols[0] * system.symbols[4], "slip")
        assert prove(replace(system, laws=(wrong,)), wrong.name).decision == "refuted"


@pytest.mark.slow
@pytest.mark.parametrize("n", [4, 5])
@pytest.mark.parametrize("kind", ["moments", "mass_tensor"])
def test_the_level_is_that_of_the_whole_ball(n, kind):
    rng = np.random.default_rng(n)
    half = rng.normal(size=(n, n))
    given = of_body(n) if kind == "moments" else half @ half.T + np.eye(n)
    gamma = rng.normal(size=n)
    gamma /= np.linalg.norm(gamma)
    p = rng.normal(size=n)
    p -= p @ gamma * gamma
    level, whole = (
        from_catalogue(name, mass=1.3, radius=0.8, **{kind: given})
        for name in ("chaplygin-ball-on-level-nd", "chaplygin-ball-nd")
    )
    one = integrate(level, {"p": p, "gamma": gamma}, [0.0, 5.0, 10.0]).to_dataset()
    start = {"omega": one.omega.values[0], "attitude": one.attitude.values[0]}
    other = integrate(whole, start, [0.0, 5.0, 10.0]).to_dataset()
    for name in ("omega", "attitude", "contact"):
        assert np.abs(one[name] - other[name]).max() < 1e-12
    for name in (name for name in one if name.startswith("law_")):
        assert np.abs(one[name] - one[name][0]).max() < 1e-12 * np.abs(one[name][0])
