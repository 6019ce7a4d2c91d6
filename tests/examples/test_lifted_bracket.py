"""Brackets of cotangent type on the attitude: refuted unless the supports are isotropic."""

from __future__ import annotations

import random
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "examples"))
import lifted_bracket

MOMENTS = lifted_bracket.MOMENTS


@pytest.mark.parametrize("name", [*lifted_bracket.WEIGHTS][::4])
def test_only_isotropic_supports_lift(name: str) -> None:
    weights = lifted_bracket.WEIGHTS[name]
    assert lifted_bracket.lifts(MOMENTS, weights) == (len(set(weights)) == 1)


def test_every_body_with_unequal_supports_is_refuted() -> None:
    dice = random.Random(12)
    moments = [Fraction(dice.randint(10, 20), 10) for _ in range(3)]
    weights = [Fraction(dice.randint(1, 9), 10), Fraction(1), Fraction(dice.randint(0, 9), 10)]
    assert not lifted_bracket.lifts(moments, weights)


def test_the_equations_are_those_of_the_proof() -> None:
    """(M, ω)Θ − (Θ, ω)M − w×ω = Pω×ω, the right-hand side without a derivative."""
    weights = (Fraction(1, 2), Fraction(1, 3), Fraction(1))
    rows = np.array(lifted_bracket.unknowns(MOMENTS, weights), dtype=float)
    axes = np.array(lifted_bracket.ATTITUDE, dtype=float)
    support = axes.T @ np.diag([float(w) for w in weights]) @ axes
    inertia = np.diag([float(i) for i in MOMENTS]) + np.trace(support) * np.eye(3) - support
    for i, momentum in enumerate(np.array(lifted_bracket.MOMENTA, dtype=float)):
        omega = np.linalg.solve(inertia, momentum)
        torque = rows[3 * i : 3 * i + 3, -1]
        np.testing.assert_allclose(torque, np.cross(support @ omega, omega), atol=1e-14)
