"""What a user meets who writes something in his own way, or asks for what cannot be."""

from __future__ import annotations

from pathlib import Path

import pytest

from asking import Ask, ask
from chaplygin.experiment.dataset import open_dataset
from chaplygin.experiment.models.experiment import load_experiment
from chaplygin.experiment.study import Study

__all__ = ["ask"]

BALL = """\
[body]
mass = 1.0
inertia = [1.0, 1.2, 1.5]
[body.shape]
kind = "ball"
radius = 1.0
[start]
gamma = [0, 0, 1]
omega = [1, 0, 0]
"""


def test_a_parameter_alone_by_its_name(ask: Ask) -> None:
    code, out, _ = ask("show", "chaplygin-ball", "--as", "toml", "--set", "I_1=1.25")
    assert code == 0
    assert "I_1 = { value = 1.25" in out


def test_a_parameter_of_a_file_alone_by_its_name(ask: Ask) -> None:
    field = '[field]\npotential = "a*γ₃²"\nparameters = {a = 1.0}\n'
    Path("ball.toml").write_text(BALL + field)
    code, out, _ = ask("show", "ball.toml", "--as", "toml", "--set", "a=3.5")
    assert code == 0
    assert "a = 3.5" in out


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (
            ("--set", "system.parameters.I_1=-1"),
            "--set system.parameters.I_1: chaplygin-ball, body.inertia: principal moments -1, 1.5, "
            "2.1 must all be pos",
        ),
        (
            ("--set", "I_1=-1", "--set", "I_2=3"),
            "--set I_1 --set I_2: chaplygin-ball, body.inertia: principal moments -1, 2.1, 3 must "
            "all be positive",
        ),
        (
            ("--set", "I_9=2"),
            "--set I_9: unknown key, did you mean 'I_3'? allowed: title, system, body, start, run",
        ),
        (
            ("--set", "until=3"),
            "--set until: unknown key; a key is written with its table: --set run.until=3",
        ),
        (("--precision", "triple"), "--precision triple: it must be double or quad"),
        (("-o", "v.txt"), "v.txt: the name of a trajectory must end in .nc (NetCDF), .zarr (a Z"),
        (
            ("--set", "run.until=1e300"),
            "--set run.until: to follow a motion for 1e+300 s would take about ",
        ),
        (
            ("--set", "run.until=1e300", "--set", "run.method=gauss"),
            "--set run.until: to follow a motion for 1e+300 s would take about ",
        ),
    ],
)
def test_a_sentence_names_the_option(options: tuple[str, ...], sentence: str, ask: Ask) -> None:
    where = () if "-o" in options else ("-o", "a.nc")
    code, out, err = ask("run", "chaplygin-ball", *where, *options)
    assert (code, out) == (2, "")
    *progress, message = err.splitlines()
    assert message.startswith(f"error: {sentence}")
    # said where the refusal takes a second, or two
    assert set(progress) <= {"Chaplygin ball …", "Chaplygin ball: 0% …"}
    assert not list(Path().iterdir())


def test_a_catalogue_name_is_no_file_with_lines(ask: Ask) -> None:
    code, _, err = ask("show", "veselova", "--set", "start.gamma=[0,0,0]")
    assert code == 2
    assert "line" not in err


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (
            ("mass = 1.0", "mass = 1e308"),
            "start: M_1 = 1e+308, m = 1e+308 are too far from 1 to compute with: choose",
        ),
        (
            ("omega = [1, 0, 0]", "omega = [1e200, 0, 0]"),
            "start: M_1 = 2e+200 is too far from 1 to compute with: choose other units or",
        ),
        (
            (
                'kind = "ball"\nradius = 1.0',
                'kind = "implicit"\nsurface = "x**2 + y**2 - z**2 - 1"',
            ),
            "line 6, body.shape.surface: surface x**2 + y**2 - z**2 - 1 = 0: it is not closed",
        ),
    ],
)
def test_the_cause_is_named(change: tuple[str, str], sentence: str, ask: Ask) -> None:
    Path("ball.toml").write_text(BALL.replace(*change))
    code, _, err = ask("run", "ball.toml", "-o", "ball.nc")
    assert code == 2
    assert sentence in err
    assert "gamma" not in err


def test_a_centre_of_mass_outside_is_told(ask: Ask) -> None:
    words = "note: body.shape.centre puts the centre of mass outside the body\n"
    Path("ball.toml").write_text(BALL.replace("radius = 1.0", "radius = 1.0\ncentre = [0, 0, 3]"))
    assert ask("show", "ball.toml", "--as", "toml")[2] == words
    assert ask("show", "ball.toml", "--as", "toml", "--set", "body.shape.radius=4")[2] == ""


def test_a_centre_of_mass_outside_is_seen_where_a_study_is_printed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    text = BALL.replace("radius = 1.0", "radius = 1.0\ncentre = [0, 0, 3]")
    Path("ball.toml").write_text(text)
    assert "    note    body.shape.centre puts the centre of mass outside the body" in str(
        Study.from_experiment(load_experiment("ball.toml"))
    )


@pytest.mark.parametrize("name", ["film.gif", "film.glb"])
def test_what_cannot_be_shown_is_refused_before_it_is_integrated(
    name: str, ask: Ask, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Study, "trajectory", lambda *_: pytest.fail("it was integrated"))
    code, _, err = ask("animate", "veselova", "-o", name)
    assert code == 2
    assert err.startswith("error: Veselova system has no body that could be ")


BALL_SECTION = ("section", "chaplygin-ball", "-o", "s.zarr", "--on")
DISK_SECTION = ("section", "dry.toml", "-o", "s.zarr", "--on")


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ((*BALL_SECTION, "nonsense"), "--on: unknown name 'nonsense'"),
        ((*BALL_SECTION, "M"), "--on: M is a vector; name one of its components"),
        ((*BALL_SECTION, "M_1", "--coordinates", "odd,M_2"), "--coordinates: unknown name 'odd'"),
        ((*BALL_SECTION, "M_1", "--within", "odd<1"), "--within: unknown name 'odd'"),
        (("orbit", "chaplygin-ball", "--on", "nonsense"), "--on: unknown name 'nonsense'"),
        ((*DISK_SECTION, "nonsense"), "--on: unknown name 'nonsense'"),
        ((*DISK_SECTION, "2"), "--on 2: it is the same at all times"),
        ((*DISK_SECTION, "gamma_3", "--coordinates", "odd,M_2"), "--coordinates: unknown name"),
        ((*DISK_SECTION, "gamma_3", "--within", "odd<1"), "--within: unknown name 'odd'"),
    ],
)
def test_the_option_is_named(arguments: tuple[str, ...], sentence: str, ask: Ask) -> None:
    Path("dry.toml").write_text(f'{BALL}[contact]\nmodel = "friction"\nmu = 0.3\n')
    code, _, err = ask(*arguments)
    assert code == 2
    # what takes long is announced first
    assert f"\nerror: {sentence}" in f"\n{err}"


@pytest.mark.parametrize(
    ("condition", "sentence"),
    [
        ("I_1", "I₁ = 0, but I₁ > 0 is required"),
        ("I_1 = 0", "I₁ = 0, but I₁ > 0 is required"),
        ("2*I_1 + 2", "I₁ = −1, but I₁ > 0 is required"),
        ("I_1 + I_2", "the level I₁ + I₂ = 0 is empty"),
        ("I_1**2 + I_2**2 + I_3**2 + I_13**2 + I_23**2 = 9", "must be linear in one of I₁, I₂, I₃"),
    ],
)
def test_parameters_are_written_alike_in_a_sentence(
    condition: str, sentence: str, ask: Ask
) -> None:
    code, _, err = ask("find", "integrals", "suslov", "--at", condition)
    assert code == 2
    assert sentence in err
    assert "I_" not in err


@pytest.mark.slow
@pytest.mark.parametrize("ending", ["nc", "csv", "zarr"])
def test_a_run_is_written_as_its_name_ends(ending: str, ask: Ask) -> None:
    options = ("--set", "run.until=1", "--set", "run.samples=3")
    code, _, err = ask("run", "chaplygin-ball", "-o", f"v.{ending}", *options)
    assert code == 0, err
    if ending == "csv":
        lines = [line for line in Path("v.csv").read_text().splitlines() if line[0] != "#"]
        assert lines[0].startswith("time,M_1,M_2,M_3,gamma_1,gamma_2,gamma_3,")
        assert len(lines) == 4
    else:
        assert open_dataset(f"v.{ending}").sizes["time"] == 3
    code, _, err = ask("run", "chaplygin-ball", "-o", f"v.{ending}", *options)
    assert code == 2
    assert f"v.{ending} exists already" in err
    assert ask("run", "chaplygin-ball", "-o", f"v.{ending}", "--force", *options)[0] == 0


def test_a_chart_that_finds_no_room(ask: Ask) -> None:
    axes = ("--x", "I_1=1:1.1:100000", "--y", "I_2=1:1.1:100000")
    code, _, err = ask("chart", "chaplygin-ball", "--of", "megno", *axes, "-o", "big.zarr")
    assert code == 2
    assert "numbers of the result would take " in err
    assert "GiB of disk, and there are " in err
    assert not list(Path().iterdir())


def test_motions_that_are_never_over(ask: Ask) -> None:
    words = "would take about 1e+301 steps, and it is given up after 1e+08"
    code, _, err = ask("lyapunov", "chaplygin-ball", "--until", "1e300")
    assert code == 2
    assert words in err


def test_groups_and_filters(ask: Ask) -> None:
    code, out, _ = ask("list", "--contact", "rubber", "--section", "9")
    assert code == 0
    assert "Bodies that roll with neither slipping nor spinning (rubber)" in out
    assert "rubber-ball-on-sphere" in out
    assert "veselova" not in out
    assert "heavy-disk" not in out
    integrable = ask("list", "--integrable")[1]
    assert "ball-bearing" in integrable
    assert "rattleback" not in integrable


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (("--contact", "glue"), "--contact glue: it must be one of marble, rubber, none"),
        (("--section", "77"), "--section 77: nothing is from there; there are 1, 2, 3,"),
        (
            ("--section", "4", "--contact", "rubber"),
            "no system of the catalogue is of all these kinds: leave out a filter",
        ),
    ],
)
def test_filters_that_let_nothing_through(
    options: tuple[str, ...], sentence: str, ask: Ask
) -> None:
    code, out, err = ask("list", *options)
    assert (code, out) == (2, "")
    assert err.startswith(f"error: {sentence}")


def test_laws_alone(ask: Ask) -> None:
    code, out, _ = ask("show", "veselova", "--laws")
    assert code == 0
    assert "Constant along the motion" in out
    assert "Equations of motion" not in out
    assert ask("show", "veselova", "--laws", "--as", "c")[0] == 2
