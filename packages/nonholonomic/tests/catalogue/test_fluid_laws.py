"""Laws of bodies with fluid: proven, and the lost ones refuted."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from flowlanes.system.laws import Integral, Measure
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, Vector, cross, dot, norm_squared, real_symbol
from lawproof.proof.prover import prove
from nonholonomic.catalogue import known_laws_of
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.cavity import Cavity
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.shapes.shapes import Ball
from nonholonomic.mechanics.shapes.surfaces import Sphere

M, N, gamma, omega, r, xi = (Vector(n) for n in ("M", "N", "gamma", "omega", "r", "xi"))
m, R = real_symbol("m"), real_symbol("R")
I, A, J = Diagonal("I"), Diagonal("A"), Diagonal("J")
MOMENTS = (0.4, 0.5, 0.6)
TRIAXIAL, SPHERE = Cavity((0.5, 0.4, 0.3), 0.8), Cavity((0.4, 0.4, 0.4), 0.8)
TWO = (
    Cavity((0.3, 0.4, 0.3), 0.4, centre=(0.4, 0.0, 0.0)),
    Cavity((0.3, 0.4, 0.3), 0.4, centre=(-0.4, 0.0, 0.0)),
)
ROTORS = (0.1, 0.2, -0.3)


def with_laws(rolling: RollingBody) -> System:
    system = rolling.system()
    return system.with_laws(*known_laws_of(rolling, system))


CASES = {
    "marble": (
        RollingBody(Body(1.0, MOMENTS, Ball(1.0), ROTORS, TRIAXIAL)),
        "area momentum measure",
    ),
    "rubber": (
        RollingBody(Body(1.0, MOMENTS, Ball(1.0), ROTORS, TRIAXIAL), contact="rubber"),
        "momentum measure",
    ),
    "marble, two cavities": (
        RollingBody(Body(1.0, MOMENTS, Ball(1.0), cavity=TWO)),
        "area momentum measure",
    ),
    "marble, heavy, on a sphere": (
        RollingBody(Body(1.0, MOMENTS, Ball(1.0), cavity=TRIAXIAL), Sphere(3.0), field=Forces(2.0)),
        "measure",
    ),
    "marble on a sphere": (
        RollingBody(Body(1.0, MOMENTS, Ball(1.0), cavity=TRIAXIAL), Sphere(3.0)),
        "momentum measure",
    ),
    "rubber on a sphere": (
        RollingBody(Body(1.0, MOMENTS, Ball(1.0), cavity=TRIAXIAL), Sphere(3.0), "rubber"),
        "measure",
    ),
    "spherical cavity": (
        RollingBody(Body(1.0, MOMENTS, Ball(1.0), cavity=SPHERE)),
        "area momentum measure vorticity angle",
    ),
    "spherical cavity off the centre": (
        RollingBody(
            Body(1.0, MOMENTS, Ball(1.0), cavity=replace(SPHERE, centre=(0.1, 0.2, 0.0))),
            contact="rubber",
            field=Forces(2.0),
        ),
        "vorticity",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_laws_are_proven(case):
    rolling, names = CASES[case]
    system = with_laws(rolling)
    circulations = sum(str(name).startswith("N") for name in system.state)
    assert [law.name for law in system.laws[1 + circulations :]] == names.split()
    for law in system.laws:
        verdict = prove(system, law)
        assert verdict.decision == "proven", verdict


FREE = RollingBody(Body(1.0, MOMENTS, Ball(1.0), cavity=TRIAXIAL))
OFF_CENTRE = RollingBody(Body(1.0, MOMENTS, Ball(1.0, centre=(-0.1, 0.05, 0.2)), cavity=TRIAXIAL))
ROUTH = RollingBody(
    Body(
        1.0, (0.4, 0.4, 0.6), Ball(1.0, centre=(0.0, 0.0, 0.2)), cavity=Cavity((0.4, 0.4, 0.3), 0.8)
    ),
    field=Forces(9.81),
)
LOST = {
    "(10.3) of the unbalanced ball": (
        OFF_CENTRE,
        norm_squared(M) - m * norm_squared(r) * dot(M, omega),
    ),
    "(10.3) with the momentum of the body alone": (
        OFF_CENTRE,
        norm_squared(M - Diagonal("C") * N)
        - m * norm_squared(r) * dot(M - Diagonal("C") * N, omega),
    ),
    "Jellett's integral": (ROUTH, dot(M, r)),
    "Jellett's integral of the body alone": (ROUTH, dot(M - Diagonal("C") * N, r)),
    "vorticity along the vertical": (FREE, dot(N, gamma)),
    "rigid momentum": (FREE, norm_squared(M - Diagonal("C") * N)),
    "horizontal momentum of a rubber ball without its fluid": (
        replace(FREE, contact="rubber"),
        norm_squared(cross(M - Diagonal("C") * N, gamma)),
    ),
}


@pytest.mark.parametrize("case", LOST)
def test_a_lost_integral_is_refuted(case):
    """By a point at which it changes; of a rigid body (C = 0, N = 0) it is one."""
    rolling, value = LOST[case]
    law = Integral("lost", value, level=_level(rolling))
    verdict = prove(rolling.system(), law)
    assert verdict.decision == "refuted"
    assert verdict.witness["point"]


def _level(rolling: RollingBody) -> tuple[sp.Expr, ...]:
    """A body of revolution with a coaxial spheroidal cavity, for that of Routh."""
    if rolling is not ROUTH:
        return ()
    C, W = Diagonal("C").symbols, Diagonal("W").symbols
    c = Vector("c").symbols
    return (I.symbols[0] - I.symbols[1], C[0] - C[1], C[2] - 1, W[0] - W[1], c[0], c[1])


@pytest.mark.parametrize(
    ("contact", "density"),
    [
        ("marble", {dot(I * gamma, A * gamma): sp.Rational(1, 2)}),
        ("marble", {dot(J * gamma, A * gamma): -sp.Rational(1, 2)}),
        ("rubber", {dot(gamma, A * gamma): -sp.Rational(1, 2)}),
        ("rubber", ()),
    ],
)
def test_a_wrong_density_is_refuted(contact, density):
    system = replace(FREE, contact=contact).system()
    assert prove(system, Measure("slip", density)).decision == "refuted"
