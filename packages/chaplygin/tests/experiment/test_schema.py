"""The schema of experiment files admits what `load` admits, and marks simple mistakes."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import Any

import pytest

from chaplygin.cli import app
from chaplygin.experiment.models.schema import experiment_schema
from needs import optional

Draft202012Validator = optional("jsonschema").Draft202012Validator
EXAMPLES = sorted((Path(__file__).parents[4] / "examples").rglob("*.toml"))


@pytest.fixture(scope="module")
def validator() -> Any:
    return Draft202012Validator(experiment_schema())


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example_fits(validator: Any, path: Path) -> None:
    table = tomllib.loads(path.read_text(encoding="utf-8"))
    assert [error.message for error in validator.iter_errors(table)] == []


@pytest.mark.parametrize(
    "mistake",
    [
        "[run]\nuntil = 10",
        '[system]\nname = "veselova"\n[run]\nuntil = -1',
        '[system]\nname = "veselova"\n[runs]\nuntil = 1',
        '[system]\nname = "veselova"\n[run]\nprecision = "single"',
    ],
)
def test_mistakes_are_marked(validator: Any, mistake: str) -> None:
    assert not validator.is_valid(tomllib.loads(mistake))


def test_every_table_has_words() -> None:
    for name, table in experiment_schema()["$defs"].items():
        assert table.get("description") or "enum" in table, name
        assert "Raises" not in table.get("description", ""), name


def test_the_command_prints_it_without_a_name(capsys: pytest.CaptureFixture[str]) -> None:
    app(["show", "--schema"], standalone_mode=False)
    assert json.loads(capsys.readouterr().out) == experiment_schema()
