"""What the page on the engine says, runs."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "packages/flowlanes/docs/engine.md").read_text()


@pytest.mark.slow
def test_the_steps_run(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, Any] = {}
    for step in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL):
        exec(compile(step, "engine.md", "exec"), names)
    sentence = capsys.readouterr().out
    assert "(1000, 2, 6)" in sentence
    assert "normal force" in sentence
    assert "'energy'" in sentence
    assert (names["crossed"].counts > 0).all()
