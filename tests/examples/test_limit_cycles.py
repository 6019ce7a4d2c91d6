"""The example of limit cycles of the unbalanced rubber ball."""

from __future__ import annotations

import sys
from fractions import Fraction
from pathlib import Path

import matplotlib
import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def example():
    matplotlib.use("agg")
    sys.path.insert(0, str(EXAMPLES))
    try:
        import limit_cycles

        yield limit_cycles
    finally:
        sys.path.remove(str(EXAMPLES))


def test_the_ball_is_the_ball_of_the_torus(example):
    """Back from the tensor about the centre of mass to J and κ, and onto the torus."""
    ball = example.Ball.of(example.J, example.KAPPA)
    moments = [ball.values[f"I_{i}"] for i in (1, 2, 3)]
    centre = [ball.values[f"c_{i}"] for i in (1, 2, 3)]
    J, kappa = example.central(ball.values["m"], ball.values["R"], moments, centre)
    assert pytest.approx(example.J) == J
    assert np.abs(kappa) == pytest.approx(np.abs(example.KAPPA))
    start = ball.start(0.95, 2.0)
    integrals = ball.returns.integrals
    values = dict(zip(integrals.names, integrals.values(start[None])[0], strict=True))
    assert values == pytest.approx({"energy": 0.5, "quadratic": 0.95})


@pytest.mark.slow
def test_limit_cycle_of_the_ball_and_its_end(example):
    orbit, branch = example.cycles(example.Ball.of(example.J, example.KAPPA))
    assert orbit.kind == "attracting"
    assert orbit.multipliers.values[0].real == pytest.approx(0.744598208831, abs=1e-10)
    folds = sorted({round(event.place, 9) for event in branch.events if event.kind == "fold"})
    assert folds == pytest.approx([0.870556044, 1.013611791], abs=2e-9)


@pytest.mark.slow
def test_controls_have_multiplier_one(example):
    line = np.array([0.19, 0.0, 0.0])
    for moments, kappa in ((example.J, 0 * line), (np.array([0.5, 2.75, 2.75]), line)):
        orbit = example.control(example.Ball.of(moments, kappa), 0.94, 1)
        assert orbit.kind == "neutral"
        assert orbit.multipliers.values[0].real == pytest.approx(1, abs=1e-11)


def test_widths_are_linear_in_the_displacement(example):
    flat = example.staircase(
        example.circles(example.J, 0 * example.KAPPA), example.levels(example.J, 60), tolerance=1e-6
    )
    found = example.widths(flat, Fraction(3, 2), (2.0**-6, 2.0**-7))
    assert found.power == pytest.approx(1.0, abs=1e-2)
    assert all(step.open for step in found.steps)


@pytest.mark.slow
def test_cycles_are_proven(example):
    attracting, repelling = example.proofs()
    assert (attracting.kind, repelling.kind) == ("attracting", "repelling")
    assert attracting.multiplier.contains(0.7446)
    assert attracting.multiplier < 1 < repelling.multiplier


@pytest.mark.slow
def test_story_and_figure(example, tmp_path, capsys):
    story = example.measure(80, 3)
    example.report(story)
    assert "locked" in capsys.readouterr().out
    example.figure(story).savefig(tmp_path / "limit_cycles.png")
    assert (tmp_path / "limit_cycles.png").stat().st_size > 10_000
