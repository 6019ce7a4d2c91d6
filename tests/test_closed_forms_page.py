"""The page on closed forms: its steps run, and end where an integration ends."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

PAGE = (Path(__file__).parents[1] / "packages/nonholonomic/docs/closed-forms.md").read_text()


@pytest.mark.slow
def test_the_steps_run(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, Any] = {}
    for step in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL):
        exec(compile(step, "closed-forms.md", "exec"), names)
    sentence = capsys.readouterr().out
    assert "two-frequency motion on a torus" in sentence
    assert "refuted" not in sentence
    assert "undecided" not in sentence
    assert (
        np.abs(names["solution"].states([10.0]) - np.float64(names["path"].states[-1])).max()
        < 1e-13
    )
    # γ at τ = 0.7, from the theta functions alone, is of length one
    assert 1 in sum(x * x for x in names["torus"].ball(names["v"])[0])
