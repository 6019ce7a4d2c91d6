"""The command line as a user meets it: what it prints, what it writes, how it refuses."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from catalogue import built
from chaplygin.cli import main
from chaplygin.experiment.dataset import open_dataset
from chaplygin.experiment.models.experiment import load_experiment
from named_states import named_states
from nonholonomic.catalogue import CATALOGUE
from spread import spread

__all__ = ["named_states"]

EXAMPLES = Path(__file__).parents[4] / "examples"

Answer = tuple[int, str, str]
Ask = Callable[..., Answer]


@pytest.fixture
def ask(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Ask:
    """Run a command in an empty folder; exit code, standard output, standard error."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: object) -> Answer:
        monkeypatch.setattr(sys, "argv", ["chaplygin", *map(str, arguments)])
        with pytest.raises(SystemExit) as end:
            main()
        output = capsys.readouterr()
        return int(end.value.code or 0), output.out, output.err

    return run


def test_list_names_every_system(ask: Ask) -> None:
    code, out, _ = ask("list")
    assert code == 0
    assert all(name in out for name in CATALOGUE)
    code, out, _ = ask("list", "--json")
    assert [item["name"] for item in json.loads(out)] == list(CATALOGUE)


@pytest.mark.slow
@pytest.mark.parametrize("name", CATALOGUE)
def test_equations_fit_a_terminal(name: str) -> None:
    assert max(map(len, str(built.system(name)).splitlines())) <= 100


# the place in the hierarchy takes seconds of proofs: a part of the catalogue stands for all
@pytest.mark.slow
@pytest.mark.parametrize("name", list(CATALOGUE)[::7])
def test_show_prints_equations_that_fit_a_terminal(ask: Ask, name: str) -> None:
    code, out, _ = ask("show", name)
    assert code == 0
    assert "Equations of motion" in out
    assert CATALOGUE[name].title in out
    assert max(map(len, out.splitlines())) <= 100


@pytest.mark.parametrize(
    ("form", "sign"), [("latex", r"\begin{aligned}"), ("julia", "function"), ("c", "void")]
)
def test_show_in_other_languages(ask: Ask, form: str, sign: str) -> None:
    code, out, _ = ask("show", "rattleback", "--as", form)
    assert code == 0
    assert sign in out


def test_show_as_javascript_is_a_module(ask: Ask) -> None:
    code, out, _ = ask("show", "veselova", "--as", "javascript")
    assert code == 0
    assert "export const model = {" in out and "export default () =>" in out


def test_show_as_wasm_writes_a_module(tmp_path: Path) -> None:
    with (tmp_path / "veselova.wasm").open("wb") as file:
        command = [sys.executable, "-m", "chaplygin", "show", "veselova", "--as", "wasm"]
        subprocess.run(command, check=True, stdout=file, stderr=subprocess.DEVNULL)
    assert (tmp_path / "veselova.wasm").read_bytes()[:8] == b"\0asm\1\0\0\0"


def test_show_as_toml_is_a_complete_experiment(ask: Ask, tmp_path: Path) -> None:
    _, out, _ = ask("show", EXAMPLES / "egg.toml", "--as", "toml")
    (tmp_path / "egg.toml").write_text(out)
    original = load_experiment(EXAMPLES / "egg.toml")
    assert load_experiment(tmp_path / "egg.toml") == original


@pytest.mark.slow
def test_show_json(ask: Ask) -> None:
    _, out, _ = ask("show", "chaplygin-ball", "--json")
    facts = json.loads(out)
    assert facts["state"][:3] == ["M_1", "M_2", "M_3"]
    found = {law["name"] for law in facts["laws"] if law["kind"] == "Integral"}
    assert found == {"energy", "area", "momentum"}
    assert all(law["heading"] and law["value"] for law in facts["laws"])


@pytest.mark.slow
def test_run_writes_a_trajectory(ask: Ask) -> None:
    code, out, err = ask("run", "chaplygin-ball", "-o", "ball.nc", "--set", "run.until=5")
    # a slow machine is told what it is waiting for
    assert (code, err.removeprefix("Chaplygin ball …\n")) == (0, "")
    assert "drift" in out
    dataset = open_dataset("ball.nc")
    assert dataset.sizes["time"] == 101
    assert float(dataset.time[-1]) == 5.0
    assert dataset.attrs["complete"] == 1
    assert "chaplygin-ball" in dataset.attrs["experiment"]


@pytest.mark.slow
def test_run_json_in_quad_has_thirty_digits(ask: Ask) -> None:
    arguments = ["run", "veselova", "-o", "v.nc", "--precision", "quad", "--json"]
    code, out, _ = ask(*arguments, "--set", "run.until=2", "--set", "run.samples=3")
    assert code == 0
    facts = json.loads(out)
    assert all(len(text.strip("-0.")) >= 30 for text in facts["final"].values())
    assert facts["drift"]["energy"] < 1e-30
    dataset = open_dataset("v.nc")
    assert np.abs(dataset.omega_low).max() < 1e-15


@pytest.mark.slow
def test_the_stored_experiment_makes_the_same_bits(ask: Ask, tmp_path: Path) -> None:
    ask("run", EXAMPLES / "egg.toml", "-o", "first.nc", "--set", "run.until=1")
    (tmp_path / "again.toml").write_text(open_dataset("first.nc").attrs["experiment"])
    ask("run", "again.toml", "-o", "second.nc")
    assert open_dataset("first.nc").identical(open_dataset("second.nc"))


@pytest.mark.slow
def test_normalising_gamma_is_said(ask: Ask) -> None:
    _, _, err = ask("run", EXAMPLES / "egg.toml", "-o", "egg.nc", "--set", "run.until=0.1")
    assert "start.gamma has length 0.98" in err
    assert "normalised" in err


@pytest.mark.slow
def test_study_writes_its_folder(ask: Ask, tmp_path: Path) -> None:
    code, out, _ = ask("study", "heavy-disk", "--set", "run.until=2")
    assert code == 0
    folder = tmp_path / "heavy-disk"
    assert str(Path("heavy-disk") / "report.html") in out
    page = (folder / "report.html").read_text()
    assert page.count('<svg role="img"') == 16
    assert "<math" in page
    assert re.findall(r"http-equiv=\"([\w-]+)", page) == ["Content-Security-Policy"]
    assert 'src="' not in page and "@import" not in page
    assert (folder / "trajectory.nc").exists()
    assert load_experiment(folder / "experiment.toml").run.until == 2.0
    suffixes = {path.suffix for path in (folder / "figures").iterdir()}
    assert suffixes == {".svg", ".png"}
    code, _, err = ask("study", "heavy-disk")
    assert code == 2
    assert "--force" in err


@pytest.mark.slow
def test_reports_are_reproducible(ask: Ask, tmp_path: Path) -> None:
    for name in ("one", "two"):
        ask("study", EXAMPLES / "coin.toml", "-o", name, "--set", "run.until=0.2")
    pages = [(tmp_path / name / "report.html").read_text() for name in ("one", "two")]
    assert pages[0] == pages[1]


@pytest.mark.slow
def test_lift_off_is_reported(ask: Ask) -> None:
    bowl = [EXAMPLES / "ball_in_a_bowl.toml", "--set", "surface.side=outside"]
    code, out, _ = ask("run", *bowl, "-o", "stop.nc", "--json")
    facts = json.loads(out)
    assert code == 0
    assert facts["events"][0]["stopped"]
    assert facts["time"] == facts["events"][0]["time"] < 3.0
    _, out, _ = ask("run", *bowl, "-o", "on.nc", "--set", "run.on_liftoff=warn")
    assert "the run continues" in out


@pytest.mark.slow
def test_a_time_limit_keeps_what_was_computed(ask: Ask) -> None:
    long = ["--set", "run.until=1e7", "--set", "run.time_limit=0.2", "--set", "run.samples=1000001"]
    code, _, err = ask("run", "chaplygin-ball", "-o", "long.nc", *long)
    assert code == 1
    assert "time limit" in err
    assert "last good time" in err
    dataset = open_dataset("long.nc")
    assert dataset.attrs["complete"] == 0
    assert 1 < dataset.sizes["time"] < 1_000_000


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["show", "ratleback"], ["ratleback", "did you mean 'rattleback'"]),
        (["show", "no.toml"], ["no.toml", "there is no such file"]),
        (["show", "rattleback", "--as", "pdf"], ["--as pdf", "julia"]),
        (["run", "rattleback", "-o", "no/b.nc"], ["no folder no"]),
        (["run", "rattleback", "-o", "."], ["a folder"]),
        (["run", "heavy-disk", "-o", "d.nc", "--set", "start.gamma=[0,0,1]"], ["lies flat"]),
        (["run", "heavy-disk", "-o", "d.nc", "--set", "system.parameters.m=-1"], ["m = -1.0"]),
        (
            ["run", "heavy-disk", "-o", "d.nc", "--set", "system.parameters.b=1"],
            ["no parameter b", "I_1"],
        ),
        (["run", "veselova", "-o", "v.nc", "--set", "start.omega=[0,0,1]"], ["nearest admissible"]),
        (["run", "veselova", "-o", "v.nc", "--precision", "triple"], ["precision", "quad"]),
        (["run", "veselova", "-o", "v.nc", "--set", "run.samples=1"], ["run.samples", "2"]),
    ],
)
def test_mistakes_get_one_sentence(ask: Ask, arguments: list[str], words: list[str]) -> None:
    code, out, err = ask(*arguments)
    assert (code, out) == (2, "")
    assert err.startswith("error: ")
    assert "Traceback" not in err
    for word in words:
        assert word in err
    assert not list(Path().iterdir())


def test_existing_files_are_never_overwritten(ask: Ask) -> None:
    Path("a.nc").write_text("mine")
    code, _, err = ask("run", "veselova", "-o", "a.nc")
    assert code == 2
    assert "--force" in err
    assert Path("a.nc").read_text() == "mine"


def test_the_nearest_admissible_start_is_admissible(ask: Ask) -> None:
    arguments = ["run", "veselova", "-o", "v.nc", "--set", "run.until=1"]
    _, _, err = ask(*arguments, "--set", "start.omega=[1, 2, 3]")
    nearest = err.split("nearest admissible omega is ")[1].strip()
    code, _, _ = ask(*arguments, "--set", f"start.omega={nearest}")
    assert code == 0


@pytest.mark.slow
def test_quiet_and_whole_when_piped(tmp_path: Path) -> None:
    script = "from chaplygin.cli import main; main()"
    result = subprocess.run(
        [sys.executable, "-c", script, "run", "veselova", "-o", "v.nc"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
        env=os.environ,
    )
    assert result.stderr in ("", "Veselova system …\n")
    assert "\x1b" not in result.stdout


def test_help_and_version(ask: Ask) -> None:
    code, out, _ = ask("--help")
    assert code == 0
    assert all(word in out for word in ("list", "show", "run", "study"))
    code, out, _ = ask("--version")
    assert out.startswith("chaplygin ")


def test_importing_the_command_line_imports_nothing_heavy() -> None:
    script = (
        "import sys, chaplygin.cli;"
        "print([m for m in ('sympy', 'heyoka', 'numpy', 'xarray', 'matplotlib', 'pydantic')"
        " if m in sys.modules])"
    )
    result = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert result.stdout.strip() == "[]"


@pytest.mark.slow
@pytest.mark.parametrize("name", spread(["trial-sleigh", "trial-top"]))
def test_systems_started_by_their_state(ask: Ask, named_states: None, name: str) -> None:
    code, out, _ = ask("show", name)
    assert code == 0
    assert "contact point" not in out
    assert ("u velocity along the blade" in out) == (name == "trial-sleigh")
    code, out, _ = ask("run", name, "-o", "motion.nc", "--set", "run.until=1")
    assert code == 0
    assert "energy: drift" in out
    assert float(open_dataset("motion.nc").time[-1]) == 1.0
    code, out, _ = ask("study", name, "--set", "run.until=1")
    assert code == 0
    assert load_experiment(Path(name) / "experiment.toml").run.until == 1.0
    code, _, err = ask("run", name, "-o", "other.nc", "--set", "start.speed=1")
    assert code == 2
    assert "--set start.speed: unknown variable" in err
