"""The page on charts: its steps run, its pictures are there."""

from __future__ import annotations

import re
import shlex
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from chaplygin.cli import main

DOCS = Path(__file__).parents[1] / "packages/flowlanes/docs"
PAGE = (DOCS / "charts.md").read_text()


@pytest.mark.slow
def test_the_steps_run(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    for step in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL):
        exec(compile(step, "charts.md", "exec"), names)
    megno = names["dataset"]["megno"]
    assert megno.shape == (6, 9)
    # regular at k = −1, 0 and 1, and not at all of the others
    assert np.nanmax(megno.sel(k=[-1, 0, 1]).values) < 4.0 < np.nanmax(megno.values)
    assert (tmp_path / "ball.png").stat().st_size > 10_000


@pytest.mark.slow
def test_the_command_runs(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    (command,) = re.findall(r"    chaplygin (chart ball-on-sphere .*?)\n\n", PAGE, re.DOTALL)
    words = shlex.split(command.replace("\\\n", " ").replace(":300", ":3").replace("1000", "10"))
    monkeypatch.setattr(sys, "argv", ["chaplygin", *words])
    with pytest.raises(SystemExit) as end:
        main()
    assert not end.value.code
    assert (tmp_path / "ball.png").exists()
