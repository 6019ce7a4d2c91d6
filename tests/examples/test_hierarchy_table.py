"""The documented table of the catalogue is what the program prints."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "packages/nonholonomic/docs/hierarchy.md").read_text()


@pytest.fixture(scope="module")
def table() -> Iterator[ModuleType]:
    sys.path.insert(0, str(ROOT / "examples"))
    try:
        import hierarchy_table

        yield hierarchy_table
    finally:
        sys.path.remove(str(ROOT / "examples"))


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["rattleback", "suslov", "heavy-disk", "chaplygin-ball", "veselova", "unbalanced-ball"]
)
def test_lines_of_fast_systems(table: ModuleType, name: str) -> None:
    for line in table.rows(name):
        assert line in PAGE


def test_every_system_has_a_line() -> None:
    from nonholonomic.catalogue import CATALOGUE

    listed = re.findall(r"^\| `([a-z0-9-]+)` \|", PAGE, re.MULTILINE)
    assert listed == list(CATALOGUE)


def test_printed_as_a_table(
    table: ModuleType, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "argv", ["hierarchy_table.py", "suslov"])
    table.main()
    head, rule, line = capsys.readouterr().out.splitlines()
    assert head.count("|") == rule.count("|") == line.count("|")
    assert head in PAGE


@pytest.mark.slow
def test_the_lines_of_python_run(capsys: pytest.CaptureFixture[str]) -> None:
    code = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)[0]
    exec(compile(code, "hierarchy.md", "exec"), {})
    assert capsys.readouterr().out.startswith("4 2 ['none known']\n")
