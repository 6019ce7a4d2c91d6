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

from chaplygin.mechanics.body import Body
from chaplygin.mechanics.rolling import Field, Rolling
from chaplygin.mechanics.shapes import Ball, Disk, Revolution, Torus
from chaplygin.mechanics.surfaces import Sphere
from chaplygin.statements import Integral
from chaplygin.system import System
from chaplygin.systems import CATALOGUE, known_laws_of
from chaplygin.vectors import dot, normed, vectors
from evaluation import as_fraction, is_rational, rates_of_change

M, omega, gamma = vectors("M omega gamma")

DIGITS = 60

#: Rational points of the unit sphere.
NORMALS = ((2, -3, 6, 7), (-12, 16, 15, 25), (1, 4, -8, 9), (6, 10, 15, 19))


def known(system: System, number: type, seed: int) -> dict[sp.Symbol, Any]:
    """A point of the phase space with rational coordinates, and the default parameters."""
    rng = np.random.default_rng(seed)
    x, y, z, length = NORMALS[seed]
    direction = [Fraction(value, length) for value in (x, y, z)]
    spin = [Fraction(int(n), 7) for n in rng.integers(-9, 10, 3)]
    if dot(omega, gamma) in system.relations:
        along = sum(u * v for u, v in zip(spin, direction, strict=True))
        spin = [u - along * v for u, v in zip(spin, direction, strict=True)]
    point = dict(zip(gamma.symbols, direction, strict=True))
    for vector in (omega, M):
        if vector in system.state:
            point |= dict(zip(vector.symbols, spin, strict=True))
    point |= {symbol: as_fraction(value) for symbol, value in system.defaults.items()}
    return {symbol: number(x.numerator) / x.denominator for symbol, x in point.items()}


def derivatives(system: System, laws: tuple[Integral, ...], seed: int) -> Mapping[str, Any]:
    """dF/dt of each law, relative to its value where that is rounded."""
    formulas = [law.value for law in laws]
    names = [law.name for law in laws]
    if is_rational(system, formulas):
        found = rates_of_change(system, formulas, known(system, Fraction, seed))
        return {name: dual.rate for name, dual in zip(names, found, strict=True)}
    with mpmath.workdps(DIGITS):
        found = rates_of_change(system, formulas, known(system, mpmath.mpf, seed))
        slack = mpmath.mpf(10) ** (8 - DIGITS)
        return {
            name: 0 if abs(dual.rate) < slack * (1 + abs(dual.value)) else dual.rate
            for name, dual in zip(names, found, strict=True)
        }


@pytest.mark.parametrize("seed", range(len(NORMALS)))
@pytest.mark.parametrize("name", CATALOGUE)
def test_laws_of_the_catalogue(name, seed):
    system = CATALOGUE[name].system()
    assert derivatives(system, system.laws, seed) == {law.name: 0 for law in system.laws}


@pytest.mark.parametrize("seed", range(len(NORMALS)))
@pytest.mark.parametrize("name", CATALOGUE)
def test_relations_are_kept(name, seed):
    system = CATALOGUE[name].system()
    claims = tuple(
        Integral(f"relation {i}", relation, "") for i, relation in enumerate(system.relations)
    )
    assert claims
    assert set(derivatives(system, claims, seed).values()) == {0}


def test_the_derivative_sees_a_wrong_law():
    system = CATALOGUE["chaplygin-ball"].system()
    wrong = Integral("wrong", normed(M) + dot(omega, gamma), "")
    assert derivatives(system, (wrong,), 0)["wrong"] != 0


I_1, I_2, I_3, K = sp.symbols("I_1 I_2 I_3 K", real=True)
BRUNS = K / 2 * sum(i * s**2 for i, s in zip((I_1, I_2, I_3), gamma.symbols, strict=True))
ROTORS = (0.3, -0.2, 0.5)
MOMENTS = (1.0, 1.5, 2.1)
TURNED = ((1.0, 0.1, 0.0), (0.1, 1.5, -0.05), (0.0, -0.05, 2.1))

VARIANTS = {
    "marble ball in Bruns' field": (
        Rolling(Body(1.2, MOMENTS, Ball(0.9)), field=Field(0.0, BRUNS, ((K, 0.7),))),
        {"energy", "area", "momentum"},
    ),
    "rubber ball in Bruns' field": (
        Rolling(
            Body(1.2, MOMENTS, Ball(0.9)),
            contact="rubber",
            field=Field(0.0, BRUNS, ((K, 0.7),)),
        ),
        {"energy", "momentum"},
    ),
    "marble ball with rotors": (
        Rolling(Body(1.2, MOMENTS, Ball(0.9), gyrostat=ROTORS)),
        {"energy", "area", "momentum"},
    ),
    "rubber ball with rotors": (
        Rolling(Body(1.2, MOMENTS, Ball(0.9), gyrostat=ROTORS), contact="rubber"),
        {"energy", "momentum"},
    ),
    "marble ball with rotors on a sphere": (
        Rolling(Body(1.2, MOMENTS, Ball(0.9), gyrostat=ROTORS), Sphere(2.3)),
        {"energy", "momentum"},
    ),
    "marble ball inside a sphere": (
        Rolling(Body(1.2, MOMENTS, Ball(0.9)), Sphere(-2.3)),
        {"energy", "momentum"},
    ),
    "marble ball with a full tensor": (
        Rolling(Body(1.2, TURNED, Ball(0.9))),
        {"energy", "area", "momentum"},
    ),
    "rubber ball with a full tensor": (
        Rolling(Body(1.2, TURNED, Ball(0.9)), contact="rubber"),
        {"energy", "momentum"},
    ),
    "unbalanced marble ball with a full tensor": (
        Rolling(Body(1.2, TURNED, Ball(0.9, centre=(0.1, -0.2, 0.05)))),
        {"energy", "quadratic"},
    ),
    "unbalanced rubber ball with a full tensor": (
        Rolling(Body(1.2, TURNED, Ball(0.9, centre=(0.1, -0.2, 0.05))), contact="rubber"),
        {"energy", "quadratic"},
    ),
    "symmetric unbalanced rubber ball": (
        Rolling(Body(1.2, (1.0, 1.0, 1.7), Ball(0.9, centre=(0.0, 0.0, 0.25))), contact="rubber"),
        {"energy", "quadratic", "spin"},
    ),
    "heavy rubber disk": (
        Rolling(Body(1.2, (0.3, 0.3, 0.5), Disk(0.9)), contact="rubber", field=Field(9.81)),
        {"energy", "spin"},
    ),
    "heavy rubber torus with its centre of mass on the axis": (
        Rolling(
            Body(1.2, (0.6, 0.6, 0.8), Torus(0.9, 0.2, centre=(0.0, 0.0, 0.1))),
            contact="rubber",
            field=Field(9.81, gamma.symbols[2] ** 3),
        ),
        {"energy", "spin"},
    ),
    "rubber body of revolution by its support function": (
        Rolling(
            Body(1.2, (0.6, 0.6, 0.8), Revolution(1 + gamma.symbols[2] ** 2 / 5)),
            contact="rubber",
            field=Field(9.81),
        ),
        {"energy", "spin"},
    ),
    "heavy balanced ball": (
        Rolling(Body(1.2, MOMENTS, Ball(0.9)), field=Field(9.81)),
        {"energy", "area", "momentum"},
    ),
    "ball in another potential": (
        Rolling(
            Body(1.2, MOMENTS, Ball(0.9)),
            field=Field(0.0, gamma.symbols[0] ** 2 + gamma.symbols[1] * gamma.symbols[2]),
        ),
        {"energy", "area"},
    ),
}


@pytest.mark.parametrize("seed", range(len(NORMALS)))
@pytest.mark.parametrize("variant", VARIANTS)
def test_laws_that_the_catalogue_knows_of_other_bodies(variant, seed):
    rolling, names = VARIANTS[variant]
    system = rolling.system()
    system = system.with_laws(*known_laws_of(rolling, system))
    assert derivatives(system, system.laws, seed) == dict.fromkeys(names, 0)
