"""Motion planning: inputs of minimal effort that move the contact point along a given path."""

from __future__ import annotations

import time as clock
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np
import sympy as sp
from scipy.optimize import NonlinearConstraint, OptimizeResult, minimize
from scipy.sparse import bmat, csr_matrix, identity
from scipy.sparse.linalg import splu

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError, RunError
from flowlanes.system.arrays import FloatArray

from .collocation import Transcription
from .compiled_equations import CompiledEquations
from .controlled import ControlledSystem
from .equations import controlled_system, driftless_system
from .guess import least_inputs, motion_with_lowest_mass, unit_quaternion
from .path import PlanePath
from .plan import MotionPlan, distances, inputs_motion
from .robot import SphericalRobot

OPTIMAL = 1e-6
"""Relative slope of the effort along admissible motions at which the optimiser stops."""
FEASIBLE = 1e-10
"""Largest residual of the equations of a plan, in units of the state."""
EXACT = 1e-12
"""Tolerance of integrations without a subsequent optimisation."""
SMALLEST = 1 / 64
"""Smallest increment of the size of the path in a continuation."""


@arguments_checked
def motion_along(
    robot: SphericalRobot,
    path: PlanePath,
    *,
    attitude: Sequence[float] | None = (1.0, 0.0, 0.0, 0.0),
    intervals: int = 40,
    stages: int = 6,
    iterations: int = 100,
) -> MotionPlan:
    """Plan inputs that move the contact point along a path.

    The unknowns are states and inputs at the nodes of a collocation; SciPy's ``trust-constr``
    minimises ½∫|inputs|² dt under its equations, with their exact derivatives. The motion is then
    integrated independently with these inputs.

    Parameters
    ----------
    robot : SphericalRobot
        A balanced ball with two or three rotors starts from rest, M = 0. With a moving mass the
        momentum and the joints at the start are optimised too: a pendulum must already swing when
        the ball begins to move, so that the motion does not start from rest.
    path : PlanePath
    attitude : 4 numbers or None
        Quaternion at the start, body to space; None to optimise it.
    intervals, stages : int
        Number of time intervals, and of nodes in each; the error decreases at least with the power
        `stages` + 1 of the number of intervals.
    iterations : int
        Maximum number of iterations; the motion follows the path even if the least effort is not
        reached.

    Returns
    -------
    MotionPlan

    Raises
    ------
    InputError
        If the robot has fewer than two inputs, or is unbalanced without a moving mass; or two
        inputs at the given attitude cannot follow the path.
    RunError
        If no motion along the path is found.

    Examples
    --------
    >>> from nonholonomic.control import Rotor, SphericalRobot, figure_of_eight, motion_along
    >>> axes = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    >>> robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, tuple(Rotor(e, 0.1) for e in axes))
    >>> plan = motion_along(robot, figure_of_eight(1.0, 0.5, 8.0), intervals=20, iterations=2)
    >>> plan.relative_error < 1e-5
    True
    """
    began = clock.perf_counter()
    _check(robot, intervals, stages, iterations)
    system = driftless_system(robot) if robot.is_balanced else controlled_system(robot)
    quaternion = unit_quaternion((1.0, 0.0, 0.0, 0.0) if attitude is None else attitude)
    problem = _transcription(
        system, path, intervals, stages, None if attitude is None else quaternion
    )
    if robot.moving_mass is not None:
        begin, states, inputs = motion_with_lowest_mass(
            robot, robot.moving_mass, problem, quaternion
        )
        guess, spent = problem.unknowns_of(begin, states, inputs), 0
    else:
        guess, spent = _guess_with_rotors(problem, quaternion, attitude is None, iterations)
    unknowns, more = _least_effort(problem, guess, iterations)
    left = float(np.abs(problem.residuals(unknowns)).max())
    if not left < FEASIBLE * max(1.0, path.diameter):
        raise RunError(
            f"spherical robot: no motion along the path was found; the equations are left with a "
            f"residual of {left:.1g} after {spent + more} iterations; a smaller path, a longer "
            "period or more intervals may help",
            0.0,
        )
    return _checked_plan(robot, system, problem, unknowns, spent + more, began)


@arguments_checked
def motion_without_spin(
    robot: SphericalRobot,
    path: PlanePath,
    *,
    attitude: Sequence[float] = (1.0, 0.0, 0.0, 0.0),
    intervals: int = 40,
    stages: int = 6,
) -> MotionPlan:
    """The speeds u = −K⁻¹ A(γ) ω of three rotors for rolling along a path without spin.

    The path and (ω, γ) = 0 determine ω, so that no optimisation is needed: the attitude follows by
    integration, the speeds in closed form.

    Parameters
    ----------
    robot : SphericalRobot
        Balanced, with three rotors and a marble contact.
    path, attitude, intervals, stages
        As of :func:`motion_along`.

    Returns
    -------
    MotionPlan
        The plan, with 0 iterations.

    Raises
    ------
    InputError
        If the robot is of another kind, or the attitude is not a quaternion.

    Examples
    --------
    >>> from nonholonomic.control import (
    ...     Rotor,
    ...     SphericalRobot,
    ...     figure_of_eight,
    ...     motion_without_spin,
    ... )
    >>> axes = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    >>> robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, tuple(Rotor(e, 0.1) for e in axes))
    >>> plan = motion_without_spin(robot, figure_of_eight(1.0, 0.5, 8.0), intervals=20)
    >>> plan.iterations, plan.relative_error < 1e-5
    (0, True)
    """
    began = clock.perf_counter()
    _check(robot, intervals, stages, 1)
    if len(robot.rotors) != 3 or robot.moving_mass or robot.contact != "marble":
        raise InputError(
            "spherical robot: speeds without spin are determined for a balanced marble with three "
            "rotors; use motion_along"
        )
    system, quaternion = driftless_system(robot), unit_quaternion(attitude)
    problem = _transcription(system, path, intervals, stages, quaternion)
    start = np.concatenate([quaternion, path.places([0.0])[0]])
    states, inputs, _ = least_inputs(problem, start, spin=0.0, tolerance=EXACT)
    return _checked_plan(
        robot, system, problem, problem.unknowns_of(start, states, inputs), 0, began
    )


def _checked_plan(
    robot: SphericalRobot,
    system: ControlledSystem,
    problem: Transcription,
    unknowns: FloatArray,
    iterations: int,
    began: float,
) -> MotionPlan:
    """A plan whose motion is integrated independently of the collocation."""
    start, points = problem.start_and_nodes(unknowns)
    inputs = points[:, problem.equations.size :]
    times, motion = inputs_motion(problem, start, inputs)
    return MotionPlan(
        robot,
        problem.path,
        tuple(map(str, system.inputs)),
        tuple(map(str, system.state)),
        start,
        problem.times,
        inputs,
        problem.intervals,
        _effort(problem, unknowns),
        times,
        motion,
        float(distances(problem.path, times, motion).max()),
        iterations,
        clock.perf_counter() - began,
    )


def _check(robot: SphericalRobot, intervals: int, stages: int, iterations: int) -> None:
    joints = len(robot.moving_mass.joints) if robot.moving_mass else 0
    if len(robot.rotors) + joints < 2:
        raise InputError(
            "spherical robot: it has one input; to lead the contact along a path in the plane two "
            "are needed at least"
        )
    if not robot.is_balanced and robot.moving_mass is None:
        raise InputError(
            "spherical robot: paths are planned for a balanced ball with rotors, or one with a "
            "moving mass; its centre of mass lies beside the geometric centre"
        )
    if intervals < 2 or not 2 <= stages <= 8 or iterations < 1:
        raise InputError(
            f"intervals = {intervals}, stages = {stages}, iterations = {iterations}: at least 2 "
            "intervals, 2 to 8 stages and 1 iteration are needed"
        )


def _transcription(
    system: ControlledSystem,
    path: PlanePath,
    intervals: int,
    stages: int,
    attitude: FloatArray | None,
) -> Transcription:
    output = [system.state.index(name) for name in system.output]
    start = dict(zip(output, path.places([0.0])[0].tolist(), strict=True))
    if attitude is not None:
        start |= dict(enumerate(attitude.tolist()))
    return Transcription(_compiled_equations(system), path, output, intervals, stages, start)


@lru_cache(maxsize=16)
def _compiled_equations(system: ControlledSystem) -> CompiledEquations:
    return CompiledEquations(system)


def _guess_with_rotors(
    problem: Transcription, attitude: FloatArray, free: bool, iterations: int
) -> tuple[FloatArray, int]:
    """A motion from rest along the path, and the number of iterations used.

    If the minimal inputs become singular on the way, and the attitude is free, the path is enlarged
    gradually from a small one (continuation).
    """

    def least_inputs_of(task: Transcription) -> tuple[FloatArray, float]:
        start = np.concatenate([attitude, task.path.places([0.0])[0]])
        states, inputs, reached = least_inputs(task, start)
        return task.unknowns_of(start, states, inputs), reached

    guess, reached = least_inputs_of(problem)
    period = problem.path.period
    if reached >= period:
        return guess, 0
    if not free:
        raise InputError(
            f"spherical robot: from this attitude the path cannot be followed beyond t = "
            f"{reached:.4g}, where no speed of the {problem.equations.inputs} rotors moves the "
            "contact along it; another attitude, attitude=None, a smaller path or a third rotor "
            "may help"
        )
    size, spent = 1.0, 0
    while reached < period and size > SMALLEST:
        size /= 2
        guess, reached = least_inputs_of(_with_scale(problem, size))
    step = size
    while size < 1 and step > SMALLEST:
        larger = min(1.0, size + step)
        task = _with_scale(problem, larger)
        trial, count = _least_effort(task, guess, iterations)
        spent += count
        if np.abs(task.residuals(trial)).max() < FEASIBLE * max(1.0, task.path.diameter):
            guess, size = trial, larger
        else:
            step /= 2
    return guess, spent


def _with_scale(problem: Transcription, size: float) -> Transcription:
    """The problem with its path scaled down towards its start."""
    path = problem.path
    factor = sp.Float(size)
    first = [sp.Float(x) for x in path.places([0.0])[0]]
    x, y = (
        begin + factor * (sp.sympify(f) - begin)
        for begin, f in zip(first, (path.x, path.y), strict=True)
    )
    return replace(problem, path=PlanePath(x, y, path.period))


def _effort(problem: Transcription, unknowns: FloatArray) -> float:
    _, points = problem.start_and_nodes(unknowns)
    squares = np.sum(points[:, problem.equations.size :] ** 2, axis=1)
    return float(0.5 * problem.weights @ squares / problem.path.period)


def _least_effort(
    problem: Transcription, guess: FloatArray, iterations: int
) -> tuple[FloatArray, int]:
    """The motion of minimal effort near a guess, and the number of iterations."""
    curvature = problem.effort
    curvature = curvature / max(float(guess @ (curvature @ guess)), 1e-3)
    empty = csr_matrix((len(guess), len(guess)))

    def enough(_: FloatArray, state: OptimizeResult) -> bool:
        return bool(state.constr_violation < FEASIBLE and state.optimality < OPTIMAL)

    found = minimize(
        lambda w: 0.5 * float(w @ (curvature @ w)),
        guess,
        jac=lambda w: curvature @ w,
        hess=lambda _: curvature,
        constraints=[
            # The curvature of the equations is neglected: near the path their Jacobian suffices.
            NonlinearConstraint(
                problem.residuals, 0.0, 0.0, jac=problem.jacobian, hess=lambda _, __: empty
            )
        ],
        method="trust-constr",
        callback=enough,
        options={
            "maxiter": iterations,
            "gtol": OPTIMAL,
            "xtol": 1e-14,
            "initial_tr_radius": float(np.linalg.norm(guess)) / 10,
        },
    )
    return _on_equations(problem, found.x), int(found.nit)


def _on_equations(problem: Transcription, unknowns: FloatArray) -> FloatArray:
    """The nearest solution of the equations, by Newton's method."""
    best, left = unknowns, float(np.linalg.norm(problem.residuals(unknowns)))
    for _ in range(8):
        slopes = problem.jacobian(best)
        rows, columns = slopes.shape
        # minimum-norm Newton step: the KKT system of min |d|² with J d = −residuals, slightly
        # regularised
        both = bmat([[identity(columns), slopes.T], [slopes, -1e-14 * identity(rows)]]).tocsc()
        side = np.concatenate([np.zeros(columns), -problem.residuals(best)])
        try:
            trial = best + splu(both).solve(side)[:columns]
        except RuntimeError:  # a singular matrix
            break
        error = float(np.linalg.norm(problem.residuals(trial)))
        if not error < left / 2:
            break
        best, left = trial, error
    return best
