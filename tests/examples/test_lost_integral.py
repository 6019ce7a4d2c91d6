"""Rotors and Bruns' field together lose the quadratic integral, at the rate that is stated."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

import chaplygin as ch

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def lost_integral() -> Iterator[ModuleType]:
    sys.path.insert(0, str(ROOT / "examples"))
    try:
        import lost_integral

        yield lost_integral
    finally:
        sys.path.remove(str(ROOT / "examples"))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["Chaplygin ball", "Veselova system", "ball around a sphere"])
def test_the_integral_is_refuted_and_its_rate_proven(lost_integral: ModuleType, name: str) -> None:
    system, lost, rate = lost_integral.cases()[name]
    assert ch.prove(system, ch.Integral("lost", lost)).decision == "refuted"
    assert ch.prove(system, ch.Identity("rate", ch.Rate(lost) - rate)).decision == "proven"
    assert ch.prove(system, ch.Identity("rate", ch.Rate(lost) + rate)).decision == "refuted"
