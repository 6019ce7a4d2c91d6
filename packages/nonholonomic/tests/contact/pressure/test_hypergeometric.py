"""The hypergeometric function ₂F₁(a, ½; c; z) against multiprecision."""

from __future__ import annotations

from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest

from contact.patches import relative_error
from nonholonomic.contact.pressure.hypergeometric import (
    half_beta,
    half_hypergeometric,
    series_coefficients,
)


@pytest.mark.parametrize("seed", range(12))
def test_random_parameters(seed):
    random = np.random.default_rng(seed)
    a = random.choice([-0.5, 0.5, -random.uniform(0, 20)])
    c = random.uniform(1.01, 3) + max(a, 0)
    complement = np.concatenate(
        [[0.0, 1.0, 0.5], random.uniform(0, 1, 4), 10.0 ** -np.arange(1, 16, 3)]
    )
    z = 1 - complement
    with mp.workdps(40):
        exact = [mp.hyp2f1(mp.mpf(a), mp.mpf(0.5), mp.mpf(c), 1 - mp.mpf(w)) for w in complement]
    # of z only the complement is exact here
    assert relative_error(half_hypergeometric(a, c, z, complement), exact) < 1.5e-15


@pytest.mark.parametrize("b", [0.51, 1.0, 7.3, 165.0, 2000.0])
def test_beta(b):
    with mp.workdps(30):
        assert half_beta(b) == pytest.approx(float(mp.beta(mp.mpf(0.5), mp.mpf(b))), rel=1e-15)


def test_coefficients_are_exact():
    # ₂F₁(½, ½; 3/2; z²) = arcsin(z)/z
    half = Fraction(1, 2)
    assert series_coefficients(half, half, 3 * half, 4) == [
        1,
        Fraction(1, 6),
        Fraction(3, 40),
        Fraction(5, 112),
    ]


def test_any_number_of_values_at_once():
    z = np.linspace(0, 1, 9001)
    many = half_hypergeometric(0.5, 2.0, z, 1 - z)
    np.testing.assert_array_equal(
        many[::3000], half_hypergeometric(0.5, 2.0, z[::3000], 1 - z[::3000])
    )
    assert half_hypergeometric(0.5, 2.0, np.empty((0, 2)), np.empty((0, 2))).shape == (0, 2)
