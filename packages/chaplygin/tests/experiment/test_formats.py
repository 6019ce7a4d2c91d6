"""Trajectories as NetCDF, Zarr and tables."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

from chaplygin.experiment.dataset import open_dataset, write_dataset
from chaplygin.experiment.formats import csv_text
from chaplygin.experiment.models.experiment import catalogue_experiment
from chaplygin.experiment.study import Study, dataset_of
from flowlanes.errors import InputError

OPTIONS = ("run.until=1", "run.samples=4")


@pytest.fixture(scope="module")
def dataset():
    study = Study.from_experiment(catalogue_experiment("chaplygin-ball", OPTIONS))
    return dataset_of(study, study.trajectory())


def test_a_table_has_all_digits(dataset) -> None:
    lines = csv_text(dataset).splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    assert len(rows) == 4
    assert np.array_equal([float(row["time"]) for row in rows], dataset.time)
    for i, axis in enumerate((1, 2, 3)):
        assert np.array_equal([float(row[f"M_{axis}"]) for row in rows], dataset.M[:, i])
    assert np.array_equal([float(row["attitude_w"]) for row in rows], dataset.attitude[:, 0])
    assert "# M: angular momentum about the contact point [kg m^2/s]" in lines
    assert '# name = "chaplygin-ball"' in lines


@pytest.mark.parametrize("ending", ["nc", "zarr"])
def test_what_is_written_reads_back(dataset, ending: str, tmp_path: Path) -> None:
    path = write_dataset(dataset, tmp_path / f"motion.{ending}")
    found = open_dataset(path)
    for name in dataset.data_vars:
        assert np.array_equal(found[name], dataset[name])
        assert found[name].attrs == dataset[name].attrs
    assert found.attrs["experiment"] == dataset.attrs["experiment"]
    with pytest.raises(InputError, match="exists already"):
        write_dataset(dataset, path)
    write_dataset(dataset, path, force=True)
    assert [p.name for p in tmp_path.iterdir()] == [path.name]


def test_a_folder_of_the_user_stays(dataset, tmp_path: Path) -> None:
    folder = tmp_path / "mine.zarr"
    folder.mkdir()
    (folder / "letter.txt").write_text("dear")
    with pytest.raises(InputError, match="is a folder with something else in it"):
        write_dataset(dataset, folder, force=True)
    assert (folder / "letter.txt").read_text() == "dear"


def test_an_ending_that_means_nothing(dataset, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"must end in \.nc \(NetCDF\), \.zarr \(a Zarr store\)"):
        write_dataset(dataset, tmp_path / "motion.xlsx")
