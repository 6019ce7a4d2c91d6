"""Where a polynomial first becomes positive: known roots."""

from __future__ import annotations

import numpy as np
import pytest

from nonholonomic.contact.impact.polynomial_events import first_rise, value

P = np.polynomial.Polynomial


@pytest.mark.parametrize(
    ("roots", "sign", "first"),
    [
        ([0.3, 0.7, 2.0], 1, 0.3),
        ([0.3, 0.34, 0.7, 0.9], -1, 0.3),
        # Up and down again between two of the places looked at.
        ([0.51, 0.54, -1, -2, 3], 1, 0.51),
        ([1.5, 2.0, 3.0], 1, None),
        ([-1.0, -2.0, -3.0, 0.25], 1, 0.25),
        # Zero at the start, falling first.
        ([0.0, 0.01, -1.0, -2.0], 1, 0.01),
        # Zero at the start, rising.
        ([0.0, -1.0, -2.0, -3.0], 1, 0.0),
        ([0.0, 2.0, -1.0, 3.0], -1, None),
        ([0.4, 0.4, -1.0, -2.0], -1, None),
    ],
)
def test_first_rise(roots: list[float], sign: int, first: float | None) -> None:
    series = sign * P.fromroots(roots).coef
    found = first_rise(series, 1.0)
    assert found == (None if first is None else pytest.approx(first, abs=1e-13))


@pytest.mark.parametrize(
    ("series", "first"),
    [
        ([-1.0, 2.0], 0.5),
        ([-1.0, -2.0], None),
        ([0.0, -2.0], None),
        ([0.0, 2.0], 0.0),
        ([-1.0], None),
        ([-1.0, 0.0, 4.0], 0.5),
        ([0.0, -1.0, 2.0], 0.5),
        ([-3.0, 4.0, -1.0], 1.0),
        ([-3.0, 1.0, -1.0], None),
        ([-1e-20, 1.0, 1.0], 1e-20),
        ([0.0, 0.0, 1.0], 0.0),
        ([0.0, 0.0, 0.0], None),
    ],
)
def test_first_rise_of_a_quadratic(series: list[float], first: float | None) -> None:
    found = first_rise(np.array(series), np.inf)
    assert found == (None if first is None else pytest.approx(first, rel=1e-15))


@pytest.mark.parametrize("root", [1e-5, 1e-17, 1e-30, 1e-200])
def test_a_root_near_zero_to_its_own_digits(root: float) -> None:
    series = np.array([-root, 1.0, -1.3, 0.4, 0.1, -0.02])
    assert first_rise(series, 0.2) == pytest.approx(root, rel=2e-5)
    # p(x) = 0 to the last digits of its largest terms
    found = first_rise(series, 0.2)
    assert found is not None
    assert abs(value(series, found)) <= 4e-16 * root


def test_not_beyond_the_end() -> None:
    assert first_rise(np.array([-1.0, 1.0]), 0.5) is None
    assert value(np.array([1.0, 2.0, 3.0]), 2.0) == 17.0
