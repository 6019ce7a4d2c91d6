"""Rotors and Bruns' field together lose the quadratic integral, at the rate that is stated."""

from __future__ import annotations

import pytest

import chaplygin as ch
from chaplygin.borisov_mamaev.open_problems import lost_integral


@pytest.mark.slow
@pytest.mark.parametrize("name", ["Chaplygin ball", "Veselova system", "ball around a sphere"])
def test_the_integral_is_refuted_and_its_rate_proven(name: str) -> None:
    system, lost, rate = lost_integral.cases()[name]
    assert ch.prove(system, ch.Integral("lost", lost)).decision == "refuted"
    assert ch.prove(system, ch.Identity("rate", ch.Rate(lost) - rate)).decision == "proven"
    assert ch.prove(system, ch.Identity("rate", ch.Rate(lost) + rate)).decision == "refuted"
