"""What the README shows runs, and prints what stands below it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

README = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")


def test_the_python_lines_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```(?:\n\n```text\n(.*?)```)?", README, re.DOTALL)
    assert blocks
    names: dict[str, object] = {}
    for lines, shown in blocks:
        exec(compile(lines, "README.md", "exec"), names)
        printed = capsys.readouterr().out
        assert printed == shown
