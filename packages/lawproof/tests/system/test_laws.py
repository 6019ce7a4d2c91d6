"""Laws as values: what is given as a number or a mapping, and what it becomes."""

from __future__ import annotations

import pytest
import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Symmetry,
)
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.prover import prove

x, v, c = (real_symbol(name) for name in "xvc")
OSCILLATOR = System("oscillator", "Oscillator", {x: v, v: -x})
BRACKET = PoissonStructure("bracket", [[0, 1], [-1, 0]], casimirs=(1,), rank=2)
LAWS = [
    Integral("integral", 1),
    Integral("integral", 1.5),
    Integral("integral", x**2 + v**2, level=[0]),
    Measure("measure", {1: 1}),
    Measure("measure", [(1, 1)]),
    Symmetry("symmetry", {x: 0}),
    Identity("identity", (0, 0)),
    BRACKET,
    ConformallyHamiltonian("form", 1, BRACKET, (x**2 + v**2) / 2),
    Isomorphism("isomorphism", OSCILLATOR, {x: x, v: v}, time=1),
]


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_a_number_is_a_formula(law: Law) -> None:
    system = OSCILLATOR.with_laws(law)
    assert prove(system, law).decision == "proven"
    assert law.name in str(system) or law.name in repr(law)
    assert hash(law)


def test_what_is_given_becomes_pairs_of_formulas() -> None:
    assert Measure("measure", {x: 2}).density == ((x, sp.Integer(2)),)
    assert Measure("measure", {x: 2}) == Measure("measure", [(x, 2)])
    assert type(BRACKET.rank) is int
    assert BRACKET.casimirs == (sp.S.One,)
