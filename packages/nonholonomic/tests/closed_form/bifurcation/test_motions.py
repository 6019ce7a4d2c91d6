"""Bifurcation diagrams against the motions themselves: numbers of tori, stability, existence."""

from __future__ import annotations

import random
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from closed_form.tori_followed import counted
from flowlanes.flow.linearisation.linear_stability import linear_stability
from flowlanes.system.vectors import to_components
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form.bifurcation import bifurcation_diagram
from nonholonomic.closed_form.bifurcation.families import SEPARATIONS
from nonholonomic.closed_form.separations.chaplygin_ball_area_constant import chaplygin_area

QUICK = ("veselova", "chaplygin-ball", "neumann", "rubber-ball-of-ratio")
SLOW = tuple(name for name in SEPARATIONS if name not in QUICK)


# --- numbers of tori -----------------------------------------------------------------------


def _agrees(separable, diagram):
    regions = [region for region in diagram.regions if region.tori]
    assert regions
    for region in regions:
        assert counted(separable, diagram, region, 30.0) == [f.tori for f in region.families]


@pytest.mark.slow
@pytest.mark.parametrize("name", QUICK)
def test_tori_followed(name):
    separable = SEPARATIONS[name]()
    _agrees(separable, bifurcation_diagram(separable))


@pytest.mark.slow
@pytest.mark.parametrize("name", SLOW)
def test_more_tori_followed(name):
    separable = SEPARATIONS[name]()
    _agrees(separable, bifurcation_diagram(separable))


@pytest.mark.slow
def test_tori_of_the_ball_with_any_area():
    _agrees(chaplygin_area(), bifurcation_diagram("chaplygin-ball-area"))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(
    "name", ["neumann", "veselova-bruns", "chaplygin-ball-bruns", "chaplygin-ball-area"]
)
def test_tori_of_other_bodies(name, seed):
    generator = random.Random(f"{name} {seed}")
    separable = chaplygin_area() if name == "chaplygin-ball-area" else SEPARATIONS[name]()
    moments = generator.sample(range(100, 200), 3)
    values = {f"I_{i}": Fraction(moment, 100) for i, moment in enumerate(moments, 1)}
    strength = Fraction(generator.choice([-1, 1]) * generator.randint(3, 20), 10)
    values |= {s: strength for s in ("c", "K") if s in map(str, separable.system.defaults)}
    diagram = bifurcation_diagram(name, values)
    for region in diagram.regions:
        wanted = [family.tori for family in region.families]
        # near resonances and separatrices a motion takes long to go everywhere
        reached = (counted(separable, diagram, region, until) for until in (40.0, 400.0))
        assert wanted in reached if wanted else not region.tori


# --- existence -----------------------------------------------------------------------------


def _numeric(system, formulas, parameters):
    wanted = [to_components(sp.sympify(formula)) for formula in formulas]
    for symbol, value in reversed(system.scalar_definitions):
        wanted = [formula.xreplace({symbol: value}) for formula in wanted]
    known = {s: sp.Rational(str(v)) for s, v in parameters.items()}
    return sp.lambdify(system.symbols, [w.subs(known) for w in wanted], "numpy", cse=True)


@pytest.mark.parametrize("name", ["veselova", "veselova-bruns", "neumann", "chaplygin-ball-area"])
def test_every_motion_lies_in_a_region_with_tori(name):
    diagram = bifurcation_diagram(name)
    system = diagram.plane.system
    values = _numeric(system, [axis.value for axis in diagram.axes], diagram.parameters)
    generator = np.random.default_rng(5)
    met = set()
    for _ in range(60):
        up, other = generator.normal(size=(2, 3))
        up /= np.linalg.norm(up)
        if name == "chaplygin-ball-area":
            # M first, on M² = 1
            state = [*other / np.linalg.norm(other), *up]
        else:
            state = [*(other - other @ up * up) * generator.uniform(0.1, 1.5), *up]
        region = diagram.region(*values(*state))
        assert region is not None
        assert region.tori
        met.add(region.number)
    # the thin region of four tori may be missed
    assert len(met) >= 2


# --- stability -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "normal", "moving"),
    [
        ("neumann", "Gamma", "M"),
        ("veselova-bruns", "gamma", "omega"),
        ("chaplygin-ball-bruns", "gamma", "M"),
    ],
)
def test_equilibria_linearised(name, normal, moving):
    diagram = bifurcation_diagram(name)
    assert len(diagram.equilibria) == 3
    system = diagram.plane.system
    for corner in diagram.equilibria:
        state = {f"{moving}_{i}": 0 for i in (1, 2, 3)}
        state |= {f"{normal}_{i}": int(i == corner.axis) for i in (1, 2, 3)}
        rates = linear_stability(system, state).eigenvalues
        growing = sum(1 for rate in rates if rate.real > 1e-6)
        turning = sum(1 for rate in rates if rate.imag > 1e-6)
        assert (growing, turning) == (2 - corner.centres, corner.centres)


@pytest.mark.parametrize("axis", [1, 2, 3])
def test_vertical_rotations_of_the_ball_linearised(axis):
    """They are where the rotations about an axis meet the motions with M vertical."""
    diagram = bifurcation_diagram("chaplygin-ball-area")
    (boundary,) = (b for b in diagram.boundaries if b.pole == axis)
    system = from_catalogue("chaplygin-ball")
    unit = {1: (1, 0, 0), 2: (0, 1, 0), 3: (0, 0, 1)}[axis]
    state = {f"M_{i + 1}": c for i, c in enumerate(unit)}
    state |= {f"gamma_{i + 1}": c for i, c in enumerate(unit)}
    inertia = {1: "1", 2: "1.5", 3: "2.1"}[axis]
    on = boundary.curve.subs(
        {diagram.axes[0].symbol: 1 / (2 * sp.Rational(inertia)), diagram.axes[1].symbol: 1}
    )
    assert on == 0
    growing = [rate for rate in linear_stability(system, state).eigenvalues if rate.real > 1e-6]
    assert bool(growing) != boundary.stable


def _multipliers(system, parameters, start, period):
    """Floquet's multipliers: how a round of a periodic motion changes deviations."""
    symbols = system.symbols
    rates = _numeric(system, system.rates, parameters)
    wanted = list(system.rates)
    for symbol, value in reversed(system.scalar_definitions):
        wanted = [formula.xreplace({symbol: value}) for formula in wanted]
    known = {s: sp.Rational(str(v)) for s, v in parameters.items()}
    slopes = sp.lambdify(
        symbols, sp.Matrix([w.subs(known) for w in wanted]).jacobian(symbols), "numpy", cse=True
    )

    def together(_, values):
        state, deviations = values[:6], values[6:].reshape(6, 6)
        return np.concatenate([rates(*state), (slopes(*state) @ deviations).ravel()])

    whole = np.concatenate([start, np.eye(6).ravel()])
    run = solve_ivp(together, (0, period), whole, method="DOP853", rtol=1e-11, atol=1e-13)
    np.testing.assert_allclose(run.y[:6, -1], start, atol=1e-8)
    return np.linalg.eigvals(run.y[6:, -1].reshape(6, 6))


def _rotation(name, axis, tilt):
    """ω of length 1 along a body axis, γ inclined to it by `tilt`; then the state."""
    system = from_catalogue(name)
    omega = np.eye(3)[axis - 1]
    gamma = np.cos(tilt) * omega + np.sin(tilt) * np.roll(omega, 1)
    if name == "veselova":
        return system, np.concatenate([omega, gamma])
    inertia, D = np.array([1.0, 1.5, 2.1]), 1.0
    return system, np.concatenate([(inertia + D) * omega - D * (omega @ gamma) * gamma, gamma])


@pytest.mark.slow
@pytest.mark.parametrize("axis", [1, 2, 3])
@pytest.mark.parametrize(
    ("plane", "name", "tilt"),
    [
        ("veselova", "veselova", np.pi / 2),
        ("chaplygin-ball", "chaplygin-ball", np.pi / 2),
        ("chaplygin-ball-area", "chaplygin-ball", 0.7),
    ],
    ids=["veselova", "horizontal-ball", "inclined-ball"],
)
def test_permanent_rotations_go_with_floquet(plane, name, tilt, axis):
    diagram = bifurcation_diagram(plane)
    (boundary,) = (b for b in diagram.boundaries if b.pole == axis)
    system, start = _rotation(name, axis, tilt)
    multipliers = _multipliers(system, system.defaults, start, 2 * np.pi)
    # double multipliers 1 are defective and come out to 1e-4
    assert bool(abs(multipliers).max() > 1.01) != boundary.stable
