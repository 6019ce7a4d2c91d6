"""The figures of every kind of subject are drawn from what its dataset records."""

from __future__ import annotations

import pytest

from chaplygin.experiment.models.experiment import catalogue_experiment
from chaplygin.experiment.study import Study, dataset_of
from chaplygin.report.subject_figures import subject_figures


@pytest.mark.parametrize("name", ["sliding-ball", "disk-on-ice", "sliding-top"])
def test_a_place_that_is_recorded_as_a_centre_is_no_figure(name: str) -> None:
    study = Study.from_experiment(catalogue_experiment(name, ["run.samples=11"]))
    dataset = dataset_of(study, study.trajectory(), complete=True)
    assert "place" not in dataset
    assert subject_figures(study.subject, dataset, None)
