"""Changes of signs that reverse the equations."""

from __future__ import annotations

import numpy as np
import pytest

from flow.backwards import runs_backwards
from flowlanes.formulas.array_formulas import Formulas
from flowlanes.orbits.reversor import Reversor, reversing_symmetries
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.prover import prove
from nonholonomic.catalogue import from_catalogue

x, y, a = map(real_symbol, "xya")


def _named(found: Reversor) -> tuple[str, str]:
    return " ".join(map(str, found.odd)), " ".join(map(str, found.vanishing))


def test_displacements_take_reflections_away() -> None:
    found = dict(map(_named, reversing_symmetries(from_catalogue("unbalanced-ball"))))
    assert found["M_1 M_2 M_3"] == ""
    assert found["M_2 gamma_2"] == "c_2"
    assert found["M_3 gamma_1 gamma_2"] == "c_1 c_2"
    assert found["M_1 M_2 M_3 gamma_1 gamma_2 gamma_3"] == "c_1 c_2 c_3"
    assert len(found) == 8


def test_a_rattleback_is_turned_against_its_axes() -> None:
    found = dict(map(_named, reversing_symmetries(from_catalogue("rattleback"))))
    assert found["M_1 M_2 M_3"] == ""
    assert found["M_1 gamma_1"] == "delta c_1"
    assert found["M_3 gamma_3"] == "c_3"


def test_rotors_break_the_change_of_all_momenta() -> None:
    found = dict(map(_named, reversing_symmetries(from_catalogue("chaplygin-ball-gyrostat"))))
    assert found["M_1 M_2 M_3"] == "k_1 k_2 k_3"
    assert found["M_1 gamma_1"] == "k_1"


@pytest.mark.parametrize("name", ["chaplygin-sleigh", "suslov", "rubber-chaplygin-ball"])
def test_every_one_reverses_the_numbers(name: str) -> None:
    system = from_catalogue(name)
    rates = Formulas(system, system.rates)
    states = np.random.default_rng(3).uniform(0.2, 0.8, (5, len(system.symbols)))
    found = reversing_symmetries(system)
    assert found
    for reversor in found:
        signs, at = reversor.signs(system), {s: 0.0 for s in reversor.vanishing}
        assert rates(signs * states, at) == pytest.approx(-signs * rates(states, at), abs=1e-12)
        assert reversor.holds({**system.defaults, **at})


def test_the_prover_agrees() -> None:
    system = from_catalogue("suslov")
    for reversor in reversing_symmetries(system):
        signs = {s: -1 for s in (*reversor.odd, *reversor.vanishing)}
        assert prove(system, runs_backwards(system, signs))


def test_none_where_there_is_none() -> None:
    assert reversing_symmetries(System("fall", "Fall", {x: -x, y: x * y + 1})) == ()


def test_conditions_are_as_weak_as_can_be() -> None:
    system = System("shift", "Shift", {x: y + a, y: x**3}, (Parameter(a, "shift", 0.5),))
    found = {_named(r) for r in reversing_symmetries(system)}
    assert found == {("x", ""), ("y", "a")}


def test_parameters_that_must_be_positive_are_kept() -> None:
    b = real_symbol("b")
    positive = Parameter(b, "positive", 0.5, "", (b > 0,))
    system = System("push", "Push", {x: y + b, y: x**3}, (positive,))
    assert {_named(r) for r in reversing_symmetries(system)} == {("x", "")}


def test_words() -> None:
    system = from_catalogue("unbalanced-ball")
    M, gamma = system.state
    all_of = Reversor((*M.symbols,))
    some = Reversor((M.symbols[0], gamma.symbols[0]), (system.parameters[5].symbol,))
    assert all_of.words(system) == "M changes sign"
    assert some.words(system) == "M₁, γ₁ change sign where c₁ = 0"
