"""The example of a resonant torus of the Chaplygin ball."""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib
import pytest
from flint import arb, ctx

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def example():
    matplotlib.use("agg")
    sys.path.insert(0, str(EXAMPLES))
    try:
        import resonant_torus

        yield resonant_torus
    finally:
        sys.path.remove(str(EXAMPLES))


@pytest.fixture(scope="module")
def story(example):
    return example.measure(4)


@pytest.mark.slow
def test_resonance(example, story):
    with ctx.workdps(example.DIGITS):
        assert abs(story.rotation + arb(1) / 2) < 1e-30
    assert 0.1 < story.root < 0.8


@pytest.mark.slow
def test_periods_differ_in_the_physical_time(story):
    periods = [orbit.period for orbit in story.orbits]
    assert float(max(periods, key=float) - min(periods, key=float)) > 0.02


@pytest.mark.slow
def test_orbits_close_after_their_own_period_alone(example, story):
    first, second = story.orbits[:2]
    assert example.miss(story, first, first.period) < 1e-28
    assert example.miss(story, first, second.period) > 1e-3


@pytest.mark.slow
def test_figure(example, story, tmp_path):
    example.figure(story).savefig(tmp_path / "resonant_torus.png")
    assert (tmp_path / "resonant_torus.png").stat().st_size > 10_000
