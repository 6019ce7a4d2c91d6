"""Initial guesses of a motion along a path, for the optimisation."""

from __future__ import annotations

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ..mechanics.rotations import rotation_rows
from .collocation import Transcription
from .robot import MovingMass, SphericalRobot

SINGULAR = 1e-3
"""Smallest singular value of B_xy, relative to the largest at the start, that is accepted."""
TOLERANCE = 1e-8
"""Tolerance of the integration of a guess."""


def least_inputs(
    plan: Transcription,
    start: FloatArray,
    spin: float | None = None,
    tolerance: float = TOLERANCE,
) -> tuple[FloatArray, FloatArray, float]:
    """States and inputs of a driftless system that follow a path with minimal |u| at each time.

    With rates B(z) u, and B_xy the two rows of the output, u = B_xy⁺ v: the unique inputs if there
    are only two, and those of minimal norm at each instant if there are more.  A prescribed spin
    about the vertical adds a third row and determines three inputs.

    Returns
    -------
    states : array (k, n)
        States at the nodes.
    inputs : array (k, m)
    reached : float
        The time up to which the path was followed; beyond it the last state is repeated, at rest.
    """
    equations, path = plan.equations, plan.path
    wanted = [] if spin is None else [spin]

    def rows(z: FloatArray) -> FloatArray:
        fields = _fields(plan, z)
        turns = _spins(z, fields)[None] if wanted else np.empty((0, equations.inputs))
        return np.concatenate([fields[plan.output], turns])

    best = float(np.linalg.svd(rows(start))[1][0])

    def least(t: float, z: FloatArray) -> FloatArray:
        inverse = np.linalg.pinv(rows(z))
        speeds: FloatArray = inverse @ [*path.velocities([t])[0], *wanted]
        return speeds

    def margin(_: float, z: FloatArray) -> float:
        return float(np.linalg.svd(rows(z))[1][-1]) - SINGULAR * best

    margin.terminal = True  # type: ignore[attr-defined]
    run = solve_ivp(
        lambda t, z: _fields(plan, z) @ least(t, z),
        (0.0, path.period),
        start,
        method="DOP853",
        rtol=tolerance,
        atol=tolerance,
        events=margin,
        dense_output=True,
    )
    reached = float(run.t[-1])
    states = np.array([run.sol(min(t, reached)) for t in plan.times])
    inputs = np.array(
        [
            least(t, z) if t <= reached else np.zeros(equations.inputs)
            for t, z in zip(plan.times, states, strict=True)
        ]
    )
    return states, inputs, reached


def _fields(plan: Transcription, state: FloatArray) -> FloatArray:
    """B of ż = B(z) u, for a driftless system."""
    points = np.hstack([np.tile(state, (plan.equations.inputs, 1)), np.eye(plan.equations.inputs)])
    return plan.equations.rates(points).T


def _spins(state: FloatArray, fields: FloatArray) -> FloatArray:
    """(ω, γ) of each field, from the rates of the quaternion."""
    w, x, y, z = state[:4]
    # ω in space axes is twice the vector part of q̇ q̄; (ω, γ) is its third component
    spins: FloatArray = 2 * (w * fields[3] - z * fields[0] + x * fields[2] - y * fields[1])
    return spins


def motion_with_lowest_mass(
    robot: SphericalRobot, mass: MovingMass, plan: Transcription, attitude: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """A motion without spin along the path, with the moving mass at its lowest position.

    Returns
    -------
    start : array (n,)
    states : array (k, n)
        States at the nodes, with the momentum of this motion.
    inputs : array (k, m)
    """
    path, radius = plan.path, robot.radius

    def rolling(t: float, q: FloatArray) -> FloatArray:
        x, y = path.velocities([t])[0]
        return _product(np.array([0.0, -y / radius, x / radius, 0.0]), q) / 2

    run = solve_ivp(
        rolling,
        (0.0, path.period),
        attitude,
        method="DOP853",
        rtol=1e-9,
        atol=1e-9,
        dense_output=True,
    )
    times = np.append(0.0, plan.times)
    turns = run.sol(times).T
    turns /= np.linalg.norm(turns, axis=1, keepdims=True)
    joints = _lowest(mass, turns)
    speeds = np.gradient(joints, times, axis=0)
    matrices = np.array([rotation(q) for q in turns])
    velocity = path.velocities(times)
    space = np.stack([-velocity[:, 1], velocity[:, 0], 0 * times], axis=1) / radius
    omega = np.einsum("kij,ki->kj", matrices, space)
    inputs = np.hstack([np.zeros((len(times), len(robot.rotors))), speeds])
    states = np.hstack(
        [turns, path.places(times), _momenta(robot, mass, matrices, omega, joints, speeds), joints]
    )
    return states[0], states[1:], inputs[1:]


def _lowest(mass: MovingMass, turns: FloatArray) -> FloatArray:
    """Joint values of the lowest position of the mass, continued by Newton's method."""
    up = sp.symbols("up_1:4", real=True)
    height = sum((p * g for p, g in zip(mass.formulas, up, strict=True)), sp.S.Zero)
    slope = sp.Matrix([height]).jacobian(mass.symbols)
    hessian = sp.hessian(height, mass.symbols)
    numbers = sp.lambdify((mass.symbols, up), (slope, hessian), "numpy")
    joints = np.array(mass.start, dtype=float)
    values = []
    for q in turns:
        vertical = rotation(q)[2]
        for _ in range(20):
            first, second = numbers(joints, vertical)
            if np.linalg.eigvalsh(np.array(second, dtype=float)).min() <= 1e-9:
                break  # no minimum nearby: keep the joint values
            change = np.linalg.solve(np.array(second, dtype=float), np.ravel(first))
            joints = joints - change
            if np.abs(change).max() < 1e-12:
                break
        values.append(joints)
    return np.array(values)


def _momenta(
    robot: SphericalRobot,
    mass: MovingMass,
    matrices: FloatArray,
    omega: FloatArray,
    joints: FloatArray,
    speeds: FloatArray,
) -> FloatArray:
    """M of a motion, without its vertical component for a rubber contact."""
    place = sp.lambdify((mass.symbols,), mass.formulas, "numpy")
    slope = sp.lambdify((mass.symbols,), sp.Matrix(mass.formulas).jacobian(mass.symbols), "numpy")
    momenta = []
    for Q, w, q, rate in zip(matrices, omega, joints, speeds, strict=True):
        vertical = robot.radius * Q[2]
        shell = vertical - np.array(robot.centre)
        arm = vertical + np.array(place(q), dtype=float)
        drift = np.array(slope(q), dtype=float) @ rate
        total = robot.tensor @ w + robot.mass * np.cross(shell, np.cross(w, shell))
        total += mass.mass * np.cross(arm, np.cross(w, arm) + drift)
        if robot.contact == "rubber":
            total -= (total @ Q[2]) * Q[2]
        momenta.append(total)
    return np.array(momenta)


def rotation(quaternion: FloatArray) -> FloatArray:
    """The rotation matrix from body to space components."""
    return np.array(rotation_rows(quaternion / np.linalg.norm(quaternion)))


def _product(p: FloatArray, q: FloatArray) -> FloatArray:
    """The product of two quaternions."""
    vector = p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])
    return np.append(p[0] * q[0] - p[1:] @ q[1:], vector)


def unit_quaternion(attitude: object) -> FloatArray:
    """Four numbers as a unit quaternion.

    Raises
    ------
    InputError
        If they are not four finite numbers, or all zero.
    """
    try:
        numbers = np.asarray(attitude, dtype=float)
    except (TypeError, ValueError):
        numbers = np.empty(0)
    if numbers.shape != (4,) or not np.isfinite(numbers).all() or not numbers.any():
        raise InputError(
            f"attitude {attitude}: it must be a quaternion, four finite numbers that are not all "
            "zero"
        )
    result: FloatArray = numbers / np.linalg.norm(numbers)
    return result
