"""The Veselova system, separated."""

from __future__ import annotations

import pytest

from chaplygin.explicit.veselova import veselova
from chaplygin.laws.prove import prove
from explicit.along import follows, slips

SEPARABLE = veselova()
LAWS = {law.name: law for law in SEPARABLE.laws}
SLIPS = dict(slips(SEPARABLE))


@pytest.mark.parametrize("name", LAWS)
def test_proven(name):
    assert prove(SEPARABLE.system, LAWS[name]).decision == "proven"


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_is_refuted(slip):
    assert prove(SEPARABLE.system, SLIPS[slip]).decision == "refuted"


def test_along_a_motion():
    # principal moments in another order, and a start with (ω, γ) = 0
    start = ("0.9", "-0.3", "-1.04", "0.48", "-0.64", "0.6")
    follows(SEPARABLE, start, {"I_1": "2.1", "I_2": "1", "I_3": "1.5"}, 1e-27)
