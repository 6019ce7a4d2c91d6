"""Why a law was not tried, in words."""

from __future__ import annotations

import pytest

from nonholonomic.catalogue import from_catalogue
from nonholonomic.classification.facts import ProofBudget


@pytest.mark.parametrize(
    ("altogether", "reason"),
    [
        (0, "not tried, as proofs were left out"),
        (1, "not tried, as the effort for all laws together was spent"),
    ],
)
def test_a_law_that_is_not_tried_says_why(altogether: int, reason: str) -> None:
    system = from_catalogue("suslov")
    budget = ProofBudget(1, altogether)
    last = [budget.verdict(system, law) for law in system.laws][-1]
    assert (last.decision, last.reason) == ("undecided", reason)
