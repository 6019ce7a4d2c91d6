"""What the page on isomorphisms says, runs."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from flowlanes.flow.integrator import integrate

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "packages/nonholonomic/docs/isomorphisms.md").read_text()


@pytest.mark.slow
def test_the_steps_run(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, Any] = {}
    for step in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL):
        exec(compile(step, "isomorphisms.md", "exec"), names)
    sentence = capsys.readouterr().out
    assert "gamma_1 = Gamma_1" in sentence
    assert "proven" in sentence
    motion = integrate(names["system"], names["start"], [0.0, 10.0])
    assert np.abs(names["solution"].states([10.0])[0] - motion.states[-1]).max() < 1e-12
