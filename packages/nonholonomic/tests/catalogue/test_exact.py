"""At points of the phase space the derivative of every law along the field is zero, exactly.

Where all formulas are rational the points are rational and the derivative is computed without
rounding; where roots or angles occur, with 60 digits.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

from catalogue import built
from evaluation import is_rational, on_conditions, parameter_values, rates_of_change
from flowlanes.system.laws import Integral
from flowlanes.system.system import System
from flowlanes.system.vectors import dot, norm_squared, to_components, vectors
from nonholonomic.catalogue import CATALOGUE, known_laws_of
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Torus
from nonholonomic.mechanics.shapes.surfaces import Sphere
from nonholonomic.starts import initial_state
from spread import spread

M, omega, gamma = vectors("M omega gamma")

DIGITS = 60
SEEDS = 4

#: Rational points of the unit sphere.
NORMALS = ((2, -3, 6, 7), (-12, 16, 15, 25), (1, 4, -8, 9), (6, 10, 15, 19))


def rational_point(system: System, seed: int) -> dict[sp.Symbol, Fraction]:
    """A point of the phase space with rational coordinates, and the default parameters."""
    rng = np.random.default_rng(seed)
    x, y, z, length = NORMALS[seed]
    direction = [Fraction(value, length) for value in (x, y, z)]
    spin = [Fraction(int(n), 7) for n in rng.integers(-9, 10, 3)]
    if dot(omega, gamma) in system.relations:
        along = sum(u * v for u, v in zip(spin, direction, strict=True))
        spin = [u - along * v for u, v in zip(spin, direction, strict=True)]
    numbers = rng.integers(2, 9, len(system.symbols))
    known = {s: Fraction(int(n), 5) for s, n in zip(system.symbols, numbers, strict=True)}
    for vector, values in ((gamma, direction), (omega, spin), (M, spin)):
        if vector in system.state:
            known |= dict(zip(vector.symbols, values, strict=True))
    return known | parameter_values(system, Fraction)


def nearby(system: System, start: Any, level: tuple[Any, ...], seed: int) -> dict[sp.Symbol, Any]:
    """A point of the phase space and of a level, not far from a start, with many digits."""
    rng = np.random.default_rng(seed)
    state = [mpmath.mpf(x) for x in start[: len(system.symbols)]]
    size = max(map(abs, state))
    moved = [x + size * mpmath.mpf(rng.uniform(-0.05, 0.05)) for x in state]
    known = dict(zip(system.symbols, moved, strict=True)) | parameter_values(system, mpmath.mpf)
    conditions = [to_components(c) for c in (*system.relations, *level)]
    return on_conditions(system, conditions, known, system.symbols)


def derivative(system: System, law: Integral, start: Any, seed: int) -> Any:
    """dF/dt of a law at a point of its level; what is due to rounding is zero.

    `start` is a state near which the point is chosen, unless it is rational.
    """
    simple = {norm_squared(gamma) - 1, dot(omega, gamma)} >= set(system.relations)
    level = tuple(c for c in law.level if set(to_components(c).free_symbols) - set(system.defaults))
    if simple and not level and is_rational(system, [law.value]):
        (dual,) = rates_of_change(system, [law.value], rational_point(system, seed))
        return dual.rate
    with mpmath.workdps(DIGITS):
        known = nearby(system, start, level, seed)
        (dual,) = rates_of_change(system, [law.value], known)
        slack = mpmath.mpf(10) ** (12 - DIGITS)
        return 0 if abs(dual.rate) < slack * (1 + abs(dual.value)) else dual.rate


def derivatives(
    system: System, laws: tuple[Integral, ...], start: Any, seed: int
) -> Mapping[str, Any]:
    return {law.name: derivative(system, law, start, seed) for law in laws}


def example(name: str) -> tuple[System, Any]:
    """A system of the catalogue with its start."""
    made = built.example(name)
    return made.system, made.start


@pytest.mark.slow
@pytest.mark.parametrize("seed", spread(range(SEEDS), SEEDS))
@pytest.mark.parametrize("name", CATALOGUE)
def test_integrals_of_the_catalogue(name, seed):
    system, start = example(name)
    found = derivatives(system, system.integrals, start, seed)
    assert found == {law.name: 0 for law in system.integrals}


@pytest.mark.parametrize("seed", spread(range(SEEDS), SEEDS))
@pytest.mark.parametrize("name", CATALOGUE)
def test_relations_are_kept(name, seed):
    system, start = example(name)
    claims = tuple(
        Integral(f"relation {i}", relation) for i, relation in enumerate(system.relations)
    )
    assert derivatives(system, claims, start, seed) == {claim.name: 0 for claim in claims}


@pytest.mark.parametrize("name", ["chaplygin-ball", "chaplygin-ball-reduced", "marble-ball"])
def test_the_derivative_sees_a_wrong_law(name):
    system, start = example(name)
    wrong = Integral("wrong", system.symbols[0] + system.integrals[0].value)
    assert derivative(system, wrong, start, 0) != 0


I_1, I_2, I_3, K = sp.symbols("I_1 I_2 I_3 K", real=True)
BRUNS = K / 2 * sum(i * s**2 for i, s in zip((I_1, I_2, I_3), gamma.symbols, strict=True))
ROTORS = (0.3, -0.2, 0.5)
MOMENTS = (1.0, 1.5, 2.1)
TURNED = ((1.0, 0.1, 0.0), (0.1, 1.5, -0.05), (0.0, -0.05, 2.1))

VARIANTS = {
    "marble ball in Bruns' field": (
        RollingBody(Body(1.2, MOMENTS, Ball(0.9)), field=Forces(0.0, BRUNS, {K: 0.7})),
        {"energy", "area", "momentum"},
    ),
    "rubber ball in Bruns' field": (
        RollingBody(
            Body(1.2, MOMENTS, Ball(0.9)),
            contact="rubber",
            field=Forces(0.0, BRUNS, {K: 0.7}),
        ),
        {"energy", "momentum"},
    ),
    "marble ball with rotors": (
        RollingBody(Body(1.2, MOMENTS, Ball(0.9), gyrostat=ROTORS)),
        {"energy", "area", "momentum"},
    ),
    "rubber ball with rotors": (
        RollingBody(Body(1.2, MOMENTS, Ball(0.9), gyrostat=ROTORS), contact="rubber"),
        {"energy", "momentum"},
    ),
    "marble ball with rotors on a sphere": (
        RollingBody(Body(1.2, MOMENTS, Ball(0.9), gyrostat=ROTORS), Sphere(2.3)),
        {"energy", "momentum"},
    ),
    "marble ball inside a sphere": (
        RollingBody(Body(1.2, MOMENTS, Ball(0.9)), Sphere(2.3, side="inside")),
        {"energy", "momentum"},
    ),
    "marble ball with a full tensor": (
        RollingBody(Body(1.2, TURNED, Ball(0.9))),
        {"energy", "area", "momentum"},
    ),
    "rubber ball with a full tensor": (
        RollingBody(Body(1.2, TURNED, Ball(0.9)), contact="rubber"),
        {"energy", "momentum"},
    ),
    "unbalanced marble ball with a full tensor": (
        RollingBody(Body(1.2, TURNED, Ball(0.9, centre=(0.1, -0.2, 0.05)))),
        {"energy", "quadratic"},
    ),
    "unbalanced rubber ball with a full tensor": (
        RollingBody(Body(1.2, TURNED, Ball(0.9, centre=(0.1, -0.2, 0.05))), contact="rubber"),
        {"energy", "quadratic"},
    ),
    "symmetric unbalanced rubber ball": (
        RollingBody(
            Body(1.2, (1.0, 1.0, 1.7), Ball(0.9, centre=(0.0, 0.0, 0.25))), contact="rubber"
        ),
        {"energy", "quadratic", "spin"},
    ),
    "heavy rubber disk": (
        RollingBody(Body(1.2, (0.3, 0.3, 0.5), Disk(0.9)), contact="rubber", field=Forces(9.81)),
        {"energy", "spin"},
    ),
    "heavy rubber torus with its centre of mass on the axis": (
        RollingBody(
            Body(1.2, (0.6, 0.6, 0.8), Torus(0.9, 0.2, centre=(0.0, 0.0, 0.1))),
            contact="rubber",
            field=Forces(9.81, gamma.symbols[2] ** 3),
        ),
        {"energy", "spin"},
    ),
    "rubber body of revolution by its support function": (
        RollingBody(
            Body(1.2, (0.6, 0.6, 0.8), ShapeOfRevolution(1 + gamma.symbols[2] ** 2 / 5)),
            contact="rubber",
            field=Forces(9.81),
        ),
        {"energy", "spin"},
    ),
    "heavy balanced ball": (
        RollingBody(Body(1.2, MOMENTS, Ball(0.9)), field=Forces(9.81)),
        {"energy", "area", "momentum"},
    ),
    "ball in another potential": (
        RollingBody(
            Body(1.2, MOMENTS, Ball(0.9)),
            field=Forces(0.0, gamma.symbols[0] ** 2 + gamma.symbols[1] * gamma.symbols[2]),
        ),
        {"energy", "area"},
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(len(NORMALS)))
@pytest.mark.parametrize("variant", VARIANTS)
def test_laws_that_the_catalogue_knows_of_other_bodies(variant, seed):
    rolling, names = VARIANTS[variant]
    system = rolling.system()
    system = system.with_laws(*known_laws_of(rolling, system))
    start = initial_state(system, (0.8, -0.4, -0.6), (0.6, 0.0, 0.8))
    assert derivatives(system, system.integrals, start, seed) == dict.fromkeys(names, 0)
