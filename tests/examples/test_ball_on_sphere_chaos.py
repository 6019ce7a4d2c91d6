"""The example of the ball on a sphere: regular for three ratios, chaotic for others."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def example():
    sys.path.insert(0, str(EXAMPLES))
    try:
        import ball_on_sphere_chaos

        yield ball_on_sphere_chaos
    finally:
        sys.path.remove(str(EXAMPLES))


@pytest.mark.slow
def test_what_holds(example) -> None:
    always = ["Dot(M, M) (proven)", "Dot(M, omega) (proven)"]
    assert example.proven_integrals("", 2) == always
    assert example.proven_integrals("k = 1", 2) == ["Dot(M, n) (proven)", *always]
    assert len(example.proven_integrals("k = -1", 2)) == 3


def test_starts_lie_on_the_level(example) -> None:
    for states in (example.starts(50), example.section_starts(50)):
        assert len(states) > 25
        assert np.abs(example.ON_LEVEL(states) - example.LEVEL).max() < 1e-14


@pytest.mark.slow
def test_regular_where_it_must_be_and_chaotic_elsewhere(example) -> None:
    size = example.Size(starts=40, followed=300.0)
    rows = {row.ratio: row for row in example.shares(size, (-1, 0, 0.25, 1))}
    assert [rows[ratio].share for ratio in (-1, 0, 1)] == [0.0, 0.0, 0.0]
    assert rows[0.25].share > 0.5
    made = example.exponents(rows[0.25], 1000.0)
    assert made.chaotic
    assert made.symmetric
    line = example.table_row(rows[0.25], made)
    assert "chaotic; forced to zero: energy, momentum, flow" in line
    last = example.exponents(rows[1], 1000.0)
    assert "no chaos seen; forced to zero: energy, momentum, area, flow" in example.table_row(
        rows[1], last
    )


def test_the_chart(example) -> None:
    made = example.exponent_chart(example.Size(cells=6, until=60.0))
    assert made["lyapunov"].shape == (6, 6)
    assert not made["outcome"].values.any()


def test_the_sections(example) -> None:
    figure = example.sections(example.Size(orbits=6, returns=5))
    assert [axes.get_title() for axes in figure.axes] == [f"$k = {k:g}$" for k in example.SHOWN]
    points = figure.axes[0].lines[0].get_xydata()
    assert np.all(np.abs(points[:, 1]) <= 1.0)
