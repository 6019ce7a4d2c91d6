"""The scalar form of a system: nothing in it is a vector, and nothing else has changed."""

from __future__ import annotations

import pickle

import pytest
import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Integral, Law, Measure, Symmetry
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import Guard, System
from flowlanes.system.vectors import Diagonal, Vector, cross, dot, norm_squared, to_components
from nonholonomic.catalogue import from_catalogue

M, gamma = Vector("M"), Vector("gamma")
SYSTEMS = ("chaplygin-ball", "veselova", "heavy-disk")


def formulas(law: Law) -> list[sp.Basic]:
    """The formulas of a law, and of those in it."""
    parts = list(law.formulas)
    return [*parts, *(law.onto if isinstance(law, Isomorphism) else ())]


@pytest.mark.parametrize("name", SYSTEMS)
def test_no_vector_is_left(name: str) -> None:
    scalar = from_catalogue(name).scalar
    seen = [*scalar.rates, *scalar.relations, *(f for _, f in scalar.definitions)]
    seen += [item.value for item in (*scalar.observables, *scalar.guards)]
    seen += [f for law in scalar.laws for f in formulas(law)]
    assert seen
    for formula in scalars(tuple(seen)):
        assert not formula.atoms(MatrixExpr), formula
        assert to_components(formula) == formula


@pytest.mark.parametrize("name", SYSTEMS)
def test_everything_keeps_its_place(name: str) -> None:
    system = from_catalogue(name)
    scalar = system.scalar
    assert scalar.relations == tuple(map(to_components, system.relations))
    for here, there in zip(scalar.laws, system.laws, strict=True):
        assert type(here) is type(there)
        assert (here.name, here.source) == (there.name, there.source)
        assert here.level == tuple(map(to_components, there.level))
    for here, there in zip(scalar.integrals, system.integrals, strict=True):
        assert here.value == to_components(there.value)
    for here, there in zip(scalar.observables, system.observables, strict=True):
        assert here.value == to_components(there.value)
        assert here.frame == there.frame
    assert scalar is system.scalar


def test_pairs_that_name_vectors_have_one_for_each_component() -> None:
    law = Symmetry("turn", {gamma: cross(M, gamma), M: cross(M, M)})
    named = dict(law.scalar.field)
    assert set(named) == {*gamma.symbols, *M.symbols}
    g, m = gamma.symbols, M.symbols
    assert named[g[0]] == m[1] * g[2] - m[2] * g[1]


def test_a_base_that_is_a_symbol_stays_a_base() -> None:
    ell = sp.Symbol("ell", real=True)
    law = Measure("measure", {ell: 2, dot(gamma, Diagonal("I") * gamma): -1})
    (first, second) = law.scalar.density
    assert first == (ell, 2)
    assert second[0] == sum(
        i * s**2 for i, s in zip(sp.symbols("I_1 I_2 I_3", real=True), gamma.symbols, strict=True)
    )


def test_a_law_of_scalars_is_its_own_scalar_form() -> None:
    law = Integral("x", sp.Symbol("x", real=True))
    assert law.scalar is law


def test_it_is_not_sent_to_other_processes() -> None:
    system = from_catalogue("chaplygin-ball")
    assert system.scalar.laws
    copy: System = pickle.loads(pickle.dumps(system))
    assert "scalar" not in vars(copy)
    assert all("scalar" not in vars(law) for law in copy.laws)
    assert copy == system
    assert copy.scalar.laws == system.scalar.laws


def test_a_guard_in_scalar_form() -> None:
    guard = Guard("short", norm_squared(gamma) - 1, "too short", lift_off=True)
    assert guard.scalar == Guard(
        "short", sum(s**2 for s in gamma.symbols) - 1, "too short", lift_off=True
    )
