"""``chaplygin chart`` as a user meets it."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from chaplygin.cli import main

Answer = tuple[int, str, str]
Ask = Callable[..., Answer]

SMALL = (
    *("ball-on-sphere", "--of", "lyapunov", "--until", "20"),
    *("--x", "k=-1.5:0.5:4", "--y", "gamma_1=-1.2:1.2:3", "--let", "a=k*R/(1-k)"),
)

RATTLEBACK = """
title = "Stone"
[body]
mass = 1.0
inertia = [0.8, 1.0, 1.6]
[body.shape]
kind = "ball"
radius = 1.0
centre = [0.1, 0.05, -0.2]
[start]
gamma = [0.0, 0.6, 0.8]
omega = [0.7, 0.4, 1.1]
[run]
until = 5.0
"""


@pytest.fixture
def ask(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Ask:
    """Run `chaplygin chart` in an empty folder; exit code, standard output, standard error."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: object) -> Answer:
        monkeypatch.setattr(sys, "argv", ["chaplygin", "chart", *map(str, arguments)])
        with pytest.raises(SystemExit) as end:
            main()
        output = capsys.readouterr()
        return int(end.value.code or 0), output.out, output.err

    return run


@pytest.mark.slow
def test_store_picture_and_table(ask: Ask, tmp_path: Path) -> None:
    code, out, err = ask(*SMALL, "-o", "chart.zarr")
    assert code == 0
    assert "largest Lyapunov exponent" in out
    assert "4 of 12 have a number" in out
    assert "8 of 12   no state with these values was found" in out
    assert "written to chart.zarr, figure: chart.png" in err
    assert (tmp_path / "chart.png").read_bytes().startswith(b"\x89PNG")
    found = xr.open_zarr("chart.zarr")
    assert found["lyapunov"].dims == ("gamma_1", "k")
    assert np.array_equal(found["k"], np.linspace(-1.5, 0.5, 4))
    assert found["lyapunov"].attrs["units"] == "1/s"
    assert 'name = "ball-on-sphere"' in found.attrs["experiment"]
    assert np.isfinite(found["lyapunov_error"].values).sum() == 4


@pytest.mark.slow
def test_the_record(ask: Ask) -> None:
    code, out, _ = ask(*SMALL, "-o", "chart.zarr", "--figure", "other.svg", "--json")
    assert code == 0
    record = json.loads(out)
    assert record["outcomes"] == {
        "no state with these values was found": 8,
        "followed to the end": 4,
    }
    assert record["lowest"] <= record["median"] <= record["highest"]
    assert (record["x"], record["y"], record["figure"]) == ("k", "gamma_1", "other.svg")


@pytest.mark.slow
def test_what_is_there_is_gone_on_with_and_nothing_else_touched(ask: Ask, tmp_path: Path) -> None:
    _, first, _ = ask(*SMALL, "-o", "chart.zarr")
    code, again, _ = ask(*SMALL, "-o", "chart.zarr")
    assert (code, again) == (0, first)
    code, _, err = ask(*SMALL[:4], "30", *SMALL[5:], "-o", "chart.zarr")
    assert code == 2
    assert "chart.zarr" in err
    code, _, _ = ask(*SMALL[:4], "30", *SMALL[5:], "-o", "chart.zarr", "--force")
    assert code == 0
    (tmp_path / "taken.png").write_text("mine")
    code, _, err = ask(*SMALL, "-o", "taken.zarr")
    assert code == 2
    assert "taken.png exists already" in err
    assert not (tmp_path / "taken.zarr").exists()
    (tmp_path / "foreign.zarr").mkdir()
    (tmp_path / "foreign.zarr" / "letter.txt").write_text("mine")
    assert ask(*SMALL, "-o", "foreign.zarr", "--force")[0] == 2
    assert (tmp_path / "foreign.zarr" / "letter.txt").read_text() == "mine"


@pytest.mark.slow
def test_interrupted(ask: Ask, monkeypatch: pytest.MonkeyPatch) -> None:
    from flowlanes.scans.scan_task import Scan

    def interrupted(self: Scan, first: int, last: int) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(Scan, "__call__", interrupted)
        code, out, err = ask(*SMALL, "-o", "chart.zarr")
    assert (code, out) == (130, "")
    assert err.endswith(
        "interrupted: chart.zarr stays, with nothing added; the same command resumes there\n"
    )
    assert ask(*SMALL, "-o", "chart.zarr")[0] == 0


def test_a_body_of_the_user(ask: Ask, tmp_path: Path) -> None:
    (tmp_path / "stone.toml").write_text(RATTLEBACK)
    code, _, err = ask(
        *("stone.toml", "--of", "duration", "--x", "energy=15:200:4", "--y", "theta=0:1:2"),
        *("--let", "gamma_1=sin(theta)", "--let", "gamma_2=0", "--let", "gamma_3=cos(theta)"),
        *("-o", "stone.zarr"),
    )
    assert code == 0, err
    found = xr.open_zarr("stone.zarr")
    duration = found["duration"].values
    assert np.all((duration == 5.0) == (found["outcome"].values == 0))
    # a ball whose centre of mass is off the middle jumps when it rolls fast
    assert duration[0, 0] == 5.0
    assert duration[0, 3] < 1.0


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"--of": "chaos"}, "chaos: no number has this name"),
        ({"--x": "k"}, "--x: k: an axis is written NAME=FIRST:LAST:COUNT"),
        ({"--y": "gamma_9=0:1:2"}, "gamma_9"),
        ({"--let": "a"}, "--let a: it is written NAME=FORMULA"),
        ({"-o": "chart.nc"}, "must end in .zarr"),
        ({"--figure": "chart.bmp"}, "must end in .png"),
        ({"--until": "-3"}, "until"),
        ({"--hold": "q"}, "q: no variable of the start"),
        ({"--workers": "none"}, "--workers none"),
        ({"--workers": "0"}, "--workers 0: it must be a whole number from 1 on"),
        ({"--workers": "-1"}, "--workers -1: it must be a whole number from 1 on"),
    ],
)
def test_mistakes(ask: Ask, change: dict[str, str], message: str, tmp_path: Path) -> None:
    options = dict(zip(SMALL[1::2], SMALL[2::2], strict=True)) | {"-o": "chart.zarr"} | change
    code, out, err = ask(SMALL[0], *(word for pair in options.items() for word in pair))
    assert (code, out) == (2, "")
    assert message in err
    assert "Traceback" not in err
    assert not (tmp_path / "chart.png").exists()


@pytest.mark.slow
def test_on_two_processes_the_bits_are_the_same(ask: Ask) -> None:
    assert ask(*SMALL, "-o", "one.zarr")[0] == 0
    assert ask(*SMALL, "-o", "two.zarr", "--workers", "2")[0] == 0
    one, two = xr.open_zarr("one.zarr"), xr.open_zarr("two.zarr")
    assert one.equals(two)
