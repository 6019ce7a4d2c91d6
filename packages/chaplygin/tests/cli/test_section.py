"""``chaplygin section`` as a user meets it."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from chaplygin.cli import main
from flowlanes.flow.ensembles.zarr_store import read_store

Answer = tuple[int, str, str]
Ask = Callable[..., Answer]

BALL = (
    *("unbalanced-ball", "--on", "gamma_3", "--points", "20"),
    *("--set", "start.omega=[1, 2, 0]", "--set", "start.gamma=[0, 0.6, 0.8]"),
)


def with_options(options: list[str]) -> list[str]:
    """The arguments of `BALL` and a file to write, with some options in place of theirs."""
    arguments = [*BALL, "-o", "ball.zarr"]
    pairs = list(zip(arguments[1::2], arguments[2::2], strict=True))
    replaced = [_place(*options[:2])] if len(options) > 1 else []
    return [
        arguments[0],
        *(text for pair in pairs if _place(*pair) not in replaced for text in pair),
        *options,
    ]


def _place(option: str, value: str) -> str:
    """What an option sets: a key of the file, or itself."""
    return value.partition("=")[0] if option == "--set" else option


@pytest.fixture
def ask(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Ask:
    """Run `chaplygin section` in an empty folder; exit code, standard output, standard error."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: object) -> Answer:
        monkeypatch.setattr(sys, "argv", ["chaplygin", "section", *map(str, arguments)])
        with pytest.raises(SystemExit) as end:
            main()
        output = capsys.readouterr()
        return int(end.value.code or 0), output.out, output.err

    return run


@pytest.mark.slow
def test_the_points_of_one_motion(ask: Ask) -> None:
    code, out, err = ask(*BALL, "-o", "ball.zarr")
    assert code == 0
    for part in ("gamma_3 = 0, rising", "the start of the experiment", "20 of 1 motion"):
        assert part in out
    assert "written to ball.zarr, figure: ball.png" in err
    assert Path("ball.png").read_bytes().startswith(b"\x89PNG")
    found = read_store(Path("ball.zarr"))
    assert found.sizes["run"] == 1
    assert found.sizes["section_point"] == 20
    assert np.abs(found["gamma"].sel(axis=3)).max() < 1e-13
    assert (np.diff(found["time"].values[0]) > 0).all()
    assert all(found[name].units and "source" in found[name].attrs for name in found.data_vars)
    energy = found["law_energy"].values
    assert np.ptp(energy) < 1e-11 * energy[0, 0]
    assert 'name = "unbalanced-ball"' in found.attrs["experiment"]


@pytest.mark.slow
def test_many_motions_on_a_level(ask: Ask) -> None:
    """The record, a folder, coordinates of one's own, and that what is done stays done."""
    arguments = (
        *("chaplygin-ball", "--on", "atan2(gamma_2, gamma_1)", "--angle", "--value", "0.5"),
        *("--direction", "both", "--points", "15", "--starts", "6", "--seed", "3"),
        *("--level", "energy=1,area=0.3", "--coordinates", "area, h = gamma_3**2, M_2"),
        *("--until", "1e4", "-o", "ball", "--json"),
    )
    code, out, _ = ask(*arguments)
    assert code == 0
    record = json.loads(out)
    assert record["file"] == "ball/section.zarr"
    assert record["coordinates"] == ["area", "h", "M_2"]
    assert record["runs"] == 6
    assert sum(record["outcomes"].values()) == 6
    assert max(record["drift"].values()) < 1e-11
    found = read_store(Path("ball/section.zarr")).load()
    gamma = found["gamma"].values
    assert np.nanmax(np.abs(np.arctan2(gamma[..., 1], gamma[..., 0]) - 0.5)) < 1e-12
    assert np.nanmax(np.abs(found["h"] - gamma[..., 2] ** 2)) < 1e-15
    assert np.nanmax(np.abs(found["area"] - 0.3)) < 1e-11
    assert "energy = 1, area = 0.3" in found.attrs["starts"]
    again = json.loads(ask(*arguments)[1])
    assert again == record
    other = list(arguments)
    other[other.index("3")] = "4"
    code, _, err = ask(*other)
    assert code == 2
    assert "another" in err
    assert ask(*other, "--force")[0] == 0
    changed = read_store(Path("ball/section.zarr"))
    assert not np.array_equal(changed["M"].values, found["M"].values)


@pytest.mark.slow
def test_a_section_in_a_plane(ask: Ask) -> None:
    code, out, _ = ask(
        *("veselova", "--on", "gamma_3", "--points", "30"),
        *("--coordinates", "phi = atan2(gamma_2, gamma_1), omega_3", "-o", "veselova.zarr"),
    )
    assert code == 0
    assert "30 of 1 motion" in out
    assert read_store(Path("veselova.zarr"))["phi"].units == "rad"


@pytest.mark.slow
def test_a_section_of_the_section(ask: Ask) -> None:
    arguments = [*BALL, "--within", "M_1 < 0.8", "--within", "M_3**2<9", "-o", "ball.zarr"]
    arguments[arguments.index("20")] = "5"
    code, out, _ = ask(*arguments, "--until", "1e4")
    assert code == 0
    assert "gamma_3 = 0, rising, |M_1| < 0.8, |M_3**2| < 9" in " ".join(out.split())
    found = read_store(Path("ball.zarr"))
    momenta = found["M"].values[0, : int(found["points"][0])]
    assert len(momenta) > 0
    assert (np.abs(momenta[:, 0]) < 0.8).all()
    assert (momenta[:, 2] ** 2 < 9).all()


@pytest.mark.slow
def test_a_surface_that_is_never_met_is_an_answer(ask: Ask) -> None:
    code, out, err = ask(*BALL, "--value", "2", "--until", "10", "-o", "ball.zarr")
    assert (code, out) == (1, "")
    assert err.startswith("error: no motion passes gamma_3 = 2, rising: the time limit was reached")
    assert err.count("\n") == 1
    # nothing stays that would refuse the corrected command
    assert ask(*BALL, "-o", "ball.zarr")[0] == 0


def test_a_file_is_no_folder(ask: Ask) -> None:
    Path("notes").write_text("mine")
    code, _, err = ask(*BALL, "-o", "notes")
    assert (code, err.count("\n")) == (2, 1)
    assert "--output notes: a file has this name" in err
    assert Path("notes").read_text() == "mine"


def test_interrupted(ask: Ask, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object, progress: Callable[[float], None], **__: object) -> None:
        Path(names.pop(0)).mkdir()
        progress(0.25)
        raise KeyboardInterrupt

    names = ["ball.zarr", "forced.zarr"]
    monkeypatch.setattr("flowlanes.flow.ensembles.computation.compute", interrupted)
    code, out, err = ask(*BALL, "-o", "ball.zarr")
    assert (code, out) == (130, "")
    sentence = (
        "interrupted: 25% is computed and saved in ball.zarr; the same command resumes from there\n"
    )
    assert err.endswith(sentence)
    code, _, err = ask(*BALL, "-o", "forced.zarr", "--force")
    assert "the same command without --force resumes" in err


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--on", "gamma_4"], "unknown name 'gamma_4'"),
        (["--on", "gamma"], "is a vector"),
        (["--on", "m"], "contains no state"),
        (["--direction", "up"], "--direction up: it must be one of rising, falling, both"),
        (["--points", "0"], "--points 0: it must be at least 1"),
        (["-o", "ball.nc"], "--output ball.nc: its name must end in .zarr"),
        (["--starts", "0"], "--starts 0: it must be at least 1"),
        (["--until", "-1"], "--until -1.0: it must be positive and finite"),
        (["--level", "energy"], "--level energy: it is written NAME=VALUE"),
        (["--level", "energi=1"], "energi"),
        (["--coordinates", "M_1"], "two or three are needed"),
        (["--coordinates", "M_1,M_1*M_2"], "needs a name, as in height = M_1*M_2"),
        (["--coordinates", "M_1,time=M_2"], "bears the name of something else"),
        (["--within", "M_1"], "it is written QUANTITY<WIDTH"),
        (["--within", "M_1<0"], "it must be positive"),
        (["--tolerance", "1"], "it must be from 1e-16 to 0.1"),
        (["--set", "start.gamma=[0,0,0]"], "gamma"),
        (["-o", "no/where.zarr"], "no/where"),
        (["-o", "no/where"], "--output no/where: there is no folder no"),
    ],
)
def test_mistakes_are_told_in_one_sentence(ask: Ask, arguments: list[str], sentence: str) -> None:
    code, out, err = ask(*with_options(arguments))
    assert (code, out) == (2, "")
    assert err.startswith("error: ")
    assert sentence in err
    assert not Path("ball.zarr").exists()
