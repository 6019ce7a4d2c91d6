"""What is decided of the open problems: judged as it says, and quoted by docs and audit."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from borisov_mamaev_2008 import Remark, audit, remarks
from borisov_mamaev_2008.open_problems.findings import FINDINGS

PAGE = (
    Path(__file__).parents[5] / "packages/borisov-mamaev-2008/docs/open-problems.md"
).read_text()
ROWS = [
    [cell.strip().replace(r"\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
    for line in PAGE.splitlines()
    if line.startswith("| ")
]


@pytest.mark.parametrize("finding", FINDINGS, ids=lambda f: f"{f.key} {f.decision}")
def test_a_finding_is_judged_as_it_says(finding):
    remark = Remark("§12", "an open question", "open", findings=(finding,))
    ((_, verdict),) = audit.judged_findings(remark)
    assert verdict.decision == finding.decision


@pytest.mark.parametrize("finding", FINDINGS, ids=lambda f: f"{f.key} {f.decision}")
def test_the_page_quotes_statement_and_decision(finding):
    assert [finding.key, finding.statement, f"**{finding.decision}**"] in ROWS
    # the row of the question in the first table has the same word
    assert any(
        key == finding.key and f"**{finding.decision}**" in cell for key, _, cell in ROWS[:16]
    )


def test_the_page_quotes_nothing_else():
    quoted = [row for row in ROWS if row[-1] in ("**proven**", "**refuted**", "**undecided**")]
    assert len(quoted) == len(FINDINGS)


def test_remarks_refer_to_findings_that_there_are():
    referred = {finding for remark in remarks() for finding in remark.findings}
    assert {finding.key for finding in referred} >= {"2a", "lift", "3", "4"}
    assert referred <= set(FINDINGS)
