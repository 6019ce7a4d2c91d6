"""Arithmetic of truncated power series against expansions known from analysis."""

from __future__ import annotations

import math

import numpy as np

from contact.power_series import Series, arcsine, root, solution

TERMS = 12


def variable(start: float) -> Series:
    """The series start + t."""
    c = np.zeros(TERMS)
    c[:2] = start, 1.0
    return Series(c)


def test_geometric_series() -> None:
    assert np.allclose((1.0 / (1.0 - variable(0.0))).c, 1.0, atol=1e-15)


def test_square_root_is_the_binomial_series() -> None:
    expected = [1.0]
    for k in range(1, TERMS):
        expected.append(expected[-1] * (1.5 - k) / k)
    assert np.allclose(root(variable(1.0)).c, expected, rtol=1e-14)


def test_inverse_sine_at_zero() -> None:
    expected = np.zeros(TERMS)
    for k in range(TERMS // 2):
        expected[2 * k + 1] = math.comb(2 * k, k) / (4**k * (2 * k + 1))
    assert np.allclose(arcsine(variable(0.0)).c, expected, atol=1e-15)


def test_values_of_a_product_and_a_quotient() -> None:
    x, t = variable(0.3), 0.01
    y = (x * x + 2.0) / (1.0 + x) - x
    value = 0.3 + t
    assert abs(y.at(t) - ((value * value + 2.0) / (1.0 + value) - value)) < 1e-15


def test_linear_system_with_series() -> None:
    x = variable(0.5)
    matrix = [[x, 2.0, 0.0], [1.0, x * x, x], [0.0, 1.0, 3.0]]
    wanted = [x + 1.0, x * x, 1.0 / x]
    right = [sum(a * b for a, b in zip(row, wanted, strict=True)) for row in matrix]
    for got, want in zip(solution(matrix, right), wanted, strict=True):
        assert np.allclose(got.c, want.c, rtol=1e-10, atol=1e-12)
