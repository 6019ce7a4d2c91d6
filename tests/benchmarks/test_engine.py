"""The benchmark of the engine: its parts are right, and it runs."""

from __future__ import annotations

import importlib
import math
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from flowlanes import lambdify
from needs import needs

pytestmark = needs("heyoka")

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"
NAMES = ["chaplygin-ball", "unbalanced-ball", "ellipsoid"]


@pytest.fixture
def contest(monkeypatch: pytest.MonkeyPatch) -> SimpleNamespace:
    """Modules of the benchmark by their names."""
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    names = ("bodies", "generated", "peak", "programs", "report", "taylor", "tasks")
    modules = {name: importlib.import_module(f"contest.{name}") for name in names}
    return SimpleNamespace(**modules, engine=importlib.import_module("engine"))


@pytest.mark.parametrize("name", NAMES)
def test_all_programs_are_given_the_same_equations(contest: SimpleNamespace, name: str):
    import heyoka as hy

    body = contest.bodies.BODIES[name]
    (start,) = body.starts(seed=7, count=1)
    wanted = lambdify(body.system, "numpy")(0.0, start)
    written = contest.generated.defined(contest.generated.field_text(body), {"sqrt": math.sqrt})[
        "field"
    ]
    given = hy.cfunc([rate for _, rate in body.taylor], [x for x, _ in body.taylor])
    assert np.allclose(written(*start), wanted, rtol=1e-13, atol=1e-13)
    assert np.allclose(given(start), wanted, rtol=1e-13, atol=1e-13)


def test_starts_depend_on_seed_and_body(contest: SimpleNamespace):
    bodies = contest.bodies.BODIES
    ball = bodies["chaplygin-ball"]
    assert np.array_equal(ball.starts(1, 3), ball.starts(1, 5)[:3])
    assert not np.allclose(ball.starts(1, 3), ball.starts(2, 3))
    assert not np.allclose(ball.starts(1, 3)[:, 3:], bodies["ellipsoid"].starts(1, 3)[:, 3:])


def test_deviation_of_points_looks_at_what_both_sides_have(contest: SimpleNamespace):
    exact = np.array([[[1.0, 2.0], [3.0, 4.0]], [[1.0, 1.0], [np.nan, np.nan]]])
    found = np.array([[[1.0, 2.0]], [[1.0, 1.5]]])
    assert np.allclose(contest.bodies.deviation(found, exact), [0.0, 0.5])


def test_calibration_takes_the_coarsest_setting_that_meets_the_target(contest: SimpleNamespace):
    program = contest.programs.Program(
        "linear", lambda setting: lambda starts: starts + setting, (1e-1, 1e-2, 1e-3, 1e-4)
    )
    ones = np.ones((3, 2))
    assert program.calibrate(ones, ones, 2e-3) == 1e-3
    assert program.calibrate(ones, ones, 1e-5) is None
    assert program.finest(ones, ones, 1e-5) == 1e-4


def test_a_step_of_order_eight_is_right(contest: SimpleNamespace):
    body = contest.bodies.BODIES["chaplygin-ball"]
    names: dict[str, Any] = {"sqrt": math.sqrt}
    names["field"] = contest.generated.defined(contest.generated.field_text(body), names)["field"]
    step = contest.generated.defined(contest.generated.step_text(body.size), names)["step"]
    (start,) = body.starts(7, 1)
    exact = body.ends(start[None], 0.0625)[0]
    assert np.allclose(step(0.0625, *start)[: body.size], exact, rtol=0, atol=1e-11)


def test_operations_are_counted(contest: SimpleNamespace):
    body = contest.bodies.BODIES["chaplygin-ball"]
    counts = contest.generated.operations(body)
    assert counts["recip"] == 1
    assert contest.peak.per_step(body) > 12 * sum(counts.values())


@pytest.mark.slow
def test_every_task_runs_and_gives_a_ratio(contest: SimpleNamespace):
    tasks = contest.tasks
    effort = tasks.Effort(states=2, few=1, many=8, turns=1, thorough=False)
    body = replace(contest.bodies.BODIES["chaplygin-ball"], span=4.0, long=4.0, short=1.0)
    outcomes = [task.run(body, task.targets[0], effort) for task in tasks.TASKS]
    found = contest.engine.ratios(outcomes)
    assert list(found) == ["ensemble", "numba", "single", "section", "tangent", "digits30"]
    assert all(row[body.name] > 0 for row in found.values())
    for outcome in outcomes:
        assert outcome.own.error <= 100 * outcome.target
        assert contest.report.table(outcome).row_count == len(outcome.results)
