"""The audit: cases joined, verdicts kept, interruptions survived, the page."""

from __future__ import annotations

import re

import pytest
import sympy as sp

from borisov_mamaev_2008 import Claim, audit as module, claims, remarks
from borisov_mamaev_2008.audit import DECISIONS, TITLES, Audit, Judgement, audit, counts, page
from borisov_mamaev_2008.methods.derived_verdicts import contrary
from chaplygin.cli import main
from flowlanes.system.laws import Integral
from flowlanes.system.vectors import norm_squared, vectors
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import from_catalogue

M, gamma = vectors("M gamma")
SECTION = 6


@pytest.fixture(scope="module")
def judged():
    return audit(SECTION).judgements


def supposed() -> list[Judgement]:
    """The claims of the section with the verdicts that they should have, without their proofs."""
    right = Verdict("right", "proven", finding="it is so")
    wrong = Verdict("wrong", "refuted", finding="at a point it is not so")
    return [
        Judgement(n, c, right, None, 0.1)
        if c.corrected is None
        else Judgement(n, c, wrong, right, 0.1)
        for n, c in claims(SECTION)
    ]


@pytest.fixture(params=["supposed", pytest.param("computed", marks=pytest.mark.slow)])
def judgements(request):
    return supposed() if request.param == "supposed" else request.getfixturevalue("judged")


@pytest.mark.slow
def test_every_claim_is_judged_in_reading_order(judged):
    assert [j.claim.source for j in judged] == [c.source for _, c in claims(SECTION)]
    assert all(j.section == SECTION for j in judged)


@pytest.mark.slow
def test_a_second_audit_computes_nothing(judged, monkeypatch):
    def refused(*_, **__):
        raise AssertionError("computed again")

    monkeypatch.setattr(module, "ProcessPoolExecutor", refused)
    result = audit(SECTION)
    again, left = result.judgements, result.unjudged
    assert left == 0
    assert [j.printed for j in again] == [j.printed for j in judged]


def test_an_interrupted_audit_keeps_what_is_done(monkeypatch, tmp_path):
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path))
    original = module.wait
    rounds = []

    def interrupted(tasks, **options):
        if rounds:
            raise KeyboardInterrupt
        ended, rest = original(tasks, **{**options, "timeout": 60})
        rounds.append(len(ended))
        return ended, rest

    monkeypatch.setattr(module, "wait", interrupted)
    result = audit(SECTION, workers=2)
    done, left = result.judgements, result.unjudged
    assert len(done) == rounds[0] > 0
    assert left == len(claims(SECTION)) - len(done) > 0
    assert all(j.printed.decision in DECISIONS for j in done)


def test_the_page_of_an_interrupted_audit_is_not_in_the_way_of_the_next(
    monkeypatch, tmp_path, capsys
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(module, "audit", lambda *_: Audit((), 5))
    monkeypatch.setattr("sys.argv", ["chaplygin", "audit", "-o", "a.html"])
    with pytest.raises(SystemExit) as end:
        main()
    assert end.value.code == 130
    assert capsys.readouterr().err.endswith(
        "interrupted: 5 claims were not checked and no page was written; verdicts are saved, and "
        "the same command resumes\n"
    )
    assert not list(tmp_path.iterdir())


def test_one_worker_is_no_other_process_and_can_be_interrupted(monkeypatch, tmp_path):
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path))
    monkeypatch.setattr(module, "ProcessPoolExecutor", None)
    verdict = Verdict("a", "proven")
    shares = []

    def judge(number, section):
        if len(shares) == 2:
            raise KeyboardInterrupt
        return verdict, None

    monkeypatch.setattr(module, "judge", judge)
    result = audit(SECTION, workers=1, progress=shares.append)
    done, left = result.judgements, result.unjudged
    total = len(claims(SECTION))
    assert [j.printed for j in done] == [verdict] * 2
    assert left == total - 2
    assert shares == [1 / total, 2 / total]


@pytest.mark.slow
def test_a_case_of_several_laws_holds_when_all_hold():
    ball = from_catalogue("chaplygin-ball")
    right = Integral("square", norm_squared(M))
    wrong = Integral("component", M.symbols[0])
    hard = Integral("absolute", sp.Abs(M.symbols[0]))
    joined = module._joint_verdict
    assert joined(((ball, right), (ball, right))).decision == "proven"
    assert joined(((ball, right), (ball, wrong))).decision == "refuted"
    assert joined(((ball, hard), (ball, right))).decision == "undecided"
    assert joined(((ball, hard), (ball, wrong))).decision == "refuted"
    assert joined((ball, wrong)).decision == "refuted"
    given = Verdict("direct", "undecided", reason="tried")
    assert joined(given) is given


PARTLY = Verdict("part", "proven where", finding="a part", conditions=("x > 0",))
OPEN = Verdict("open", "undecided", reason="too large")


def partly_proven():
    """A claim that is proven where x > 0, and one put right by what is not decided."""
    refuted = Verdict("wrong", "refuted", finding="a point")
    claim = Claim("(1)", "$x$", lambda: PARTLY, note="read $x$ so")
    wrong = Claim("(2)", "$x$", lambda: refuted, lambda: OPEN, "$x = 1$", "x")
    return Judgement(1, claim, PARTLY, None, 0.1), Judgement(1, wrong, refuted, OPEN, 0.1)


def test_conditions_of_all_parts_are_kept(monkeypatch):
    verdicts = iter(
        (
            Verdict("a", "proven where", conditions=("x > 0",)),
            Verdict("b", "proven"),
            Verdict("c", "proven where", conditions=("y > 0", "x > 0")),
        )
    )
    monkeypatch.setattr(module, "prove", lambda *_, **__: next(verdicts))
    joined = module._joint_verdict(((None, None),) * 3)
    assert joined.decision == "proven where"
    assert joined.conditions == ("x > 0", "y > 0")


def test_what_is_proven_in_part_or_open_is_counted_as_such():
    table = counts(partly_proven())
    assert table["printed"] == {"proven": 0, "proven where": 1, "refuted": 1, "undecided": 0}
    assert table["corrected"] == {"proven": 0, "proven where": 0, "refuted": 0, "undecided": 1}


def test_conditions_of_a_claim_are_in_its_judgement(monkeypatch, tmp_path):
    """Computed, read from the cache and counted: proven where they hold."""
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path))
    proven = Verdict("law", "proven", finding="a proof")
    claim = Claim("(1)", "$x$", lambda: proven, argument="in $n$ dimensions", where=("$n > 2$",))
    monkeypatch.setattr(module, "claims", lambda section=None: ((SECTION, claim),))
    for _ in range(2):
        result = audit(SECTION, workers=1)
        (judgement,) = result.judgements
        assert result.unjudged == 0
        assert judgement.printed.decision == "proven where"
        record = judgement.record()
        assert record["conditions"] == ["$n > 2$"]
        assert record["argument"] == "in $n$ dimensions"
        assert counts([judgement])["printed"]["proven"] == 0
    body = page([judgement], SECTION).split("</style>")[1]
    assert "Proven where <math" in body
    assert "By an argument: in <math" in body


def test_records_tell_conditions_and_reasons():
    part, open_one = (judgement.record() for judgement in partly_proven())
    assert part["printed"] == "proven where"
    assert part["conditions"] == ["x > 0"]
    assert "reason" not in part
    assert part["note"] == "read $x$ so"
    assert open_one["verdict"] == "undecided"
    assert open_one["reason"] == "too large"
    assert "conditions" not in open_one


def test_the_page_tells_conditions_and_reasons():
    body = page(partly_proven(), 1).split("</style>")[1]
    assert '<div class="verdict proven-where">proven where</div>' in body
    assert "Proven where x &gt; 0." in body
    assert "Undecided: too large" in body
    # each decision has its column for both forms, and each row its numbers
    rows = re.findall(r"<tr>.*?</tr>", body, flags=re.S)
    cells = [len(re.findall(r"<t[hd]", row)) for row in rows]
    assert cells[1:] == [3 + 2 * len(DECISIONS)] * (len(rows) - 1)


def test_the_opposite_of_what_is_proven_in_part_is_undecided():
    opposite = contrary(PARTLY)
    assert opposite.decision == "undecided"
    assert opposite.reason == "excluded only where x > 0"
    assert not opposite.conditions


def test_counts_add_up(judgements):
    table = counts(judgements)
    assert sum(table["printed"].values()) == len(judgements)
    assert sum(table["corrected"].values()) == sum(j.corrected is not None for j in judgements)


def test_the_page_shows_every_claim_typeset(judgements):
    text = page(judgements, SECTION)
    body = text.split("</style>")[1]
    assert body.count('<article class="claim') == len(judgements)
    assert body.count(" misprint") == counts(judgements)["printed"]["refuted"]
    assert "$" not in body
    assert "<merror" not in body
    assert TITLES[SECTION] in body
    assert not re.search(r'(src|href)="http', text)


def test_the_page_of_the_whole_paper_has_all_sections_with_claims(judgements):
    assert {number for number, _ in claims()} <= set(TITLES)
    assert 'id="section-6"' in page(judgements)


def test_what_was_not_computed_is_listed_with_its_reason():
    assert remarks()
    assert all(r.source and r.statement and r.reason for r in remarks())


def test_records_have_the_agreed_fields(judgements):
    for judgement in judgements:
        record = judgement.record()
        assert {"source", "statement", "printed", "seconds"} <= set(record)
        assert ("corrected" in record) == (judgement.corrected is not None)
