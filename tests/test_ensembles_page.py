"""The page on ensembles: its steps run, and what it says of them is so."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

PAGE = (Path(__file__).parents[1] / "packages/flowlanes/docs/ensembles.md").read_text()


@pytest.mark.slow
def test_the_steps_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(Path(__file__).parents[1] / "examples")
    names: dict[str, Any] = {"__name__": "ensembles_page"}
    for step in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL):
        exec(compile(step, "ensembles.md", "exec"), names)
    sentence = capsys.readouterr().out
    quoted = re.findall(r"^> (.*)$", PAGE, re.MULTILINE)
    assert quoted
    assert all(line in sentence for line in quoted)
    assert {path.name for path in tmp_path.iterdir()} == {"balls.zarr", "examples", "powers.zarr"}
