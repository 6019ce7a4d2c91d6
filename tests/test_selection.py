"""Which tests run: none that are slow unless they are asked for, and samples that add up to all."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
TESTS = """
import pytest

def test_quick(): pass

@pytest.mark.slow
@pytest.mark.parametrize("n", range(12))
def test_slow(n): pass

@pytest.mark.parametrize("n", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_partly(n): pass

@pytest.mark.campaign
def test_campaign(): pass

@pytest.mark.browser
def test_page(): pass

@pytest.mark.browser
@pytest.mark.slow
def test_slow_page(): pass
"""
SETTINGS = "[pytest]\nmarkers =\n  slow\n  campaign\n  browser\n  server\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with tests of all kinds, and the settings of these tests."""
    shutil.copy(ROOT / "conftest.py", tmp_path)
    shutil.copy(ROOT / "tests" / "needs.py", tmp_path)
    (tmp_path / "pytest.ini").write_text(SETTINGS)
    (tmp_path / "test_kinds.py").write_text(TESTS)
    return tmp_path


def collected(folder: Path, *options: str) -> set[str]:
    """The tests that options choose, without the name of their file."""
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "--collect-only", "-q"]
    done = subprocess.run(
        [*command, *options], cwd=folder, capture_output=True, text=True, check=False
    )
    assert done.returncode in (0, 5), done.stdout + done.stderr
    return {line.partition("::")[2] for line in done.stdout.splitlines() if "::" in line}


QUICK = {"test_quick", "test_partly[0]"}
SLOW = {*(f"test_slow[{n}]" for n in range(12)), "test_partly[1]"}


@pytest.mark.slow
def test_nothing_slow_runs_by_itself(folder: Path) -> None:
    assert collected(folder) == QUICK


@pytest.mark.slow
def test_what_is_asked_for_runs(folder: Path) -> None:
    assert collected(folder, "--slow") == {*QUICK, *SLOW, "test_campaign"}
    assert collected(folder, "-m", "slow") == SLOW
    assert collected(folder, "-m", "browser") == {"test_page"}
    assert collected(folder, "-m", "browser or slow") == {*SLOW, "test_page", "test_slow_page"}
    assert collected(folder, "test_kinds.py::test_slow_page") == {"test_slow_page"}


@pytest.mark.slow
def test_samples_are_parts_of_the_slow_tests(folder: Path) -> None:
    parts = [collected(folder, "--slow-sample", f"{k}/3") - QUICK for k in range(3)]
    assert sum(map(len, parts)) == len(set().union(*parts)) == len(SLOW)
    assert collected(folder, "--slow-sample", "3") - QUICK in parts


def test_a_sample_is_written_as_n_or_as_k_of_n(request: pytest.FixtureRequest) -> None:
    plugins = request.config.pluginmanager.get_plugins()
    (part,) = {plugin._part for plugin in plugins if hasattr(plugin, "_part")}
    assert part("7/40") == (7, 40)
    assert part("40")[1] == 40
    with pytest.raises(pytest.UsageError, match=r"takes N or K/N, as 40 or 7/40, not 0$"):
        part("0")
    with pytest.raises(pytest.UsageError, match="4/4: the parts are numbered 0 to 3"):
        part("4/4")
