"""Commands on a contact with friction."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import chaplygin as ch
from asking import Ask, ask
from contact.case_files import CASES, experiment_text
from flowlanes.flow.ensembles.zarr_store import read_store

__all__ = ["ask"]

COLUMNS = 80


@pytest.fixture
def billiard(tmp_path: Path) -> Path:
    path = tmp_path / "billiard.toml"
    path.write_text(experiment_text(CASES["billiard ball"], 11))
    return path


def test_a_run_tells_its_events_in_narrow_lines(ask: Ask, billiard: Path) -> None:
    code, output, _ = ask("run", billiard, "-o", "a.nc")
    assert code == 0
    lines = output.splitlines()
    assert lines[0] == "Ball on a plane, with friction"
    assert "  1 event: 1 stick" in lines
    moment = CASES["billiard ball"]["events"][0]["time"]
    assert f"    t = {moment:.9g}: stick, then rolling" in lines
    assert max(map(len, lines)) <= COLUMNS
    dataset = ch.open_dataset("a.nc")
    assert dataset["event_time"].values == pytest.approx([moment], abs=1e-10)
    assert dataset.attrs["complete"] == 1


def test_a_run_as_json(ask: Ask, billiard: Path) -> None:
    code, output, _ = ask("run", billiard, "-o", "a.nc", "--json")
    facts = json.loads(output)
    assert code == 0
    assert [event["what"] for event in facts["events"]] == ["stick"]
    assert facts["ended"] == ""
    assert facts["work"]["work_coulomb"] > 0
    assert facts["drift"]["energy_balance"] < 1e-12


def test_show_says_which_equations_it_shows(ask: Ask, billiard: Path) -> None:
    code, output, _ = ask("show", billiard)
    assert code == 0
    assert "These are the equations of one mode of the contact, sliding." in output
    assert "q̇ = " in output
    code, output, _ = ask("show", billiard, "--json")
    assert json.loads(output)["place"] is None
    code, output, _ = ask("show", billiard, "--as", "toml")
    assert ch.parse_experiment(output).toml() == ch.parse_experiment(output, overrides=[]).toml()
    assert 'impact_law = "stronge"' in output


@pytest.mark.slow
def test_what_friction_keeps_is_proved(ask: Ask, billiard: Path) -> None:
    code, output, _ = ask("prove", billiard, "--json")
    verdicts = {item["law"]: item["verdict"] for item in json.loads(output)}
    assert code == 0
    assert set(verdicts.values()) == {"proven"}
    assert set(verdicts) == {
        *("jellett", "momentum_x", "momentum_y", "momentum_z", "direction_x", "direction_y"),
        *("power", "coulomb_power"),
    }
    code, output, _ = ask("show", "--laws", billiard)
    assert code == 0
    assert "Homogeneous ball under any force against its slip" in output
    assert "Jellett's integral" in output
    assert output.splitlines()[-1].endswith("billiard.toml proves them.")


def test_a_contact_without_known_laws_is_told(ask: Ask, tmp_path: Path) -> None:
    case = CASES["ball in a bowl"]
    turning = {**case, "surface": {**case["surface"], "turntable": 1.0}}
    (tmp_path / "bowl.toml").write_text(experiment_text(turning))
    for command in (["prove", "bowl.toml"], ["show", "--laws", "bowl.toml"]):
        code, output, _ = ask(*command)
        assert (code, output.splitlines()[-1]) == (0, "No laws of it are known.")


OTHERS = """\
find integrals {}
lyapunov {}
solve {}
bifurcation {}
orbit {} --on gamma_3
sweep {} -o a.zarr --over mu=0.1:0.3:3
"""


@pytest.mark.parametrize("command", OTHERS.splitlines())
def test_other_commands_say_that_they_cannot(
    ask: Ask, billiard: Path, command: str, tmp_path: Path
) -> None:
    code, output, error = ask(*command.format("billiard.toml").split())
    assert (code, output) == (2, "")
    (line,) = [text for text in error.splitlines() if text.startswith("error")]
    assert line.startswith("error: billiard.toml, line ")
    assert line.endswith(
        "contact.model: with friction the equations of motion change at events, and only show, "
        "prove, run, study, ensemble, chart and section take such a file"
    )
    assert [path.name for path in tmp_path.iterdir()] == ["billiard.toml"]


@pytest.mark.slow
def test_an_ensemble_resumes_and_has_its_seed(ask: Ask, billiard: Path) -> None:
    drawn = ("--starts", 3, "--draw", "velocity_1=1:2", "--over", "mu=0.2:0.3:2")
    arguments = ("ensemble", billiard, *drawn, "--seed", 4, "-o", "a.zarr", "--record", "energy")
    code, output, error = ask(*arguments)
    assert code == 0, error
    assert "3 with velocity_1 from 1 to 2 (seed 4) × 2 of mu" in output
    assert "6 of 6 motions: the last time was reached" in output
    data = read_store("a.zarr")
    assert data.sizes["run"] == 6
    assert data.attrs["seed"] == 4
    assert ask(*arguments, "--json")[0] == 0
    code, _, error = ask(*arguments, "--draw", "omega_3=0:1")
    assert code == 2
    assert "a.zarr holds another experiment" in error


@pytest.mark.slow
def test_a_chart_and_a_section(ask: Ask, billiard: Path) -> None:
    axes = ("--x", "mu=0.1:0.3:2", "--y", "u=1:2:2", "--let", "velocity_1=u")
    code, output, error = ask("chart", billiard, "--of", "first:stick", *axes, "-o", "c.zarr")
    assert code == 0, error
    assert "time of the first stick" in output
    assert Path("c.png").is_file()
    place = ("--on", "position_1", "--value", -0.005, "--points", 1, "--direction", "falling")
    code, output, error = ask("section", billiard, *place, "-o", "s.zarr")
    assert code == 0, error
    assert "1 of 1 motion" in output
    assert Path("s.png").is_file()


MISTAKES = {
    "ensemble {} -o a.zarr": "an ensemble needs --draw NAME=A:B or --over NAME=A:B:N",
    "ensemble {} -o a.zarr --starts 3": "it is not said what differs",
    "ensemble {} -o a.zarr --starts 0 --draw mu=0:1": "--starts 0: it must be at least 1",
    "ensemble {} -o a.zarr --level energy=1": "with friction no integrals remain",
    "ensemble {} -o a.zarr --draw mu=a:b": "--draw mu=a:b: it is written NAME=A:B",
    "ensemble {} -o a.zarr --draw mue=0:1": "the experiment has no number of this name",
    "ensemble veselova -o a.zarr --draw mu=0:1": "only with friction are starts drawn from ranges",
    "chart {} --of drift --x mu=0:1:3 --y mass=1:2:3 -o a.zarr": "no number of a motion with",
    "chart {} --of events --x mu=0:1:3 --y mass=1:2:3 -o a.zarr --hold gamma": "nothing of a start",
    "section {} --on gamma_3 -o a.zarr --starts 3": "no integrals remain on whose level",
}


@pytest.mark.parametrize("command", MISTAKES)
def test_mistakes_of_many_motions(ask: Ask, billiard: Path, command: str, tmp_path: Path) -> None:
    code, output, error = ask(*command.format("billiard.toml").split())
    assert (code, output) == (2, "")
    (line,) = [text for text in error.splitlines() if text.startswith("error")]
    assert MISTAKES[command] in line
    assert [path.name for path in tmp_path.iterdir()] == ["billiard.toml"]


def test_a_mistake_is_told_with_its_place(ask: Ask, billiard: Path) -> None:
    code, output, error = ask("run", billiard, "-o", "a.nc", "--set", "start.position=[0,0,0.05]")
    assert (code, output) == (2, "")
    assert "error: --set start.position: the body lies 0.05 m inside the support" in error


@pytest.mark.slow
def test_a_run_that_ends_early_says_why(ask: Ask, tmp_path: Path) -> None:
    path = tmp_path / "dome.toml"
    path.write_text(experiment_text(CASES["ball leaves a dome"], 11))
    code, output, _ = ask("run", path, "-o", "a.nc", "--set", "run.on_liftoff=stop")
    assert code == 0
    assert "the motion ends at t = " in output
    assert ch.open_dataset("a.nc").attrs["end_reason"] in " ".join(output.split())


@pytest.mark.slow
def test_a_study_has_a_report(ask: Ask, billiard: Path) -> None:
    code, output, _ = ask("study", billiard)
    assert code == 0
    assert "1 event: 1 stick" in output
    assert "stick, then rolling" in Path("billiard/report.html").read_text()
    assert ch.open_dataset("billiard/trajectory.nc").sizes["event"] == 1
