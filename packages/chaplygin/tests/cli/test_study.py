"""A study as a user meets it: what it says while it works, and how it resumes when interrupted."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from chaplygin.cli import main, study as command
from chaplygin.report import study_output as folders
from flowlanes.flow.taylor_run import TaylorRun

Ask = Callable[..., tuple[int, str, str]]
SHORT = ("study", "veselova", "--set", "run.until=0.2")


@pytest.fixture
def ask(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Ask:
    """Run a command in an empty folder; exit code, standard output, standard error."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: object) -> tuple[int, str, str]:
        monkeypatch.setattr(sys, "argv", ["chaplygin", *map(str, arguments)])
        with pytest.raises(SystemExit) as end:
            main()
        output = capsys.readouterr()
        return int(end.value.code or 0), output.out, output.err

    return run


def forbid(monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(*_: object, **__: object) -> None:
        raise AssertionError("a proof was tried")

    monkeypatch.setattr("nonholonomic.classification.facts.prove", refused)
    monkeypatch.setattr(
        "nonholonomic.classification.configuration_measures.invariant_measure", refused
    )


@pytest.mark.slow
def test_quick_leaves_proofs_out(ask: Ask, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    forbid(monkeypatch)
    code, _, err = ask(*SHORT, "--quick")
    assert code == 0, err
    page = (tmp_path / "veselova" / "report.html").read_text()
    assert "not tried, as proofs were left out" in page
    code, _, err = ask(*SHORT, "--quick", "--effort", "1", "-o", "other")
    assert code == 2
    assert "--quick leaves out the proofs that --effort is for" in err


@pytest.mark.slow
def test_what_is_tried_is_said_by_name(ask: Ask, monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[str] = []

    class Heard:
        def __init__(self, task: str) -> None:
            said.append(task)

        def __enter__(self) -> Heard:
            return self

        def __exit__(self, *_: object) -> None:
            pass

        def __call__(self, done: float, /) -> None:
            assert 0 <= done <= 1

        def say(self, what: str) -> None:
            said.append(what)

    monkeypatch.setattr(command, "progress", Heard)
    code, _, err = ask(*SHORT)
    assert code == 0, err
    assert said[:2] == ["integrating: Veselova system", "looking for a closed form and drawing"]
    assert "proving: energy of Veselova system" in said


@pytest.mark.slow
def test_an_interrupted_study_goes_on(
    ask: Ask, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def interrupted(*_: Any, **__: Any) -> str:
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(folders.page, "render", interrupted)
        code, out, err = ask(*SHORT, "--quick")
    assert (code, out) == (130, "")
    assert err.endswith(
        "interrupted: the part that is done is in veselova; the same command resumes there\n"
    )
    assert not (tmp_path / "veselova" / "report.html").exists()
    code, _, err = ask("study", "veselova", "--set", "run.until=0.3", "--quick")
    assert code == 2
    assert "veselova holds an unfinished study of another experiment" in err
    code, _, err = ask(*SHORT, "--quick")
    assert code == 0, err
    assert sorted(path.name for path in (tmp_path / "veselova").iterdir()) == [
        "experiment.toml",
        "figures",
        "report.html",
        "trajectory.nc",
    ]
    code, _, err = ask(*SHORT, "--quick")
    assert code == 2
    assert "veselova holds report.html" in err


@pytest.mark.slow
def test_an_interrupted_integration_is_no_finished_study(
    ask: Ask, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    is_pressed = TaylorRun._is_pressed

    def interrupted(self: Any, now: Any, log: Any, on_liftoff: str) -> bool:
        is_pressed(self, now, log, on_liftoff)
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(TaylorRun, "_is_pressed", interrupted)
        code, out, err = ask(*SHORT, "--quick")
        assert (code, out) == (130, "")
        assert err.count("interrupted: ") == 1
        code, out, err = ask("run", "veselova", "-o", "v.nc")
        assert code == 130
        assert re.search(r"interrupted: the trajectory up to t = 0 is in v\.nc; the same", err)
    assert ask(*SHORT, "--quick")[0] == 0


@pytest.mark.slow
def test_an_interrupted_study_is_not_integrated_again(
    ask: Ask, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def interrupted(*_: Any, **__: Any) -> str:
        raise KeyboardInterrupt

    def refused(*_: Any, **__: Any) -> None:
        raise AssertionError("the motion was integrated")

    assert ask(*SHORT, "--quick", "-o", "whole")[0] == 0
    with monkeypatch.context() as patched:
        patched.setattr(folders.page, "render", interrupted)
        assert ask(*SHORT, "--quick", "-o", "parts")[0] == 130
    with monkeypatch.context() as patched:
        patched.setattr("flowlanes.flow.integrator.integrate", refused)
        code, _, err = ask(*SHORT, "--quick", "-o", "parts")
    assert code == 0, err
    pages = [(tmp_path / name / "report.html").read_text() for name in ("whole", "parts")]
    assert pages[0] == pages[1]
    assert not list((tmp_path / "parts").glob(".unfinished*"))
