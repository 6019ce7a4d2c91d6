"""What the page on orbits says, runs."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "packages/flowlanes/docs/orbits.md").read_text()


@pytest.mark.slow
def test_the_steps_run(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, Any] = {}
    for step in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL):
        exec(compile(step, "orbits.md", "exec"), names)
    sentence = capsys.readouterr().out
    assert "attracting" in sentence
    assert "trivial multipliers (equal to 1): flow, energy, quadratic" in sentence
    assert "fold at F/2H = 0.870556044" in sentence
    assert "fold at F/2H = 1.013611791" in sentence
    assert "the branch is closed" in sentence
    assert "F/2H = 0.95: 2.0000000000" in sentence
    assert "locked" in sentence
    assert "quasi-periodic" in sentence
    (low, high) = re.search(r"from (\S+) to (\S+) ±", sentence).groups()
    assert abs(float(low) - 0.8705560439602) < 1e-11
    assert abs(float(high) - 1.0136117911880) < 1e-11
    assert names["exact"].error < 1e-28
