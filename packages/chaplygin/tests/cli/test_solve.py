"""``chaplygin solve`` as a user meets it."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from chaplygin.cli import main
from chaplygin.experiment.dataset import open_dataset

Answer = tuple[int, str, str]
Ask = Callable[..., Answer]

FULL = """
[body]
mass = 1.3
inertia = [[1.0, 0.1, 0.05], [0.1, 1.5, -0.2], [0.05, -0.2, 2.1]]
[body.shape]
kind = "ball"
radius = 0.9
[contact]
model = "rubber"
[field]
gravity = 9.81
[start]
gamma = [0.36, -0.48, 0.8]
omega = [0.8, -0.4, -0.6]
"""


@pytest.fixture
def ask(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Ask:
    """Run `chaplygin solve` in an empty folder; exit code, standard output, standard error."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: object) -> Answer:
        monkeypatch.setattr(sys, "argv", ["chaplygin", "solve", *map(str, arguments)])
        with pytest.raises(SystemExit) as end:
            main()
        output = capsys.readouterr()
        return int(end.value.code or 0), output.out, output.err

    return run


@pytest.mark.slow
def test_the_table(ask: Ask) -> None:
    code, out, err = ask("veselova", "--at", "0,1,1e6")
    assert (code, err) == (0, "")
    assert "Two-frequency motion on a torus" in out
    for part in ("t = 0", "t = 1", "t = 1000000", "omega_3", "rad/s", "attitude_w", "Ω₁", " ± "):
        assert part in out
    assert max(map(len, out.splitlines())) <= 80
    energies = [line.split()[2:] for line in out.splitlines() if line.startswith("energy")]
    assert len({value for row in energies for value in row}) == 1


@pytest.mark.slow
def test_the_record_agrees_with_the_integration(ask: Ask) -> None:
    code, out, _ = ask("veselova", "--at", "0,60", "--json")
    assert code == 0
    record = json.loads(out)
    assert [state["time"] for state in record["states"]] == [0.0, 60.0]
    assert len(record["ovals"]) == 2
    assert len(record["equations"]) == 8
    frequencies = [item for item in record["figures"] if item["symbol"].startswith("Omega")]
    assert all(float(item["error"]) < 1e-15 and item["unit"] == "turns/s" for item in frequencies)
    from chaplygin.experiment.models.experiment import parse_experiment
    from chaplygin.experiment.study import Study

    study = Study.from_experiment(
        parse_experiment('[system]\nname = "veselova"\n', "x", ["run.samples=2"])
    )
    last = study.trajectory()
    for name in ("omega", "gamma", "attitude"):
        assert np.abs(np.array(record["states"][1][name]) - last[name][-1]).max() < 1e-12


@pytest.mark.slow
def test_files(ask: Ask, tmp_path: Path) -> None:
    (tmp_path / "ball.toml").write_text(FULL)
    code, _, err = ask("ball.toml", "--at", "0,1e3,1e6", "-o", "ball.nc", "--figure", "ball.svg")
    assert code == 0
    assert "written to ball.nc" in err
    dataset = open_dataset("ball.nc")
    assert dataset.time.values.tolist() == [0.0, 1e3, 1e6]
    for name in ("omega", "gamma", "M", "attitude", "centre", "contact", "normal_force"):
        assert dataset[name].sizes["time"] == 3
        assert dataset[name].units
    energy = dataset.law_energy.values
    assert np.ptp(energy) < 1e-9 * energy[0]
    assert dataset.attrs["integrator"].startswith("none: closed form")
    assert "start" in dataset.attrs
    assert "inertia = [[1.0, 0.1, 0.05]" in dataset.attrs["experiment"]
    assert (tmp_path / "ball.svg").read_text().startswith("<?xml")
    code, _, err = ask("ball.toml", "--at", "0", "-o", "ball.nc")
    assert code == 2
    assert "exists already" in err
    assert ask("ball.toml", "--at", "0", "-o", "ball.nc", "--force")[0] == 0


@pytest.mark.slow
def test_digits_come_with_error_bars(ask: Ask) -> None:
    code, out, _ = ask("rubber-disk", "--at", "0.1", "--digits", "25", "--json")
    assert code == 0
    (state,) = json.loads(out)["states"]
    ball = state["gamma_3"]
    assert len(ball["value"].strip("-0.")) >= 20
    assert 0 < float(ball["error"]) < 1e-20
    code, out, _ = ask("rubber-disk", "--at", "0.1", "--digits", "25")
    (row,) = (line for line in out.splitlines() if line.startswith("gamma_3"))
    assert f"{ball['value']} ± {ball['error']}" in row


@pytest.mark.slow
def test_without_times_those_of_the_run_are_taken(ask: Ask) -> None:
    code, out, err = ask("neumann", "--set", "run.until=8")
    assert code == 0
    assert "t = 8" in out
    assert "5 of 101 times are shown" in err
    _, out, _ = ask("neumann", "--set", "run.until=8", "--set", "run.samples=21", "--json")
    assert len(json.loads(out)["states"]) == 21


@pytest.mark.slow
def test_a_motion_without_closed_form_is_refused_in_one_line(ask: Ask) -> None:
    code, out, err = ask("ball-on-sphere", "--at", "0,1")
    assert (code, out) == (1, "")
    assert err.startswith("error: the ball on a sphere with k = 0.6666")
    assert err.count("\n") == 1


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--at", "0,x"], "--at 0,x: it must be finite numbers separated by commas"),
        (["--at", "1e400"], "it must be finite numbers"),
        (["--at", "1/0"], "it must be finite numbers"),
        (["--digits", "0"], "--digits 0: it must be from 1 to 1000"),
        (["--figure", "curve.gif"], "its name must end in .png, .svg, .pdf"),
        (["-o", "no/where.nc"], "there is no folder no"),
        (["--set", "start.omega=[0,0,1]"], "the nearest admissible omega is"),
        (["--set", "system.parameters.q=1"], "veselova: no parameter q"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_mistakes_are_told_in_one_sentence(ask: Ask, arguments: list[str], sentence: str) -> None:
    code, out, err = ask("veselova", *arguments)
    assert (code, out) == (2, "")
    assert sentence in err
    assert err.count("\n") == 1
