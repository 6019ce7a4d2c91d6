"""The general derivation against Lagrange–d'Alembert in Euler angles, to forty digits.

The other side is written out here from the Lagrangian in angles and places, with the multipliers
as unknowns; it shares nothing with the package but SymPy.
"""

from __future__ import annotations

import random
from functools import cache
from typing import Any

import mpmath
import pytest
import sympy as sp

from flowlanes.system.vectors import Vector, real_symbol
from nonholonomic import Ball, Body, Ellipsoid, Forces, Plane, RollingBody
from nonholonomic.mechanics.lagrangian.generic_points import GenericPoint
from nonholonomic.mechanics.lagrangian.poincare_suslov import equations_of_motion
from nonholonomic.mechanics.rolling.mechanism import rolling_mechanism

DIGITS = 60
q = sp.symbols("theta phi psi x y z", real=True)
u = sp.symbols("thetadot phidot psidot xdot ydot zdot", real=True)
m, g = sp.Rational(11, 10), sp.Rational(97, 10)
I = sp.diag(sp.Rational(2), sp.Rational(3), sp.Rational(4))

SHAPES = {
    "unbalanced ball": (
        Ball(0.5, centre=(0.125, -0.25, 0.0625)),
        lambda n: sp.Matrix([sp.Rational(1, 8), -sp.Rational(1, 4), sp.Rational(1, 16)]) - n / 2,
    ),
    "ellipsoid": (
        Ellipsoid((1.0, 0.75, 0.5), centre=(0.0, 0.125, 0.0625)),
        lambda n: (
            sp.Matrix([0, sp.Rational(1, 8), sp.Rational(1, 16)])
            - sp.diag(1, sp.Rational(9, 16), sp.Rational(1, 4))
            * n
            / sp.sqrt(n[0] ** 2 + sp.Rational(9, 16) * n[1] ** 2 + n[2] ** 2 / 4)
        ),
    ),
}


def turned(axis: int, angle: sp.Expr) -> sp.Matrix:
    c, s = sp.cos(angle), sp.sin(angle)
    plane = sp.Matrix([[c, -s], [s, c]])
    return sp.diag(1, plane) if axis == 1 else sp.diag(plane, 1)


def rate(formula: Any) -> Any:
    """The rate of a formula in the coordinates."""
    return sum((sp.diff(formula, s) * v for s, v in zip(q, u, strict=True)), 0 * formula)


def lagrange(shape: Any, model: str) -> dict[str, Any]:
    """L, constraints, γ, ω, v in angles and places; v and ω in body axes."""
    attitude = turned(3, q[2]) * turned(1, q[0]) * turned(3, q[1])
    spin = (attitude.T * rate(attitude)).applyfunc(sp.simplify)
    omega = sp.Matrix([spin[2, 1], spin[0, 2], spin[1, 0]])
    v = attitude.T * sp.Matrix(u[3:])
    gamma = attitude.T * sp.Matrix([0, 0, 1])
    constraints = list(v + omega.cross(shape(gamma)))
    if model == "rubber":
        constraints.append(omega.dot(gamma))
    L = m * v.dot(v) / 2 + omega.dot(I * omega) / 2 - m * g * q[5]
    return {"L": L, "f": constraints, "gamma": gamma, "omega": omega, "v": v}


@cache
def formulas(name: str, model: str) -> Any:
    """Everything that the equations with multipliers need, as one function of q and q̇."""
    parts = lagrange(SHAPES[name][1], model)
    L, f, omega = parts["L"], parts["f"], parts["omega"]
    momenta = [sp.diff(L, s) for s in u]
    tables = (
        [sp.diff(p, t) for p in momenta for t in u],
        [sp.diff(L, s) - rate(p) for s, p in zip(q, momenta, strict=True)],
        [sp.diff(c, s) for c in f for s in u],
        [-rate(c) for c in f],
        [rate(w) for w in omega],
        [sp.diff(w, s) for w in omega for s in u],
        list(parts["gamma"]),
        list(omega),
        f,
    )
    return sp.lambdify([*q, *u], tables, "mpmath", cse=True), len(f)


def solved(tables: Any, count: int) -> tuple[Any, Any]:
    """ω̇ and the multipliers at a point, from the equations with the multipliers as unknowns."""
    mass, force, slopes, drift, turning, levers, *_ = tables
    size = len(q) + count
    matrix, right = mpmath.zeros(size), mpmath.matrix([*force, *drift])
    for i in range(len(q)):
        for j in range(len(q)):
            matrix[i, j] = mass[len(q) * i + j]
        for k in range(count):
            slope = slopes[len(q) * k + i]
            matrix[i, len(q) + k] = -slope
            matrix[len(q) + k, i] = slope
    answer = mpmath.lu_solve(matrix, right)
    accelerations = [
        start + sum(levers[len(q) * k + j] * answer[j] for j in range(len(q)))
        for k, start in enumerate(turning)
    ]
    return accelerations, answer[len(q) :]


def admissible(function: Any, count: int, seed: int) -> list[Any]:
    """Random angles and velocities that keep to the constraints, which are linear in them."""
    rng = random.Random(seed)
    places = [mpmath.mpf(rng.uniform(0.3, 1.2)) for _ in q]
    speeds = [mpmath.mpf(rng.uniform(0.3, 1.2)) for _ in u]
    size = len(u)
    slopes, values = (function(*places, *speeds)[k] for k in (2, 8))
    matrix = mpmath.matrix([[slopes[size * k + i] for i in range(size)] for k in range(count)])
    move = matrix.T * mpmath.lu_solve(matrix * matrix.T, mpmath.matrix(values))
    return [*places, *(x - d for x, d in zip(speeds, move, strict=True))]


@pytest.mark.slow
@pytest.mark.parametrize("model", ["marble", "rubber"])
@pytest.mark.parametrize("name", SHAPES)
def test_agrees_with_euler_angles(name: str, model: Any) -> None:
    body = Body(1.1, (2.0, 3.0, 4.0), SHAPES[name][0])
    system = equations_of_motion(
        rolling_mechanism(RollingBody(body, Plane(), model, Forces(gravity=9.7)))
    )
    exact = {p.symbol: sp.Rational(str(p.default)) for p in system.parameters}
    rates = dict(zip(system.symbols, system.rates, strict=True))
    function, count = formulas(name, model)
    ours = [rates[s] for s in Vector("omega").symbols]
    ours += [real_symbol(f"lambda_{i}") for i in range(1, count + 1)]
    with mpmath.workdps(DIGITS):
        for seed in range(5):
            point = admissible(function, count, seed)
            tables = function(*point)
            turning, forces = solved(tables, count)
            state = dict(zip(Vector("gamma").symbols, tables[6], strict=True))
            state |= dict(zip(Vector("omega").symbols, tables[7], strict=True))
            state[real_symbol("R_3")] = point[5]
            state |= {s: mpmath.mpf(int(x.p)) / int(x.q) for s, x in exact.items()}
            found = GenericPoint(state, system.scalar_definitions)
            for formula, number in zip(ours, [*turning, *forces], strict=True):
                assert abs(found.value(formula) - number) < mpmath.mpf(10) ** -40
