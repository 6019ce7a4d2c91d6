"""What the README shows works as shown."""

from __future__ import annotations

import re
import shlex
import sys
from pathlib import Path
from typing import Any

import pytest

from chaplygin.cli import main

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text()


def block(language: str, containing: str) -> str:
    """The code block of a language that contains a text."""
    blocks = re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)
    return next(text for text in blocks if containing in text)


@pytest.mark.slow
def test_the_python_lines_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    exec(compile(block("python", "import chaplygin"), "README.md", "exec"), {})
    assert "turns back at t = 2." in capsys.readouterr().out
    assert (tmp_path / "stone.nc").exists()


@pytest.mark.slow
def test_the_laws_found_are_those_shown(capsys: pytest.CaptureFixture[str]) -> None:
    exec(compile(block("python", "find_laws"), "README.md", "exec"), {})
    assert capsys.readouterr().out == block("text", "repeats")


def test_first_lines() -> None:
    first = re.search(r"```sh\n(.*?)```", README, re.DOTALL)
    assert first is not None
    assert [line.split("#")[0].strip() for line in first[1].splitlines()] == [
        "make demo",
        "make test",
    ]


def commands() -> list[list[str]]:
    """The arguments of every line that calls the command line."""
    starts = ("chaplygin list", "chaplygin prove", "sleigh.toml", "chaplygin solve")
    lines = [
        line
        for start in (*starts, "chaplygin section")
        for line in block("sh", start).splitlines()
        if line
    ]
    return [shlex.split(line.split("#")[0].split(">")[0]) for line in lines]


def test_the_shell_lines_name_commands_and_options(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    wrong = []
    for command in commands():
        monkeypatch.setattr(sys, "argv", [*command[:2], "--help"])
        with pytest.raises(SystemExit):
            main()
        offered = set(re.findall(r"(?<![\w-])--?[a-z][\w-]*", capsys.readouterr().out))
        used = {word.split("=")[0] for word in command if re.match("--?[a-z]", word)}
        wrong += [" ".join(command)] if used - offered or not offered else []
    assert wrong == []


@pytest.mark.slow
def test_the_shell_lines_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    for command in commands():
        monkeypatch.setattr(sys, "argv", command)
        with pytest.raises(SystemExit) as end:
            main()
        assert not end.value.code, capsys.readouterr().err


def test_many_motions_are_computed() -> None:
    names: dict[str, Any] = {}
    exec(compile(block("python", "flowlanes.sample_level"), "README.md", "exec"), names)
    assert names["there"].shape == (1000, 1, 6)
    assert dict(names["runs"].sizes) == {"run": 1000, "time": 2, "axis": 3}
    assert not names["exact"].outcome.any()


def test_the_sleigh_is_derived(capsys: pytest.CaptureFixture[str]) -> None:
    exec(compile(block("python", "sleigh = Mechanism"), "README.md", "exec"), {})
    sentence = capsys.readouterr().out
    assert sentence.startswith("proven")
    assert "completely nonholonomic" in sentence


@pytest.mark.slow
def test_the_equations_are_the_ones_that_show_prints(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["chaplygin", "show", "chaplygin-ball"])
    with pytest.raises(SystemExit):
        main()
    shown = capsys.readouterr().out
    for line in block("text", "Equations of motion").splitlines():
        assert line in shown
