"""Verdicts that rest on others."""

from __future__ import annotations

import pytest

from borisov_mamaev_2008.methods.derived_verdicts import computed_verdict, conclusion_verdict
from flowlanes.system.laws import Integral
from flowlanes.system.vectors import norm_squared, vectors
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import from_catalogue

(M,) = vectors("M")
PROVEN = Verdict("first", "proven", finding="x", terms=7, seconds=2.0)


def test_a_conclusion_is_proven_when_all_it_rests_on_is():
    ball = from_catalogue("chaplygin-ball")
    found = conclusion_verdict(
        "both", "what follows", (PROVEN, (ball, Integral("square", norm_squared(M))))
    )
    assert found.decision == "proven"
    assert found.finding == "what follows"
    assert not found.reason
    assert found.seconds >= 2.0 and found.terms >= 7


@pytest.mark.parametrize(
    ("premiss", "words"),
    [
        (Verdict("second", "undecided", reason="too large"), "second: too large"),
        (Verdict("second", "proven where", conditions=("x > 0",)), "second: proven where, x > 0"),
        (Verdict("second", "refuted", finding="a point"), "second: refuted"),
    ],
)
def test_a_premiss_that_is_not_proven_leaves_it_undecided(premiss, words):
    found = conclusion_verdict("both", "what follows", (PROVEN, premiss))
    assert found.decision == "undecided"
    assert found.reason == words
    assert not found.finding


def test_a_computation_that_fails_leaves_a_claim_undecided():
    good = computed_verdict("area", True, "it is one", "it is not", witness={"n": 1})
    assert (good.decision, good.finding, good.reason) == ("proven", "it is one", "")
    assert good.witness == {"n": 1}
    bad = computed_verdict("area", 0, "it is one", "it is not", decision="refuted")
    assert (bad.decision, bad.reason) == ("undecided", "it is not")
    assert computed_verdict("area", 1, decision="refuted").decision == "refuted"
