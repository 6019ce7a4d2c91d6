"""Names of experiments: the same in every process, others for others."""

from __future__ import annotations

import functools
import os
import pickle
import subprocess
import sys
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.digest import canonical, digest, field_digests
from flowlanes.system.laws import Identity, Measure, Symmetry
from nonholonomic.catalogue import CATALOGUE, from_catalogue

x, y = sp.symbols("x y")


@dataclass(frozen=True)
class Pair:
    first: Any
    second: Any


VALUES = [
    None,
    0,
    1,
    True,
    1.0,
    -0.0,
    0.0,
    1 + 0j,
    "1",
    b"1",
    (),
    (1,),
    (1, (2,)),
    ((1, 2),),
    (1, 2),
    ("12", "3"),
    ("1", "23"),
    {},
    {"a": 1},
    {"a": 2},
    {1},
    np.ones(2),
    np.ones(2, dtype="float32"),
    np.ones((2, 1)),
    np.array(["x", None], dtype=object),
    np.array(["y", None], dtype=object),
    x,
    sp.Symbol("x", real=True),
    x + y,
    sp.Matrix([x, y]),
    Pair(1, 2),
    Pair(2, 1),
    np.sin,
    functools.partial(np.add, 1),
    functools.partial(np.add, 2),
    dict,
]


def test_different_values_have_different_names() -> None:
    assert len({digest(value) for value in VALUES}) == len(VALUES)


def test_equal_values_have_equal_names() -> None:
    assert digest({"a": 1, "b": 2}) == digest({"b": 2, "a": 1})
    assert digest((1, 2)) == digest([1, 2])
    assert digest(np.float64(0.1)) == digest(0.1)
    assert digest(np.arange(6).reshape(2, 3).T) == digest(np.arange(6).reshape(2, 3).T.copy())
    assert digest(x + y) == digest(y + x)


@pytest.mark.slow
def test_a_system_is_its_equations() -> None:
    system = from_catalogue("chaplygin-ball")
    other = replace(system, summary="in other words").with_laws(Identity("same", sp.Integer(0)))
    assert digest(other) == digest(system) == digest(pickle.loads(pickle.dumps(system)))
    assert digest(from_catalogue("chaplygin-ball", m=2.0)) != digest(system)
    assert digest(replace(system, guards=())) == digest(system)
    assert digest(from_catalogue("rattleback")) != digest(system)


def test_a_system_is_what_is_measured_along_its_motions() -> None:
    system = from_catalogue("rattleback").lifted()
    energy, seen = system.integrals[0], system.observables[0]
    others = [
        replace(system, laws=(replace(energy, value=2 * energy.value), *system.laws[1:])),
        replace(system, observables=(replace(seen, value=2 * seen.value),)),
        replace(system, observables=()),
        system.with_laws(Symmetry("turned", {system.symbols[0]: 1})),
        system.with_laws(Measure("smooth", {sp.Integer(2): 1})),
    ]
    assert len({digest(item) for item in (system, *others)}) == 1 + len(others)
    assert digest(replace(system, laws=(replace(energy, meaning="E"), *system.laws[1:]))) == digest(
        system
    )


@pytest.mark.parametrize("name", sorted(CATALOGUE)[::8])
def test_systems_keep_their_names_on_the_way_to_a_worker(name: str) -> None:
    system = canonical(from_catalogue(name))
    assert digest(pickle.loads(pickle.dumps(system))) == digest(system)


@pytest.mark.slow
def test_formulas_that_sympy_rewrites_are_settled() -> None:
    system = from_catalogue("trailers")
    assert digest(canonical(system)) != digest(system)
    assert digest(canonical(canonical(system))) == digest(canonical(system))


@pytest.mark.slow
def test_all_systems_keep_their_names_on_the_way_to_a_worker() -> None:
    names = {}
    for name in CATALOGUE:
        system = canonical(from_catalogue(name))
        names[name] = digest(system)
        assert digest(pickle.loads(pickle.dumps(system))) == names[name], name
    assert len(set(names.values())) == len(names)


@pytest.mark.slow
def test_names_are_the_same_in_another_process() -> None:
    script = (
        "from flowlanes.formulas.digest import digest\n"
        "from nonholonomic.catalogue import from_catalogue\n"
        "print(digest((from_catalogue('unbalanced-ball'), {'b': 1, 'a': {'x', 'y', 'z'}})))"
    )
    here = digest((from_catalogue("unbalanced-ball"), {"a": {"z", "y", "x"}, "b": 1}))
    sentence = subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONHASHSEED": "7"},
        cwd=Path(__file__).parents[4],
    )
    assert sentence.stdout.strip() == here


def test_parts_are_named() -> None:
    assert set(field_digests(Pair(1, 2))) == {"function", "first", "second"}
    assert set(field_digests(functools.partial(np.add, 1, dtype="f8"))) == {
        "function",
        "argument 1",
        "dtype",
    }
    assert set(field_digests(np.sin)) == {"function"}


@pytest.mark.parametrize("value", [lambda: 0, object(), (1, object())], ids=["f", "thing", "in"])
def test_what_has_no_name_is_refused(value: Any) -> None:
    with pytest.raises(InputError, match="what it is must show by a name"):
        digest(value)
