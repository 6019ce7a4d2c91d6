"""The equations of the laws of friction keep what any force keeps, and lose what a couple takes."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import nonholonomic
from flowlanes.formulas.array_evaluation import values
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System
from nonholonomic.contact import ContensouErismann, Coulomb, FrictionLaw, NormalViscous, Viscous
from nonholonomic.contact.equations.equations_of_motion import contact_equations
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.modes import Mode
from nonholonomic.contact.friction.symbols import couple, reaction
from nonholonomic.mechanics.rotations import upright

MOMENTS, RADIUS, OFFSET = np.array([0.4, 0.4, 0.3]), 1.0, 0.2
TOP = nonholonomic.Body(1.3, (0.4, 0.4, 0.3), nonholonomic.Ball(RADIUS, centre=(0.0, 0.0, OFFSET)))
LAWS = (Coulomb(0.3), Viscous(0.5), NormalViscous(0.4), ContensouErismann(0.3, 0.05))


@cache
def system_of(law: FrictionLaw) -> System:
    contact = FrictionalContact(
        TOP, nonholonomic.Plane(), (law,), nonholonomic.Forces(gravity=9.81)
    )
    return contact_equations(contact, Mode(range="outer"))


def random_state(seed: int) -> tuple[FloatArray, FloatArray]:
    """A sliding state without its works, and the contact."""
    random = np.random.default_rng(seed)
    gamma = random.normal(size=3)
    gamma /= np.linalg.norm(gamma)
    omega, u = random.normal(size=3), 3 * random.normal(size=3)
    r = np.array([0.0, 0.0, OFFSET]) - RADIUS * gamma
    v = u - (u @ gamma) * gamma - np.cross(omega, r)
    turn = [float(x) for x in upright(list(map(float, gamma)))]
    return np.array([*turn, 0.0, 0.0, -r @ gamma, *v, *omega, *gamma]), r


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
@pytest.mark.parametrize("seed", [1, 2])
def test_the_rate_of_jellett(law: FrictionLaw, seed: int) -> None:
    system = system_of(law)
    state, r = random_state(seed)
    whole = np.append(state, np.zeros(len(system.symbols) - len(state)))[None]
    rates = values(system, system.rates, whole)[0]
    K, R = (values(system, list(x.symbols), whole)[0] for x in (couple, reaction))
    omega, gamma = state[10:13], state[13:16]
    swing = rates[13:16]
    np.testing.assert_allclose(swing, np.cross(gamma, omega), rtol=0, atol=1e-14)
    change = -MOMENTS * rates[10:13] @ r + RADIUS * (MOMENTS * omega) @ swing
    assert change == pytest.approx(-K @ r, abs=1e-13)
    # without forces nothing would be tested
    assert abs(R @ gamma) > 0.1
    assert (np.abs(K).max() > 0) == isinstance(law, ContensouErismann)
