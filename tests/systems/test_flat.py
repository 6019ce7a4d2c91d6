"""Along numerical motions every law of every system of the catalogue is flat, and no other."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
import sympy as sp

from chaplygin.flow.trajectory import Trajectory, integrate
from chaplygin.mechanics.start import starting_state
from chaplygin.study.summary import drift
from chaplygin.systems import CATALOGUE
from chaplygin.vectors import explicit
from evaluation import numeric
from systems.admissible import random_parameters, random_start

NAMES = tuple(CATALOGUE)


def drifts(motion: Trajectory) -> dict[str, float]:
    return {law.name: drift(motion.recorded[f"law_{law.name}"]) for law in motion.system.laws}


def follow(name: str, until: float) -> Trajectory:
    entry = CATALOGUE[name]
    system = entry.system()
    start = starting_state(system, entry.start.omega, entry.start.gamma)
    return integrate(system, start, np.linspace(0.0, until, 201))


@pytest.mark.parametrize("name", NAMES)
def test_every_law_is_flat_along_the_example(name):
    motion = follow(name, 100.0)
    assert motion.times[-1] == 100.0
    assert drifts(motion)
    assert max(drifts(motion).values()) < 2e-14


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.slow) if n == "rattleback" else n for n in NAMES]
)
def test_every_law_is_flat_for_long(name):
    motion = follow(name, 1000.0)
    assert motion.times[-1] == 1000.0
    assert max(drifts(motion).values()) < 1e-13


def test_chaplygin_ball_at_a_hundred_thousand():
    motion = follow("chaplygin-ball", 1e5)
    assert motion.times[-1] == 1e5
    assert max(drifts(motion).values()) < 1e-12


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", NAMES)
def test_every_law_is_flat_for_random_bodies(name, seed):
    entry, rng = CATALOGUE[name], np.random.default_rng((seed, NAMES.index(name)))
    system = entry.system(random_parameters(entry, rng))
    start = random_start(system, entry, rng)
    motion = integrate(system, start, np.linspace(0.0, 20.0, 41), on_liftoff="warn")
    assert motion.times[-1] == 20.0
    assert max(drifts(motion).values()) < 1e-13
    assert [law.name for law in system.laws] == [law.name for law in entry.system().laws]


def wrong_forms(formula: sp.Expr) -> Iterator[tuple[str, sp.Expr]]:
    """The formula with one sign, one factor or one exponent changed, in every possible place."""
    for node in set(sp.preorder_traversal(formula)):
        if node.is_Add:
            term = sorted(node.args, key=sp.default_sort_key)[0]
            yield f"sign of {term} in {node}", formula.xreplace({node: node - 2 * term})
            yield f"factor of {term} in {node}", formula.xreplace({node: node + term})
        if node.is_Pow:
            raised = sp.Pow(node.base, node.exp + 1)
            yield f"exponent of {node}", formula.xreplace({node: raised})


@pytest.mark.parametrize("name", NAMES)
def test_a_planted_error_shows(name):
    entry, rng = CATALOGUE[name], np.random.default_rng(NAMES.index(name))
    system = entry.system(random_parameters(entry, rng))
    start = random_start(system, entry, rng)
    motion = integrate(system, start, np.linspace(0.0, 20.0, 201), on_liftoff="warn")
    wrong = [form for law in system.laws for form in wrong_forms(explicit(law.value))]
    assert wrong
    # complex, since a wrong sign may make a root imaginary
    states = motion.states.T.astype(complex)
    found = numeric(motion.system, [formula for _, formula in wrong])(states)
    for (what, _), values in zip(wrong, found, strict=True):
        assert np.abs(values - values[0]).max() > 1e-4 * np.abs(values[0]), what
