"""What the page on Lyapunov exponents says, runs."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "packages/flowlanes/docs/lyapunov.md").read_text()


@pytest.mark.slow
def test_the_steps_run(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, Any] = {}
    for step in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL):
        exec(compile(step, "lyapunov.md", "exec"), names)
    sentence = capsys.readouterr().out
    assert "['γ² = 1', 'energy', 'area', 'momentum', 'flow']" in sentence
    assert "chaotic (observed)" in sentence
    assert "M changes sign\n" in sentence
    assert "M₁, γ₁ change sign where c₁ = 0" in sentence
    first = names["butterfly"].exponents[0]
    assert abs(first.value - 0.9056) < first.error
    # the numbers on the page are those of its own steps, but for chaos
    written = [float(x) for x in re.findall(r"λ₁ = ([\d.]+) ± ([\d.]+)", PAGE)[0]]
    assert written == pytest.approx([first.value, first.error], abs=first.error)
