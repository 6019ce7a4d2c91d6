"""The corrected formulas of §1 by derivations of their own, in numbers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from borisov_mamaev_2008.section_01 import section_01_1
from evaluation import numeric
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Vector, to_components
from nonholonomic.catalogue.bodies.any_shape import POTENTIAL, SUPPORT
from nonholonomic.catalogue.bodies.marble_body import any_marble_body
from nonholonomic.catalogue.bodies.rubber_body import a, any_rubber_body
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, rolling_system
from nonholonomic.mechanics.shapes.shapes import Ellipsoid
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere

GAMMA = Vector("gamma").symbols
AXES, CENTRE = (1.0, 0.9, 0.8), (0.125, 0.25, -0.1)
MASS, INERTIA = 1.3, (1.2, 1.5, 2.1)
FIELD = GAMMA[0] * GAMMA[1] / 2 + GAMMA[2] ** 3 / 4
ELLIPSOID = sp.sqrt(sum(sp.Rational(str(x)) ** 2 * s**2 for x, s in zip(AXES, GAMMA, strict=True)))


def chosen(system: System, functions: dict[sp.Expr, sp.Expr], **numbers: float | None) -> System:
    """The system with its unspecified functions and parameters chosen."""
    table = {type(f): sp.Lambda(f.args, value) for f, value in functions.items()}

    def written(formula: object) -> sp.Expr:
        value = to_components(formula)
        for name, meaning in table.items():
            value = value.replace(name, meaning).doit()
        return value

    return replace(
        system,
        parameters=tuple(
            Parameter(p.symbol, p.meaning, numbers.get(str(p.symbol), p.default))
            for p in system.parameters
        ),
        definitions=tuple((s, written(f)) for s, f in system.scalar_definitions),
        field=tuple((s, written(f)) for s, f in zip(system.symbols, system.rates, strict=True)),
    )


def states(count: int) -> np.ndarray:
    """Random γ and, orthogonal to it, ω (or a momentum M), as columns."""
    rng = np.random.default_rng(1)
    gamma = rng.normal(size=(3, count))
    gamma /= np.linalg.norm(gamma, axis=0)
    omega = rng.normal(size=(3, count))
    omega -= (omega * gamma).sum(axis=0) * gamma
    return np.concatenate([omega, gamma])


GENERAL = {"marble": any_marble_body, "rubber": any_rubber_body}


@pytest.mark.parametrize("contact", GENERAL)
@pytest.mark.parametrize("radius", [None, 2.5, -4.5])
def test_a_body_of_any_shape_is_the_ellipsoid_for_its_support_function(radius, contact):
    body = Body(MASS, INERTIA, Ellipsoid(AXES, centre=CENTRE))
    surface = Plane() if radius is None else Sphere.of_signed_radius(radius)
    rolled = rolling_system(body, surface, contact, Forces(potential=FIELD))
    numbers = {"m": MASS, "a": radius}
    numbers |= {f"I_{i}": x for i, x in enumerate(INERTIA, 1)}
    numbers |= {f"c_{i}": x for i, x in enumerate(CENTRE, 1)}
    curvature = sp.S.Zero if radius is None else 1 / a
    made = chosen(GENERAL[contact](curvature), {SUPPORT: ELLIPSOID, POTENTIAL: FIELD}, **numbers)
    where = states(7)
    ours, theirs = numeric(made, made.rates)(where), numeric(rolled, rolled.rates)(where)
    assert np.abs(theirs).max() > 0.3
    np.testing.assert_allclose(ours, theirs, rtol=1e-11, atol=1e-12)


def test_the_multipliers_of_ferrers_equations_solve_newtons_and_the_constraints_at_once():
    """Accelerations and multipliers as the solution of one linear system of five equations."""
    made = section_01_1.constrained()
    q, v = (np.array(section_01_1.q.symbols), np.array(section_01_1.v.symbols))
    shape = sp.Matrix([[3, q[0], 0], [0, 2, q[1] * q[2]], [q[2], 0, 2]])
    matrix = shape.T * shape
    rows = sp.Matrix([[q[1], 1, q[2] ** 2], [1, q[0] * q[2], -q[1]]])
    rests = sp.Matrix([q[0] * q[1], q[2] - 1])
    force = sp.Matrix([v[0] * v[1], q[2] * v[2], sp.sin(q[0])])
    functions = {section_01_1.MATRIX[i, j]: matrix[i, j] for i in range(3) for j in range(3)}
    for i in range(2):
        functions |= dict(zip(section_01_1.ROWS[i], rows.row(i), strict=True))
    functions |= dict(zip(section_01_1.RESTS, rests, strict=True))
    forces = sp.Matrix([sp.Function(f"Q_s{i}")(*q, *v) for i in (1, 2, 3)])
    functions |= dict(zip(forces, force, strict=True))
    made = chosen(made, functions)

    point = np.random.default_rng(2).normal(size=6)
    here = dict(zip([*q, *v], point, strict=True))
    speed = sp.Matrix(v)
    momentum = matrix * speed
    kinetic = (speed.T * momentum)[0] / 2
    drift = momentum.jacobian(q) * speed - sp.Matrix([kinetic]).jacobian(q).T
    wanted = (rows * speed + rests).jacobian(q) * speed
    left = np.zeros((5, 5))
    left[:3, :3] = np.array(matrix.subs(here), dtype=float)
    left[:3, 3:] = -np.array(rows.T.subs(here), dtype=float)
    left[3:, :3] = np.array(rows.subs(here), dtype=float)
    right = np.array(sp.Matrix([force - drift, -wanted]).subs(here), dtype=float).ravel()
    solution = np.linalg.solve(left, right)

    found = numeric(made, [*made.rates[3:], *section_01_1.multiplier])(point)
    np.testing.assert_allclose(found, solution, rtol=1e-10)
