"""The Neumann system, separated."""

from __future__ import annotations

import numpy as np
import pytest

from closed_form.followed import follow, refused
from flowlanes.flow.integrator import integrate
from lawproof.proof.prover import prove
from nonholonomic.closed_form.genus_two_solution import solve_on_torus
from nonholonomic.closed_form.separations.neumann import neumann_system

SEPARABLE = neumann_system()
LAWS = {law.name: law for law in SEPARABLE.laws}
START = ("0.9", "-0.3", "-1.04", "0.48", "-0.64", "0.6")
#: Moments in two orders, and both signs of the strength.
CASES = {
    "attracted": {"I_1": "1", "I_2": "1.5", "I_3": "2.1", "c": "0.8"},
    "repelled": {"I_1": "2.1", "I_2": "1", "I_3": "1.5", "c": "-1.7"},
}
PLANTED = {
    "leading": ("separation", {"leading": -SEPARABLE.leading}),
    "root": ("separation", {"roots": (*SEPARABLE.roots[:3], *SEPARABLE.roots[3:][::-1][:1] * 2)}),
    "weight": ("separation", {"weights": SEPARABLE.weights[::-1]}),
    "speeds": ("separation", {"speeds": SEPARABLE.speeds[::-1]}),
    "turning": ("direction", {"turning": -SEPARABLE.turning}),
}


@pytest.mark.parametrize("name", LAWS)
def test_proven(name):
    assert prove(SEPARABLE.system, LAWS[name]).decision == "proven"


@pytest.mark.parametrize("slip", PLANTED)
def test_a_slip_is_refuted(slip):
    law, changes = PLANTED[slip]
    assert refused(SEPARABLE, law, **changes) == "refuted"


@pytest.mark.parametrize("case", CASES)
def test_along_a_motion(case):
    follow(SEPARABLE, START, CASES[case])


@pytest.mark.parametrize("case", CASES)
def test_closed_form(case):
    values = {p.symbol: CASES[case][str(p.symbol)] for p in SEPARABLE.system.parameters}
    times = np.linspace(0.0, 40.0, 9)
    found = solve_on_torus(SEPARABLE, values, START).states(times)
    start = [float(x) for x in START]
    motion = integrate(SEPARABLE.system, start, times, parameters=CASES[case])
    assert np.abs(found - motion.states).max() < 1e-12
