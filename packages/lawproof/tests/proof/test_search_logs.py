"""Logarithms in the search: in fields, in what is claimed, and among what is searched."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.verdict import Verdict
from lawproof.search import integrals, measures, search_space, symmetries
from lawproof.search.input_formulas import quantities
from lawproof.search.phase_space import restricted_system

x, y, u, v = (real_symbol(name) for name in ("x", "y", "u", "v"))
a, b, c, d = (real_symbol(name) for name in ("a", "b", "c", "d"))
VOLTERRA = d * x - c * sp.log(x) + b * y - a * sp.log(y)
PREY = {x: x * (a - b * y), y: y * (-c + d * x)}
BESIDE = {**PREY, u: v, v: -u}


def predators(field: dict[sp.Symbol, sp.Expr], *laws: Law) -> System:
    parameters = tuple(Parameter(s, str(s), 0.5, admissible=(s > 0,)) for s in (a, b, c, d))
    return System("predators", "Predators", field, parameters, laws=laws)


@pytest.fixture
def candidates(monkeypatch: pytest.MonkeyPatch) -> list[sp.Expr]:
    """What the search hands to the prover, which is left aside."""
    found: list[sp.Expr] = []

    def noted(system: System, law: Any, **_: Any) -> Verdict:
        found.append(law.value)
        return Verdict(law.name, "undecided")

    monkeypatch.setattr(sys.modules[integrals.__module__], "prove", noted)
    return found


@pytest.mark.parametrize("search", [integrals, measures, symmetries])
@pytest.mark.parametrize("claimed", [VOLTERRA, sp.atan(x) + sp.asin(y) - sp.log(-x)])
def test_what_is_claimed_stops_no_search(search, claimed):
    laws = (Integral("planted", claimed, "planted"), Measure("planted_too", {sp.atan(x): 1}))
    found = list(search(search_space(predators(BESIDE, *laws))))
    assert found
    assert all(finding.proven for finding in found)
    assert not any(finding.catalogue_law for finding in found)


def test_the_integral_of_lotka_and_volterra(candidates):
    question = search_space(
        predators(PREY, Integral("planted", VOLTERRA, "planted")),
        momenta="x, y",
        coordinates="log(x), log(y)",
        degree=1,
        gamma_degree=1,
    )
    (found,) = integrals(question)
    (formula,) = candidates
    assert sp.expand(formula - VOLTERRA) == 0 or sp.expand(formula + VOLTERRA) == 0
    assert found.catalogue_law == "planted"


def test_a_field_with_logarithms(candidates):
    clock = sp.log(x * y)
    question = search_space(
        predators({s: rate * clock for s, rate in PREY.items()}),
        momenta="x, y",
        coordinates="log(x), log(y)",
        degree=1,
        gamma_degree=1,
    )
    assert len(list(integrals(question))) == 1
    (formula,) = candidates
    assert sp.expand(formula - VOLTERRA) == 0 or sp.expand(formula + VOLTERRA) == 0


@pytest.mark.parametrize(
    "zero",
    [
        sp.log(x * y) - sp.log(x) - sp.log(y),
        sp.log(x**3 / y) - 3 * sp.log(x) + sp.log(y),
        sp.log(x**2 - y**2) - sp.log(y - x) - sp.log(x + y),
        sp.log(6 * x) - sp.log(2) - sp.log(3 * x),
        sp.log(sp.sqrt(x)) - sp.log(x) / 2,
    ],
)
def test_logarithms_of_products(zero):
    sample = restricted_system(predators(PREY)).sample(40, 1, common=False)
    jet = sample(zero)
    good = sample.evaluate.good
    assert good.sum() > 10
    assert not jet.value[good].any()
    assert not jet.slope[:, good].any()
    assert len(np.unique(sample(sp.log(x)).value)) == 40


def test_the_slope_of_a_logarithm():
    sample = restricted_system(predators(PREY)).sample(20, 1, common=False)
    argument = x**2 + 3 * y
    jet = sample(x**2 * argument * sp.log(argument))
    both = (sample(2 * x * argument * sp.log(argument)), sample(x**2 * 2 * x * sp.log(argument)))
    rest = sample(x**2 * 2 * x)
    expected = both[0].value + both[1].value + rest.value
    assert not ((jet.slope[0] - expected) % 2_147_483_647).any()


def test_levels_with_logarithms_have_points_where_these_exist():
    with pytest.raises(InputError, match="no points can be found on"):
        search_space(predators(PREY), level=["d*x - c*log(x) + b*y - a*log(y) - 9"])
    with pytest.raises(InputError, match="is empty: no real point"):
        search_space(predators(PREY), level=["log(x)**2 + 1"])


def test_formulas_among_quantities():
    system = predators(PREY)
    assert quantities("x, log(x*y), y", system) == (x, sp.log(x * y), y)
    with pytest.raises(InputError, match="unknown name 'z'"):
        quantities("log(z)", system)
    with pytest.raises(InputError, match="unknown variable 'z'"):
        quantities("x, z", system)
