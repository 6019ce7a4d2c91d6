"""The first falling root of a polynomial in the unit interval."""

from __future__ import annotations

import numpy as np
import pytest

from flowlanes.flow.taylor.first_root import first_falling_root


def with_roots(*roots: float, sign: float = 1.0) -> np.ndarray:
    return sign * np.polynomial.polynomial.polyfromroots(roots)


@pytest.mark.parametrize("seed", range(40))
def test_roots_are_those_of_the_factors(seed: int) -> None:
    random = np.random.default_rng(seed)
    roots = np.sort(random.uniform(-0.5, 1.5, random.integers(1, 7)))
    coefficients = with_roots(*roots, sign=random.choice([-1.0, 1.0]))
    slopes = np.polynomial.polynomial.polyder(coefficients)
    falling = [x for x in roots if 0 < x <= 1 and np.polynomial.polynomial.polyval(x, slopes) < 0]
    root = first_falling_root(coefficients)
    assert (root is None) == (not falling)
    if falling:
        assert root == pytest.approx(falling[0], abs=1e-9)
        later = first_falling_root(coefficients, falling[0] + 1e-6)
        assert (later is None) == (len(falling) == 1)
        if later is not None:
            assert later == pytest.approx(falling[1], abs=1e-9)


def test_roots_that_lie_close_together_are_told_apart() -> None:
    # it rises at the first, falls at the second
    assert first_falling_root(with_roots(0.5, 0.5 + 1e-6, sign=-1.0)) == pytest.approx(
        0.5 + 1e-6, abs=1e-9
    )


@pytest.mark.parametrize(
    ("coefficients", "expected"),
    [
        ([1.0, -1.0], 1.0),
        ([0.0, -1.0], None),
        ([0.0, 1.0, -1.0], 1.0),
        ([0.0, 1.0, -2.0], 0.5),
        ([-1.0, 1.0], None),
        ([0.25, -1.0, 1.0 + 1e-12], None),
    ],
)
def test_roots_at_the_ends(coefficients: list[float], expected: float | None) -> None:
    root = first_falling_root(np.array(coefficients))
    assert root == (None if expected is None else pytest.approx(expected, abs=1e-12))
