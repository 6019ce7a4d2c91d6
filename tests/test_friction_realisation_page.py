"""The page on rolling as a limit: its steps print what it says, and its tables are computed."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nonholonomic.contact.rolling_limit.skate import Skate

PAGE = (
    Path(__file__).parents[1] / "packages/nonholonomic/docs/friction-realisation.md"
).read_text()


@pytest.mark.slow
def test_the_steps_run_and_print_what_the_page_says(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, Any] = {}
    for step in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL):
        exec(compile(step, "friction-realisation.md", "exec"), names)
    printed = re.findall(r"^    (\S.*)$", re.sub(r"```.*?```", "", PAGE, flags=re.DOTALL), re.M)
    assert capsys.readouterr().out.splitlines() == printed


@pytest.mark.slow
@pytest.mark.parametrize(
    ("row", "shares"),
    [
        ("nonholonomic: c → ∞", (1.0, 0.0)),
        ("c = 64 N → ∞", (64.0, 1.0)),
        ("c = 8 N → ∞", (8.0, 1.0)),
        ("c = N → ∞", (1.0, 1.0)),
        ("vakonomic: N → ∞", (0.0, 1.0)),
    ],
)
def test_the_limits_of_the_skate_are_those_of_the_table(
    row: str, shares: tuple[float, float]
) -> None:
    line = next(line for line in PAGE.splitlines() if line.startswith(f"| {row} |"))
    numbers = [float(x.replace("−", "-")) for x in line.split("|")[2:5]]
    found = Skate((1.0, 2.0), *shares).limit(np.array([2.0]))[0, :3]
    np.testing.assert_allclose(found, numbers, rtol=0, atol=5e-8)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("column", "shares"), [(2, (1.0, 0.0)), (4, (0.0, 1.0)), (6, (1.0, 1.0)), (8, (8.0, 1.0))]
)
def test_the_differences_are_those_of_the_table(column: int, shares: tuple[float, float]) -> None:
    table = PAGE[PAGE.index("| s | c = s |") :].splitlines()[2:8]
    family, there = Skate((50.0, 1600.0), *shares), np.array([2.0])
    for line in (table[0], table[-1]):
        cells = line.split("|")
        motion = family.motion(float(cells[1]), there)
        assert f"{np.abs(motion - family.limit(there)).max():.3e}" == cells[column].strip()
