"""Accelerations and reactions of every mode, against dense linear equations of their own."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import sympy as sp

from contact.dense_motion import Motion, accelerations, random_state, rotation
from flowlanes.system.vectors import to_components
from nonholonomic.contact.equations.equations_of_motion import contact_equations
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.dry_friction import ContensouErismann, Coulomb, SpinFriction
from nonholonomic.contact.friction.modes import FLIGHT, Mode
from nonholonomic.contact.friction.rolling_friction import (
    ContourResistance,
    RollingResistance,
    ViscousRolling,
)
from nonholonomic.contact.friction.symbols import spin_sign
from nonholonomic.contact.friction.viscous_friction import NormalViscous, Viscous
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces
from nonholonomic.mechanics.shapes.shapes import Ball, Ellipsoid
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere

FULL = ((1.2, 0.1, -0.2), (0.1, 1.5, 0.3), (-0.2, 0.3, 2.1))
EGG = Ellipsoid((1.0, 1.2, 0.9), turn=0.4, centre=(0.1, -0.2, 0.15))
BODIES = {
    "egg": Body(1.3, FULL, EGG, gyrostat=(0.3, -0.4, 0.5)),
    "ball": Body(0.7, (1.2, 1.5, 2.1), Ball(0.9, centre=(0.1, -0.2, 0.15))),
}
SURFACES = {
    "plane": Plane(),
    "turntable": Plane(turntable=0.7),
    "outside": Sphere(2.0),
    "inside": Sphere(6.0, side="inside"),
    "turning dome": Sphere(2.0, turntable=-0.6),
}
POINT = (
    Coulomb(0.3),
    SpinFriction(0.02),
    Viscous(0.4, 0.05),
    NormalViscous(0.1),
    RollingResistance(0.03),
    ViscousRolling(0.02),
)
PATCH = (ContensouErismann(0.3, 0.8), Viscous(0.4, 0.05), ContourResistance(0.02))
MODES = {
    "sliding": (POINT, Mode()),
    "sliding, spin held": (POINT, Mode(spinning=False)),
    "rolling": (POINT, Mode(sliding=False)),
    "rolling, spin held": (POINT, Mode(sliding=False, spinning=False)),
    "inner": (PATCH, Mode(range="inner")),
    "middle": (PATCH, Mode(range="middle")),
    "outer": (PATCH, Mode(range="outer")),
    "patch held": (PATCH, Mode(sliding=False, spinning=False, range="below")),
    "flight": (POINT, FLIGHT),
}
#: Bounds of k = |u|/(a|Ω|) in the ranges.
RATIOS = {"inner": (0.0, 1.0), "middle": (1.001, 2.0), "outer": (2.001, np.inf)}
SETTINGS = [
    ("egg", "plane"),
    ("egg", "turntable"),
    ("egg", "outside"),
    ("egg", "inside"),
    ("ball", "turning dome"),
    ("ball", "plane"),
]
#: The ball goes through all modes at once; of the others some are left to the slow tests.
CASES = [
    pytest.param((*setting, mode), marks=() if setting == SETTINGS[-1] else pytest.mark.slow)
    for setting in SETTINGS
    for mode in MODES
]


@cache
def machine(body, surface, mode):
    """A situation, its system, and everything of interest as a function of state and parameters."""
    laws, kind = MODES[mode]
    situation = FrictionalContact(BODIES[body], SURFACES[surface], laws, Forces(gravity=1.7))
    system = contact_equations(situation, kind)
    wanted = {f"rate of {i}": rate for i, rate in enumerate(system.rates)}
    wanted |= {item.name: to_components(item.value) for item in system.observables}
    wanted |= {"balance": to_components(system.integrals[0].value)}
    wanted |= {f"relation {i}": to_components(x) for i, x in enumerate(system.relations)}
    entries = {n: list(e) if isinstance(e, sp.MatrixBase) else [e] for n, e in wanted.items()}
    names = [*system.symbols, *system.defaults]
    formulas = [x for e in entries.values() for x in e]
    steps = list(system.required_definitions(formulas))
    function = sp.lambdify(names, formulas, "numpy", cse=lambda e: (steps, e))
    return situation, system, function, {name: len(e) for name, e in entries.items()}


def parts(case, y, gamma):
    """Rates of the state, observables, rate of the balance, and relations."""
    situation, system, function, sizes = machine(*case)
    turn = rotation(y[:4])
    state = np.zeros(len(system.symbols))
    state[:16] = [*y[:7], *(turn.T @ y[7:10]), *y[10:13], *gamma]
    sign = 1.0 if Motion(situation).spin(y, gamma).real >= 0 else -1.0
    constants = list((system.defaults | {spin_sign: sign}).values())
    found = np.array(function(*state, *constants))
    rates = found[: len(state)]
    moved = np.array(function(*(state + 1e-30j * rates), *constants)).imag / 1e-30
    ends = np.cumsum(list(sizes.values()))[:-1]
    values = dict(zip(sizes, np.split(found, ends), strict=True))
    along = dict(zip(sizes, np.split(moved, ends), strict=True))
    relations = [float(x[0]) for name, x in values.items() if name.startswith("relation")]
    return rates, values, float(along["balance"][0]), relations


def states(case, number=4):
    situation, _, _, _ = machine(*case)
    mode, motion = MODES[case[2]][1], Motion(situation)
    random = np.random.default_rng([ord(c) for c in "/".join(case)])
    for _ in range(number):
        y, gamma = random_state(situation, mode, random)
        if mode.range in RATIOS:
            # the slip made so long that k lies in the range
            low, high = RATIOS[mode.range]
            k = 1 / random.uniform(1 / high, 1 / low) if low else random.uniform(low, high)
            slip, spin = motion.slip(y, gamma).real, motion.spin(y, gamma).real
            y[7:10] += slip * (k * PATCH[0].patch * abs(spin) / np.linalg.norm(slip) - 1)
        yield y, gamma


@pytest.mark.parametrize("case", CASES)
def test_accelerations_and_reaction(case):
    situation, _, _, _ = machine(*case)
    mode = MODES[case[2]][1]
    for y, gamma in states(case):
        expected = accelerations(situation, mode, y, gamma)
        rates, values, balance, relations = parts(case, y, gamma)
        turn = rotation(y[:4])
        body_rate = turn.T @ expected.velocity - np.cross(y[10:13], turn.T @ y[7:10])
        size = 1 + abs(expected.normal_force)
        np.testing.assert_allclose(rates[7:10], body_rate, atol=1e-12 * size)
        np.testing.assert_allclose(rates[10:13], expected.omega, atol=1e-12 * size)
        np.testing.assert_allclose(rates[13:16], expected.gamma, atol=1e-12)
        np.testing.assert_allclose(rates[4:7], y[7:10], atol=1e-14)
        assert values["normal_force"][0] == pytest.approx(expected.normal_force, rel=1e-11, abs=0)
        whole = expected.normal_force * gamma + values["friction_force"]
        np.testing.assert_allclose(whole, expected.force, atol=1e-12 * size)
        np.testing.assert_allclose(values["friction_couple"], expected.couple, atol=1e-12 * size)
        assert abs(balance) < 1e-12 * size
        assert np.abs(relations).max() < 1e-14 * (1 + np.linalg.norm(y))
