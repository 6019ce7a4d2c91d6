"""The examples with a ball on a surface run, and show what they say."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from chaplygin.experiment.models.experiment import load_experiment
from chaplygin.experiment.study import Study
from chaplygin.report.summary import drift

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize("name", ["ball_in_a_pipe", "ball_on_waves"])
def test_an_example_runs_to_its_end(name):
    found = Study.from_experiment(load_experiment(EXAMPLES / f"{name}.toml")).trajectory()
    assert not found.events
    assert drift(found.records["law_energy"]) < 1e-14


def test_the_ball_in_the_pipe_comes_up_again():
    found = Study.from_experiment(load_experiment(EXAMPLES / "ball_in_a_pipe.toml")).trajectory(
        pieces=20
    )
    height, times = found.records["centre"][:, 2], np.asarray(found.times)
    inner = (height[1:-1] > height[:-2]) & (height[1:-1] > height[2:])
    tops = times[1:-1][inner]
    centre = found.records["centre"]
    turns = np.unwrap(np.arctan2(centre[:, 1], centre[:, 0])) / (2 * np.pi)
    per_oscillation = np.diff(np.interp(tops, times, turns))
    np.testing.assert_allclose(np.abs(per_oscillation), np.sqrt(3.5), atol=5e-3)
    np.testing.assert_allclose(height[1:-1][inner], 0.0, atol=1e-6)
