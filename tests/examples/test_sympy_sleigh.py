"""A SymPy model in a Python file, used from the command line."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from chaplygin.cli import main
from chaplygin.experiment.dataset import open_dataset

SLEIGH = Path(__file__).parents[2] / "examples" / "sympy_sleigh.py"


def ask(monkeypatch: pytest.MonkeyPatch, *arguments: object) -> int:
    monkeypatch.setattr(sys, "argv", ["chaplygin", *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


def test_its_energy_is_proven(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    assert ask(monkeypatch, "prove", SLEIGH) == 0
    line = next(row for row in capsys.readouterr().out.splitlines() if row.startswith("energy"))
    assert "proven" in line


@pytest.mark.slow
def test_it_runs_and_keeps_to_its_blade(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
):
    path = tmp_path / "sleigh.nc"
    assert ask(monkeypatch, "run", SLEIGH, "-o", path) == 0
    run = open_dataset(path)
    angle = run["phi"].values
    across = run["ydot"].values * np.cos(angle) - run["xdot"].values * np.sin(angle)
    assert np.abs(across).max() < 1e-14
    # the sleigh turns until its centre of mass leads the way
    assert abs(run["phidot"].values[-1]) < 0.05
