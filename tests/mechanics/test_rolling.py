"""Motions and instants of rolling bodies against the independent reference."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings

import reference
from chaplygin.flow.trajectory import integrate
from mechanics.bodies import COMBINATIONS as COMBINED
from mechanics.bodies import portrait, state_of
from mechanics.compare import (
    begin,
    deviations,
    draw,
    equations,
    instant_of_package,
    instant_of_reference,
    told_by_package,
    told_by_reference,
    worst,
)
from mechanics.portrait import coordinates, directions

SHAPES = ("ball centred", *reference.SHAPES)

COMBINATIONS = [
    (shape, support, contact, inertia)
    for shape in SHAPES
    for support in reference.SUPPORTS
    for contact in reference.CONTACTS
    for inertia in reference.INERTIAS
    if shape != "hollow ball" or support == "outside"
]

FLAT_SHAPES = ("disk", "torus")

TIMES = np.linspace(0.0, 10.0, 11)


def prepare(shape, support, contact, inertia, seed):
    """A case, the package's equations and its start; a full inertia tensor comes loaded."""
    drawn = draw(shape, support, contact, inertia, seed, loaded=inertia == "turned")
    system = equations(drawn)
    case, state = begin(drawn, system)
    return case, system, state


def compare_motions(case, system, state):
    trajectory = integrate(system, state, TIMES, on_liftoff="warn")
    assert len(trajectory.times) == len(TIMES)
    return deviations(told_by_package(trajectory), told_by_reference(case, case.run(TIMES)))


@pytest.fixture(scope="module", params=COMBINATIONS, ids="-".join)
def prepared(request):
    return prepare(*request.param, seed=1)


def test_instant_agrees_with_reference(prepared):
    case, system, state = prepared
    found = instant_of_package(system, state)
    deviation = deviations(found, instant_of_reference(case, system, state))
    assert worst(deviation) < 1e-11, deviation


def test_motion_agrees_with_reference(prepared):
    deviation = compare_motions(*prepared)
    assert worst(deviation) < 1e-10, deviation


@pytest.mark.slow
@pytest.mark.parametrize("seed", [2, 3, 4])
@pytest.mark.parametrize("names", COMBINATIONS, ids="-".join)
def test_more_motions_agree_with_reference(names, seed):
    deviation = compare_motions(*prepare(*names, seed))
    assert worst(deviation) < 1e-10, deviation


# ---------------------------------------------------------------------------------------------
# Whatever rolls: what every motion keeps


@pytest.mark.parametrize("contact", reference.CONTACTS)
@pytest.mark.parametrize(("shape", "surface"), COMBINED)
@given(omega=coordinates, gamma=directions, zeta=directions)
@settings(max_examples=25, deadline=None)
def test_energy_and_relations_are_kept(shape, surface, contact, omega, gamma, zeta):
    one = portrait(shape, surface, contact)
    assume(shape not in FLAT_SHAPES or np.hypot(gamma[0], gamma[1]) > 0.1)
    state = state_of(one, 3 * omega, gamma, zeta)
    here, rates = one.at(state), one.along(state)
    size = 1 + max(np.abs(here[f"rate of {name}"]).max() for name in one.system.state)
    for name in [name for name in here if name.startswith("relation")]:
        assert abs(here[name][0]) < 1e-12
        assert abs(rates[name][0]) < 1e-11 * size
    assert abs(rates["energy"][0]) < 1e-11 * size * (1 + abs(here["energy"][0]))
