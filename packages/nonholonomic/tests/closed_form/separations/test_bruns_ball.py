"""The Chaplygin ball in Bruns' field at zero area constant, separated."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from closed_form.followed import follow
from flowlanes.flow.integrator import integrate
from lawproof.proof.prover import prove
from nonholonomic.closed_form.genus_two_solution import solve_on_torus
from nonholonomic.closed_form.separations.bruns_ball import (
    chaplygin_ball_in_bruns_field,
    product,
    total,
)

SEPARABLE = chaplygin_ball_in_bruns_field()
LAWS = {law.name: law for law in SEPARABLE.laws}
#: M and γ with (M, γ) = 0.
START = ("2", "-0.3", "-1.92", "0.48", "-0.64", "0.6")
#: Moments in two orders, and both signs of the field.
NUMBERS = {
    "attracted": {"I_1": "1", "I_2": "1.5", "I_3": "2.1", "K": "0.7", "m": "1.2", "R": "0.9"},
    "repelled": {"I_1": "2.1", "I_2": "1", "I_3": "1.5", "K": "-0.4", "m": "1.2", "R": "0.9"},
}


@pytest.mark.parametrize("name", LAWS)
def test_proven(name):
    assert prove(SEPARABLE.system, LAWS[name]).decision == "proven"


@pytest.mark.parametrize("name", ["clock", "kinetic", "field"])
def test_sum_and_product_exchanged_are_refuted(name):
    law = LAWS[name]
    turned = {total: product, product: total}
    wrong = replace(law, value=tuple(e.xreplace(turned) for e in law.value))
    assert prove(SEPARABLE.system, wrong).decision == "refuted"


def test_lagrange_for_another_vector_is_refuted():
    law = LAWS["lagrange"]
    first, second, third = SEPARABLE.system.symbols[:3]
    wrong = replace(law, value=(law.value[1].xreplace({first: second, second: third}) + first,))
    assert prove(SEPARABLE.system, wrong).decision == "refuted"


def test_another_area_constant_is_refuted():
    assert prove(SEPARABLE.system, replace(LAWS["kinetic"], level=())).decision == "refuted"


@pytest.mark.parametrize("case", NUMBERS)
def test_along_a_motion(case):
    follow(SEPARABLE, START, NUMBERS[case])


@pytest.mark.parametrize("case", NUMBERS)
def test_closed_form(case):
    bare = replace(SEPARABLE.system, reconstruction=None, observables=(), guards=())
    reduced = replace(SEPARABLE, system=bare)
    values = {p.symbol: NUMBERS[case][str(p.symbol)] for p in bare.parameters}
    times = np.linspace(0.0, 20.0, 5)
    found = solve_on_torus(reduced, values, START).states(times)
    motion = integrate(bare, [float(x) for x in START], times, parameters=NUMBERS[case])
    assert np.abs(found - motion.states).max() < 1e-12
