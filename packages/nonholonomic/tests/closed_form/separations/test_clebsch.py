"""The Clebsch case at zero area constant, on the tori of the Neumann system."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from closed_form.followed import follow
from flowlanes.flow.integrator import integrate
from flowlanes.system.vectors import cross
from lawproof.proof.prover import prove
from nonholonomic.catalogue.e3 import Gamma, I, M
from nonholonomic.catalogue.fixed_point.clebsch import alpha, beta
from nonholonomic.closed_form.genus_two_solution import solve_on_torus
from nonholonomic.closed_form.separations.clebsch import clebsch_case

SEPARABLE = clebsch_case()
LAWS = {law.name: law for law in SEPARABLE.laws}
START = ("0.9", "-0.3", "-1.04", "0.48", "-0.64", "0.6")
MOMENTS = {"I_1": "2.1", "I_2": "1", "I_3": "1.5", "c": "0.8"}
#: Weights of both Hamiltonians; with β/α < 0 one coordinate turns where the other passes −α/β.
WEIGHTS = {
    "neumann": {"alpha": "1", "beta": "0"},
    "bruns": {"alpha": "0", "beta": "1"},
    "definite": {"alpha": "1", "beta": "0.7"},
    "indefinite": {"alpha": "1", "beta": "-0.7"},
}


@pytest.mark.parametrize("name", LAWS)
def test_proven(name):
    assert prove(SEPARABLE.system, LAWS[name]).decision == "proven"


def test_exchanged_weights_are_refuted():
    (flow,) = (law for law in SEPARABLE.laws if law.name == "flow")
    turned = {alpha: beta, beta: alpha}
    wrong = replace(flow, value=tuple(e.xreplace(turned) for e in flow.value))
    assert prove(SEPARABLE.system, wrong).decision == "refuted"


def test_without_the_level_is_refuted():
    (flow,) = (law for law in SEPARABLE.laws if law.name == "flow")
    assert prove(SEPARABLE.system, replace(flow, level=())).decision == "refuted"


@pytest.mark.parametrize("weights", WEIGHTS)
def test_own_rates_have_both_speeds(weights):
    spin = alpha * M + beta * (I * M)
    own = replace(SEPARABLE, turning=cross(Gamma, spin), along=None, state=((Gamma, Gamma),))
    follow(own, START, {**MOMENTS, **WEIGHTS[weights]})


def test_on_the_torus_of_neumann():
    neumann = replace(SEPARABLE, speeds=SEPARABLE.along)
    follow(neumann, START, {**MOMENTS, **WEIGHTS["indefinite"]})


@pytest.mark.parametrize("weights", WEIGHTS)
def test_closed_form(weights):
    numbers = {**MOMENTS, **WEIGHTS[weights]}
    values = {p.symbol: numbers[str(p.symbol)] for p in SEPARABLE.system.parameters}
    times = np.linspace(0.0, 40.0, 9)
    found = solve_on_torus(SEPARABLE, values, START).states(times)
    motion = integrate(SEPARABLE.system, [float(x) for x in START], times, parameters=numbers)
    assert np.abs(found - motion.states).max() < 1e-12
