"""The formulas of §2 by derivations of their own, in numbers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from borisov_mamaev_2008.methods.growth_vector import growth
from borisov_mamaev_2008.methods.rigid_body_in_space import COORDINATES
from borisov_mamaev_2008.section_01.section_01_3a import rational_rotation
from borisov_mamaev_2008.section_02.section_02_1 import PRINTED, b, ball_growth, field_of
from evaluation import numeric
from flowlanes.flow.integrator import integrate
from flowlanes.system.vectors import Vector, constant, cross, to_components
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.chaplygin_ball import chaplygin_suslov_ball
from nonholonomic.starts import initial_state

x, y, z, u, w = sp.symbols("x y z u w", real=True)
ONE = sp.S.One

KNOWN = {
    "a plane field that is integrable": ([{x: ONE, z: y}, {y: ONE, z: x}], (x, y, z), (2, 2)),
    "Heisenberg": ([{x: ONE}, {y: ONE, z: x}], (x, y, z), (2, 3, 3)),
    "Engel": ([{x: ONE}, {y: ONE, z: x, u: x**2 / 2}], (x, y, z, u), (2, 3, 4, 4)),
    "Cartan": (
        [{x: ONE}, {y: ONE, z: x, u: x**2 / 2, w: x * y}],
        (x, y, z, u, w),
        (2, 3, 5, 5),
    ),
}


@pytest.mark.parametrize("name", KNOWN)
def test_growth_of_known_distributions(name):
    fields, coordinates, expected = KNOWN[name]
    point = {s: sp.Rational(i + 1, 7) for i, s in enumerate(coordinates)}
    assert growth(fields, coordinates, point) == expected


def attitude_and_place() -> dict[sp.Symbol, sp.Expr]:
    numbers = (*rational_rotation().flat(), *(sp.Rational(n, 5) for n in (1, 2, 3)))
    return dict(zip(COORDINATES, numbers, strict=True))


def test_a_marble_ball_reaches_the_same_dimension_in_one_step():
    gamma, radius = Vector("gamma"), sp.Rational(3, 7)
    spins = [constant([int(i == axis) for i in range(3)]) for axis in range(3)]
    fields = [field_of((spin, to_components(radius * cross(spin, gamma)))) for spin in spins]
    assert growth(fields, COORDINATES, attitude_and_place()) == (3, 5, 5)


def test_the_printed_fields_span_five_dimensions_as_well():
    fields = [field_of(coefficients) for coefficients in PRINTED]
    counts = growth(fields, COORDINATES, attitude_and_place() | {b: sp.Rational(3, 7)})
    assert counts == ball_growth() == (2, 3, 5, 5)


def test_a_marble_ball_on_a_spring_swings_as_a_heavier_particle():
    entry = CATALOGUE["marble-ball"]
    motion = integrate(entry.system(), [1.0, 0.5, 1.0, -0.6, 0.2, 0.5], np.linspace(0.0, 9.0, 31))
    numbers = entry.defaults
    pace = np.sqrt(numbers["kappa"] / (numbers["m"] + numbers["mu"] / numbers["b"] ** 2))
    phase = pace * motion.times
    speed = numbers["b"] * np.array([0.2, 0.6])  # v = r×ω with r = (0, 0, -b)
    place = np.array([1.0, 0.5])
    expected = np.outer(np.cos(phase), place) + np.outer(np.sin(phase), speed) / pace
    np.testing.assert_allclose(motion["R"][:, :2], expected, atol=1e-13)


def test_a_rubber_ball_in_a_bowl_follows_a_particle_in_the_coordinates_of_the_plane():
    """Lagrange's equations of a particle of mass m + μ/b² on z = f(x, y)."""
    entry = CATALOGUE["rubber-ball-on-surface"]
    m, mu, radius, p, q, g = (entry.defaults[s] for s in ("m", "mu", "b", "p", "q", "g"))
    heavier = m + mu / radius**2
    xdot, ydot = sp.symbols("xdot ydot", real=True)
    bowl = x**2 / (2 * p) + y**2 / (2 * q)
    slope = sp.Matrix([bowl.diff(x), bowl.diff(y)])
    metric = heavier * (sp.eye(2) + slope * slope.T)
    speed = sp.Matrix([xdot, ydot])
    kinetic = (speed.T * metric * speed)[0] / 2
    momentum = metric * speed
    force = sp.Matrix([(kinetic - m * g * bowl).diff(s) for s in (x, y)])
    acceleration = metric.LUsolve(force - momentum.jacobian([x, y]) * speed)
    rate = sp.lambdify((x, y, xdot, ydot), [xdot, ydot, *acceleration])

    system = replace(entry.system(), reconstruction=None)
    start = entry.start.state
    state = [*start["R"], *start["omega"]]
    times = np.linspace(0.0, 5.0, 26)
    motion = integrate(system, state, times)
    velocity = numeric(system, Vector("v"))(np.array(state, dtype=float))
    first = [*start["R"][:2], *velocity[:2]]
    particle = solve_ivp(
        lambda t, s: rate(*s), (0.0, 5.0), first, "DOP853", times, rtol=1e-12, atol=1e-12
    )
    assert np.ptp(motion["R"][:, 0]) > 1
    np.testing.assert_allclose(motion["R"][:, :2], particle.y[:2].T, atol=1e-9)


def test_suslovs_constraint_on_a_rolling_ball_as_one_linear_system():
    """Ĩω̇ = Ĩω×ω − m r×(ω×ṙ) + λ₀e and (ω̇, e) = 0, solved for ω̇ and λ₀ together."""
    entry = CATALOGUE["chaplygin-suslov-ball"]
    system = entry.system()
    mass, radius = entry.defaults["m"], entry.defaults["R"]
    axis = np.array([entry.defaults[f"e_{i}"] for i in (1, 2, 3)])
    omega, gamma = np.array(entry.start.omega), np.array(entry.start.gamma)
    omega = omega - omega @ axis / (axis @ axis) * axis
    gamma = gamma / np.linalg.norm(gamma)
    r = -radius * gamma
    inertia = np.diag([entry.defaults[f"I_{i}"] for i in (1, 2, 3)])
    tensor = inertia + mass * (r @ r * np.eye(3) - np.outer(r, r))
    wander = -radius * np.cross(gamma, omega)
    free = np.cross(tensor @ omega, omega) - mass * np.cross(r, np.cross(omega, wander))
    left = np.block([[tensor, -axis[:, None]], [axis[None, :], np.zeros((1, 1))]])
    solution = np.linalg.solve(left, [*free, 0.0])
    formulas = [*system.rates[:3], chaplygin_suslov_ball.lambda_0]
    found = numeric(system, formulas)(np.concatenate([omega, gamma]))
    np.testing.assert_allclose(found, solution, rtol=1e-13)


@pytest.mark.parametrize("turn_rate", [(0.4, -0.9), (1.3, 0.2)])
def test_a_ball_that_does_not_turn_about_a_principal_axis_turns_uniformly(turn_rate):
    system = CATALOGUE["chaplygin-suslov-ball"].system({"e_1": 0.0, "e_2": 0.0, "e_3": 1.0})
    start = initial_state(system, (*turn_rate, 0.0), (2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0))
    motion = integrate(system, start, np.linspace(0.0, 20.0, 21))
    assert np.ptp(motion["gamma"], axis=0).min() > 0.1
    assert np.ptp(motion["omega"], axis=0).max() < 1e-14
    kept = {law.name for law in system.integrals}
    assert kept == {"energy", "omega_1", "omega_2", "spin"}
