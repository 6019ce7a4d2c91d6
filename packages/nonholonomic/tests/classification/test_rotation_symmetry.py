"""Symmetries proven definition by definition."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from flowlanes.system.laws import Symmetry
from flowlanes.system.system import System
from flowlanes.system.vector_operators import outer
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)
from lawproof.proof.prover import prove
from nonholonomic.catalogue import entry
from nonholonomic.classification.ranks import RankSample
from nonholonomic.classification.rotation_symmetry import proven_rotation_symmetry

x, y, f = vectors("x y f")
e_3 = sp.ImmutableMatrix([0, 0, 1])
a = real_symbol("a")


@pytest.mark.parametrize(
    ("name", "about"),
    [
        ("rubber-body-of-revolution", [False, False, True]),
        ("heavy-disk", [False, False, True]),
        ("rattleback", [False, False, False]),
        ("chaplygin-ball", [False, False, False]),
        ("chaplygin-sleigh", [False, False, False]),
    ],
)
def test_bodies_of_revolution_turn_about_their_axis(name: str, about: list[bool]) -> None:
    standing = RankSample(entry(name).system())
    assert [proven_rotation_symmetry(standing, axis) is not None for axis in range(3)] == about


def test_a_slight_asymmetry_is_seen() -> None:
    disk = entry("heavy-disk").system()
    other = [
        replace(p, default=p.default * 1.0001) if str(p.symbol) == "I_2" else p
        for p in disk.parameters
    ]
    assert proven_rotation_symmetry(RankSample(replace(disk, parameters=tuple(other))), 2) is None


def system() -> System:
    """ẋ = y, with a force from definitions of every kind."""
    definitions = {
        a: norm_squared(x) + 1,
        Symmetric("S"): outer(x, x) + sp.diag(3, 3, 1),
        Diagonal("D"): sp.diag(a, a, norm_squared(x)),
        f: Symmetric("S") * x + Diagonal("D") * cross(x, e_3),
    }
    return System("made", "Made", {x: y, y: f}, definitions=definitions)


def test_every_kind_of_definition() -> None:
    made = system()
    found = proven_rotation_symmetry(RankSample(made), 2)
    assert found is not None
    assert found.keeps(dot(x, y))
    assert found.keeps(x.symbols[2] * norm_squared(y))
    assert not found.keeps(x.symbols[0])
    assert proven_rotation_symmetry(RankSample(made), 0) is None
    field = {v: cross(e_3, v) for v in (x, y)}
    assert prove(made, Symmetry("turning", field))


def test_a_tensor_that_does_not_turn() -> None:
    made = system()
    crooked = {**dict(made.definitions), Symmetric("S"): outer(x, x) + sp.diag(3, 2, 1)}
    assert (
        proven_rotation_symmetry(RankSample(replace(made, definitions=tuple(crooked.items()))), 2)
        is None
    )
    crooked = {**dict(made.definitions), Diagonal("D"): sp.diag(a, 2 * a, 1)}
    assert (
        proven_rotation_symmetry(RankSample(replace(made, definitions=tuple(crooked.items()))), 2)
        is None
    )


def test_a_relation_must_turn_too() -> None:
    made = system()
    assert (
        proven_rotation_symmetry(RankSample(replace(made, relations=(norm_squared(x) - 1,))), 2)
        is not None
    )
    tilted = to_components(dot(x, sp.ImmutableMatrix([1, 0, 1])))
    assert proven_rotation_symmetry(RankSample(replace(made, relations=(tilted,))), 2) is None
