"""A homogeneous ball on any surface: against other derivations and itself."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from flowlanes.flow.integrator import integrate
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import Vector
from lawproof.proof.prover import prove, prove_all
from mechanics.balls import SURFACES, on
from nonholonomic.mechanics.ball.equations import ball_equations, ball_parameters, centre_surface
from nonholonomic.mechanics.ball.mechanism import ball_mechanism
from nonholonomic.mechanics.ball.surface import FlatSurface, ImplicitSurface, SphericalSurface
from nonholonomic.mechanics.lagrangian.poincare_suslov import equations_of_motion
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, rolling_system
from nonholonomic.mechanics.shapes.shapes import Ball
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere
from nonholonomic.starts import initial_state
from spread import spread

R = Vector("R")
TIMES = np.linspace(0.0, 1.5, 16)
CONTACTS = ("marble", "rubber")


def motion(ball, place, omega):
    system = ball.system()
    state = initial_state(ball, omega, place=place)
    return integrate(system, state, TIMES, on_liftoff="warn").records


@pytest.mark.slow
@pytest.mark.parametrize("contact", spread(CONTACTS))
def test_the_equations_follow_from_the_lagrangian(contact):
    # neither a sphere nor a quadric; with three fourth powers the proof costs more than its effort
    surface = R.symbols[0] ** 4 + R.symbols[1] ** 2 + R.symbols[2] ** 2 - 1
    potential = R.symbols[0] * R.symbols[2]
    numbers = ball_parameters(1.0, 0.4, 1.0)
    derived = equations_of_motion(ball_mechanism(contact, surface, potential, numbers))
    closed = ball_equations(contact, centre_surface(surface), -gradient(potential, R), numbers)
    same = Isomorphism("derived", closed, {s: s for s in closed.symbols})
    assert prove(derived, same).decision == "proven"


@pytest.mark.slow
@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize("radius", [None, 2.0, -2.0])
def test_it_moves_as_a_rolling_body_does(contact, radius):
    """On planes and spheres every body rolls, by equations in body axes derived elsewhere."""
    ground = Plane() if radius is None else Sphere.of_signed_radius(radius)
    body = Body(1.0, (0.036,) * 3, Ball(0.3))
    rolling = rolling_system(body, ground, contact, Forces(9.81))
    omega = (1.0, 6.0, 0.0 if contact == "rubber" else 4.0)
    up = (0.0, 0.0, 1.0)
    start = initial_state(rolling, omega, up, normal=up)
    theirs = integrate(rolling, start, TIMES, on_liftoff="warn").records
    side = "inside" if radius is not None and radius < 0 else "outside"
    surface = FlatSurface() if radius is None else SphericalSurface(abs(radius), side=side)
    place = (0.0, 0.0, 0.0 if radius is None else radius)
    ours = motion(on(surface, contact=contact), place, omega)
    for name in ("centre", "contact", "normal_force"):
        np.testing.assert_allclose(ours[name], theirs[name], atol=1e-10, rtol=1e-10)


@pytest.mark.slow
@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize("side", ["outside", "inside"])
@pytest.mark.parametrize("name", ["sphere", "cylinder", "torus"])
def test_both_ways_to_give_a_surface_agree(name, side, contact):
    """The contact point as state, by curvatures, and the centre as state, on a parallel surface."""
    made = SURFACES[name]
    known = type(made)(**{**vars(made), "side": side})
    numbers = {p.symbol: p.default for p in known.parameters}
    formula = made.equation(ImplicitSurface.coordinates).subs(numbers)
    place = {"sphere": (2.0, 0.0, 0.0), "cylinder": (2.0, 0.0, 0.0), "torus": (4.0, 0.0, 0.0)}
    omega = (0.0, 2.0, 5.0)
    unknown = on(ImplicitSurface(formula, side=side), contact=contact)
    first = motion(on(known, contact=contact), place[name], omega)
    second = motion(unknown, place[name], omega)
    for observed in ("centre", "contact", "velocity", "normal_force", "friction_force"):
        np.testing.assert_allclose(first[observed], second[observed], atol=1e-9, rtol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize("carrier", ["support", "centre"])
@pytest.mark.parametrize("name", [n for n in SURFACES if n != "waves"])
def test_energy_and_measure_are_proven(name, carrier, contact):
    system = on(SURFACES[name], carrier=carrier, contact=contact).system()
    assert [verdict.decision for verdict in prove_all(system)] == ["proven", "proven"]


@pytest.mark.parametrize("contact", CONTACTS)
def test_a_surface_that_is_no_polynomial_is_kept_as_an_integral(contact):
    system = on(SURFACES["waves"], contact=contact).system()
    assert len(system.relations) == (contact == "rubber")
    assert {v.law: v.decision for v in prove_all(system)} == {
        "energy": "proven",
        "volume": "proven",
        "surface": "proven",
    }


def test_the_sign_of_the_force_is_watched_only_under_forces():
    free = on(SURFACES["cone"], gravity=0.0).system()
    assert [guard.name for guard in free.guards] == ["fit", "apex"]
    heavy = on(SURFACES["cone"]).system()
    assert [guard.name for guard in heavy.guards] == ["contact", "fit", "apex"]


def test_gravity_may_point_anywhere():
    """On a plane that stands upright gravity acts along it, and the ball goes down as a disk."""
    fall = on(FlatSurface(axis="x"), carrier="centre", contact="rubber")
    state = initial_state(fall, (0.0, 0.0, 0.0), place=(0.0, 0.0, 0.0))
    found = integrate(fall.system(), state, TIMES, on_liftoff="warn").records["centre"]
    heavier = 1.0 + 0.036 / 0.3**2
    np.testing.assert_allclose(found[:, 2], -9.81 / heavier * TIMES**2 / 2, atol=1e-12)
    tilted = on(FlatSurface(), direction=(1.0, 0.0, -1.0)).system()
    assert {str(p.symbol) for p in tilted.parameters} >= {"e_1", "e_3"}
    share = {str(p.symbol): p.default for p in tilted.parameters}["e_1"]
    assert share == pytest.approx(float(mpmath.sqrt(0.5)))
