"""The page on combinations is made of the outcomes that the commands gave."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "examples"))
import combinations_table as table

OUTCOMES = table.read()
COMMANDS = [c for row in table.ROWS.values() for c in row.commands.values() if c]


def test_the_page_is_that_of_the_outcomes() -> None:
    assert table.PAGE.read_text(encoding="utf-8") == table.page(OUTCOMES)


def test_every_outcome_is_of_a_command_of_the_table() -> None:
    assert set(OUTCOMES) == set(COMMANDS)


def test_the_files_of_the_commands_are_there() -> None:
    words = {word for command in COMMANDS for word in shlex.split(command)}
    files = [word for word in words if word.endswith((".toml", ".py"))]
    assert files
    assert all((ROOT / word).exists() for word in files)


@pytest.mark.parametrize("key", ["veselova-11", "two-balls-00"])
def test_outcomes_are_repeated(key: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    command = table.ROWS[key].measure
    again = table.outcome(command)
    assert again["verdict"] == OUTCOMES[command]["verdict"] == "proven"


@pytest.mark.slow
@pytest.mark.parametrize("key", table.ROWS)
def test_a_search_is_repeated(key: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    command = table.ROWS[key].integrals
    again = table.outcome(command)
    for name in ("verdict", "count", "size", "divisors"):
        assert again[name] == OUTCOMES[command][name]
