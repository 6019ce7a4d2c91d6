"""The Whipple bicycle benchmark: published eigenvalues, equations by hand, a nonlinear run."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import matplotlib
import numpy as np
import pytest
import sympy as sp

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def bicycle() -> Iterator[ModuleType]:
    matplotlib.use("agg")
    sys.path.insert(0, str(EXAMPLES))
    try:
        import whipple_bicycle

        yield whipple_bicycle
    finally:
        sys.path.remove(str(EXAMPLES))


@pytest.mark.slow
def test_eigenvalues_of_the_benchmark_at_five_metres_a_second(bicycle: ModuleType):
    published = [
        -0.322866429004090,
        -0.775341882195850 + 4.46486771378823j,
        -0.775341882195850 - 4.46486771378823j,
        -14.0783896927982,
    ]
    found = [complex(value) for value in bicycle.linearisation_near(5).eigenvalues]
    assert found == pytest.approx(published, abs=2e-14, rel=1e-13)


@pytest.mark.slow
@pytest.mark.parametrize("speed", range(11))
def test_eigenvalues_agree_with_the_equations_by_hand(bicycle: ModuleType, speed: int):
    assert bicycle.difference(speed) < 1e-18


@pytest.mark.slow
def test_critical_speeds_of_the_benchmark(bicycle: ModuleType):
    weave, capsize = bicycle.critical_speeds()
    assert weave == pytest.approx(4.29238253634111, abs=1e-13)
    assert capsize == pytest.approx(6.02426201538837, abs=1e-12)


@pytest.mark.slow
def test_json(bicycle: ModuleType, capsys: pytest.CaptureFixture[str], monkeypatch):
    monkeypatch.setattr(sys, "argv", ["whipple_bicycle.py", "--json"])
    bicycle.main()
    table = json.loads(capsys.readouterr().out)
    assert list(table) == [str(speed) for speed in range(11)]
    assert all(len(values) == 4 for values in table.values())
    # without a speed the machine is a double pendulum upside down
    assert sorted(re for re, _ in table["0"]) == pytest.approx(
        [-5.53094371765393, -3.13164324790656, 3.13164324790656, 5.53094371765393], rel=1e-14
    )


@pytest.mark.slow
def test_a_stable_bicycle_rights_itself_and_keeps_its_energy(bicycle: ModuleType):
    run = bicycle.pushed_motion(seconds=4.0)
    energy = run.records["law_energy"]
    assert max(abs(energy / energy[0] - 1)) < 1e-13
    assert max(abs(np.degrees(run.records["lean"]))) > 6
    assert abs(np.degrees(run.records["lean"][-1])) < 1.5


@pytest.mark.slow
def test_a_push_to_the_right_turns_it_to_the_right(bicycle: ModuleType):
    run = bicycle.pushed_motion(seconds=1.0)
    assert run.records["lean"][20] > 0
    names = [str(symbol) for symbol in run.system.symbols]
    path = dict(zip(names, run.states.T, strict=True))
    assert path["delta"][40] > 0
    assert path["y"][-1] < -0.1
    # it has gone as far as its speed says
    assert path["x"][-1] == pytest.approx(4.6, rel=0.03)


def test_equations_stay_small(bicycle: ModuleType):
    system = bicycle.model()
    steps = system.required_definitions(system.rates)
    count = sum(sp.count_ops(e) for e in (*system.rates, *(value for _, value in steps)))
    assert count < 3000
