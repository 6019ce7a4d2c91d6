"""The Veselova system, and the rubber ball on a plane that moves as it does, separated."""

from __future__ import annotations

import pytest

from closed_form.along import follows, slips
from lawproof.proof.prover import prove
from nonholonomic.closed_form.separations.rubber_ball_plane import rubber_ball_plane
from nonholonomic.closed_form.separations.veselova import veselova

SEPARABLES = {made.name: made for made in (veselova(), rubber_ball_plane())}
LAWS = {f"{of}-{law.name}": (made, law) for of, made in SEPARABLES.items() for law in made.laws}
SLIPS = {
    f"{of}-{slip}": (made, law) for of, made in SEPARABLES.items() for slip, law in slips(made)
}

#: Principal moments in another order than the usual.
PARAMETERS = {"I_1": "2.1", "I_2": "1", "I_3": "1.5"}


@pytest.mark.parametrize("name", LAWS)
def test_proven(name):
    separable, law = LAWS[name]
    assert prove(separable.system, law).decision == "proven"


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_is_refuted(slip):
    separable, law = SLIPS[slip]
    assert prove(separable.system, law).decision == "refuted"


@pytest.mark.parametrize(
    ("name", "further"), [("veselova", {}), ("rubber-chaplygin-ball", {"m": "1.3", "R": "0.7"})]
)
def test_along_a_motion(name, further):
    # (ω, γ) = 0
    start = ("0.9", "-0.3", "-1.04", "0.48", "-0.64", "0.6")
    follows(SEPARABLES[name], start, {**PARAMETERS, **further}, 1e-27)
