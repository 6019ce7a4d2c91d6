"""Homogeneous balls of the catalogue: laws for every kind of surface, numbers known beforehand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from catalogue import built
from flowlanes.flow.integrator import integrate
from lawproof.proof.prover import prove
from lawproof.search import integrals, search_space
from mechanics.balls import SURFACES, on
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.ball_laws import known_ball_laws
from nonholonomic.starts import initial_state

BALLS = tuple(name for name, item in CATALOGUE.items() if item.ball is not None)

#: Names of the laws known of a heavy ball with gravity along the axis, and of one free of forces.
MARBLE = {
    ("plane", "support"): ({"spin"}, {"spin"}),
    ("sphere", "support"): (
        {"spin", "vertical", "meridian"},
        {"spin", "momentum_x", "momentum_y", "momentum_z", "meridian"},
    ),
    ("cylinder", "support"): ({"rotation", "swing", "oscillation"},) * 2,
    ("elliptic cylinder", "support"): ({"rotation"},) * 2,
    ("cone", "support"): ({"rotation", "ray"},) * 2,
    ("cone", "centre"): ({"rotation", "ray"},) * 2,
    ("ellipsoid", "support"): (set(), set()),
    ("ellipsoid", "centre"): (set(), {"quadratic"}),
    ("lens", "support"): ({"meridian"},) * 2,
    ("lens", "centre"): ({"meridian"}, {"meridian", "quadratic"}),
    ("bowl", "centre"): ({"quadratic"},) * 2,
    ("round bowl", "support"): ({"meridian"},) * 2,
    ("round bowl", "centre"): (
        {"meridian", "linear_first", "linear_second", "linear_product", "quadratic"},
    )
    * 2,
    ("saddle", "centre"): ({"quadratic"},) * 2,
    ("torus", "support"): ({"meridian"},) * 2,
    ("quartic", "centre"): (set(), set()),
}


@pytest.mark.slow
@pytest.mark.parametrize(("case", "names"), MARBLE.items(), ids=map("-".join, MARBLE))
@pytest.mark.parametrize("side", ["outside", "inside"])
@pytest.mark.parametrize("axis", ["x", "z"])
def test_what_is_known_of_a_marble_ball_is_proven(case, names, side, axis):
    name, carrier = case
    surface = replace(SURFACES[name], side=side, axis=axis)
    down = tuple(-float(letter == axis) for letter in "xyz")
    for gravity, expected in zip((9.81, 0.0), names, strict=True):
        ball = on(surface, carrier=carrier, gravity=gravity, direction=down)
        system, laws = ball.system(), known_ball_laws(ball)
        assert {law.name for law in laws} == expected
        assert {prove(system, law).decision for law in laws} <= {"proven"}


@pytest.mark.slow
@pytest.mark.parametrize("side", ["outside", "inside"])
@pytest.mark.parametrize("name", SURFACES)
def test_what_is_known_of_a_rubber_ball_is_proven(name, side):
    ball = on(replace(SURFACES[name], side=side), carrier="centre", contact="rubber", gravity=0.0)
    system = ball.system()
    assert {prove(system, law).decision for law in known_ball_laws(ball)} <= {"proven"}


def test_gravity_across_the_axis_breaks_the_laws_of_revolution():
    for name in ("cylinder", "cone", "torus", "bowl"):
        ball = on(SURFACES[name], carrier="centre", direction=(1.0, 0.0, 0.0))
        assert known_ball_laws(ball) == ()


def test_a_potential_of_the_user_leaves_no_law():
    ball = on(SURFACES["sphere"])
    assert known_ball_laws(replace(ball, potential=ball.height)) == ()


def trajectory(name):
    made = built.example(name)
    return integrate(made.system, made.start, np.linspace(0.0, CATALOGUE[name].start.until, 401))


def test_a_solid_ball_in_a_pipe_oscillates_at_the_root_of_two_sevenths():
    found = trajectory("marble-ball-on-cylinder")
    centre, times = found.records["centre"], np.asarray(found.times)
    turn = np.unwrap(np.arctan2(centre[:, 1], centre[:, 0]))[-1] / times[-1]
    rate = abs(turn) * np.sqrt(2 / 7)
    height = centre[:, 2]
    lowest = -9.81 / 1.4 / rate**2
    np.testing.assert_allclose(height, 1.0 + lowest * (1 - np.cos(rate * times)), atol=1e-11)


def test_a_rubber_ball_in_a_pipe_falls():
    pipe = CATALOGUE["marble-ball-on-cylinder"].rolling_ball()
    ball, times = replace(pipe, contact="rubber"), np.linspace(0.0, 2.0, 21)
    system = ball.system()
    start = initial_state(ball, (0.0, 0.0, -16.0), place=(2.0, 0.0, 0.0))
    centre = integrate(system, start, times).records["centre"]
    np.testing.assert_allclose(centre[:, 2], -9.81 / 1.4 * times**2 / 2, atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("name", BALLS)
def test_the_ball_stays_in_touch_and_on_its_surface(name):
    found = trajectory(name)
    assert not found.events
    gap = found.records["centre"] - found.records["contact"]
    radius = CATALOGUE[name].defaults["b"]
    np.testing.assert_allclose(np.linalg.norm(gap, axis=1), radius, rtol=1e-12)
    turned = np.cross(found.records["omega"], gap)
    np.testing.assert_allclose(turned, found.records["velocity"], atol=1e-10)


FOUND = {
    "marble-ball-on-cone": ({"degree": 1, "gamma_degree": 1}, {"ray", "rotation"}),
    "marble-ball-on-cylinder": ({"degree": 1, "gamma_degree": 1}, {"swing", "rotation"}),
    "marble-ball-on-ellipsoid": (
        {"gamma_degree": 4, "at": ("kappa=0", "a_1=1", "a_2=2", "a_3=3")},
        {"energy", "quadratic"},
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize(("name", "asked"), FOUND.items(), ids=list(FOUND))
def test_the_search_finds_the_integrals_and_no_others(name, asked):
    options, expected = asked
    system = CATALOGUE[name].system()
    question = search_space(system, momenta="omega", coordinates="R", **options)
    found = list(integrals(question))
    assert all(finding.proven for finding in found)
    assert {finding.catalogue_law.split(",")[0] for finding in found} == expected
