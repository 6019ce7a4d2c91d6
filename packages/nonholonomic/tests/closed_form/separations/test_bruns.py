"""The Veselova system and the rubber ball in Bruns' field, separated."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from closed_form.followed import follow, refused
from flowlanes.flow.integrator import integrate
from lawproof.proof.prover import prove
from nonholonomic.closed_form.genus_two_solution import solve_on_torus
from nonholonomic.closed_form.separations.bruns import (
    rubber_ball_in_bruns_field,
    veselova_in_bruns_field,
)

SYSTEMS = {of.name: of for of in (veselova_in_bruns_field(), rubber_ball_in_bruns_field())}
VESELOVA = SYSTEMS["veselova-bruns"]
LAWS = {f"{name} {law.name}": (of, law) for name, of in SYSTEMS.items() for law in of.laws}
#: (ω, γ) = 0.
START = ("0.9", "-0.3", "-1.04", "0.48", "-0.64", "0.6")
#: Moments in two orders, and both signs of the field.
NUMBERS = {
    "attracted": {"I_1": "1", "I_2": "1.5", "I_3": "2.1", "K": "0.7", "m": "1.2", "R": "0.9"},
    "repelled": {"I_1": "2.1", "I_2": "1", "I_3": "1.5", "K": "-0.4", "m": "1.2", "R": "0.9"},
}
CASES = [f"{name} {numbers}" for name in SYSTEMS for numbers in NUMBERS]
PLANTED = {
    "without the field": (
        "separation",
        {"roots": (*VESELOVA.roots[:4], *(sp.S.Zero,) * 2)},
    ),
    "leading": ("separation", {"leading": 2 * VESELOVA.leading}),
    "time_rescaling": ("direction", {"time_rescaling": 1 / VESELOVA.time_rescaling}),
    "fixed": ("fixed_1", {"fixed": (VESELOVA.state[0][0],)}),
}


def chosen(case):
    """A system and its numbers."""
    name, numbers = case.split()
    names = {str(p.symbol) for p in SYSTEMS[name].system.parameters}
    return SYSTEMS[name], {key: x for key, x in NUMBERS[numbers].items() if key in names}


@pytest.mark.parametrize("name", LAWS)
def test_proven(name):
    of, law = LAWS[name]
    assert prove(of.system, law).decision == "proven"


@pytest.mark.parametrize("slip", PLANTED)
def test_a_slip_is_refuted(slip):
    law, changes = PLANTED[slip]
    assert refused(VESELOVA, law, **changes) == "refuted"


@pytest.mark.parametrize("case", CASES)
def test_along_a_motion(case):
    of, parameters = chosen(case)
    follow(of, START, parameters)


@pytest.mark.parametrize("case", CASES)
def test_closed_form(case):
    of, parameters = chosen(case)
    reduced = replace(of, system=replace(of.system, reconstruction=None, observables=(), guards=()))
    values = {p.symbol: parameters[str(p.symbol)] for p in of.system.parameters}
    times = np.linspace(0.0, 20.0, 5)
    found = solve_on_torus(reduced, values, START).states(times)
    motion = integrate(reduced.system, [float(x) for x in START], times, parameters=parameters)
    assert np.abs(found - motion.states).max() < 1e-12
