"""``chaplygin ensemble`` as a user meets it."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from chaplygin.cli import main
from flowlanes.flow.ensembles.zarr_store import read_store

Ask = Callable[..., tuple[int, str, str]]


@pytest.fixture
def ask(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Ask:
    """Run `chaplygin ensemble` in an empty folder; exit code, standard output, standard error."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: object) -> tuple[int, str, str]:
        monkeypatch.setattr(sys, "argv", ["chaplygin", "ensemble", *map(str, arguments)])
        with pytest.raises(SystemExit) as end:
            main()
        output = capsys.readouterr()
        return int(end.value.code or 0), output.out, output.err

    return run


@pytest.mark.slow
def test_drawn_starts_with_several_masses(ask: Ask) -> None:
    arguments = (
        *("chaplygin-ball", "--starts", 4, "--level", "energy=1", "--seed", 3),
        *("--over", "m=1:2:3", "--record", "energy", "-o", "balls.zarr"),
        *("--set", "run.until=5", "--set", "run.samples=6"),
    )
    code, out, err = ask(*arguments)
    assert code == 0, err
    assert "4 drawn on energy = 1.0 (seed 3) × 3 of m" in out
    assert "starts drawn according to the invariant measure ρ d³M d³γ (7.3)" in out
    assert "12 of 12 motions: the last time was reached" in out
    data = read_store("balls.zarr")
    assert data.sizes == {"run": 12, "time": 6, "axis": 3}
    assert np.allclose(data.law_energy, 1.0, rtol=0, atol=1e-11)
    assert 'name = "chaplygin-ball"' in data.attrs["experiment"]
    # the same command finds everything done; another one is another experiment
    code, out, _ = ask(*arguments, "--json")
    assert code == 0
    assert json.loads(out)["motions"] == 12
    code, _, err = ask(*arguments, "--seed", 4)
    assert code == 2
    assert "balls.zarr holds another experiment: its " in err
    assert ask(*arguments, "--seed", 4, "--force")[0] == 0


@pytest.mark.parametrize("name", ["chaplygin-ball", "suslov"])
def test_the_start_of_the_experiment(name: str, ask: Ask) -> None:
    code, _, err = ask(name, "-o", "a.zarr", "--set", "run.until=1", "--set", "run.samples=3")
    assert code == 0, err
    data = read_store("a.zarr")
    assert data.sizes["run"] == 1
    assert np.isfinite(data.omega if "omega" in data else data.M).all()


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("-o", "a.nc"), "--output a.nc: its name must end in .zarr"),
        (("-o", "a.zarr", "--starts", "3"), "--level is needed"),
        (("-o", "a.zarr", "--level", "energy"), "it is written NAME=VALUE"),
        (("-o", "a.zarr", "--over", "m"), "an axis is written NAME=FIRST:LAST:COUNT"),
        (("-o", "a.zarr", "--over", "mass=1:2:3"), "no parameter of chaplygin-ball"),
        (("-o", "none/a.zarr"), "there is no folder none"),
    ],
    ids=["name", "level", "value", "axis", "parameter", "folder"],
)
def test_mistakes_are_told(arguments: tuple[str, ...], sentence: str, ask: Ask) -> None:
    code, _, err = ask("chaplygin-ball", *arguments)
    assert code == 2
    assert sentence in err
    assert err.count("\n") == 1
