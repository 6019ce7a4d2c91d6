"""Brackets of cotangent type on the attitude: refuted unless the supports are isotropic."""

from __future__ import annotations

import random
from fractions import Fraction

import numpy as np
import pytest

from borisov_mamaev_2008.open_problems import lifted_bracket


@pytest.mark.parametrize("name", ["Chaplygin ball, D = 1", "three equal supporting balls"])
def test_only_isotropic_supports_lift(name: str) -> None:
    weights = lifted_bracket.WEIGHTS[name]
    assert lifted_bracket.lifts(lifted_bracket.MOMENTS, weights) == (len(set(weights)) == 1)


def test_a_body_with_unequal_supports_is_refuted() -> None:
    rng = random.Random(12)
    moments = [Fraction(rng.randint(10, 20), 10) for _ in range(3)]
    weights = [Fraction(rng.randint(1, 9), 10), Fraction(1), Fraction(rng.randint(0, 9), 10)]
    assert not lifted_bracket.lifts(moments, weights)


def test_the_equations_are_those_of_the_proof() -> None:
    """(M, ω)Θ − (Θ, ω)M − w×ω = Pω×ω, the right-hand side without a derivative."""
    weights = (Fraction(1, 2), Fraction(1, 3), Fraction(1))
    moments = lifted_bracket.MOMENTS
    rows = np.array(lifted_bracket.unknowns(moments, weights), dtype=float)
    axes = np.array(lifted_bracket.ATTITUDE, dtype=float)
    support = axes.T @ np.diag([float(w) for w in weights]) @ axes
    inertia = np.diag([float(i) for i in moments]) + np.trace(support) * np.eye(3) - support
    for i, momentum in enumerate(np.array(lifted_bracket.MOMENTA, dtype=float)):
        omega = np.linalg.solve(inertia, momentum)
        torque = rows[3 * i : 3 * i + 3, -1]
        np.testing.assert_allclose(torque, np.cross(support @ omega, omega), atol=1e-14)
