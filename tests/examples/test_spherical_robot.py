"""The example of spherical robots that follow a figure of eight."""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def example():
    matplotlib.use("agg")
    sys.path.insert(0, str(EXAMPLES))
    try:
        import spherical_robot

        yield spherical_robot
    finally:
        sys.path.remove(str(EXAMPLES))


@pytest.mark.slow
@pytest.mark.parametrize("number", range(4))
def test_each_robot_follows_its_figure_to_a_millionth(example, number):
    plan = example.TASKS[number].plan()
    assert plan.relative_error < 1e-6
    assert plan.path.diameter == pytest.approx(example.TASKS[number].size, rel=1e-3)


@pytest.mark.slow
def test_the_pictures_are_drawn(example, tmp_path):
    task = example.Task("rubber", example.with_rotors(2, "rubber"), 1.0, 8.0, intervals=8)
    plans = {task.title: task.plan(stages=3, iterations=1)}
    example.still(plans).savefig(tmp_path / "still.png")
    figure, moving = example.film(plans, frames=2)
    moving.save(tmp_path / "film.gif", example.PillowWriter(fps=5), dpi=40)
    assert (tmp_path / "film.gif").stat().st_size > 1000
    assert len(figure.axes) == 1
