"""Every law of the catalogue is proven, and every misprint in one is refuted."""

from __future__ import annotations

import pytest

from catalogue.claimed import CLAIMED
from lawproof.proof.prover import prove

PRINTED = tuple(c for c in CLAIMED if c.law.as_printed is not None)


@pytest.mark.slow(every=4)
@pytest.mark.parametrize("claimed", CLAIMED, ids=str)
def test_a_law_is_proven(claimed):
    verdict = prove(claimed.system, claimed.law)
    assert verdict.decision == "proven", verdict.reason or verdict.witness
    assert verdict.law == claimed.law.name
    assert verdict.finding and not verdict.reason and verdict.witness is None


@pytest.mark.slow
@pytest.mark.parametrize("claimed", PRINTED, ids=str)
def test_a_misprint_is_refuted(claimed):
    printed = claimed.law.as_printed
    verdict = prove(claimed.system, printed)
    assert verdict.decision == "refuted", verdict
    assert verdict.witness["point"]
    assert claimed.law.misprint
    assert type(printed) is type(claimed.law)
    assert printed.name == claimed.law.name


@pytest.mark.parametrize("claimed", CLAIMED, ids=str)
def test_a_law_says_where_it_stands_and_what_it_means(claimed):
    assert claimed.law.source
    assert claimed.law.meaning
    assert (claimed.law.as_printed is None) == (not claimed.law.misprint)


def test_names_of_laws_are_unique():
    labels = [claimed.label for claimed in CLAIMED]
    assert len(set(labels)) == len(labels)


def test_every_kind_of_law_occurs():
    kinds = {type(claimed.law).__name__ for claimed in CLAIMED}
    assert kinds >= {
        "ConformallyHamiltonian",
        "Identity",
        "Integral",
        "Isomorphism",
        "Measure",
        "PoissonStructure",
        "Reduction",
        "Separation",
        "Symmetry",
    }
