"""The page on random starts: its steps run and print what it says."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

PAGE = (Path(__file__).parents[1] / "packages/flowlanes/docs/sampling.md").read_text()


@pytest.mark.slow
def test_the_steps_run_and_print_what_the_page_says(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, Any] = {}
    for step in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL):
        exec(compile(step, "sampling.md", "exec"), names)
    printed = re.findall(r"^    (\S.*)$", re.sub(r"```.*?```", "", PAGE, flags=re.DOTALL), re.M)
    assert capsys.readouterr().out.splitlines() == printed
