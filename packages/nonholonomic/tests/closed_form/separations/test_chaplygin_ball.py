"""The Chaplygin ball at zero area constant, separated, and Fedorov's variables."""

from __future__ import annotations

import pytest

from closed_form.along import follows, slips
from lawproof.proof.prover import prove
from nonholonomic.closed_form.separations.chaplygin_ball import chaplygin_ball
from nonholonomic.closed_form.separations.fedorov import fedorov

SEPARABLES = {made.name: made for made in (chaplygin_ball(), fedorov())}
LAWS = {f"{of}-{law.name}": (made, law) for of, made in SEPARABLES.items() for law in made.laws}
SLIPS = {
    f"{of}-{slip}": (made, law) for of, made in SEPARABLES.items() for slip, law in slips(made)
}


@pytest.mark.parametrize("name", LAWS)
def test_proven(name):
    separable, law = LAWS[name]
    assert prove(separable.system, law).decision == "proven"


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_is_refuted(slip):
    separable, law = SLIPS[slip]
    assert prove(separable.system, law).decision == "refuted"


def test_the_separation_is_that_of_fedorov():
    (law,) = (law for law in SEPARABLES["chaplygin-ball"].laws if law.name == "fedorov")
    (separation,) = (
        law for law in SEPARABLES["chaplygin-ball-fedorov"].laws if law.name == "separation"
    )
    assert separation in law.target.laws


def test_ball_along_a_motion():
    # (M, γ) = 0
    start = ("0.8", "-0.6", "-1.28", "0.48", "-0.64", "0.6")
    parameters = {"m": "1.3", "I_1": "2.1", "I_2": "1", "I_3": "1.5", "R": "0.7"}
    follows(SEPARABLES["chaplygin-ball"], start, parameters, 1e-27)


def test_fedorov_along_a_motion():
    start = ("0.8", "-0.6", "-1.28", "0.48", "-0.64", "0.6")
    parameters = {"I_1": "2.1", "I_2": "1", "I_3": "1.5", "beta": "0.2"}
    follows(SEPARABLES["chaplygin-ball-fedorov"], start, parameters, 1e-27)
