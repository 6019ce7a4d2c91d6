"""§11: the share of friction in slow sliding, by direct integration over the contact disk."""

from __future__ import annotations

import numpy as np
import pytest

from borisov_mamaev_2008.section_11.section_11_3b import sliding_share


def friction(sliding: float, points: int = 801) -> float:
    """Force on a unit disk under Hertz' pressure, spin 1, friction 1, load 1."""
    # r = sin u takes the root out of the pressure
    u = (np.arange(points) + 0.5) / points * np.pi / 2
    angle = (np.arange(points) + 0.5) / points * 2 * np.pi
    r, cell = np.sin(u)[:, None], (np.pi / 2 / points) * (2 * np.pi / points)
    weight = 3 / (2 * np.pi) * np.cos(u)[:, None] ** 2 * r * cell
    along, across = sliding - r * np.sin(angle), r * np.cos(angle)
    return float(np.sum(weight * along / np.hypot(along, across)))


@pytest.mark.parametrize("sliding", [0.01, 0.02])
def test_slow_sliding_feels_a_force_in_proportion(sliding: float) -> None:
    assert friction(sliding) / sliding == pytest.approx(float(sliding_share()), rel=5e-3)


def test_fast_sliding_feels_the_force_of_coulomb() -> None:
    assert friction(50.0) == pytest.approx(1.0, rel=1e-3)
