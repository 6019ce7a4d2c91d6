"""Dry friction of prescribed direction: the law itself where the slip has that direction."""

from __future__ import annotations

import math

import numpy as np
import pytest

from contact.friction_formulas import ContactState, reaction
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.vectors import to_components
from nonholonomic.contact.friction.dry_friction import ContensouErismann, Coulomb
from nonholonomic.contact.friction.modes import Mode
from nonholonomic.contact.friction.prescribed_friction import (
    DEGREE,
    HEADING_COEFFICIENTS,
    LATITUDE_COEFFICIENTS,
    PrescribedDirection,
    PrescribedRolling,
    clock,
    duration,
    prescribed_direction,
)
from nonholonomic.contact.friction.rolling_friction import ContourResistance, RollingResistance
from nonholonomic.contact.friction.symbols import contour_couple, gamma, slip, spin, spin_sign
from nonholonomic.contact.friction.user_friction import UserFriction

MU, PATCH = 0.3, 0.02
NORMAL = np.array([0.48, -0.6, 0.64])
FIRST = np.array([0.9, 0.7, -0.1])
HEADINGS = np.array([0.3, -0.2, 0.05, 0.01, -0.02, 0.03, 0.004])
LATITUDES = 0.1 * HEADINGS[::-1]


def beginning(law, at, latitude=0.0, sign=1.0):
    """Direction, force and couple at a time in units of the duration."""
    known = dict(zip(gamma.symbols, NORMAL, strict=True)) | {clock: at, spin_sign: sign}
    values = {"mu": MU, "patch": PATCH, "theta_0": latitude, "duration": 0.1}
    values |= {f"n_0_{i}": x for i, x in enumerate(FIRST, 1)}
    values |= dict(zip(map(str, HEADING_COEFFICIENTS), HEADINGS, strict=True))
    values |= dict(zip(map(str, LATITUDE_COEFFICIENTS), LATITUDES, strict=True))
    known |= {p.symbol: values.get(str(p.symbol), p.default) for p in law.parameters}
    known |= dict(zip(slip.symbols, 0.2 * direction_at(at), strict=True)) | {spin: sign * 0.5}
    for symbol, formula in flat_pairs(law.definitions(Mode())):
        known[symbol] = float(formula.xreplace(known))
    parts = law.reaction(Mode())
    numbers = [
        np.array([float(x.xreplace(known)) for x in to_components(part).as_explicit()])
        for part in (parts.p, parts.q)
    ]
    return known, *numbers


def direction_at(at):
    across = FIRST - (NORMAL @ FIRST) * NORMAL
    across /= np.linalg.norm(across)
    angle = HEADINGS @ at ** np.arange(1, DEGREE + 1)
    return math.cos(angle) * across + math.sin(angle) * np.cross(NORMAL, across)


@pytest.mark.parametrize("at", [0.0, 0.4, 1.0])
def test_coulomb(at):
    _, p, q = beginning(PrescribedDirection(), at)
    expected, *_ = reaction(Coulomb(MU), ContactState(direction_at(at), 1.0, None, NORMAL, None))
    np.testing.assert_allclose(p, expected, atol=1e-16)
    assert not q.any()


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize(("span", "k"), [("inner", 0.3), ("middle", 1.4), ("outer", 8.0)])
def test_coupled_law(span, k, sign):
    at = 0.6
    # the angle of (|u|, aΩ) from the axis of spin
    first = math.atan2(k, sign) - LATITUDES @ at ** np.arange(1, DEGREE + 1)
    law = PrescribedDirection("contensou", span)
    _, p, q = beginning(law, at, first, sign)
    contact_state = ContactState(k * PATCH * direction_at(at), sign, None, NORMAL, None)
    force, couple, *_ = reaction(ContensouErismann(MU, PATCH), contact_state)
    np.testing.assert_allclose(p, force, atol=1e-15)
    np.testing.assert_allclose(q, couple, atol=1e-15 * PATCH)


def test_the_clock_runs_in_units_of_the_duration():
    assert PrescribedDirection().clocks == ((clock, 1 / duration),)
    assert not PrescribedDirection().guards(Mode())


def test_the_law_in_whose_place_it_stands():
    law = PrescribedDirection("contensou", "inner")
    names = {str(p.symbol) for p in law.parameters}
    assert {"mu", "patch", "theta_0", "theta_7", "phi_7", "n_0_3", "duration"} <= names
    assert "patch" not in {str(p.symbol) for p in PrescribedDirection().parameters}


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_law_of_the_user(sign):
    law = UserFriction("mu + slip_speed", couple="spin/(3 + spin)", parameters={"mu": 0.4})
    _, p, q = beginning(prescribed_direction(law), 0.4, sign=sign)
    np.testing.assert_allclose(p, -0.6 * direction_at(0.4), atol=1e-15)
    np.testing.assert_allclose(q, -sign * NORMAL / 7, atol=1e-15)


def test_what_stands_in_its_place():
    assert prescribed_direction(Coulomb(0.3)) == PrescribedDirection()
    assert prescribed_direction(ContensouErismann(0.3, 0.1), "inner").range == "inner"


@pytest.mark.parametrize("at", [0.0, 0.4, 1.0])
def test_resistance_to_rolling(at):
    _, p, q = beginning(PrescribedRolling(RollingResistance(0.02)), at)
    contact_state = ContactState(direction_at(at), 1.0, direction_at(at), NORMAL, None)
    _, expected, *_ = reaction(RollingResistance(0.02), contact_state)
    np.testing.assert_allclose(q, expected, atol=1e-17)
    assert not p.any()


def test_resistance_along_the_contour():
    law = PrescribedRolling(ContourResistance(0.02))
    assert law.name == "contour"
    assert law.reaction(Mode()).q == ContourResistance(0.02).reaction(Mode()).q
    assert set(contour_couple.symbols) <= to_components(law.reaction(Mode()).q).free_symbols
