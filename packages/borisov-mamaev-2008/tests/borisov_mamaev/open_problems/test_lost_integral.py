"""Rotors and Bruns' field together lose the quadratic integral, at the rate that is stated."""

from __future__ import annotations

import pytest

import flowlanes
import lawproof
from borisov_mamaev_2008.open_problems import lost_integral


@pytest.mark.slow
@pytest.mark.parametrize("name", ["Chaplygin ball", "Veselova system", "ball around a sphere"])
def test_the_integral_is_refuted_and_its_rate_proven(name: str) -> None:
    system, lost, rate = lost_integral.cases()[name]
    assert lawproof.prove(system, flowlanes.Integral("lost", lost)).decision == "refuted"
    assert (
        lawproof.prove(system, flowlanes.Identity("rate", flowlanes.Rate(lost) - rate)).decision
        == "proven"
    )
    assert (
        lawproof.prove(system, flowlanes.Identity("rate", flowlanes.Rate(lost) + rate)).decision
        == "refuted"
    )
