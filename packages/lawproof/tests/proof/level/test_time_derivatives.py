"""Rates in laws: of first and second order, in maps, quantities and integrals."""

from __future__ import annotations

import pytest

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Integral, Rate, Reduction
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.prover import prove

x, y, q, v = (real_symbol(name) for name in "xyqv")
energy = real_symbol("energy")

OSCILLATOR = System("oscillator", "oscillator", field={x: energy, y: -x}, definitions={energy: y})
TARGET = System("target", "target", field={q: v, v: -q})

LAWS = {
    "map": (Isomorphism("law", TARGET, {q: x, v: Rate(x)}), "proven"),
    "wrong map": (Isomorphism("law", TARGET, {q: x, v: -Rate(x)}), "refuted"),
    "integral": (Integral("law", Rate(x) ** 2 + x**2), "proven"),
    "wrong integral": (Integral("law", Rate(x) ** 2 - x**2), "refuted"),
    "second": (Identity("law", Rate(Rate(x)) + x), "proven"),
    "wrong second": (Identity("law", Rate(Rate(x)) - x), "refuted"),
    "third": (Identity("law", Rate(Rate(Rate(x))) + Rate(x)), "proven"),
    "quantity": (Reduction("law", {q: Rate(x)}, (Rate(q) + x, Rate(Rate(q)) + q)), "proven"),
    "wrong quantity": (Reduction("law", {q: Rate(x)}, (Rate(q) - x,)), "refuted"),
}


@pytest.mark.parametrize("name", LAWS)
def test_rates_are_taken_wherever_they_stand(name):
    law, decision = LAWS[name]
    assert prove(OSCILLATOR, law).decision == decision
