"""The trajectory that an unfinished study leaves in its folder."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from chaplygin.report.stored_trajectory import read_trajectory, store_trajectory, trajectory_digest

FALL = """
title = "Falling"
[parameters]
g = {value = 9.81, unit = "m/s^2"}
[equations]
state = ["z", "v"]
rates = {z = "v", v = "-g"}
[laws.integrals]
energy = {value = "v**2/2 + g*z"}
[guards]
ground = {value = "z", message = "the ground is reached"}
[start]
z = 1.0
v = 0.0
[run]
until = 1.0
samples = 9
"""


def fall(*overrides: str) -> Study:
    return Study.from_experiment(parse_experiment(FALL, overrides=overrides))


@pytest.mark.parametrize("precision", ["double", "quad"])
def test_a_stored_trajectory_is_the_same_to_the_last_digit(tmp_path: Path, precision: str) -> None:
    study, path = fall(f"run.precision={precision}"), tmp_path / "t.npz"
    whole, key = study.trajectory(), trajectory_digest(study, 1)
    store_trajectory(path, key, whole)
    stored = read_trajectory(path, key, study)
    assert stored is not None
    assert stored.states.dtype == whole.states.dtype
    assert np.array_equal(stored.times, whole.times)
    assert np.array_equal(stored.states, whole.states)
    assert stored.records.keys() == whole.records.keys() == {"law_energy"}
    assert np.array_equal(stored["law_energy"], whole["law_energy"])
    assert (stored.system, stored.parameters) == (whole.system, whole.parameters)
    assert (stored.events, stored.statistics) == (whole.events, whole.statistics)
    assert stored.events


def test_another_study_has_another_digest(monkeypatch: pytest.MonkeyPatch) -> None:
    key = trajectory_digest(fall(), 1)
    assert key == trajectory_digest(fall(), 1)
    assert key != trajectory_digest(fall(), 2)
    for change in ("start.z=2.0", "run.tolerance=1e-12", "parameters.g.value=9.8", "run.samples=5"):
        assert key != trajectory_digest(fall(change), 1)
    monkeypatch.setattr("flowlanes.files.cache.computation_digest", lambda: "another program")
    assert key != trajectory_digest(fall(), 1)


@pytest.mark.parametrize("damage", ["absent", "cut", "foreign", "without a digest"])
def test_what_is_not_the_trajectory_is_not_read(tmp_path: Path, damage: str) -> None:
    study, path = fall(), tmp_path / "t.npz"
    key = trajectory_digest(study, 1)
    if damage != "absent":
        store_trajectory(path, None if damage == "without a digest" else key, study.trajectory())
    if damage == "cut":
        path.write_bytes(path.read_bytes()[:-100])
    wanted = trajectory_digest(fall("start.z=2.0"), 1) if damage == "foreign" else key
    assert read_trajectory(path, wanted, study) is None
