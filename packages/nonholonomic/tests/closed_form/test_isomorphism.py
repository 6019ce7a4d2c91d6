"""Closed forms carried over the isomorphisms of Theorems 8 and 10 and Proposition 6."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from flint import ctx

from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.formulas.balls import ball, ball_values
from flowlanes.system.laws import Identity
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.vectors import to_components
from lawproof.proof.prover import prove
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form.genus_two.separation_laws import separation_laws
from nonholonomic.closed_form.genus_two_solution import BITS, solve_on_torus
from nonholonomic.closed_form.isomorphism import inverse, inverse_identity, pull_back, push_forward
from nonholonomic.closed_form.separations.chaplygin_ball import chaplygin_ball
from nonholonomic.closed_form.separations.clebsch import clebsch_case
from nonholonomic.closed_form.separations.fedorov import fedorov
from nonholonomic.closed_form.separations.neumann import neumann_system
from nonholonomic.closed_form.separations.veselova import veselova

#: System, isomorphism, the target as it separates, and a start on the level.
CASES = {
    "Theorem 8": ("veselova", "neumann", neumann_system, (0.9, -0.3, -1.04, 0.48, -0.64, 0.6)),
    "Theorem 10": (
        "chaplygin-ball",
        "clebsch_case",
        clebsch_case,
        (2, -0.3, -1.92, 0.48, -0.64, 0.6),
    ),
    "Fedorov": ("chaplygin-ball", "fedorov", fedorov, (2, -0.3, -1.92, 0.48, -0.64, 0.6)),
    "Proposition 6": (
        "veselova-geodesic-flow",
        "clebsch",
        clebsch_case,
        (2, -0.3, -1.92, 0.48, -0.64, 0.6),
    ),
}
#: The same with what separates on the near side.
FORTH = {"Theorem 8": veselova, "Theorem 10": chaplygin_ball, "Fedorov": chaplygin_ball}
TIMES = np.linspace(0.0, 60.0, 7)


def bare(system):
    """Without its motion in space."""
    return replace(system, reconstruction=None, observables=(), guards=())


def given(case):
    """System, law, target, start."""
    name, law, target, start = CASES[case]
    system = from_catalogue(name)
    (found,) = (each for each in system.laws if each.name == law)
    return bare(system), found, target(), start


def image(system, law, start):
    """The parameters of the target, and the image of a start, as balls."""
    with ctx.workprec(BITS):
        known = {symbol: ball(Fraction(str(x))) for symbol, x in system.defaults.items()}
        known |= {s: ball(Fraction(str(x))) for s, x in zip(system.symbols, start, strict=True)}
        for symbol, formula in system.scalar_definitions:
            known[symbol] = ball_values([formula], known)[0]
        constants = {p: ball_values([to_components(f)], known)[0] for p, f in law.constants}
        shared = {p.symbol: known.get(p.symbol) for p in law.target.parameters}
        return {**shared, **constants}, ball_values([f for _, f in flat_pairs(law.map)], known)


@pytest.mark.parametrize("case", CASES)
def test_inverse_is_proven(case):
    system, law, _, _ = given(case)
    assert prove(system, inverse_identity(system, law)).decision == "proven"


def test_another_inverse_is_refuted():
    system, law, _, _ = given("Theorem 10")
    images = dict(flat_pairs(law.map))
    wrong = {**inverse(system, law), system.symbols[3]: law.target.symbols[3]}
    claim = Identity("wrong", tuple(wrong[s].xreplace(images) - s for s in system.symbols))
    assert prove(system, claim).decision == "refuted"


VESELOVA = pull_back(*given("Theorem 8")[:3])


@pytest.mark.parametrize("law", separation_laws(VESELOVA), ids=lambda law: law.name)
def test_veselova_by_way_of_neumann_is_proven(law):
    assert prove(VESELOVA.system, law).decision == "proven"


def test_another_clock_is_refuted():
    wrong = replace(VESELOVA, time_rescaling=1 / VESELOVA.time_rescaling)
    (law,) = (each for each in separation_laws(wrong) if each.name == "direction")
    assert prove(VESELOVA.system, law).decision == "refuted"


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_back_from_the_target(case):
    system, law, target, start = given(case)
    found = solve_on_torus(pull_back(system, law, target), system.defaults, start).states(TIMES)
    motion = integrate(system, start, TIMES)
    assert np.abs(found - motion.states).max() < 1e-12


@pytest.mark.parametrize(
    "case", ["Theorem 8", "Theorem 10", pytest.param("Fedorov", marks=pytest.mark.slow)]
)
def test_forth_to_the_target(case):
    system, law, target, start = given(case)
    near = replace(FORTH[case](), system=system)
    parameters, begin = image(system, law, start)
    pushed = push_forward(system, law, near)
    found = solve_on_torus(pushed, {**pushed.system.defaults, **parameters}, begin).states(TIMES)
    own = solve_on_torus(replace(target, system=bare(target.system)), parameters, begin).states(
        TIMES
    )
    assert np.abs(found - own).max() < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("case", ["Theorem 8", "Theorem 10"])
def test_both_sides_agree(case):
    system, law, target, start = given(case)
    near = solve_on_torus(replace(FORTH[case](), system=system), system.defaults, start)
    carried = solve_on_torus(pull_back(system, law, target), system.defaults, start)
    late = np.array([0.0, 1e3, 1e4])
    assert np.abs(near.states(late) - carried.states(late)).max() < 1e-10


def test_a_map_of_another_kind_is_refused():
    system = from_catalogue("chaplygin-ball-gyrostat")
    (law,) = (each for each in system.laws if each.name == "hamiltonian_form")
    place = law.map[1]
    wrong = replace(law, map=(law.map[0], (place[0], place[1] + law.map[0][1])))
    with pytest.raises(InputError, match="no explicit inverse"):
        inverse(system, wrong)
