"""Zeros of functions of one variable, and slopes along a level."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from flowlanes.flow.sampling.counter_rng import counter_normals
from flowlanes.flow.sampling.great_circles import GreatCircleProposal, crossings
from flowlanes.flow.sampling.level_set_fibration import find_fibration
from flowlanes.formulas.array_evaluation import parameter_rows
from flowlanes.formulas.compiled import SystemFormulas
from nonholonomic.catalogue import from_catalogue


def test_all_zeros_of_waves() -> None:
    speeds = np.array([3.0, 11.0, 40.0])

    def waves(which: Any, s: Any) -> tuple[Any, Any]:
        phase = speeds[which] * s + 0.3
        return np.sin(phase), speeds[which] * np.cos(phase)

    which, found = crossings(waves, 3, np.linspace(0, 1, 3))
    for i, speed in enumerate(speeds):
        wanted = (np.arange(1, 20) * np.pi - 0.3) / speed
        assert found[which == i] == pytest.approx(wanted[wanted < 1], abs=1e-11)


def test_a_shallow_dip_is_seen_and_a_near_miss_is_not() -> None:
    depth = np.array([1e-8, -1e-8])

    def dips(which: Any, s: Any) -> tuple[Any, Any]:
        return (s - 0.43) ** 2 - depth[which], 2 * (s - 0.43)

    which, found = crossings(dips, 2, np.array([0.0, 1.0]))
    assert which.tolist() == [0, 0]
    assert found == pytest.approx([0.43 - 1e-4, 0.43 + 1e-4], abs=1e-9)


def test_no_functions_have_no_zeros() -> None:
    which, found = crossings(lambda i, s: (s, s), 0, np.array([0.0, 1.0]))
    assert which.size == found.size == 0


@pytest.mark.parametrize(
    ("name", "level"),
    [
        ("chaplygin-ball", {"energy": 1.0, "area": 0.3, "momentum": 4.0}),
        ("chaplygin-ball-gyrostat", {"energy": 1.0, "area": 0.3, "momentum": 4.0}),
        ("veselova", {"energy": 1.0, "momentum": 2.6}),
        ("lagrange-top", {"energy": 1.0, "area": 0.3, "spin": 0.5}),
        ("unbalanced-ball", {"energy": 1.0, "quadratic": 1.0}),
    ],
)
def test_slopes_along_geodesics_are_difference_quotients(
    name: str, level: dict[str, float]
) -> None:
    system, step = from_catalogue(name), 1e-5
    sheet, parameters = SystemFormulas(system), parameter_rows(system, None, 1)[0]
    chosen = GreatCircleProposal.from_fibration(
        find_fibration(system, sheet, level, parameters), sheet, parameters
    )
    numbers = counter_normals(1, np.arange(100), np.zeros(100), chosen.numbers)
    places, pushes = chosen.curves(numbers)
    inside = chosen.excess(places)[0] > 0.05
    for quantity in (chosen.excess, chosen.value):
        before, after = (
            quantity(chosen.geodesic_points(places, pushes, np.full(100, way))[0])[0]
            for way in (-step, step)
        )
        slope = (quantity(places)[1] * pushes.T).sum(axis=1)
        quotient = (after - before) / (2 * step)
        assert inside.sum() > 50
        assert np.abs(slope - quotient)[inside].max() < 1e-6
