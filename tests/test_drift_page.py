"""The page on drift has every system, and what it says of short runs is so."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from chaplygin.experiment.models.experiment import catalogue_experiment
from chaplygin.experiment.study import Study
from chaplygin.report.summary import drift
from flowlanes.flow.integrator import integrate
from nonholonomic.catalogue import CATALOGUE

PAGE = (Path(__file__).parents[1] / "packages/nonholonomic/docs/drift.md").read_text()
ROWS = {
    name: (float(until), float(size))
    for name, until, size in re.findall(r"^\| ([\w-]+) \| ([\d.]+) \| \d+ \| (\S+) \|", PAGE, re.M)
}


def test_every_system_has_its_row() -> None:
    assert list(ROWS) == list(CATALOGUE)


def test_what_the_page_counts_is_in_its_table() -> None:
    reached = sum(until >= 1e5 for until, _ in ROWS.values())
    assert f"Of {len(ROWS)} systems {reached} reached 10⁵" in PAGE
    more = [
        "snakeboard",
        "vertical-rolling-disk",
        "chaplygin-ball-angles",
        "chaplygin-ball-reduced",
    ]
    assert sorted(name for name in ROWS if ROWS[name][1] > 4.1e-12) == sorted(more)


@pytest.mark.parametrize("name", ["chaplygin-sleigh", "marble-ball", "suslov"])
def test_short_runs_drift_no_more(name: str) -> None:
    study = Study.from_experiment(catalogue_experiment(name))
    found = integrate(
        study.system_on_level, study.start, np.linspace(0, 300.0, 31), on_liftoff="warn"
    )
    for law in found.system.integrals:
        assert drift(found.records[f"law_{law.name}"]) < 10 * max(ROWS[name][1], 1e-15)
