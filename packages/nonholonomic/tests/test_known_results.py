"""Results that can be looked up, found again by the package."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq
from scipy.special import ellipk

from evaluation import drift, jacobian, numeric
from flowlanes.flow.integrator import integrate
from flowlanes.flow.trajectory import Trajectory
from flowlanes.system.system import System
from flowlanes.system.vectors import constant, cross, dot, norm_squared, vectors
from nonholonomic.catalogue import CATALOGUE, from_catalogue
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, rolling_system
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere
from nonholonomic.starts import initial_state

M, gamma, omega, r = vectors("M gamma omega r")
G = 9.81


def follow(
    system: System, spin: object, up: object, times: object, **options: object
) -> Trajectory:
    """The motion from ω and γ."""
    return integrate(system, initial_state(system, spin, up), times, **options)


def turned(motion: Trajectory, vector: np.ndarray) -> np.ndarray:
    """A vector along a motion, from body axes to space."""
    w, v = motion["attitude"][:, :1], motion["attitude"][:, 1:]
    twice = 2 * np.cross(v, vector)
    return vector + w * twice + np.cross(v, twice)


# --- a rolling disk stays upright when it is fast enough --------------------------------------

DISKS = {
    # radius, and the moments of inertia over ma²
    "uniform disk": (0.7, 1 / 4, 1 / 2),
    "hoop": (1.3, 1 / 2, 1.0),
    "wheel": (0.4, 0.3, 0.55),
}
MASS = 1.7


def disk(radius: float, across: float, along: float) -> System:
    moments = np.array([across, across, along]) * MASS * radius**2
    return rolling_system(Body(MASS, tuple(moments), Disk(radius)), field=Forces(G))


def square_of_growth(system: System, spin: float) -> float:
    """λ² of small deviations from rolling straight, from axes that do not take part in the spin.

    All other eigenvalues are zero: of six, four belong to neighbouring motions of the same kind.
    """
    field = numeric(system, system.rates)
    turn = np.kron(np.eye(2), spin * np.array([[0, -1, 0], [1, 0, 0], [0, 0, 0]]))
    state = np.array([float(x) for x in initial_state(system, (0, 0, spin), (1, 0, 0))[:6]])

    def seen(point: np.ndarray) -> np.ndarray:
        return field(point) + turn @ point

    assert np.abs(seen(state)).max() < 1e-13
    matrix = jacobian(seen, state)
    return float(np.trace(matrix @ matrix)) / 2


@pytest.mark.parametrize("name", DISKS)
def test_the_slowest_stable_roll_of_a_disk(name):
    """Ω² = m g a I₁ / (I₃ (I₃ + ma²)), which is g/(3a) for a uniform disk."""
    radius, across, along = DISKS[name]
    system = disk(*DISKS[name])
    slowest = brentq(lambda spin: square_of_growth(system, spin), 1.0, 20.0, xtol=1e-14, rtol=1e-14)
    exact = np.sqrt(G * across / (along * (along + 1)) / radius)
    assert slowest == pytest.approx(exact, rel=1e-12)
    if name == "uniform disk":
        assert slowest == pytest.approx(np.sqrt(G / (3 * radius)), rel=1e-12)


def test_a_small_lean_grows_below_that_speed_and_not_above():
    system = disk(*DISKS["uniform disk"])
    slowest = np.sqrt(G / (3 * DISKS["uniform disk"][0]))
    largest = []
    for factor in (0.8, 1.3):
        motion = follow(system, (0, 0, factor * slowest), (1, 0, 1e-8), np.linspace(0, 8, 161))
        largest.append(np.abs(motion["gamma"][:, 2]).max())
    slow, fast = largest
    assert slow > 1e-4
    assert fast < 1e-7


def test_the_slowest_stable_roll_seen_in_motions():
    """A small lean obeys z̈ = λ²z + b: z(2t) − z(0) is 2 + 2 cosh λt times z(t) − z(0)."""
    system = disk(*DISKS["uniform disk"])

    def excess(spin: float) -> float:
        lean = follow(system, (0, 0, spin), (1, 0, 1e-6), [0.0, 0.4, 0.8])["gamma"][:, 2]
        return (lean[2] - lean[0]) / (lean[1] - lean[0]) - 4

    assert excess(1.5) > 0 > excess(3.0)
    found = brentq(excess, 1.5, 3.0, xtol=1e-9)
    assert found == pytest.approx(np.sqrt(G / (3 * DISKS["uniform disk"][0])), rel=1e-6)


# --- the rattleback turns back ----------------------------------------------------------------


@pytest.mark.slow
def test_the_rattleback_has_a_direction_of_its_own():
    entry = CATALOGUE["rattleback"]
    system = entry.system()
    spins = []
    for sense in (-1, 1):
        motion = follow(system, (0, 0, sense * 5.0), entry.start.gamma, np.linspace(0, 8, 401))
        spins.append((motion["omega"] * motion["gamma"]).sum(axis=1))
        assert motion.events == ()
    wrong, right = spins
    assert wrong[0] < -4.9
    # within four seconds it has turned back; the other way it goes on
    assert wrong[200:].min() > 1.0
    assert wrong[-1] > 4.0
    assert right.min() > 2.0


# --- homogeneous balls are particles (§2.2, §2.3) ---------------------------------------------

RADIUS, BOWL = 0.3, 1.9
HOMOGENEOUS = Body(1.4, (0.4 * 1.4 * RADIUS**2,) * 3, Ball(RADIUS))


@pytest.mark.parametrize("gravity", [0.0, G])
@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_a_homogeneous_ball_on_a_plane_rolls_straight(contact, gravity):
    """Proposition 2 without a horizontal force: uniformly, and ω is constant in space."""
    system = rolling_system(HOMOGENEOUS, Plane(), contact, Forces(gravity))
    spin = (0.8, -0.4, -0.6) if contact == "rubber" else (0.7, 0.4, 1.1)
    times = np.linspace(0.0, 50.0, 51)
    motion = follow(system, spin, (0.36, -0.48, 0.8), times)
    turning = turned(motion, motion["omega"])
    assert np.abs(turning - turning[0]).max() < 1e-13
    velocity = RADIUS * np.cross(turning[0], [0.0, 0.0, 1.0])
    expected = motion["centre"][0] + times[:, None] * velocity
    assert np.abs(motion["centre"] - expected).max() < 1e-12


def bowl(contact: str) -> System:
    return rolling_system(HOMOGENEOUS, Sphere(BOWL, side="inside"), contact, Forces(G))


#: 5g/(7(|a| − R)), the square of the frequency of small oscillations in a bowl.
BOWL_SQUARE = 5 * G / (7 * (BOWL - RADIUS))


@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize(("angle", "slack"), [(1e-5, 1e-9), (1.2, 1e-12)])
def test_a_homogeneous_ball_in_a_bowl_swings_as_a_pendulum(contact, angle, slack):
    """Exactly so at every amplitude: the period is that of a pendulum, an elliptic integral."""
    period = 4 * ellipk(np.sin(angle / 2) ** 2) / np.sqrt(BOWL_SQUARE)
    if angle < 1e-4:
        assert period == pytest.approx(2 * np.pi / np.sqrt(BOWL_SQUARE), rel=1e-10)
    system = bowl(contact)
    start = initial_state(
        system, (0, 0, 0), (0.36, -0.48, 0.8), normal=(np.sin(angle), 0, np.cos(angle))
    )
    motion = integrate(system, start, period * np.array([0, 0.25, 0.5, 0.75, 1.0]))
    across = motion["contact"][:, 0] / (BOWL * np.sin(angle))
    assert across == pytest.approx([-1.0, 0.0, 1.0, 0.0, -1.0], abs=slack)


def test_a_homogeneous_rubber_ball_in_a_bowl_is_a_spherical_pendulum():
    """Proposition 3: its centre moves as a particle of mass m + μ/b² under the weight mg."""
    system = bowl("rubber")
    times = np.linspace(0.0, 10.0, 21)
    spin, up = (2.0, 1.0, -0.3), (0.36, -0.48, 0.8)
    spin -= np.dot(spin, up) * np.array(up)
    start = initial_state(system, spin, up, normal=(0.6, 0.0, 0.8))
    motion = integrate(system, start, times)
    length, pull = BOWL - RADIUS, np.array([0.0, 0.0, -5 * G / 7])

    def pendulum(_: float, state: np.ndarray) -> np.ndarray:
        place, velocity = state[:3], state[3:]
        string = (velocity @ velocity + pull @ place) / length**2
        return np.concatenate([velocity, pull - string * place])

    velocity = RADIUS * np.cross(turned(motion, motion["omega"])[0], [0.6, 0.0, 0.8])
    first = np.concatenate([motion["centre"][0], velocity])
    found = solve_ivp(pendulum, (0, 10), first, "DOP853", t_eval=times, rtol=1e-13, atol=1e-13)
    assert np.ptp(motion["centre"], axis=0).min() > 0.1
    assert np.abs(motion["centre"] - found.y[:3].T).max() < 1e-10


def test_a_homogeneous_ball_on_a_free_sphere_draws_a_circle():
    """Without forces the contact point of a marble ball goes around a circle uniformly."""
    system = rolling_system(HOMOGENEOUS, Sphere(1.1))
    motion = follow(system, (2.0, 1.0, 3.0), (0.36, -0.48, 0.8), np.linspace(0, 20, 201))
    steps = np.diff(motion["contact"], axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    assert np.ptp(lengths) < 1e-13
    axis = np.cross(steps[0], steps[1])
    heights = motion["contact"] @ axis / np.linalg.norm(axis)
    assert np.ptp(heights) < 1e-12
    assert np.ptp(motion["contact"], axis=0).min() > 0.1


# --- a ball with displaced centre of mass -----------------------------------------------------

SHIFT = 0.25
ROLY_POLY = Body(1.3, (0.4, 0.5, 0.45), Ball(0.8, centre=(0.0, 0.0, SHIFT)))


def test_small_oscillations_of_a_displaced_ball():
    """Frequencies √(m g d / (I + m(R − d)²)) about both horizontal axes, by linearisation."""
    system = rolling_system(ROLY_POLY, field=Forces(G))
    state = np.array([float(x) for x in initial_state(system, (0, 0, 0), (0, 0, 1))[:6]])
    matrix = jacobian(numeric(system, system.rates), state)
    found = np.sort(np.linalg.eigvals(matrix).imag)[-2:]
    exact = [
        np.sqrt(ROLY_POLY.mass * G * SHIFT / (moment + ROLY_POLY.mass * (0.8 - SHIFT) ** 2))
        for moment in (0.5, 0.4)
    ]
    assert found == pytest.approx(exact, rel=1e-12)


@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize(("angle", "slack"), [(1e-4, 1e-8), (2.0, 1e-12)])
def test_period_of_a_displaced_ball_rocking_in_a_plane(contact, angle, slack):
    """From the energy ½(I + m(R² + d² − 2Rd cos θ))θ̇² − m g d cos θ."""
    mass, radius, moment = ROLY_POLY.mass, 0.8, 0.4
    depth = np.sin(angle / 2)

    def integrand(u: float) -> float:
        cosine = 1 - 2 * (depth * np.sin(u)) ** 2
        inertia = moment + mass * (radius**2 + SHIFT**2 - 2 * radius * SHIFT * cosine)
        return np.sqrt(inertia / (1 - (depth * np.sin(u)) ** 2))

    period = 4 / np.sqrt(mass * G * SHIFT) * quad(integrand, 0, np.pi / 2, epsrel=1e-14)[0]
    linear = 2 * np.pi * np.sqrt((moment + mass * (radius - SHIFT) ** 2) / (mass * G * SHIFT))
    assert (abs(period / linear - 1) < 1e-8) == (angle < 0.1)
    system = rolling_system(ROLY_POLY, Plane(), contact, Forces(G))
    motion = follow(
        system,
        (0, 0, 0),
        (0, np.sin(angle), np.cos(angle)),
        period * np.array([0, 0.25, 0.5, 0.75, 1.0]),
        on_liftoff="warn",
    )
    lean = motion["gamma"][:, 1] / np.sin(angle)
    assert lean == pytest.approx([1.0, 0.0, -1.0, 0.0, 1.0], abs=slack)


def test_integrals_of_jellett_and_routh():
    """A heavy ball with its centre of mass on the axis of symmetry: two integrals linear in ω."""
    system = rolling_system(
        Body(1.3, (0.4, 0.4, 0.55), Ball(0.8, centre=(0.0, 0.0, SHIFT))), field=Forces(G)
    )
    I_1, I_3, m = sp.symbols("I_1 I_3 m", real=True)
    inertia = constant(sp.diag(I_1, I_1, I_3))
    jellett = dot(inertia * omega, r)
    r_1, r_2, r_3 = r.symbols
    routh = omega.symbols[2] * sp.sqrt(I_1 * I_3 + m * (I_1 * (r_1**2 + r_2**2) + I_3 * r_3**2))
    motion = follow(
        system, (0.7, 0.4, 5.0), (0.36, -0.48, 0.8), np.linspace(0, 20, 201), on_liftoff="warn"
    )
    found = numeric(motion.system, [jellett, routh, dot(M, gamma)])(motion.states.T)
    assert drift(found[0]) < 1e-13
    assert drift(found[1]) < 1e-13
    assert drift(found[2]) > 1e-3


# --- Chaplygin's ball -------------------------------------------------------------------------


def test_the_momentum_of_a_chaplygin_ball_is_fixed_in_space():
    entry = CATALOGUE["chaplygin-ball"]
    motion = follow(entry.system(), entry.start.omega, entry.start.gamma, np.linspace(0, 100, 101))
    momentum = turned(motion, motion["M"])
    assert np.abs(momentum - momentum[0]).max() < 5e-14


def test_rubber_chaplygin_ball_is_the_veselova_system():
    """§2.4: with J = I + mR² the same ω and γ at all times, and the same attitude."""
    mass, radius, moments = 1.4, 0.7, (1.0, 1.5, 2.1)
    names = ("I_1", "I_2", "I_3")
    ball = from_catalogue("rubber-chaplygin-ball", m=mass, R=radius)
    body = from_catalogue(
        "veselova", **dict(zip(names, (x + mass * radius**2 for x in moments), strict=True))
    )
    start = CATALOGUE["veselova"].start
    times = np.linspace(0.0, 100.0, 101)
    one, other = (follow(system, start.omega, start.gamma, times) for system in (ball, body))
    for name in ("omega", "gamma", "attitude"):
        assert np.abs(one[name] - other[name]).max() < 1e-12, name
    # what the Veselova system calls (Iω × γ)² is (M × γ)² of the ball
    claimed = numeric(one.system, [norm_squared(cross(M, gamma))])(one.states.T)[0]
    assert claimed == pytest.approx(other["law_momentum"], rel=1e-13)


# --- limits -----------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("side", [1, -1], ids=["outside", "inside"])
@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_a_very_large_sphere_is_a_plane(contact, side):
    """The difference goes to zero as one over the radius."""
    body = Body(1.3, (0.2, 0.35, 0.4), Ellipsoid((1.0, 0.8, 0.6), turn=0.2))
    up = np.array((0.36, -0.48, 0.8))
    spin = np.array((0.7, 0.4, 1.1))
    if contact == "rubber":
        spin -= (spin @ up) * up
    times = np.linspace(0.0, 5.0, 11)
    flat = follow(rolling_system(body, Plane(), contact, Forces(G)), spin, up, times)
    gaps = []
    for radius in (1e5, 1e6):
        system = rolling_system(body, Sphere.of_signed_radius(side * radius), contact, Forces(G))
        curved = follow(system, spin, up, times)
        gaps.append(max(np.abs(curved[name] - flat[name]).max() for name in ("omega", "gamma")))
    assert gaps[1] < 1e-4
    assert gaps[0] / gaps[1] == pytest.approx(10.0, rel=1e-3)


def test_a_round_ellipsoid_is_a_ball_and_a_thin_torus_a_disk():
    """Different formulas, one motion."""
    up, spin, times = (0.36, -0.48, 0.8), (0.7, 0.4, 1.1), np.linspace(0.0, 5.0, 11)
    centre = (0.1, -0.05, 0.2)
    shapes = Ball(0.8, centre=centre), Ellipsoid((0.8, 0.8, 0.8), turn=0.4, centre=centre)
    one, other = (
        follow(
            rolling_system(Body(1.3, (0.4, 0.5, 0.45), shape), field=Forces(G)),
            spin,
            up,
            times,
            on_liftoff="warn",
        )
        for shape in shapes
    )
    for name in ("omega", "gamma", "attitude", "contact", "normal_force"):
        assert np.abs(one[name] - other[name]).max() < 1e-11, name
