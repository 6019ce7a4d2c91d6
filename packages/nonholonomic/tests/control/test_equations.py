"""Equations of driven balls against Newton's and Euler's laws for each of their parts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

import flowlanes
import lawproof
import nonholonomic
from flowlanes.errors import InputError
from flowlanes.formulas.array_formulas import Formulas
from flowlanes.system.vectors import cross
from nonholonomic.control import (
    MovingMass,
    Rotor,
    SphericalRobot,
    controlled_system,
    driftless_system,
    driven_system,
    pendulum,
)
from nonholonomic.control.compiled_equations import CompiledEquations
from nonholonomic.control.equations import M, b, gamma, omega, rho, rhodot
from nonholonomic.starts import initial_state

t = sp.Symbol("t", real=True)


def body(rng: np.random.Generator, contact: str, parts: str) -> SphericalRobot:
    """A random ball with two rotors, and a moving mass or an eccentric centre if asked for."""
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    inertia = turn @ np.diag([0.4, 0.55, 0.7]) @ turn.T
    inertia = np.round((inertia + inertia.T) / 2, 3)
    rotors = tuple(Rotor(tuple(np.round(rng.normal(size=3), 2)), 0.1) for _ in range(2))
    return SphericalRobot(
        1.3,
        tuple(map(tuple, inertia.tolist())),
        0.9,
        rotors,
        contact,
        pendulum(0.6, 0.5) if "mass" in parts else None,
        (0.1, -0.05, 0.2) if "eccentric" in parts else (0.0, 0.0, 0.0),
        9.81 if parts else 0.0,
    )


INPUTS = {"u_1": "sin(2*t)", "u_2": "t**2 - 1"}
RATES = {"theta_rate": "cos(3*t)", "phi_rate": "t/2"}


def accelerations(
    system: flowlanes.System, state: np.ndarray, robot: SphericalRobot
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """ω̇ along the field of a system, and quantities with their rates, from its formulas."""
    names = {"gamma": gamma, "omega": omega, "b": b}
    if robot.moving_mass is not None:
        names |= {"rho": rho, "rhodot": rhodot}
    formulas = [s for v in names.values() for s in v.symbols]
    values = Formulas(system, formulas)(state).reshape(-1, 3)
    flow = Formulas(system, system.rates)(state)
    rates = (Formulas(system, formulas).slopes(state) @ flow).reshape(-1, 3)
    known = dict(zip(names, values, strict=True))
    known |= {f"{n}'": r for n, r in zip(names, rates, strict=True)}
    return known["omega'"], known


def newton_euler(
    robot: SphericalRobot, known: dict[str, np.ndarray], u: np.ndarray, udot: np.ndarray
) -> np.ndarray:
    """ω̇ from the laws of shell and mass, with the contact force F and the inner force f."""

    def hat(v: np.ndarray) -> np.ndarray:
        return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])

    I, R, m, w, up = robot.tensor, robot.radius, robot.mass, known["omega"], known["gamma"]
    a, g = -np.array(robot.centre), robot.gravity
    K = np.array(robot.gyration, dtype=float)
    k, kdot = K @ u, K @ udot
    rows, right = [], []
    # unknowns: ω̇, F, f, λ; the centre's acceleration is R ω̇×γ
    O, E = np.zeros((3, 3)), np.eye(3)
    centre = -R * hat(up)
    zero = np.zeros((3, 1))
    spot = known.get("rho", np.zeros(3))
    rows.append(np.hstack([m * (centre - hat(a)), -E, E, zero]))
    right.append(-m * g * up - m * np.cross(w, np.cross(w, a)))
    rows.append(np.hstack([I, -hat(-R * up - a), hat(spot - a), -up[:, None]]))
    right.append(-np.cross(w, I @ w + k) - kdot)
    if robot.moving_mass is not None:
        mu = robot.moving_mass.mass
        drift, gain = known["rhodot"], known["rhodot'"]
        rows.append(np.hstack([mu * (centre - hat(spot)), O, -E, zero]))
        right.append(
            -mu * g * up - mu * (np.cross(w, np.cross(w, spot)) + 2 * np.cross(w, drift) + gain)
        )
    else:
        rows.append(np.hstack([O, O, E, zero]))
        right.append(np.zeros(3))
    last = np.zeros((1, 10))
    if robot.contact == "rubber":
        last[0, :3] = up
    else:
        last[0, 9] = 1.0
    rows.append(last)
    right.append(np.zeros(1))
    return np.linalg.solve(np.vstack(rows), np.concatenate(right))[:3]


@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize(
    "parts",
    [
        "",
        pytest.param("mass", marks=pytest.mark.slow),
        pytest.param("eccentric", marks=pytest.mark.slow),
        "mass eccentric",
    ],
)
def test_angular_acceleration_is_that_of_newton_and_euler(contact: str, parts: str) -> None:
    rng = np.random.default_rng(5)
    robot = body(rng, contact, parts)
    inputs = {**INPUTS, **(RATES if robot.moving_mass else {})}
    system = driven_system(robot, inputs)
    up = rng.normal(size=3)
    up /= np.linalg.norm(up)
    momentum = rng.normal(size=3)
    if contact == "rubber":
        momentum -= (momentum @ up) * up
    joints = [0.3, -0.4] if robot.moving_mass else []
    state = np.array([*momentum, *up, *joints, 0.7])
    found, known = accelerations(system, state, robot)
    formulas = [sp.sympify(inputs[f"u_{i}"], {"t": t}) for i in (1, 2)]
    u, udot = (
        np.array([float(f.subs(t, 0.7)) for f in fs])
        for fs in (formulas, [f.diff(t) for f in formulas])
    )
    expected = newton_euler(robot, known, u, udot)
    assert np.abs(found - expected).max() < 1e-11 * np.abs(expected).max()
    if contact == "rubber":
        assert abs(known["omega"] @ up) < 1e-14
    # the comparison tells a wrong sign of the rotors' momentum
    assert np.abs(newton_euler(robot, known, -u, udot) - found).max() > 1e-3


@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_momentum_is_conserved_whatever_the_rotors_do(contact: str) -> None:
    rotors = (Rotor((1, 0, 0), 0.1), Rotor((0, 3, 4), 0.2))
    robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, rotors, contact)
    system = driven_system(robot, {"u_1": "sin(t) + gamma_1", "u_2": "M_2*t"})
    names = [law.name for law in system.laws]
    assert names == (["momentum", "area"] if contact == "marble" else ["momentum"])
    assert {lawproof.prove(system, name).decision for name in names} == {"proven"}


def test_a_wrong_sign_of_the_gyroscopic_term_is_refuted() -> None:
    robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, (Rotor((1, 0, 0), 0.1),))
    system = driven_system(robot, {"u_1": "sin(t)"})
    # (Aω − b)×ω, and not (Aω + b)×ω
    wrong = dict(system.field) | {M: cross(M - 2 * b, omega)}
    planted = replace(system, field=tuple(wrong.items()))
    assert lawproof.prove(planted, "momentum").decision == "refuted"
    assert lawproof.prove(system, "momentum").decision == "proven"


def test_rotors_at_constant_speed_are_the_gyrostat_of_a_body() -> None:
    robot = SphericalRobot(
        1.0, (0.4, 0.5, 0.6), 1.0, (Rotor((1, 0, 0), 0.1), Rotor((0, 0, 2), 0.2))
    )
    driven = driven_system(robot, {"u_1": "2", "u_2": "-3"})
    body = nonholonomic.Body(
        1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0), gyrostat=(0.2, 0.0, -0.6)
    )
    rolling = nonholonomic.rolling_system(body, nonholonomic.Plane(), "marble")
    up, turn = np.array([0.0, 0.6, 0.8]), np.array([1.0, 0.2, 0.1])
    inertia = np.diag([0.4, 0.5, 0.6]) + np.eye(3)
    momentum = inertia @ turn - (turn @ up) * up + np.array([0.2, 0.0, -0.6])
    state = np.concatenate([momentum, up])
    # the state of the rolling body is M without the rotors' share
    assert list(map(str, rolling.state)) == ["M", "gamma"]
    other = np.concatenate([momentum - [0.2, 0.0, -0.6], up])
    expected = Formulas(rolling, rolling.rates)(other)
    assert np.abs(Formulas(driven, driven.rates)(state) - expected).max() < 1e-15
    assert np.abs(expected[:3]).max() > 0.1


@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_a_start_by_angular_velocity_has_it(contact: str) -> None:
    robot = body(np.random.default_rng(7), contact, "mass eccentric")
    system = driven_system(robot, {**INPUTS, **RATES})
    up = np.array([0.0, 0.6, 0.8])
    turn = np.array([0.3, 0.8, -0.6]) if contact == "rubber" else np.array([0.3, 0.8, 0.6])
    start = initial_state(system, turn, 2 * up, t=0.4, theta=0.1, phi=0.2)
    state = np.array(start[: len(system.symbols)], dtype=float)
    assert np.abs(Formulas(system, list(omega.symbols))(state) - turn).max() < 1e-14
    if contact == "rubber":
        with pytest.raises(InputError, match="needs 0"):
            initial_state(system, (0, 0, 1), up, theta=0.1, phi=0.2)


def test_starts_that_say_too_little_or_too_much() -> None:
    robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, (Rotor((1, 0, 0), 0.1),))
    system = driven_system(robot, {"u_1": "M_1"})
    with pytest.raises(InputError, match="depend on M"):
        initial_state(system, (1, 0, 0), (0, 0, 1))
    with pytest.raises(InputError, match="no joint q"):
        initial_state(system, (1, 0, 0), (0, 0, 1), q=1.0)
    with pytest.raises(InputError, match="gamma is zero"):
        initial_state(system, (1, 0, 0), (0, 0, 0))
    with pytest.raises(InputError, match="three finite numbers"):
        initial_state(system, (1, 0), (0, 0, 1))
    swinging = driven_system(
        SphericalRobot(1.0, (0.4, 0.4, 0.4), 1.0, moving_mass=pendulum(1.0, 0.5)), RATES
    )
    with pytest.raises(InputError, match="theta, phi need a value"):
        initial_state(swinging, (1, 0, 0), (0, 0, 1))


def test_without_momentum_the_speeds_alone_set_the_rates() -> None:
    robot = SphericalRobot(
        2.0, (0.4, 0.5, 0.6), 0.5, (Rotor((1, 0, 0), 0.1), Rotor((0, 1, 0), 0.2))
    )
    system = driftless_system(robot)
    equations = CompiledEquations(system)
    upright = np.array([1.0, 0, 0, 0, 0, 0])
    points = np.array([[*upright, *u] for u in ((0, 0), (1, 0), (0, 1))])
    # upright, ω = −(I + D − Dγγᵀ)⁻¹ K u with D = 1/2: ω_1 = −0.1 u_1/0.9, ω_2 = −0.2 u_2/1, and
    # the contact moves with R(ω_2, −ω_1)
    expected = [[0] * 6, [0, -1 / 18, 0, 0, 0, 1 / 18], [0, 0, -0.1, 0, -0.1, 0]]
    assert np.abs(equations.rates(points) - expected).max() < 1e-15


MISTAKES = {
    "nothing inside": (lambda: SphericalRobot(1.0, (1, 1, 1), 1.0), "no rotor and no moving mass"),
    "dependent axes": (
        lambda: SphericalRobot(
            1.0, (1, 1, 1), 1.0, tuple(Rotor(e, 1.0) for e in ((1, 0, 0), (0, 1, 0), (1, 1, 0)))
        ),
        "linearly dependent",
    ),
    "four rotors": (
        lambda: SphericalRobot(
            1.0,
            (1, 1, 1),
            1.0,
            tuple(Rotor(e, 1.0) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1))),
        ),
        "linearly dependent",
    ),
    "axis zero": (lambda: Rotor((0, 0, 0), 1.0), "not all zero"),
    "inertia of rotor": (lambda: Rotor((0, 0, 1), -1.0), "positive"),
    "mass": (lambda: MovingMass(0.0, ("s", "0", "0"), ("s",), (0.0,)), "positive"),
    "joints idle": (
        lambda: MovingMass(1.0, ("s + q", "0", "0"), ("s", "q"), (0.0, 0.0)),
        "do not move it",
    ),
    "joint named twice": (lambda: MovingMass(1.0, ("s", "0", "0"), ("s", "s"), (0, 0)), "unlike"),
    "joint named t": (
        lambda: controlled_system(
            SphericalRobot(
                1.0, (1, 1, 1), 1.0, moving_mass=MovingMass(1.0, ("m", "0", "0"), ("m",), (0.0,))
            )
        ),
        "name of another variable",
    ),
    "driftless": (
        lambda: driftless_system(
            SphericalRobot(1.0, (1, 1, 1), 1.0, (Rotor((1, 0, 0), 1.0),), centre=(0.1, 0, 0))
        ),
        "does not stay zero",
    ),
    "no input": (
        lambda: driven_system(SphericalRobot(1.0, (1, 1, 1), 1.0, (Rotor((1, 0, 0), 1.0),)), {}),
        "the inputs are u_1",
    ),
    "unknown name": (
        lambda: driven_system(
            SphericalRobot(1.0, (1, 1, 1), 1.0, (Rotor((1, 0, 0), 1.0),)), {"u_1": sp.Symbol("q")}
        ),
        "uses q",
    ),
    "contact": (
        lambda: SphericalRobot(1.0, (1, 1, 1), 1.0, (Rotor((1, 0, 0), 1.0),), "glue"),
        "contact",
    ),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_is_answered_in_one_sentence(name: str) -> None:
    call, part = MISTAKES[name]
    with pytest.raises(InputError) as refused:
        call()
    assert part in str(refused.value)
    assert "\n" not in str(refused.value)
