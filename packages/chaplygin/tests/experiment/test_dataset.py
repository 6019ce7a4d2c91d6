"""Datasets: what is in them, and that a file holds all of it or does not exist."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from catalogue import built
from catalogue.built import ROLLING
from chaplygin.experiment.dataset import open_dataset, write_dataset
from chaplygin.experiment.models.experiment import catalogue_experiment, parse_experiment
from chaplygin.experiment.study import Study, dataset_of
from flowlanes.errors import InputError
from needs import optional
from nonholonomic.catalogue import CATALOGUE
from spread import spread
from studies import catalogue_study

DIMENSIONS = {
    "omega": ("time", "axis"),
    "gamma": ("time", "axis"),
    "M": ("time", "axis"),
    "centre": ("time", "space"),
    "contact": ("time", "space"),
    "attitude": ("time", "quaternion"),
    "normal_force": ("time",),
    "energy": ("time",),
}

SHORT = """
[system]
name = "{name}"
[run]
until = 1.0
samples = 5
{more}
"""


def short(name: str = "unbalanced-ball", more: str = "") -> xr.Dataset:
    study = Study.from_experiment(parse_experiment(SHORT.format(name=name, more=more)))
    return dataset_of(study, study.trajectory())


@pytest.fixture(scope="module")
def dataset() -> xr.Dataset:
    return short()


@pytest.fixture(scope="module")
def fine() -> xr.Dataset:
    return short(more='precision = "quad"\ntolerance = 1e-30')


# --- contents --------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("name", ROLLING)
def test_a_rolling_body_has_all_of_its_variables(name):
    made = short(name)
    for variable, dimensions in DIMENSIONS.items():
        assert made[variable].dims == dimensions, variable
    for law in built.system(name).integrals:
        assert made[f"law_{law.name}"].dims == ("time",)
    assert dict(made.sizes) == {"time": 5, "axis": 3, "space": 3, "quaternion": 4}
    assert made["axis"].values.tolist() == [1, 2, 3]
    assert made["space"].values.tolist() == ["x", "y", "z"]
    assert made["quaternion"].values.tolist() == ["w", "x", "y", "z"]


def test_a_body_about_a_fixed_point_has_no_place():
    made = short("veselova")
    assert dict(made.sizes) == {"time": 5, "axis": 3, "quaternion": 4}
    assert {"omega", "gamma", "attitude", "energy", "law_energy", "law_momentum"} <= set(made)
    assert not {"centre", "contact", "normal_force"} & set(made)


@pytest.mark.slow
@pytest.mark.parametrize("name", spread(CATALOGUE))
def test_every_variable_says_what_it_is(name):
    made = short(name)
    for label, variable in made.variables.items():
        assert variable.attrs["long_name"], label
        assert variable.attrs["units"], label
        assert "source" in variable.attrs, label
        if "axis" in variable.dims[1:]:
            assert variable.attrs["frame"] == "body axes"
        if "space" in variable.dims[1:]:
            assert variable.attrs["frame"] == "space axes"
    for law in catalogue_study(name).system_on_level.integrals:
        assert made[f"law_{law.name}"].attrs["source"] == law.source
        assert made[f"law_{law.name}"].attrs["long_name"] == law.meaning


def test_values_are_those_of_the_trajectory():
    study = Study.from_experiment(
        parse_experiment(SHORT.format(name="ball-around-sphere", more=""))
    )
    motion = study.trajectory()
    made = motion.to_dataset()
    for name in ("omega", "gamma", "M", "centre", "contact", "attitude", "normal_force"):
        assert made[name].values.tolist() == motion[name].tolist()
    assert made["energy"].values.tolist() == motion["law_energy"].tolist()
    assert made["time"].values.tolist() == [0.0, 0.25, 0.5, 0.75, 1.0]


def test_units_are_consistent(dataset):
    units = {name: dataset[name].attrs["units"] for name in DIMENSIONS}
    assert units == {
        "omega": "rad/s",
        "gamma": "1",
        "M": "kg m^2/s",
        "centre": "m",
        "contact": "m",
        "attitude": "1",
        "normal_force": "N",
        "energy": "J",
    }


def test_global_attributes_tell_how_it_was_made(dataset):
    notes = dataset.attrs
    system = CATALOGUE["unbalanced-ball"].system()
    assert notes["system"] == "Unbalanced ball"
    assert notes["system_name"] == "unbalanced-ball"
    assert notes["source"] == system.source
    assert notes["parameters"].startswith("m = 1.0; I_1 = 1.0; I_2 = 1.5")
    assert notes["tolerance"] == 1e-15
    assert notes["precision"] == "double"
    assert notes["complete"] == 1
    assert notes["events"] == ""
    for package in ("flowlanes", "llvmlite", "numpy", "sympy"):
        assert f"{package} " in notes["versions"]
    start = dict(part.split(" = ") for part in notes["start"].split("; "))
    assert float(start["M_1"]) == dataset["M"].values[0, 0]
    assert float(start["gamma_3"]) == dataset["gamma"].values[0, 2]


def test_the_experiment_in_the_dataset_makes_the_same_dataset(dataset):
    study = Study.from_experiment(parse_experiment(dataset.attrs["experiment"]))
    xr.testing.assert_identical(dataset, dataset_of(study, study.trajectory()))


def test_what_happened_is_noted():
    study = Study.from_experiment(
        parse_experiment(
            """
[system]
name = "heavy-disk"
[start]
omega = [0.0, 0.0, 0.0]
gamma = [0.8, 0.0, 0.6]
[run]
until = 2.0
"""
        )
    )
    made = dataset_of(study, study.trajectory())
    assert "the body lies flat" in made.attrs["events"]
    assert f"t = {made['time'].values[-1]:.17g}" in made.attrs["events"]


def test_further_attributes_are_added():
    study = Study.from_experiment(catalogue_experiment("veselova"))
    assert study.trajectory().to_dataset({"mood": "good"}).attrs["mood"] == "good"


# --- numbers of 34 digits --------------------------------------------------------------------


def test_every_number_of_34_digits_has_its_low_part(fine):
    whole = {name for name in fine.data_vars if not name.endswith("_low")}
    assert {f"{name}_low" for name in (*whole, "time")} == set(fine.data_vars) - whole
    for name in whole:
        low = fine[f"{name}_low"]
        assert fine[name].dtype == low.dtype == np.float64
        assert low.dims == fine[name].dims
        assert low.attrs["units"] == fine[name].attrs["units"]
        assert np.all(np.abs(low.values) <= np.spacing(np.abs(fine[name].values)) / 2)


def test_both_parts_together_have_all_digits(fine):
    study = Study.from_experiment(parse_experiment(fine.attrs["experiment"]))
    motion = study.trajectory()
    for name in ("M", "omega", "attitude", "energy"):
        exact = motion["law_energy" if name == "energy" else name]
        parts = zip(
            fine[name].values.ravel(),
            fine[f"{name}_low"].values.ravel(),
            exact.ravel(),
            strict=True,
        )
        for high, low, value in parts:
            both = Fraction(high) + Fraction(low)
            whole = Fraction(str(value))
            assert abs(both - whole) <= Fraction(1, 10**32) * (1 + abs(whole))
    heyoka = optional("heyoka")
    assert isinstance(motion["omega"][0, 0], heyoka.real128)


def test_doubles_have_no_low_part(dataset):
    assert not [name for name in dataset if name.endswith("_low")]


# --- files -----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["unbalanced-ball", "veselova", "heavy-disk"])
def test_what_is_written_is_read(tmp_path, name):
    made = short(name)
    target = tmp_path / "motion.nc"
    assert write_dataset(made, target) == target
    xr.testing.assert_identical(open_dataset(target), made)
    assert [path.name for path in tmp_path.iterdir()] == ["motion.nc"]


def test_thirty_digits_are_written_and_read(tmp_path, fine):
    write_dataset(fine, tmp_path / "motion.nc")
    xr.testing.assert_identical(open_dataset(tmp_path / "motion.nc"), fine)


def test_a_file_is_read_by_xarray_alone(tmp_path, dataset):
    write_dataset(dataset, str(tmp_path / "motion.nc"))
    with xr.open_dataset(tmp_path / "motion.nc", engine="h5netcdf") as found:
        xr.testing.assert_identical(found.load(), dataset)


def test_permissions_are_those_of_any_new_file(tmp_path, dataset):
    (tmp_path / "other").write_text("")
    write_dataset(dataset, tmp_path / "motion.nc")
    assert (tmp_path / "motion.nc").stat().st_mode == (tmp_path / "other").stat().st_mode


def refusal(dataset: xr.Dataset, target: Path, **options: bool) -> str:
    before = sorted(target.parent.iterdir()) if target.parent.is_dir() else None
    with pytest.raises(InputError) as caught:
        write_dataset(dataset, target, **options)
    after = sorted(target.parent.iterdir()) if target.parent.is_dir() else None
    assert before == after
    return str(caught.value)


def test_another_file_is_not_replaced_unasked(tmp_path, dataset):
    target = tmp_path / "motion.nc"
    target.write_text("precious")
    assert refusal(dataset, target) == (
        f"{target} exists already: choose another name, or have it replaced "
        "(--force, in Python force=True)"
    )
    assert target.read_text() == "precious"
    write_dataset(dataset, target, force=True)
    xr.testing.assert_identical(open_dataset(target), dataset)


@pytest.mark.parametrize("force", [False, True])
def test_a_folder_is_not_replaced(tmp_path, dataset, force):
    (tmp_path / "motion.nc").mkdir()
    message = refusal(dataset, tmp_path / "motion.nc", force=force)
    assert message == f"{tmp_path / 'motion.nc'} is a folder: the name of a regular file is needed"


def test_a_missing_folder_is_named(tmp_path, dataset):
    target = tmp_path / "missing" / "motion.nc"
    assert refusal(dataset, target) == (
        f"{target} cannot be written: there is no folder {target.parent}"
    )


def test_a_protected_folder_is_named(tmp_path, dataset, monkeypatch):
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    target = tmp_path / "motion.nc"
    assert refusal(dataset, target) == (
        f"{target} cannot be written: the folder {tmp_path} is protected"
    )


@pytest.mark.parametrize("step", ["write_bytes", "replace"])
def test_a_full_disk_leaves_nothing_behind(tmp_path, dataset, monkeypatch, step):
    def refuse(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    target = tmp_path / "motion.nc"
    monkeypatch.setattr(Path, step, refuse)
    assert refusal(dataset, target) == f"{target} cannot be written: No space left on device"


def test_a_full_disk_spares_the_older_file(tmp_path, dataset, monkeypatch):
    target = tmp_path / "motion.nc"
    write_dataset(dataset, target)

    def refuse(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", refuse)
    refusal(dataset, target, force=True)
    xr.testing.assert_identical(open_dataset(target), dataset)


PROGRAM = """
import resource, sys
from flowlanes.errors import InputError
from chaplygin.experiment.dataset import open_dataset, write_dataset
dataset = open_dataset(sys.argv[1])
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[3]), int(sys.argv[3])))
try:
    write_dataset(dataset, sys.argv[2])
except InputError as error:
    print(error)
"""


@pytest.mark.slow
@pytest.mark.parametrize("limit", [10, 5000, 20000])
def test_a_file_that_may_not_grow_leaves_nothing_behind(tmp_path, dataset, limit):
    """A real failure in the midst of writing, as on a full disk."""
    (tmp_path / "out").mkdir()
    source, target = tmp_path / "whole.nc", tmp_path / "out" / "motion.nc"
    write_dataset(dataset, source)
    assert source.stat().st_size > limit
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, source, target, str(limit)],
        check=True,
        capture_output=True,
        text=True,
    )
    assert done.stdout == f"{target} cannot be written: File too large\n"
    assert done.stderr == ""
    assert list(target.parent.iterdir()) == []


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(InputError) as caught:
        open_dataset(tmp_path / "motion.nc")
    assert str(caught.value) == f"{tmp_path / 'motion.nc'}: there is no such file"


@pytest.mark.parametrize("content", [b"", b"no data", b"\x89HDF\r\n\x1a\n" + b"\0" * 50])
def test_a_file_of_another_kind_is_refused(tmp_path, content):
    target = tmp_path / "motion.nc"
    target.write_bytes(content)
    with pytest.raises(InputError) as caught:
        open_dataset(target)
    assert str(caught.value) == f"{target}: not a readable NetCDF file"


def test_half_a_file_is_refused(tmp_path, dataset):
    target = write_dataset(dataset, tmp_path / "motion.nc")
    target.write_bytes(target.read_bytes()[: target.stat().st_size // 2])
    with pytest.raises(InputError, match="not a readable NetCDF file"):
        open_dataset(target)


def test_a_folder_is_no_file(tmp_path):
    with pytest.raises(InputError, match="not a readable Zarr store"):
        open_dataset(tmp_path)
