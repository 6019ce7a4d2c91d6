"""The points of sections as datasets."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

from flowlanes.errors import InputError
from flowlanes.flow.ensembles.computation import compute
from flowlanes.flow.ensembles.task import Task
from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.flow.sampling.level_sampler import sample_level
from flowlanes.flow.sections import poincare_dataset as section_points
from flowlanes.flow.sections.poincare_dataset import Quantity, section_task
from flowlanes.flow.sections.poincare_map import PoincareMap
from flowlanes.system.vectors import to_components
from nonholonomic.catalogue import entry

BALL = entry("unbalanced-ball").system({})
RETURNS = PoincareMap(BALL, poincare_section(BALL, "gamma_3"), t_end=400.0)
M, GAMMA = (to_components(name) for name in BALL.state)
AREA = Quantity("area", M.dot(GAMMA), "area integral", "kg m^2/s")


def task(motions: int = 24, points: int = 40) -> Task:
    starts = sample_level(BALL, motions, {"energy": 1.0}, seed=5)
    return section_task(RETURNS, starts, points, [AREA], attributes={"seed": 5})


@pytest.fixture(scope="module")
def found() -> xr.Dataset:
    return compute(task())


def test_what_is_recorded(found: xr.Dataset) -> None:
    assert dict(found.sizes) == {"run": 24, "section_point": 40, "axis": 3}
    assert set(found.data_vars) == {
        *("M", "gamma", "time", "points", "outcome", "ended", "area"),
        *("law_energy", "law_quadratic"),
    }
    for name in found.data_vars:
        assert {"long_name", "units", "source"} <= found[name].attrs.keys()
    area = (found["M"] * found["gamma"]).sum("axis", skipna=False)
    assert np.nanmax(np.abs(found["area"] - area)) < 1e-14
    assert np.nanmax(np.abs(found["law_energy"] - 1.0)) < 1e-11
    assert found.attrs["section_value"] == "gamma_3"
    assert found.attrs["parameters"].startswith("m = 1.0; I_1 = 1.0")


def test_motions_that_have_no_more_points_say_why(found: xr.Dataset) -> None:
    short = found["points"] < 40
    assert 0 < int(short.sum()) < 24
    flags, words = found["outcome"].flag_values, found["outcome"].flag_meanings.split()
    told = dict(zip(flags, words, strict=True))
    assert {told[int(c)] for c in found["outcome"][short]} == {"the_time_limit_was_reached"}
    assert {told[int(c)] for c in found["outcome"][~short]} == {"all_its_points"}
    there = np.isfinite(found["time"]).sum("section_point")
    assert np.array_equal(there, found["points"])
    assert np.array_equal(np.isfinite(found["M"]).all("axis").sum("section_point"), there)
    assert float(found["ended"][short].min()) == 400.0


def test_blocks_and_pieces_change_no_bit(
    found: xr.Dataset, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(section_points, "BLOCK", 12_000)
    monkeypatch.setattr(section_points, "PIECE", 17)
    small = task()
    assert 1 < small.block < 24
    with compute(small, tmp_path / "section.zarr") as stored:
        assert stored.load().identical(found)


SCRIPT = """
import sys
sys.path[:0] = [{folder!r}]
import test_poincare_dataset as points
from flowlanes.flow.sections import poincare_dataset as section_points
section_points.BLOCK = 60_000
points.compute(points.task(60, 200), {store!r})
"""


@pytest.mark.slow
def test_a_killed_section_goes_on(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Killed at a moment when some blocks are there, twice; then finished, to the bit."""
    monkeypatch.setattr(section_points, "BLOCK", 60_000)
    store = tmp_path / "section.zarr"
    command = SCRIPT.format(folder=str(Path(__file__).parent), store=str(store))
    for least in (1, 3):
        process = subprocess.Popen([sys.executable, "-c", command])
        while process.poll() is None and len(_chunks(store)) < least:
            time.sleep(0.01)
        if process.poll() is None:
            os.kill(process.pid, signal.SIGKILL)
        process.wait()
    again = task(60, 200)
    with compute(again, store) as stored:
        assert stored.load().identical(compute(again))


def _chunks(store: Path) -> list[Path]:
    return list(store.glob("M/c/**/*")) if store.exists() else []


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"count": 0}, "0 points: there must be one at least"),
        ({"count": 10**9}, "do not fit into memory at once: ask for no more than"),
        ({"quantities": [Quantity("time", M[0], "")]}, "time bears the name of something else"),
        ({"starts": np.zeros((0, 6))}, "size is 0"),
    ],
)
def test_mistakes_are_told(options: dict[str, Any], sentence: str) -> None:
    arguments = {"starts": sample_level(BALL, 2, {"energy": 1.0}), "count": 3} | options
    with pytest.raises(InputError, match=sentence):
        section_task(RETURNS, **arguments)
    varied = PoincareMap(BALL, poincare_section(BALL, "gamma_3"), {"I_1": np.array([1.0, 1.1])})
    with pytest.raises(InputError, match="the same parameters"):
        section_task(varied, np.zeros((2, 6)), 3)
