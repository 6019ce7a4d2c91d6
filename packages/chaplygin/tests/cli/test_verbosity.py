"""``--quiet`` and ``--verbose``: what is said besides results."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest


def said(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "chaplygin", *arguments],
        cwd=folder,
        env={**os.environ, "FLOWLANES_CACHE": str(folder / "cache")},
        check=False,
        capture_output=True,
        text=True,
        timeout=300,
    )


@pytest.mark.slow
def test_three_levels(tmp_path: Path) -> None:
    # this ball carries its centre of mass outside, of which a note tells
    file = tmp_path / "ball.toml"
    file.write_text(
        "[body]\nmass = 1.0\ninertia = [1.0, 1.1, 1.2]\n"
        "[body.shape]\nkind = 'ball'\nradius = 1.0\ncentre = [0.0, 0.0, 1.5]\n"
        "[surface]\nkind = 'plane'\n[contact]\nmodel = 'marble'\n"
        "[start]\nomega = [0.0, 0.0, 1.0]\ngamma = [0.0, 0.0, 1.0]\n[run]\nuntil = 0.1\n"
    )
    plain = said(tmp_path, "run", file.name, "-o", "plain.nc")
    assert plain.returncode == 0, plain.stderr
    assert "note: " in plain.stderr
    quiet = said(tmp_path, "--quiet", "run", file.name, "-o", "quiet.nc")
    assert (quiet.returncode, quiet.stderr) == (0, "")
    assert quiet.stdout
    verbose = said(tmp_path, "--verbose", "run", file.name, "-o", "verbose.nc")
    assert "note: " in verbose.stderr
    assert f"machine code read from {tmp_path / 'cache'}" in verbose.stderr


def test_errors_are_never_quiet(tmp_path: Path) -> None:
    answer = said(tmp_path, "--quiet", "show", "rattlebuck")
    assert answer.returncode == 2
    assert answer.stderr.startswith("error: ")


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (("--quiet", "--verbose", "list"), "error: --quiet --verbose: only one of them can hold\n"),
        (("--quiet",), "error: a command is missing; chaplygin --help lists them\n"),
    ],
)
def test_mistaken_options(tmp_path: Path, options: tuple[str, ...], sentence: str) -> None:
    answer = said(tmp_path, *options)
    assert (answer.returncode, answer.stdout, answer.stderr) == (2, "", sentence)


def test_completion_for_a_shell(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", "from chaplygin.cli import app; app(prog_name='chaplygin')"],
        env={**os.environ, "_CHAPLYGIN_COMPLETE": "complete_bash", "COMP_WORDS": "chaplygin sho",
             "COMP_CWORD": "1"},
        check=False,
        capture_output=True,
        text=True,
        timeout=300,
    )  # fmt: skip
    assert done.stdout.split() == ["show"]
