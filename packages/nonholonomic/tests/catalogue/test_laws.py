"""Every law of the catalogue is proven, and every misprint in one is refuted."""

from __future__ import annotations

import pytest

from catalogue.claimed import LABELS, LINES, LIST, MISPRINTED, all_claimed, claimed
from lawproof.proof.prover import prove


def test_the_list_of_laws_is_complete():
    found = [one.line for one in all_claimed()]
    assert set(found) - set(LINES) == set(), f"add these lines to {LIST}"
    assert set(LINES) - set(found) == set(), f"remove these lines from {LIST}"
    assert len(set(LABELS)) == len(found), "names of laws are not unique"


@pytest.mark.slow
@pytest.mark.parametrize("label", LABELS)
def test_a_law_is_proven(label):
    one = claimed(label)
    verdict = prove(one.system, one.law)
    assert verdict.decision == "proven", verdict.reason or verdict.witness
    assert verdict.law == one.law.name
    assert verdict.finding and not verdict.reason and verdict.witness is None


@pytest.mark.slow
@pytest.mark.parametrize("label", MISPRINTED)
def test_a_misprint_is_refuted(label):
    one = claimed(label)
    printed = one.law.as_printed
    verdict = prove(one.system, printed)
    assert verdict.decision == "refuted", verdict
    assert verdict.witness["point"]
    assert one.law.misprint
    assert type(printed) is type(one.law)
    assert printed.name == one.law.name


def test_laws_say_where_they_stand_and_what_they_mean():
    laws = {one.label: one.law for one in all_claimed()}
    assert [label for label, law in laws.items() if not (law.source and law.meaning)] == []
    explained = {label for label, law in laws.items() if law.misprint}
    assert explained == set(MISPRINTED)


def test_every_kind_of_law_occurs():
    kinds = {type(one.law).__name__ for one in all_claimed()}
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
