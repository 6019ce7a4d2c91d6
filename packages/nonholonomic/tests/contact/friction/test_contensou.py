"""Formulas of the coupled law in their ranges, and the limit set of what it holds."""

from __future__ import annotations

import numpy as np
import pytest

from contact.friction_formulas import ContactState
from contact.law_values import law_values
from nonholonomic.contact.friction.contensou import held_range_of, limit_polynomial, range_of
from nonholonomic.contact.friction.dry_friction import ContensouErismann
from nonholonomic.contact.friction.modes import Mode
from nonholonomic.contact.pressure.pressure import Hertz
from nonholonomic.contact.pressure.pressure_limits import COUPLE_AT_ONE, load_factor

HERTZ = Hertz()
MU, PATCH, N = 0.4, 0.03, 2.0
LAW = ContensouErismann(MU, PATCH)
UPRIGHT, NONE = np.array([0.0, 0.0, 1.0]), np.zeros(3)

RANGES = {
    "inner": np.concatenate([[0.0, 1e-12], np.linspace(0.01, 1, 12)]),
    "middle": np.concatenate([1 + np.geomspace(2e-6, 1, 12)]),
    "outer": np.concatenate([2 / np.linspace(1e-6, 1, 8), [1e9]]),
}


def sliding(k, spin=-3.0):
    """A contact with k = |u|/(a|Ω|)."""
    slip = k * PATCH * abs(spin) * np.array([0.6, -0.8, 0.0])
    return ContactState(slip, spin, NONE, UPRIGHT, np.eye(3))


@pytest.mark.parametrize("span", RANGES)
def test_factors_are_those_of_hertz(span):
    for k in RANGES[span]:
        at = sliding(k)
        found = law_values(LAW, Mode(range=span), at)
        force = -MU * HERTZ.force(k) * np.array([0.6, -0.8, 0.0])
        np.testing.assert_allclose(found.p, force, rtol=1e-14, atol=4e-16)
        couple = MU * PATCH * HERTZ.couple(k)
        assert found.q[2] == pytest.approx(couple, rel=1e-14, abs=4e-16 * PATCH)


def test_a_range_ends_where_the_next_begins():
    for k in [0.2, 0.999, 1.00001, 1.5, 1.999, 2.001, 50.0]:
        at = sliding(k)
        span = range_of(float(np.linalg.norm(at.slip)), at.spin, PATCH)
        assert law_values(LAW, Mode(range=span), at).guards["range"] > 0
        lower, upper = min(RANGES[span]), max(RANGES[span])
        assert lower - 1e-5 <= k <= upper
    # past its end each formula still serves: neighbours overlap
    assert law_values(LAW, Mode(range="inner"), sliding(1.0000015)).guards["range"] > 0
    assert law_values(LAW, Mode(range="inner"), sliding(1.000003)).guards["range"] < 0
    outer = law_values(LAW, Mode(range="outer"), sliding(1.9999)).guards["range"]
    assert outer < 0


def test_sliding_and_spinning_end_together():
    at = sliding(0.7, spin=1e-9)
    assert law_values(LAW, Mode(range="inner"), at).guards["stop"] < 0
    assert law_values(LAW, Mode(range="inner"), sliding(0.7)).guards["stop"] > 0


def held(force, couple):
    """Guards of a held contact with |f|/(μN) and τ/(μNa)."""
    span = held_range_of(couple * MU * N, MU * N)
    at = ContactState(NONE, np.sign(couple), NONE, UPRIGHT, np.eye(3))
    friction = MU * N * force * np.array([0.6, -0.8, 0.0])
    mode = Mode(sliding=False, spinning=False, range=span)
    return law_values(LAW, mode, at, N, friction, MU * N * PATCH * couple).guards


def test_the_guard_is_the_limit_set():
    random = np.random.default_rng(5)
    forces, couples = random.uniform(0, 1.2, 40), random.uniform(-0.6, 0.6, 40)
    inside = load_factor(HERTZ, forces, np.abs(couples)) < 1
    found = [held(f, c) for f, c in zip(forces, couples, strict=True)]
    np.testing.assert_array_equal([guards["slip"] > 0 for guards in found], inside)
    assert all(guards["range"] > 0 for guards in found)
    assert 12 < inside.sum() < 28


@pytest.mark.parametrize("sign", [1, -1])
def test_the_edge_of_the_limit_set_to_rounding(sign):
    for k in np.concatenate([np.linspace(0.02, 0.99, 9), 1 + np.geomspace(1e-4, 1e5, 15)]):
        force, couple = float(HERTZ.force(k)), float(HERTZ.couple(k))
        margin = held(force, sign * couple)["slip"] / (MU * N) ** 2
        assert abs(margin) < 1e-14


def test_the_parts_of_the_limit_set_overlap():
    edge = float(COUPLE_AT_ONE)
    for couple in (edge * (1 - 1.9e-6), edge * (1 - 1.1e-6)):
        at = ContactState(NONE, 1.0, NONE, UPRIGHT, np.eye(3))
        for span in ("above", "below"):
            mode = Mode(sliding=False, spinning=False, range=span)
            guards = law_values(LAW, mode, at, N, NONE, MU * N * PATCH * couple).guards
            assert guards["range"] > 0


def test_the_polynomial_of_the_limit_set_is_even_in_the_couple():
    # at vanishing couple, 1 − F = z² · 5/2 + …: with 1/k = 5z, F = 1 − 1/(10k²)
    z = 1e-3
    t = 2 * np.sqrt(1 - (z / float(COUPLE_AT_ONE)) ** 2) - 1
    force = np.polynomial.polynomial.polyval(t, limit_polynomial())
    assert 1 - force == pytest.approx(2.5 * z**2, rel=1e-4)
