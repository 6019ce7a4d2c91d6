"""One function finds the laws of each kind, by the steps that can also be taken one by one."""

from __future__ import annotations

import inspect
import pickle
from typing import Any

import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import Integral
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from lawproof import find_laws
from lawproof.search import SEARCHES, SearchResult, search_space

x, y, u, v = (real_symbol(name) for name in ("x", "y", "u", "v"))
LENGTH = Integral("energy", u**2 + x**2)
OSCILLATOR = System("oscillator", "Plane oscillator", {x: u, y: v, u: -x, v: -y}, laws=[LENGTH])
LINEAR = {"degree": 1, "gamma_degree": 1}


@pytest.mark.parametrize(
    ("kind", "options"), [("integrals", {}), ("measure", {}), ("symmetries", LINEAR)]
)
def test_the_laws_are_those_of_the_search_of_their_kind(kind: Any, options: Any) -> None:
    found = find_laws(OSCILLATOR, kind, **options)
    steps = tuple(SEARCHES[kind](search_space(OSCILLATOR, **options), lambda done, words: None))
    assert found and all(result.proven for result in found)
    assert [(r.kind, r.law) for r in found] == [(r.kind, r.law) for r in steps]


def test_its_options_are_those_of_the_space_searched() -> None:
    asked = inspect.signature(find_laws).parameters
    for name, option in inspect.signature(search_space).parameters.items():
        assert asked[name].default == option.default, name
    assert set(asked) - set(inspect.signature(search_space).parameters) == {"kind", "progress"}


def test_options_are_passed_on() -> None:
    assert find_laws(OSCILLATOR, degree=1) == ()
    (at_rest,) = find_laws(OSCILLATOR, level=["y", "v"])
    assert sp.expand(at_rest.formula - u**2 - x**2) == 0
    done: list[float] = []
    find_laws(OSCILLATOR, progress=lambda fraction, words: done.append(fraction))
    assert done[0] == 0 and done[-1] == 1 and done == sorted(done)


def test_a_result_is_shown_as_its_formula_with_its_verdict() -> None:
    integrals = [repr(found) for found in find_laws(OSCILLATOR)]
    assert integrals[1].splitlines() == [
        "F₂ = u² + x²: proven",
        "    repeats  energy",
    ]
    (volume,) = find_laws(OSCILLATOR, "measure")
    assert repr(volume) == "ρ = 1: proven"
    field = find_laws(OSCILLATOR, "symmetries", **LINEAR)[0]
    assert repr(field).startswith("x ↦ ") and pickle.loads(pickle.dumps(field)) == field
    seen = SearchResult("integral", None, None, remark="without a formula")
    assert "only observed" in repr(seen) and "without a formula" in repr(seen)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"kind": "laws"}, "'integrals' or 'measure' or 'symmetries'"),
        ({"degree": -1}, "must not be negative"),
        ({"level": ["q"]}, "level: unknown name 'q'"),
        ({"effort": "high"}, "effort"),
    ],
)
def test_mistakes_are_told_in_a_sentence(options: Any, words: str) -> None:
    with pytest.raises(InputError, match=words):
        find_laws(OSCILLATOR, **options)
