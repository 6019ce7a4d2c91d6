"""Plans against integrations of equations written here."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from flowlanes.errors import InputError, RunError
from nonholonomic.control import (
    MotionPlan,
    PlanePath,
    Rotor,
    SphericalRobot,
    controlled_system,
    driftless_system,
    figure_of_eight,
    motion_along,
    motion_without_spin,
    path_through,
    pendulum,
)
from nonholonomic.control.collocation import Transcription, radau
from nonholonomic.control.compiled_equations import CompiledEquations
from nonholonomic.control.guess import rotation

E = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
EIGHT = figure_of_eight(0.8, 0.4, 8.0)


def ball(count: int, contact: str = "marble") -> SphericalRobot:
    return SphericalRobot(
        1.0, (0.4, 0.5, 0.6), 1.0, tuple(Rotor(e, 0.1) for e in E[:count]), contact
    )


def shell() -> SphericalRobot:
    return SphericalRobot(1.0, (0.4, 0.4, 0.4), 1.0, moving_mass=pendulum(1.0, 0.5), gravity=9.81)


@cache
def small_plan(contact: str = "marble") -> MotionPlan:
    return motion_along(ball(2, contact), EIGHT, intervals=8, stages=3, iterations=1)


def hand_integrated(plan: MotionPlan, sign: float = 1.0) -> np.ndarray:
    """The contact at the end of each interval, by rotation matrices and ω = −(I + D − Dγγᵀ)⁻¹ K u.

    For a rubber ball ω = J⁻¹(μγ − Ku) with (ω, γ) = 0.  `sign` −1 plants a wrong sign of D.
    """
    robot = plan.robot
    K = np.array(robot.gyration, dtype=float)
    D = sign * robot.mass * robot.radius**2
    J = robot.tensor + abs(D) * np.eye(3)

    def rates(t: float, s: np.ndarray) -> np.ndarray:
        Q = s[:9].reshape(3, 3)
        up, k = Q[2], K @ plan.inputs_at(np.array([t]))[0]
        if robot.contact == "rubber":
            turn, lift = np.linalg.solve(J, k), np.linalg.solve(J, up)
            w = (up @ turn) / (up @ lift) * lift - turn
        else:
            w = -np.linalg.solve(J - D * np.outer(up, up), k)
        Omega = Q @ w
        hat = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
        place = robot.radius * np.array([Omega[1], -Omega[0]])
        return np.concatenate([(Q @ hat).ravel(), place])

    state = np.concatenate([rotation(plan.start[:4]).ravel(), plan.start[4:6]])
    places = []
    edges = np.linspace(0, plan.path.period, plan.intervals + 1)
    for begin, end in pairwise(edges):
        inner = (begin * (1 + 1e-15) + 1e-14, end * (1 - 1e-15))
        state = solve_ivp(rates, inner, state, method="DOP853", rtol=1e-9, atol=1e-11).y[:, -1]
        places.append(state[9:])
    return np.array(places)


def test_radau_integrates_polynomials_of_high_degree() -> None:
    for stages in (2, 3, 4, 6):
        c, a = radau(stages)
        assert c[-1] == 1.0
        for degree in range(2 * stages - 1):
            assert a[-1] @ c**degree == pytest.approx(1 / (degree + 1), abs=1e-13)
        assert abs(a[-1] @ c ** (2 * stages - 1) - 1 / (2 * stages)) > 1e-9


@pytest.mark.parametrize("robot", [ball(2, "rubber"), shell()], ids=["rubber", "pendulum"])
def test_the_tangents_of_the_collocation_are_exact(robot: SphericalRobot) -> None:
    system = driftless_system(robot) if robot.is_balanced else controlled_system(robot)
    n, m = len(system.state), len(system.inputs)
    problem = Transcription(CompiledEquations(system), EIGHT, [4, 5], 3, 3, {4: 0.0, 5: 0.0})
    rng = np.random.default_rng(1)
    state = np.zeros(n)
    state[0] = 1.0
    unknowns = problem.unknowns_of(state, np.tile(state, (9, 1)), np.zeros((9, m)))
    unknowns = unknowns + 0.1 * rng.normal(size=len(unknowns))
    direction, h = rng.normal(size=len(unknowns)), 1e-5
    ahead, behind = (problem.residuals(unknowns + s * h * direction) for s in (1, -1))
    slopes = problem.jacobian(unknowns) @ direction
    assert np.abs(slopes - (ahead - behind) / (2 * h)).max() < 1e-7 * np.abs(slopes).max()
    # attitude free: one condition, the length of the quaternion
    assert len(ahead) == 2 + 1 + 9 * (n + 2)


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_the_planned_speeds_lead_along_the_path(contact: str) -> None:
    plan = small_plan(contact)
    places = hand_integrated(plan)
    edges = np.linspace(0, 8, 9)[1:]
    assert np.linalg.norm(places - EIGHT.places(edges), axis=1).max() < 1e-2 * EIGHT.diameter
    # what the plan says of its own motion is what comes out here
    own = plan.states[8::8, 4:6]
    assert np.abs(own - places).max() < 1e-7
    if contact == "marble":
        assert np.abs(own - hand_integrated(plan, -1.0)).max() > 1e-3


@pytest.mark.slow
def test_the_error_decreases_with_the_order() -> None:
    errors = [
        motion_along(ball(2), EIGHT, intervals=20, stages=s, iterations=1).relative_error
        for s in (3, 5)
    ]
    assert errors[1] < errors[0] / 50


@pytest.mark.slow
def test_the_optimiser_lowers_the_effort_of_three_rotors() -> None:
    path = figure_of_eight(2.0, 1.0, 8.0)
    first, better = (
        motion_along(ball(3), path, intervals=20, stages=5, iterations=n) for n in (1, 40)
    )
    assert better.effort < 0.999 * first.effort
    assert max(first.relative_error, better.relative_error) < 1e-4


@pytest.mark.slow
def test_a_free_attitude_leads_two_rotors_where_a_given_one_does_not() -> None:
    path = figure_of_eight(1.0, 0.5, 10.0)
    with pytest.raises(InputError, match="another attitude"):
        motion_along(ball(2), path, intervals=20, stages=4)
    plan = motion_along(ball(2), path, attitude=None, intervals=20, stages=4, iterations=60)
    assert plan.relative_error < 1e-4
    assert np.linalg.norm(plan.start[:4]) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.slow
def test_a_pendulum_leads_a_shell_and_swings_before_it_moves() -> None:
    path = figure_of_eight(1.0, 0.5, 12.0)
    plan = motion_along(shell(), path, intervals=30, stages=5, iterations=60)
    assert plan.relative_error < 1e-6
    # hanging at rest does not do: the joints at the start lean already
    assert np.abs(plan.start[-2:]).max() > 1e-3


def test_inputs_are_polynomials_through_the_nodes() -> None:
    plan = small_plan()
    assert np.abs(plan.inputs_at(plan.node_times[:-1] - 1e-9) - plan.node_inputs[:-1]).max() < 1e-7
    assert "u_1, u_2" in str(plan)


def test_a_plan_is_recorded_like_other_trajectories() -> None:
    data = small_plan().to_dataset()
    assert {"attitude", "contact", "centre", "gamma", "input", "path_error"} <= set(data)
    assert float(data["path_error"].max()) == small_plan().path_error
    assert all("units" in data[name].attrs for name in data)


@pytest.mark.slow
def test_a_path_by_points_is_followed() -> None:
    angles = np.linspace(0, 2 * np.pi, 9)
    points = 0.2 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    plan = motion_along(ball(3), path_through(points, 6.0), intervals=8, stages=3, iterations=1)
    assert plan.relative_error < 1e-2
    assert np.allclose(plan.start[4:6], [0.2, 0.0])


@pytest.mark.slow
def test_without_spin_three_rotors_have_speeds_in_closed_form() -> None:
    path = figure_of_eight(2.0, 1.0, 8.0)
    plan = motion_without_spin(ball(3), path, intervals=30, stages=6)
    assert plan.relative_error < 1e-6
    K = np.array(plan.robot.gyration, dtype=float)
    for i in (40, 90, 130):
        Q, v = rotation(plan.states[i, :4]), path.velocities(plan.times[i : i + 1])[0]
        w = np.array([-v[1], v[0], 0.0]) @ Q
        speeds = -np.linalg.solve(K, (plan.robot.tensor + np.eye(3)) @ w)
        assert np.abs(plan.inputs_at(plan.times[i : i + 1])[0] - speeds).max() < 1e-4


MISTAKES = {
    "spin of two rotors": (lambda: motion_without_spin(ball(2), EIGHT), "three rotors"),
    "spin of rubber": (lambda: motion_without_spin(ball(3, "rubber"), EIGHT), "three rotors"),
    "one rotor": (lambda: motion_along(ball(1), EIGHT), "one input"),
    "eccentric": (
        lambda: motion_along(
            SphericalRobot(
                1.0, (0.4, 0.5, 0.6), 1.0, tuple(Rotor(e, 0.1) for e in E), centre=(0.1, 0, 0)
            ),
            EIGHT,
        ),
        "beside the geometric centre",
    ),
    "intervals": (lambda: motion_along(ball(2), EIGHT, intervals=1), "at least 2 intervals"),
    "attitude": (lambda: motion_along(ball(2), EIGHT, attitude=(1, 0, 0)), "quaternion"),
    "zero attitude": (lambda: motion_along(ball(2), EIGHT, attitude=(0, 0, 0, 0)), "quaternion"),
    "robot": (lambda: motion_along("ball", EIGHT), "SphericalRobot"),
    "path": (lambda: motion_along(ball(2), "eight"), "PlanePath"),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_is_answered_in_one_sentence(name: str) -> None:
    call, part = MISTAKES[name]
    with pytest.raises(InputError) as refused:
        call()
    assert part in str(refused.value)


@pytest.mark.slow
def test_a_pendulum_refuses_a_path_that_is_too_fast() -> None:
    path = PlanePath("sin(6*pi*t)", "1 - cos(6*pi*t)", 1.0)
    with pytest.raises(RunError, match="no motion along the path was found"):
        motion_along(shell(), path, intervals=10, stages=3, iterations=15)
