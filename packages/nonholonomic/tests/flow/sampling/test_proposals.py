"""The largest of a quantity, sought from random throws."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from flowlanes.flow.sampling.level_set_fibration import find_fibration
from flowlanes.flow.sampling.proposals import RayProposal, maximise
from flowlanes.formulas.array_evaluation import parameter_rows
from flowlanes.formulas.compiled import SystemFormulas
from nonholonomic.catalogue import from_catalogue

SYSTEM = from_catalogue("veselova")
VALUES = parameter_rows(SYSTEM, None, 1)[0]
MADE = find_fibration(SYSTEM, SystemFormulas(SYSTEM), {"energy": 1.0}, VALUES)
PEAK = np.array([0.36, 0.48, -0.8])


def same(gauss: Any, _: Any) -> Any:
    return gauss


def test_a_narrow_peak_is_found() -> None:
    def height(gauss: Any) -> tuple[Any, Any]:
        places = MADE.uniform_points(gauss)
        off = places[:3] - PEAK[:, None]
        return places, np.exp(-1000 * (off * off).sum(axis=0))

    top, place = maximise(MADE, height, same, MADE.numbers)
    assert top == pytest.approx(1.0, abs=1e-5)
    assert place[:3] == pytest.approx(PEAK, abs=1e-3)


def test_nothing_is_less_than_anything() -> None:
    def empty(gauss: Any) -> tuple[Any, Any]:
        return gauss[:, :0], np.zeros(0)

    assert maximise(MADE, empty, same, MADE.numbers)[0] == -np.inf


def test_every_throw_on_a_level_of_the_whole_sphere_gives_a_point() -> None:
    ends = RayProposal(MADE, VALUES)
    gauss = np.random.default_rng(1).normal(size=(ends.numbers, 30))
    weighted_points = ends.weighted_points(gauss)
    assert weighted_points.which.tolist() == list(range(30))
    assert (weighted_points.volume > 0).all()
    assert (ends.nearby_proposals(gauss, gauss) == gauss).all()
