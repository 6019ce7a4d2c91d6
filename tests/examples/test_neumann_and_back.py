"""The example of motions carried over isomorphisms."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from flowlanes.flow.integrator import integrate

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def example() -> Iterator[ModuleType]:
    sys.path.insert(0, str(EXAMPLES))
    try:
        import neumann_and_back

        yield neumann_and_back
    finally:
        sys.path.remove(str(EXAMPLES))


@pytest.mark.slow
def test_back(example: ModuleType):
    for case in example.CASES:
        times = np.linspace(0.0, 20.0, 5)
        start = [float(x) for x in case.start]
        motion = integrate(case.system, start, times)
        assert example.apart(example.back(case).states(times), motion.states) < 1e-12


@pytest.mark.slow
def test_forth(example: ModuleType):
    case = example.CASES[0]
    pushed, target = example.forth(case, case.own())
    assert example.apart(pushed.states(example.LONG), target.states(example.LONG)) < 1e-12


@pytest.mark.slow
def test_report(example: ModuleType, capsys: pytest.CaptureFixture[str]):
    example.report(example.CASES[0])
    sentence = capsys.readouterr().out
    assert sentence.count("forth, against") == len(example.LONG)
    assert "rotation number -0.8359290392843" in sentence
