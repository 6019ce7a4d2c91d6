"""The audit as a whole: every claim says what it is, is judged, and is put right where it fails."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import pytest

from borisov_mamaev_2008 import Claim, claims, remarks
from borisov_mamaev_2008.audit import TITLES, audit, counts, judge
from flowlanes.printing.mathml import mathml
from lawproof.proof.verdict import Verdict

CLAIMS = claims()
NUMBERS = pytest.mark.parametrize(
    "number", range(len(CLAIMS)), ids=lambda n: f"{n} {CLAIMS[n][1].source}"
)
DOLLARS = re.compile(r"\$\$(.+?)\$\$|\$(.+?)\$", flags=re.S)


def faults(text: str) -> list[str]:
    """Why words with formulas between dollar signs are none that a browser can show."""
    words = DOLLARS.sub("", text)
    found = [] if text == text.strip() and not {"$", "\\"} & set(words) else [text]
    for display, inline in DOLLARS.findall(text):
        formula = display or inline
        opened = formula.count(r"\left") - formula.count(r"\leftrightarrow")
        closed = formula.count(r"\right") - formula.count(r"\rightarrow")
        if formula.count("{") != formula.count("}") or opened != closed:
            found.append(formula)
            continue
        shown = mathml(formula)
        if "\\" in shown or not (shown.startswith("<math ") and shown.endswith("</math>")):
            found.append(formula)
    return found


def test_claims_say_what_they_are():
    wrong = []
    for section, claim in CLAIMS:
        texts = (claim.statement, claim.correction, claim.note, claim.argument, *claim.where)
        # what is not true may be put right in words alone; a form is always told
        told = claim.corrected is None or (claim.correction and claim.note)
        if section not in TITLES or not (claim.source and claim.statement and told):
            wrong.append((section, claim.source, "a part is missing"))
        wrong += [(section, claim.source, fault) for text in texts for fault in faults(text)]
    assert wrong == []


def test_remarks_say_why_they_were_not_computed():
    assert [r.statement for r in remarks() if not (r.source and r.reason)] == []
    texts = [(r.source, text) for r in remarks() for text in (r.statement, r.reason)]
    assert [(source, fault) for source, text in texts for fault in faults(text)] == []


def test_faults_of_texts_are_seen():
    assert faults("of $x$, in words") == []
    for text in (" x", "$x", r"\alpha", "$x^{2$", r"$\left(x$", r"$\nonsense{x}$"):
        assert faults(text), text


def test_claims_are_told_apart():
    """A verdict is kept under source and statement."""
    found = Counter((claim.source, claim.statement) for _, claim in CLAIMS)
    assert max(found.values()) == 1


def test_every_section_has_claims_in_reading_order():
    sections = [section for section, _ in CLAIMS]
    assert sections == sorted(sections)
    assert set(sections) == set(TITLES)


def check_verdict(verdict: Verdict) -> None:
    if verdict.decision == "undecided":
        assert verdict.reason
    else:
        assert verdict.finding and not verdict.reason
    assert bool(verdict.conditions) == (verdict.decision == "proven where")


@pytest.mark.slow
@NUMBERS
def test_a_claim_is_judged_and_put_right(number):
    _, claim = CLAIMS[number]
    printed, corrected = judge(number, None)
    check_verdict(printed)
    if corrected is not None:
        check_verdict(corrected)
        assert printed.decision == "refuted"
        assert corrected.decision in ("proven", "proven where"), corrected
    elif printed.decision == "refuted":
        assert claim.note, "a refuted claim without a correction says why"
    holding = corrected or printed
    assert (holding.decision == "proven where") == bool(claim.where)
    assert set(claim.where) <= set(holding.conditions)


#: Words by which a note says that a computation covers less than the statement.
NARROWER = re.compile(
    r"(decided|computed|shown|proved) for (?!every|any)|for one |\bfor a homogeneous|on one torus"
    r"|[nm] = [2-9]\b|\bfor (two|three|four) |for functions"
)


def test_narrower_computations_have_an_argument_or_conditions():
    narrower = [c for _, c in CLAIMS if c.corrected is None and NARROWER.search(c.note)]
    assert narrower
    assert [(c.source, c.note) for c in narrower if not (c.argument or c.where)] == []


def test_corrected_forms_state_their_hypotheses():
    assert not [claim.source for _, claim in CLAIMS if claim.corrected and claim.where]


def test_conditions_restrict_what_is_proven_alone():
    claim = Claim("(1)", "$x$", lambda: Verdict("law", "proven"), where=("x > 0",))
    part = claim.under_conditions(Verdict("law", "proven where", conditions=("y > 0",)))
    assert part.decision == "proven where"
    assert part.conditions == ("y > 0", "x > 0")
    for decision in ("refuted", "undecided"):
        other = Verdict("law", decision)
        assert claim.under_conditions(other) is other


@pytest.mark.slow
def test_counts_are_those_of_the_judgements():
    section = min(TITLES, key=lambda n: len(claims(n)))
    result = audit(section, workers=1)
    judgements, left = result.judgements, result.unjudged
    assert left == 0
    assert [(j.section, j.claim.source) for j in judgements] == [
        (n, claim.source) for n, claim in claims(section)
    ]
    table = counts(judgements)
    assert sum(table["printed"].values()) == len(judgements)
    assert sum(table["corrected"].values()) == sum(
        c.corrected is not None for _, c in claims(section)
    )
    for judgement in judgements:
        record = judgement.record()
        assert record["source"] == judgement.claim.source
        assert record["printed"] == judgement.printed.decision
        assert ("corrected" in record) == ("verdict" in record) == (judgement.corrected is not None)


ROOT = Path(__file__).parents[4]


def test_the_page_lists_the_conditions():
    rows = [f"| {c.source} | {'; '.join(c.where)} |" for _, c in CLAIMS if c.where]
    table = (
        (ROOT / "packages/borisov-mamaev-2008/docs/audit.md")
        .read_text()
        .split("| claim | where |\n|---|---|\n")[1]
    )
    assert table.split("\n\n")[0].split("\n") == rows


def test_pages_and_results_that_arguments_name_are_there():
    """An argument that is written elsewhere names the page, and the result on it."""
    named = [(c.source, c.argument) for _, c in CLAIMS if "docs/" in c.argument]
    assert named
    for source, argument in named:
        page = re.search(r"[\w-]+/docs/[\w-]+\.md", argument)
        assert page and (ROOT / "packages" / page[0]).is_file(), source
        for result in re.findall(r"result (\d+)", argument):
            assert f"**{result}. " in (ROOT / "packages" / page[0]).read_text(), source


@pytest.mark.parametrize(
    "page", ["README.md", "packages/borisov-mamaev-2008/docs/audit.md", "CHANGELOG.md"]
)
def test_the_numbers_of_claims_in_the_documentation(page):
    """Each printed form is proven, proven where conditions hold, or put right.

    The test above judges them one by one.
    """
    text = " ".join((ROOT / page).read_text().split())
    total, wrong = len(CLAIMS), sum(claim.corrected is not None for _, claim in CLAIMS)
    partly = sum(bool(claim.where) for _, claim in CLAIMS)
    assert f"{total} claims" in text
    assert f"{total - wrong - partly} are proven as printed, {partly} where" in text
    assert re.search(rf"{wrong} are (misprinted|refuted)", text)
