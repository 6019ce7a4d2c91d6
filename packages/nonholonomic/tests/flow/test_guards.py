"""Where the equations end: falling flat, leaving the surface, leaving the convex part."""

from __future__ import annotations

from dataclasses import replace

import mpmath
import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import reference
from evaluation import numeric
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.system import Guard, System
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, rolling_system
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere
from nonholonomic.starts import initial_state

X, Y, Z = ImplicitShape.coordinates
G = 9.81


def guard_values(system: System, name: str):
    """A guard as a function of states (n, size), computed without the integrator."""
    (guard,) = (guard for guard in system.guards if guard.name == name)
    at = numeric(system, [guard.value])
    return lambda states: at(np.asarray(states).T)[0]


def falls(function, span: tuple[float, float]) -> list[float]:
    """Where a function of time falls through zero, in the order of `span`."""
    times = np.linspace(*span, 4001)
    values = function(times)
    places = np.flatnonzero((values[:-1] > 0) & (values[1:] <= 0))
    return [
        brentq(lambda t: function(np.array([t]))[0], times[i], times[i + 1], xtol=1e-15, rtol=1e-15)
        for i in places
    ]


# --- falling flat ----------------------------------------------------------------------------

INERTIA = (0.25, 0.25, 0.5)
DISK = rolling_system(Body(1.0, INERTIA, Disk(1.0)), field=Forces(G))
LEAN = (0.8, 0.0, 0.6)


def time_of_fall() -> float:
    """A disk let go falls as a rod hinged at the contact: energy gives dt in the tilt."""
    with mpmath.workdps(30):
        first, last = mpmath.asin(mpmath.mpf("0.8")), mpmath.asin(mpmath.mpf("1e-6"))
        # tilt = first − s², which takes the root away from the start
        rate = mpmath.sqrt(2 * mpmath.mpf("9.81") / mpmath.mpf("1.25"))

        def integrand(s: mpmath.mpf) -> mpmath.mpf:
            fallen = 2 * mpmath.cos(first - s**2 / 2) * mpmath.sin(s**2 / 2)
            return 2 * s / (rate * mpmath.sqrt(fallen)) if s else integrand(mpmath.mpf("1e-20"))

        return float(mpmath.quad(integrand, [0, mpmath.sqrt(first - last)]))


@pytest.mark.parametrize("sense", [1, -1], ids=["forward", "backward"])
def test_a_disk_let_go_falls_flat_on_time(sense):
    start = initial_state(DISK, (0, 0, 0), LEAN)
    motion = integrate(DISK, start, sense * np.linspace(0.0, 5.0, 51))
    (message,) = motion.events
    assert message.guard.name == "flat"
    assert message.is_terminal
    assert message.time == motion.times[-1]
    assert sense * message.time == pytest.approx(time_of_fall(), abs=1e-11)
    assert np.hypot(*motion["gamma"][-1, :2]) == pytest.approx(1e-6, rel=1e-6)
    assert sense * motion.times[-2] == 0.5
    assert str(message) == (
        f"t = {message.time:.17g}: the body lies flat (tilt below 1e-06 rad); the run ends there"
    )


def test_a_guard_of_ones_own_is_passed_when_the_reference_says():
    """A spinning disk leans below 1/√10, by the package and by another integrator."""
    omega = (0.3, 0.4, 2.0)
    g_1, g_2, _ = sp.symbols("gamma_1:4", real=True)
    low = Guard("low", g_1**2 + g_2**2 - sp.Rational(1, 10), "it leans")
    leaning = replace(DISK, guards=(*DISK.guards, low))
    independent = reference.Rolling(
        reference.Body(1.0, np.diag(INERTIA), reference.Disk(1.0)),
        reference.Plane(),
        "marble",
        reference.Forces(G),
    )
    first = independent.state(
        {"omega": omega, "gamma": LEAN, "attitude": reference.attitude_with_normal(LEAN)}
    )

    def lean(_: float, y: np.ndarray) -> float:
        gamma = independent.instant(y).gamma
        return float(gamma[0] ** 2 + gamma[1] ** 2 - 0.1)

    lean.terminal = True
    found = solve_ivp(
        independent.rate, (0, 5), first, "DOP853", events=lean, rtol=1e-13, atol=1e-14
    )
    motion = integrate(leaning, initial_state(leaning, omega, LEAN), [0.0, 5.0])
    (message,) = motion.events
    assert message.guard == low
    assert message.time == pytest.approx(found.t_events[0][0], abs=1e-10)


def test_a_disk_that_lies_flat_is_refused():
    with pytest.raises(InputError, match="the body lies flat"):
        integrate(DISK, initial_state(DISK, (0, 0, 0), (1e-7, 0, 1)), [0.0, 1.0])


# --- leaving the surface ---------------------------------------------------------------------

RADIUS, DOME = 0.5, 2.0


def dome(inertia: tuple[float, float, float]) -> System:
    return rolling_system(Body(1.0, inertia, Ball(RADIUS)), Sphere(DOME), field=Forces(G))


SMOOTH = dome((0.1, 0.1, 0.1))
ROUGH = dome((0.08, 0.1, 0.13))
TILT = 0.1


def on_the_dome(system: System, omega=(0.0, 0.0, 0.0)):
    normal = (np.sin(TILT), 0.0, np.cos(TILT))
    return initial_state(system, omega, (0.36, -0.48, 0.8), normal=normal)


def test_a_homogeneous_ball_leaves_the_dome_at_the_textbook_angle():
    """From rest at the angle θ₀ a homogeneous ball lifts off where cos θ = (10/17) cos θ₀."""
    motion = integrate(SMOOTH, on_the_dome(SMOOTH), np.linspace(0.0, 10.0, 101), dense=True)
    (message,) = motion.events
    assert message.guard.name == "contact"
    assert message.is_terminal
    assert message.time == motion.times[-1]
    cosine = motion["contact"][-1, 2] / DOME
    assert cosine == pytest.approx(10 / 17 * np.cos(TILT), abs=1e-12)
    assert motion["normal_force"][-1] == pytest.approx(0.0, abs=1e-12)
    assert np.all(motion["normal_force"][:-1] > 0)


@pytest.mark.parametrize("system", [SMOOTH, ROUGH], ids=["homogeneous", "not homogeneous"])
def test_lift_off_is_found_to_the_last_digits(system):
    """The same instant, by Newton's law for the centre of the ball and by a root on dense output.

    The centre moves on a sphere, so that N = m g cos θ − m v²/(a + R).
    """
    start = on_the_dome(system, (0.3, -0.4, 0.2))
    motion = integrate(system, start, [0.0, 5.0], on_liftoff="warn", dense=True)
    names = {str(symbol): i for i, symbol in enumerate(motion.system.symbols)}
    moments = np.array([system.defaults[sp.Symbol(f"I_{i}", real=True)] for i in (1, 2, 3)])

    def pressure(state: np.ndarray) -> float:
        momentum, gamma, zeta = (
            state[[names[f"{name}_{i}"] for i in (1, 2, 3)]] for name in ("M", "gamma", "zeta")
        )
        # M = (I + R²) ω − R² γ (γ, ω) for unit mass
        tensor = np.diag(moments + RADIUS**2) - RADIUS**2 * np.outer(gamma, gamma)
        velocity = RADIUS * np.cross(np.linalg.solve(tensor, momentum), gamma)
        return G * gamma @ zeta - velocity @ velocity / (DOME + RADIUS)

    exact = falls(
        lambda times: np.array([pressure(state) for state in motion.dense(times)]),
        motion.dense.span,
    )
    found = [message.time for message in motion.events]
    assert found
    assert found == pytest.approx(exact, abs=1e-12)


def test_lift_off_stops_or_warns():
    times = np.linspace(0.0, 3.0, 31)
    start = on_the_dome(ROUGH)
    stop, warn = (integrate(ROUGH, start, times, on_liftoff=wish) for wish in ("stop", "warn"))
    (stopped,), (warned,) = stop.events, warn.events
    assert stopped.time == warned.time == stop.times[-1] < 3.0
    assert stopped.is_terminal and not warned.is_terminal
    assert str(stopped).endswith("the normal force changes sign; the run ends there")
    assert str(warned).endswith("the normal force changes sign; the run continues")
    assert warn.times.tolist() == times.tolist()
    assert np.all((warn["normal_force"] > 0) == (times < warned.time))
    before = len(stop.times) - 1
    assert warn.states[:before].tolist() == stop.states[:before].tolist()


def test_a_body_that_is_not_pressed_at_the_start():
    start = on_the_dome(ROUGH, (20.0, 0.0, 0.0))
    stop, warn = (
        integrate(ROUGH, start, [0.0, 0.1, 0.2], on_liftoff=wish) for wish in ("stop", "warn")
    )
    assert stop.times.tolist() == [0.0]
    assert stop.events[0].time == warn.events[0].time == 0.0
    assert stop.events[0].is_terminal and not warn.events[0].is_terminal
    assert warn.times.tolist() == [0.0, 0.1, 0.2]
    assert warn["normal_force"][0] < 0


LOADED = rolling_system(
    Body(1.0, (0.4, 0.45, 0.5), Ball(1.0, centre=(0.3, -0.2, 0.1))), field=Forces(G)
)


@pytest.mark.parametrize("until", [6.0, -6.0])
def test_every_loss_of_contact_is_noted_and_no_return(until):
    """A loaded ball spun fast presses and pulls in turn."""
    start = initial_state(LOADED, (8.0, 6.0, 1.0), (0.36, -0.48, 0.8))
    motion = integrate(LOADED, start, [0.0, until], on_liftoff="warn", dense=True)
    value = guard_values(motion.system, "contact")
    exact = falls(lambda times: value(motion.dense(times)), motion.dense.span)
    found = [message.time for message in motion.events]
    assert len(exact) > 3
    assert found == pytest.approx(exact, abs=1e-12)


def test_a_guard_costs_no_accuracy():
    start = initial_state(LOADED, (8.0, 6.0, 1.0), (0.36, -0.48, 0.8))
    motion = integrate(LOADED, start, np.linspace(0.0, 6.0, 61), on_liftoff="warn")
    energy = motion.records["law_energy"]
    assert np.abs(energy - energy[0]).max() < 1e-14 * energy[0]


# --- leaving the convex part -----------------------------------------------------------------

# an oval of Cassini turned about its long axis, with a waist
FOCUS, WIDTH = sp.Rational(19, 20), sp.Rational(5, 4)
ACROSS = Y**2 + Z**2
PEANUT = ImplicitShape(
    sp.expand(((X - FOCUS) ** 2 + ACROSS) * ((X + FOCUS) ** 2 + ACROSS)) - WIDTH**4
)
PEANUT_BODY = Body(1.0, (0.4, 0.9, 0.9), PEANUT)


def total_curvature(point: np.ndarray) -> float:
    """Curvature of the peanut in one of its points, by differences of its profile y(x)."""
    x = sp.Symbol("x")
    radius = sp.sqrt(-(x**2) - FOCUS**2 + sp.sqrt(4 * FOCUS**2 * x**2 + WIDTH**4))
    slope, bend = (float(sp.diff(radius, x, n).subs(x, point[0])) for n in (1, 2))
    return -bend / (float(radius.subs(x, point[0])) * (1 + slope**2) ** 2)


@pytest.mark.parametrize("surface", [Plane(), Sphere(5.0)], ids=["plane", "dome"])
@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize("sense", [1, -1], ids=["forward", "backward"])
def test_an_implicit_body_rolls_on_to_its_waist(surface, contact, sense):
    """On a plane the contact point runs away at the waist, yet the end is found and named."""
    system = rolling_system(PEANUT_BODY, surface, contact)
    up = np.array((-0.7, 0.1, 0.7)) / np.sqrt(0.99)
    spin = np.array((0.1, 2.0, 0.0))
    if contact == "rubber":
        spin -= (spin @ up) * up
    start = initial_state(system, spin, up)
    motion = integrate(system, start, sense * np.linspace(0.0, 9.0, 91), dense=True)
    (message,) = motion.events
    assert message.guard.name == "convex"
    assert str(message).endswith(
        "the contact leaves the convex part of the body; the run ends there"
    )
    assert message.is_terminal
    assert motion.times[-1] == message.time
    assert motion.dense.span[1] == message.time
    # the curvature is a root of the time that is left, where the equations are singular
    slack = 1e-6 if surface == Plane() else 1e-12
    assert total_curvature(motion["r"][-1]) == pytest.approx(0.0, abs=slack)
    assert total_curvature(motion["r"][0]) > 0.1
    energy = motion.records["law_energy"]
    assert np.abs(energy[:-1] - energy[0]).max() < 1e-13 * energy[0]


def test_a_body_of_revolution_rolls_on_to_its_cusp():
    """p = 1 + 6u²/5 has the radius of curvature p − u p′ = 1 − 6u²/5 along the parallel."""
    u = sp.Symbol("gamma_3", real=True)
    system = rolling_system(
        Body(1.0, (0.5, 0.5, 0.6), ShapeOfRevolution(1 + sp.Rational(6, 5) * u**2))
    )
    start = initial_state(system, (0.5, 0.1, 0.2), (0.1, 0.9, 0.2))
    motion = integrate(system, start, np.linspace(0.0, 30.0, 301), dense=True)
    (message,) = motion.events
    assert message.guard.name == "convex"
    assert abs(motion["gamma"][-1, 2]) == pytest.approx(np.sqrt(5 / 6), abs=1e-14)
    index = motion.system.symbols.index(u)
    times = np.linspace(*motion.dense.span, 2001)
    assert np.all(np.abs(motion.dense(times)[:-1, index]) < np.sqrt(5 / 6))


def test_an_ellipsoid_rolls_on_to_where_the_bowl_is_too_narrow():
    shape = Ellipsoid((1.0, 1.0, 0.4))
    system = rolling_system(Body(1.0, (0.25, 0.25, 0.3), shape), Sphere(2.0, side="inside"))
    start = initial_state(system, (1.0, 0.0, 0.0), (0.0, 1.0, 0.1))
    motion = integrate(system, start, np.linspace(0.0, 30.0, 301))
    (message,) = motion.events
    assert message.guard.name == "fits"
    assert str(message).endswith(
        "the body does not fit into the sphere at the contact; the run ends there"
    )
    # the larger principal radius of curvature there is the radius of the bowl
    across, along = 1.0, 0.4
    u = motion["gamma"][-1, 2]
    reach = np.sqrt(across**2 * (1 - u**2) + along**2 * u**2)
    radii = (across**2 / reach, across**2 * along**2 / reach**3)
    assert max(radii) == pytest.approx(2.0, abs=1e-4)


def test_a_guard_may_be_the_same_in_every_state():
    """A ball given by its support function is convex everywhere; its second guard is watched."""
    u = sp.Symbol("gamma_3", real=True)
    inertia, start = (0.08, 0.1, 0.13), ((0.3, -0.4, 0.2), (0.36, -0.48, 0.8))
    shapes = Ball(RADIUS), ShapeOfRevolution(sp.Rational(1, 2) + 0 * u)
    ends = []
    for shape in shapes:
        system = rolling_system(Body(1.0, inertia, shape), Sphere(DOME), field=Forces(G))
        state = initial_state(system, *start, normal=(np.sin(TILT), 0.0, np.cos(TILT)))
        ends.append(integrate(system, state, [0.0, 5.0]))
    one, other = ends
    assert one.events[0].guard.name == other.events[0].guard.name == "contact"
    assert one.times[-1] == pytest.approx(other.times[-1], abs=1e-13)


@pytest.mark.parametrize(
    ("shape", "surface", "gamma", "message"),
    [
        (Ellipsoid((1.0, 1.0, 0.4)), Sphere(2.0, side="inside"), (0.0, 0.1, 1.0), "does not fit"),
        (
            ShapeOfRevolution(1 + sp.Rational(6, 5) * sp.Symbol("gamma_3", real=True) ** 2),
            Plane(),
            (0.0, 0.35, 0.94),
            "leaves the convex part",
        ),
        (Disk(1.0), Sphere(2.0, side="inside"), (0.0, 1e-8, 1.0), "lies flat"),
    ],
    ids=["narrow bowl", "cusp", "flat"],
)
def test_a_start_outside_the_domain_is_refused(shape, surface, gamma, message):
    system = rolling_system(Body(1.0, (0.25, 0.25, 0.3), shape), surface)
    with pytest.raises(InputError, match=message):
        integrate(system, initial_state(system, (1, 0, 0), gamma), [0.0, 1.0])
