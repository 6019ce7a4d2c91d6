"""The page on combinations is made of the outcomes that the commands gave."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def table() -> Iterator[ModuleType]:
    sys.path.insert(0, str(ROOT / "examples"))
    try:
        import combinations_table

        yield combinations_table
    finally:
        sys.path.remove(str(ROOT / "examples"))


@pytest.fixture(scope="module")
def outcomes(table: ModuleType) -> dict[str, Any]:
    return table.read()


def commands(table: ModuleType) -> list[str]:
    return [c for row in table.ROWS.values() for c in row.commands.values() if c]


def test_the_page_is_that_of_the_outcomes(table: ModuleType, outcomes: dict[str, Any]) -> None:
    assert table.PAGE.read_text(encoding="utf-8") == table.page(outcomes)


def test_every_outcome_is_of_a_command(table: ModuleType, outcomes: dict[str, Any]) -> None:
    assert set(outcomes) == set(commands(table))


def test_the_files_of_the_commands_are_there(table: ModuleType) -> None:
    words = {word for command in commands(table) for word in shlex.split(command)}
    files = [word for word in words if word.endswith((".toml", ".py"))]
    assert files
    assert all((ROOT / word).exists() for word in files)


@pytest.mark.slow
@pytest.mark.parametrize("key", ["veselova-11", "two-balls-00", "rubber-around-00"])
def test_outcomes_are_repeated(
    table: ModuleType, outcomes: dict[str, Any], key: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(ROOT)
    row = table.ROWS[key]
    assert table.outcome(row.measure)["verdict"] == outcomes[row.measure]["verdict"] == "proven"
    again = table.outcome(row.integrals)
    for name in ("verdict", "count", "size", "divisors"):
        assert again[name] == outcomes[row.integrals][name]


@pytest.mark.slow
def test_the_multiplier_in_the_field_is_that_of_the_free_ball(table: ModuleType) -> None:
    """The Borisov–Fedorov problem on every level of its linear integral."""
    (free, words), (field, more) = (table.multiplier_of(f"around-0{mark}") for mark in "01")
    assert free["verdict"] == field["verdict"] == "proven"
    denominators = [
        text.partition("multiplier")[2].split("gyroscopic")[0] for text in (words, more)
    ]
    assert denominators[0] == denominators[1] != ""
