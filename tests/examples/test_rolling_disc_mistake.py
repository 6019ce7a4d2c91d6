"""The rolling disc: right equations proven, the tutorial's refuted, and where they differ."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import matplotlib
import numpy as np
import pytest

from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.prover import prove
from nonholonomic.mechanics.lagrangian.poincare_suslov import equations_of_motion

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def disc() -> Iterator[ModuleType]:
    matplotlib.use("agg")
    sys.path.insert(0, str(EXAMPLES))
    try:
        import rolling_disc_mistake

        yield rolling_disc_mistake
    finally:
        sys.path.remove(str(EXAMPLES))


@pytest.fixture(scope="module")
def itself(disc: ModuleType) -> System:
    return equations_of_motion(disc.mechanism())


@pytest.mark.slow
def test_sympy_with_multipliers_gives_the_equations_of_the_disc(disc: ModuleType, itself: System):
    assert disc.same(disc.with_multipliers(), itself, {}).decision == "proven"


@pytest.mark.slow
def test_kanes_method_gives_the_equations_of_the_disc(disc: ModuleType, itself: System):
    speeds = {f"q{i}dot": real_symbol(f"u{i}") for i in (1, 2, 3)}
    assert disc.same(disc.by_kane(), itself, speeds).decision == "proven"


@pytest.mark.parametrize("sign", [-1, 1])
def test_the_tutorials_equations_are_refuted_at_a_rational_point(
    disc: ModuleType, itself: System, sign: int
):
    verdict = disc.same(disc.in_cosines(itself), disc.in_cosines(disc.substituted(sign)), {})
    assert verdict.decision == "refuted"
    assert verdict.law == "the rate of q1dot"
    assert not any("+/-" in str(value) for value in verdict.witness["point"].values())


def test_they_agree_where_the_lean_does_not_change(disc: ModuleType, itself: System):
    assert prove(itself, disc.difference(disc.substituted(1))).decision == "proven"


def test_the_disc_falls_where_the_tutorial_lets_it_stand(disc: ModuleType, itself: System):
    mistaken = disc.substituted(1)
    assert disc.growth(itself, 2.5) > 0.5
    assert disc.growth(mistaken, 2.5) == 0
    assert disc.growth(itself, disc.critical(3)) == 0
    assert disc.growth(mistaken, 0.99 * disc.critical(9)) > 0.1
    lean = [np.degrees(max(disc.column(disc.rolled(s), "q2"))) for s in (itself, mistaken)]
    assert lean[0] > 40
    assert lean[1] < 5


@pytest.mark.slow
def test_the_report_is_written(disc: ModuleType, capsys: pytest.CaptureFixture[str], tmp_path):
    disc.report(tmp_path)
    text = capsys.readouterr().out
    assert "completely nonholonomic" in text
    assert "momentum of q1dot: refuted" in text
    assert (tmp_path / "rolling_disc_mistake.png").stat().st_size > 10_000
