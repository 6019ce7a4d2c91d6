"""The hollow ball around a sphere in Bruns' field at zero linear integral, separated."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from closed_form.followed import follow
from flowlanes.flow.integrator import integrate
from lawproof.proof.prover import prove
from nonholonomic.closed_form.genus_two_solution import solve_on_torus
from nonholonomic.closed_form.separations.bruns_sphere import WEIGHT, hollow_ball_in_bruns_field

SEPARABLE = hollow_ball_in_bruns_field()
LAWS = {law.name: law for law in SEPARABLE.laws}
#: M and n with (AM, n) = 0 for A = (1.6, 1, 0.5) in the order of each case.
STARTS = {
    "attracted": ("1.25", "-0.3", "-3.84", "0.48", "-0.64", "0.6"),
    "repelled": ("-3.84", "1.25", "-0.3", "0.6", "0.48", "-0.64"),
}
BALL = {"m": "1.25", "R": "0.8", "a": "0.4"}
NUMBERS = {
    "attracted": {"I_1": "0.7", "I_2": "1.3", "I_3": "1.8", "K": "0.7", **BALL},
    "repelled": {"I_1": "1.8", "I_2": "0.7", "I_3": "1.3", "K": "-0.4", **BALL},
}


SLOW = {"reconstruction", "constants"}


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.slow if n in SLOW else ()) for n in LAWS]
)
def test_proven(name):
    assert prove(SEPARABLE.system, LAWS[name]).decision == "proven"


def test_another_weight_is_refuted():
    law = LAWS["field"]
    first = SEPARABLE.system.parameters[1].symbol
    wrong = replace(law, value=tuple(e + first * WEIGHT for e in law.value))
    assert prove(SEPARABLE.system, wrong).decision == "refuted"


@pytest.mark.parametrize("case", NUMBERS)
def test_along_a_motion(case):
    follow(SEPARABLE, STARTS[case], NUMBERS[case])


@pytest.mark.slow
@pytest.mark.parametrize("case", NUMBERS)
def test_closed_form(case):
    bare = replace(SEPARABLE.system, reconstruction=None, observables=(), guards=())
    # R = 2a holds for these numbers
    reduced = replace(SEPARABLE, system=bare, level=SEPARABLE.level[1:])
    values = {p.symbol: NUMBERS[case][str(p.symbol)] for p in bare.parameters}
    times = np.linspace(0.0, 20.0, 5)
    found = solve_on_torus(reduced, values, STARTS[case]).states(times)
    start = [float(x) for x in STARTS[case]]
    motion = integrate(bare, start, times, parameters=NUMBERS[case])
    assert np.abs(found - motion.states).max() < 1e-12
