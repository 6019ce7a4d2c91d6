"""The theorem on measures of bodies with fluid: its lemma, and divergences compared exactly."""

from __future__ import annotations

import random
from dataclasses import replace

import mpmath
import pytest
import sympy as sp

from flowlanes.system.laws import Measure
from flowlanes.system.system import System
from flowlanes.system.vectors import Vector, cross
from lawproof.proof.prover import prove
from nonholonomic.invariant_measures.existence import invariant_measure
from nonholonomic.invariant_measures.fluid_theorem import (
    THEOREM,
    C,
    N,
    S,
    action_of_fluid,
    lemma,
    omega,
    xi,
)
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.cavity import Cavity
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.rolling.initial_state import evaluate
from nonholonomic.mechanics.shapes.shapes import Ball, Ellipsoid, Torus
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere

FULL = ((0.5, 0.05, -0.03), (0.05, 0.6, 0.04), (-0.03, 0.04, 0.7))
TURNED = Cavity((0.5, 0.4, 0.3), 0.8, (0.9, 0.1, 0.3, -0.2), (0.1, -0.2, 0.05))
SMALL = Cavity((0.2, 0.3, 0.25), 0.3, (0.3, -0.5, 0.2, 0.8), (-0.55, 0.3, -0.25))
ALONG = Cavity((0.5, 0.4, 0.3), 0.8)


def test_the_lemma_is_proven_for_all_tensors():
    """By a symbolic computation, not at points."""
    verdict = lemma()
    assert verdict.decision == "proven"
    assert "residual" in verdict.finding


@pytest.mark.parametrize(
    "rates",
    [
        {N: cross(N, omega)},
        {omega: S * (cross(C * N, omega) + 2 * cross(omega, C * xi))},
        {omega: S * (cross(C * N, omega) - C * C * cross(xi, N))},
    ],
    ids=["vorticity carried by the body", "torque of the wrong vectors", "coupled twice"],
)
def test_the_lemma_with_a_slip_is_refuted(rates):
    true = action_of_fluid()
    slip = replace(true, field={**dict(true.field), **rates})
    verdict = prove(slip, Measure("volume", ()))
    keeps = rates.keys() == {N}
    assert verdict.decision == ("proven" if keeps else "refuted")


BODIES = {
    "ball": (Ball(1.0, centre=(0.05, 0.1, -0.1)), Plane(), (TURNED,)),
    "ball on a sphere": (Ball(1.0, centre=(0.05, 0.1, -0.1)), Sphere(3.0), (TURNED,)),
    "ellipsoid": (Ellipsoid((1.2, 1.0, 0.9), 0.3), Plane(), (TURNED, SMALL)),
    "ellipsoid in a bowl": (Ellipsoid((1.2, 1.0, 0.9)), Sphere(9.0, "inside"), (TURNED,)),
    "torus": (Torus(1.0, 0.5), Plane(), (Cavity((0.5, 0.4, 0.3), 0.8),)),
}


def divergence(system: System, point: dict[sp.Symbol, mpmath.mpf]) -> mpmath.mpf:
    """Of the field of a system in the variables of its state, by central differences."""
    h = mpmath.mpf(10) ** -20
    known = {**{s: mpmath.mpf(x) for s, x in system.defaults.items()}, **point}
    total = mpmath.mpf(0)
    for s, rate in zip(system.symbols, system.rates, strict=True):
        values = [evaluate(system, [rate], {**known, s: known[s] + step})[0] for step in (h, -h)]
        total += (values[0] - values[1]) / (2 * h)
    return total


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize("name", BODIES)
def test_divergences_are_the_same(name, contact):
    """Of the body with fluid, and of its equivalent at the same ω and γ: to 30 digits."""
    shape, surface, cavities = BODIES[name]
    body = Body(1.0, FULL, shape, (0.1, 0.2, -0.3), cavities)
    wet = RollingBody(body, surface, contact, Forces(2.0))
    rng = random.Random(20130818)

    def vector(length: float | None = None) -> list[mpmath.mpf]:
        numbers = [mpmath.mpf(rng.uniform(-1, 1)) for _ in range(3)]
        size = mpmath.norm(numbers)
        return [x / size for x in numbers] if length else numbers

    with mpmath.workdps(60):
        gamma, turning, zeta = vector(1), vector(), vector(1)
        if contact == "rubber":
            spin = sum(a * b for a, b in zip(gamma, turning, strict=True))
            turning = [a - spin * b for a, b in zip(turning, gamma, strict=True)]
        base = dict(zip((*Vector("gamma"), *Vector("zeta")), (*gamma, *zeta), strict=True))
        base |= dict(zip(Vector("omega"), turning, strict=True))
        motions = {
            s: x for fluid in body.fluids for s, x in zip(fluid.start, vector(), strict=True)
        }
        found = []
        for rolling in (wet, wet.equivalent):
            system = rolling.system()
            numbers = {s: mpmath.mpf(x) for s, x in system.defaults.items()} | base | motions
            # the definitions would hide the given ω
            point = dict(base)
            for quantity, formula in system.conventions.start_formulas:
                values = evaluate(system, list(sp.Matrix(_components(formula))), numbers)
                point |= dict(zip(quantity.symbols, values, strict=True))
            found.append(divergence(system, {s: point[s] for s in system.symbols}))
        assert abs(found[0] - found[1]) < mpmath.mpf(10) ** -30
        assert abs(found[0]) > mpmath.mpf(10) ** -3


def _components(formula):
    from flowlanes.system.vectors import to_components

    return to_components(formula)


EXISTENCE = {
    "balanced ball": (
        RollingBody(Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), cavity=ALONG), Plane(), "marble"),
        "exists",
    ),
    "balanced rubber ball": (
        RollingBody(Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), cavity=ALONG), Plane(), "rubber"),
        "exists",
    ),
    "balanced by its fluid": (
        RollingBody(
            Body(
                1.0,
                (0.4, 0.5, 0.6),
                Ball(1.0, centre=(0.1, 0.0, 0.0)),
                cavity=Cavity((0.5, 0.4, 0.3), 1.0, centre=(0.2, 0.0, 0.0)),
            ),
            Plane(),
            "rubber",
        ),
        "exists",
    ),
    "ball with its cavity off the centre": (
        RollingBody(Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), cavity=TURNED), Plane(), "marble"),
        "none",
    ),
    "spheroid, coaxial spheroidal cavity": (
        RollingBody(
            Body(
                1.0,
                (0.4, 0.4, 0.6),
                Ellipsoid((1.0, 1.0, 0.8)),
                cavity=Cavity((0.5, 0.5, 0.3), 0.8),
            ),
            Plane(),
            "rubber",
        ),
        "exists",
    ),
    "spheroid, triaxial cavity": (
        RollingBody(
            Body(
                1.0,
                (0.4, 0.4, 0.6),
                Ellipsoid((1.0, 1.0, 0.8)),
                cavity=Cavity((0.5, 0.4, 0.3), 0.8),
            ),
            Plane(),
            "rubber",
        ),
        "none",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("case", EXISTENCE)
def test_existence_is_decided(case):
    rolling, decision = EXISTENCE[case]
    existence = invariant_measure(rolling)
    assert existence.decision == decision
    assert THEOREM in existence.criterion
    assert existence.verdicts[0].law == "volume"
    if existence.density is not None:
        assert existence.system.state[-1] == N


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_the_density_is_a_law_of_the_body_with_fluid(contact):
    """Proven for the equations with fluid themselves, beside the theorem."""
    rolling = replace(EXISTENCE["balanced ball"][0], contact=contact)
    existence = invariant_measure(rolling)
    assert prove(rolling.system(), existence.density).decision == "proven"
