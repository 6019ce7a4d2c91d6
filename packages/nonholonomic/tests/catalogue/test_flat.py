"""Along numerical motions the integrals of every system of the catalogue are flat."""

from __future__ import annotations

from collections.abc import Iterator
from zlib import crc32

import numpy as np
import pytest
import sympy as sp

from catalogue import built
from catalogue.admissible import random_example, random_parameters
from catalogue.built import NAMES, ROLLING, Example
from evaluation import drift, numeric
from flowlanes.flow.integrator import integrate
from flowlanes.flow.trajectory import Trajectory
from flowlanes.system.system import System
from flowlanes.system.vectors import to_components
from nonholonomic.catalogue import CATALOGUE
from planted import moving_symbols
from spread import spread


def is_chart(name: str) -> bool:
    """Whether a motion leaves the coordinates in the end."""
    return "octant" in {guard.name for guard in built.system(name).guards}


def drifts(motion: Trajectory) -> dict[str, float]:
    """How far each integral moves, relative to the size of its terms at the start.

    Where the terms nearly cancel, rounding is as large as the terms allow, not as their sum does.
    """
    found = {}
    for law in motion.system.integrals:
        values = motion.records[f"law_{law.name}"]
        terms = sp.Add.make_args(sp.expand_mul(to_components(law.value)))
        at_start = numeric(motion.system, terms)(np.asarray(motion.states[0], dtype=float))
        size = max(float(np.abs(at_start).sum()), abs(float(values[0])))
        found[law.name] = drift(values) * (abs(float(values[0])) / size if values[0] else 1.0)
    return found


def example(name: str) -> Example:
    """The example of the catalogue; all of its integrals hold at its start."""
    made = built.example(name)
    assert made.system_on_level.integrals == made.system.integrals
    return made


def follow(made: Example, until: float, samples: int = 201) -> Trajectory:
    motion = integrate(
        made.system_on_level, made.start, np.linspace(0.0, until, samples), on_liftoff="warn"
    )
    assert motion.times[-1] == until
    return motion


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_every_integral_is_flat_along_the_example(name):
    motion = follow(example(name), CATALOGUE[name].start.until if is_chart(name) else 100.0)
    assert drifts(motion)
    assert max(drifts(motion).values()) < 5e-14


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.slow) if n == "rattleback" else n for n in ROLLING]
)
def test_every_integral_is_flat(name):
    assert max(drifts(follow(example(name), 100.0)).values()) < 1e-13


@pytest.mark.slow
@pytest.mark.parametrize("name", ROLLING)
def test_every_integral_is_flat_for_long(name):
    assert max(drifts(follow(example(name), 1000.0)).values()) < 1e-13


@pytest.mark.slow
def test_chaplygin_ball_at_a_hundred_thousand():
    assert max(drifts(follow(example("chaplygin-ball"), 1e5)).values()) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("seed", spread(range(3), 3))
@pytest.mark.parametrize("name", ROLLING)
def test_every_integral_is_flat_for_random_bodies(name, seed):
    entry, rng = CATALOGUE[name], np.random.default_rng((seed, crc32(name.encode())))
    made = random_example(entry, rng, random_parameters(entry, rng))
    assert max(drifts(follow(made, 20.0, 41)).values()) < 5e-14
    named = [law.name for law in built.system(name).integrals]
    assert [law.name for law in made.system_on_level.integrals] == named


@pytest.mark.slow
@pytest.mark.parametrize("seed", spread(range(2), 2))
@pytest.mark.parametrize("name", [name for name in NAMES if name not in ROLLING])
def test_every_integral_is_flat_from_random_starts(name, seed):
    entry, rng = CATALOGUE[name], np.random.default_rng((seed, crc32(name.encode())))
    made = random_example(entry, rng)
    assert made.system_on_level.integrals == made.system.integrals
    until = entry.start.until / 5 if is_chart(name) else 20.0
    assert max(drifts(follow(made, until, 41)).values()) < 5e-14


def wrong_forms(formula: sp.Expr, system: System) -> Iterator[tuple[str, sp.Expr]]:
    """The formula with one sign, one factor or one exponent changed, in every possible place."""
    moving = moving_symbols(system)
    formula = formula.xreplace({s: sp.S.Zero for s, value in system.defaults.items() if value == 0})
    for node in set(sp.preorder_traversal(formula)):
        terms = [x for x in node.args if node.is_Add and x.free_symbols & moving]
        if terms:
            term = sorted(terms, key=sp.default_sort_key)[0]
            yield f"sign of {term} in {node}", formula.xreplace({node: node - 2 * term})
            yield f"factor of {term} in {node}", formula.xreplace({node: node + term})
        if node.is_Pow:
            raised = sp.Pow(node.base, node.exp + 1)
            yield f"exponent of {node}", formula.xreplace({node: raised})


@pytest.mark.slow
@pytest.mark.parametrize("name", ROLLING)
def test_a_planted_error_shows(name):
    entry, rng = CATALOGUE[name], np.random.default_rng(crc32(name.encode()))
    motion = follow(random_example(entry, rng, random_parameters(entry, rng)), 20.0)
    system = motion.system
    wrong = [
        form for law in system.integrals for form in wrong_forms(to_components(law.value), system)
    ]
    assert wrong
    # complex, since a wrong sign may make a root imaginary
    states = motion.states.T.astype(complex)
    found = numeric(system, [formula for _, formula in wrong])(states)
    for (what, _), values in zip(wrong, found, strict=True):
        assert np.abs(values - values[0]).max() > 1e-4 * np.abs(values[0]), what
