"""``chaplygin prove`` and ``chaplygin audit`` as a user meets them."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from importlib import import_module
from pathlib import Path

import pytest
import sympy

from borisov_mamaev_2008 import Claim, remarks
from certificate_checker import check
from certificate_checker.__main__ import main as check_files
from chaplygin.answers import verdicts
from cli.test_cli import ask
from flowlanes.printing.formula import width
from flowlanes.system.laws import Measure
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import from_catalogue

__all__ = ["ask"]

EXAMPLES = Path(__file__).parents[4] / "examples"


@pytest.mark.slow
def test_prove_prints_a_verdict_for_every_law(ask):
    code, out, _ = ask("prove", "veselova")
    assert code == 0
    assert "proven" in out
    assert "refuted" not in out
    assert "(6.4)" in out


@pytest.mark.slow
def test_prove_as_json_has_the_fields_of_the_audit(ask):
    code, out, _ = ask("prove", "veselova", "--json")
    assert code == 0
    rows = json.loads(out)
    fields = {"source", "statement", "printed", "corrected", "verdict", "note", "seconds"}
    assert all(fields <= set(row) for row in rows)
    assert all(row["conditions"] == [] and row["effort"] > 0 for row in rows)
    assert {row["verdict"] for row in rows} == {"proven"}


def test_prove_takes_an_experiment_file(ask, tmp_path):
    (tmp_path / "egg.toml").write_text(
        "[body]\nmass = 1.0\ninertia = [1.0, 1.5, 2.1]\n"
        "[body.shape]\nkind = 'ball'\nradius = 1.0\ncentre = [0.1, 0.0, 0.2]\n"
        "[field]\ngravity = 0.0\n[start]\ngamma = [0, 0, 1]\nomega = [1, 0, 1]\n"
    )
    code, out, _ = ask("prove", "egg.toml")
    assert code == 0
    assert "(10.3)" in out


def test_a_law_that_states_nothing_is_refused_by_itself(ask, tmp_path):
    text = (EXAMPLES / "sleigh.toml").read_text()
    measures = "[laws.measures]\n"
    assert measures in text
    (tmp_path / "sleigh.toml").write_text(
        text.replace(measures, f'{measures}imaginary = "sqrt(-1 - u**2)"\n')
    )
    code, out, _ = ask("prove", "sleigh.toml", "--json")
    assert code == 2
    rows = {row["law"]: row for row in json.loads(out)}
    assert rows["imaginary"]["verdict"] == "refused"
    assert "root of a negative quantity" in rows["imaginary"]["reason"]
    assert rows["straight"]["verdict"] == rows["energy"]["verdict"] == "proven"


FACTOR = """
[equations]
state = ["x", "y", "z"]
rates = { x = "y*z", y = "-2*x*z", z = "x*y" }
relations = ["(1 + x**2)*(x**2 + y**2 + z**2 - 1)"]
[laws.measures]
volume = "1"
factor = "1 + x**2"
imaginary = "sqrt(-1 - x**2)"
[laws.integrals]
ellipsoid = "x**2 - z**2"
[start]
x = 0.6
y = 0.8
z = 0.0
"""


def test_a_factor_of_a_relation_from_the_command_line(ask, tmp_path):
    """Each law has its row, and what is proven has a certificate that checks."""
    (tmp_path / "factor.toml").write_text(FACTOR)
    code, out, _ = ask("prove", "factor.toml", "--json", "--certificate", "factor.json")
    assert code == 2
    assert {row["law"]: row["verdict"] for row in json.loads(out)} == {
        "volume": "refuted",
        "factor": "proven",
        "imaginary": "refused",
        "ellipsoid": "proven",
    }
    certificates = json.loads((tmp_path / "factor.json").read_text())
    assert len(certificates) == 3
    for certificate in certificates:
        check(certificate)
    code, out, _ = ask("find", "measure", "factor.toml")
    assert code == 0
    assert "1 + x²" in out
    (tmp_path / "square.toml").write_text(
        FACTOR.replace("(1 + x**2)*(", "(").replace(')"]', ')**2"]')
    )
    code, out, _ = ask("prove", "square.toml")
    assert code == 2
    assert "1 proven, 3 refused" in out
    assert "cut out no volume" in out


def test_a_misprint_is_refuted_beside_its_correction(ask):
    _, out, _ = ask("prove", "lagrange-top", "--law", "hamiltonian", "--json")
    (row,) = json.loads(out)
    assert (row["verdict"], row["printed"]) == ("proven", "refuted")


def test_a_printed_form_that_states_nothing_is_refused_by_itself(ask, monkeypatch):
    system = from_catalogue("veselova")
    law, *others = system.laws
    printed = Measure("printed", {-1 - system.symbols[0] ** 2: sympy.Rational(1, 2)})
    laws = (replace(law, as_printed=printed, misprint="as is"), *others)
    claims = [(system, each) for each in laws]
    monkeypatch.setattr(verdicts, "claims_of", lambda *_: claims)
    _, out, _ = ask("prove", "veselova", "--law", law.name, "--json", "--again")
    (row,) = json.loads(out)
    assert (row["verdict"], row["printed"]) == ("proven", "refused")


def test_one_law_by_its_name(ask):
    code, out, _ = ask("prove", "veselova", "--law", "momentum", "--json")
    assert code == 0
    assert [row["law"] for row in json.loads(out)] == ["momentum"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("prove", "veselova", "--law", "spin"), "its laws are"),
        (("prove", "veselow"), "did you mean 'veselova'"),
        (("prove", "veselova", "--effort", "0"), "must be a positive number"),
        (("audit", "--section", "13"), "sections 1 to 12"),
        (("audit", "--workers", "0"), "--workers 0: it must be a whole number from 1 to"),
        (("audit", "-o", "missing/audit.html"), "no folder missing"),
        (("audit", "-o", "audit.txt"), "its name must end in .html"),
    ],
)
def test_bad_input_is_one_sentence(ask, arguments, words):
    code, out, err = ask(*arguments)
    assert code == 2
    assert out == ""
    assert words in err
    assert len(err.strip().splitlines()) == 1


def test_certificates_can_be_checked(ask, tmp_path):
    code, _, err = ask("prove", "veselova", "--law", "momentum", "--certificate", "c.json")
    assert code == 0
    assert "c.json" in err
    (certificate,) = json.loads((tmp_path / "c.json").read_text())
    assert certificate["verdict"] == "proven"
    assert check_files([str(tmp_path / "c.json")]) == 0
    code, _, err = ask("prove", "veselova", "--law", "momentum", "--certificate", "c.json")
    assert code == 2
    assert "exists already" in err


@pytest.mark.slow
def test_audit_of_one_section(ask, tmp_path):
    code, out, err = ask("audit", "--section", "6", "-o", "audit.html", "--workers", "1")
    assert code == 0
    assert "(6.1)" in out
    assert "as printed" in out
    assert "audit.html" in err
    page = (tmp_path / "audit.html").read_text()
    assert "The Veselova system" in page
    assert "<math" in page
    assert "$" not in page.split("</style>")[1]


@pytest.mark.slow
def test_audit_as_json(ask):
    code, out, _ = ask("audit", "--section", "6", "--json", "--workers", "1")
    assert code == 0
    rows = json.loads(out)["claims"]
    assert {"source", "statement", "printed", "seconds"} <= set(rows[0])
    wrong = [row for row in rows if row["printed"] == "refuted"]
    assert wrong
    assert all(row["verdict"] == "proven" and row["corrected"] for row in wrong)
    assert any("(6.1)" in row["source"] for row in wrong)


def test_the_audit_speaks_unicode_on_a_terminal_and_latex_to_programs(ask, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    code, out, _ = ask("audit", "--section", "6", "--workers", "1")
    assert code == 0
    words = " ".join(out.split())
    assert "the integral is F − 2 det I (γ, I⁻¹γ); with U = (K/2)(γ, Iγ)" in words
    assert "refuted → proven" in out
    assert "§6 The Veselova system" in out
    assert not re.search(r"[\\$]|frac|mathbf", out)
    assert all(width(line.rstrip()) <= 80 for line in out.splitlines())
    _, printed, _ = ask("audit", "--section", "6", "--json", "--workers", "1")
    notes = [row.get("note", "") for row in json.loads(printed)["claims"]]
    assert any(r"U = \frac{K}{2}" in note for note in notes)


def test_the_audit_tells_what_is_proven_in_part(ask, monkeypatch):
    judged = import_module("borisov_mamaev_2008.audit")
    part = Verdict("part", "proven where", finding="a part", conditions=("x > 0", "not y = 0"))
    refuted = Verdict("wrong", "refuted", finding="a point")
    unknown = Verdict("open", "undecided", reason="20 million terms remained")
    claims = (
        Claim("(1)", "as printed", lambda: part),
        Claim("(2)", "$x^2$", lambda: refuted, lambda: unknown, "$x^3$", "the exponent"),
    )
    verdicts = ((part, None), (refuted, unknown))
    made = tuple(
        judged.Judgement(1, claim, *pair, 0.5) for claim, pair in zip(claims, verdicts, strict=True)
    )
    monkeypatch.setattr(judged, "audit", lambda *_: judged.Audit(made))
    code, out, _ = ask("audit")
    assert code == 0
    assert "x > 0, not y = 0" in out
    assert "20 million terms remained" in out
    assert "as printed: 0 proven, 1 proven where, 1 refuted, 0 undecided" in out
    assert "corrected: 0 proven, 0 proven where, 0 refuted, 1 undecided" in out
    assert "x²" in out and "x³" in out


def test_what_was_not_computed_is_counted_listed_and_in_json(ask, monkeypatch):
    judged = import_module("borisov_mamaev_2008.audit")
    found = remarks(7)
    monkeypatch.setattr(judged, "audit", lambda *_: judged.Audit(()))
    code, out, _ = ask("audit", "--section", "7")
    assert code == 0
    counted = f"{len(found)} further statements, of literature or opinion, were not computed: "
    assert counted + "chaplygin audit --section 7 --remarks" in " ".join(out.split())
    _, out, _ = ask("audit", "--section", "7", "--json")
    records = json.loads(out)["remarks"]
    assert [(row["source"], row["statement"], row["reason"]) for row in records] == [
        (remark.source, remark.statement, remark.reason) for remark in found
    ]
    assert {row["section"] for row in records} == {7}


def test_the_remarks_alone_judge_nothing(ask, monkeypatch):
    judged = import_module("borisov_mamaev_2008.audit")
    monkeypatch.setattr(judged, "audit", None)
    code, out, _ = ask("audit", "--remarks")
    assert code == 0
    assert "§12 Open problems" in out and "Remark 25" in out
    assert not re.search(r"[\\$]|mathbf", out)
    _, out, _ = ask("audit", "--remarks", "--json", "--section", "7")
    assert len(json.loads(out)["remarks"]) == len(remarks(7))
    code, out, err = ask("audit", "--remarks", "-o", "audit.html")
    assert code == 2
    assert err.strip() == "error: --remarks checks no claims: leave out --output and --workers"


def test_an_erratum_is_told_beside_the_verdict(ask, monkeypatch):
    judged = import_module("borisov_mamaev_2008.audit")
    proven = Verdict("a", "proven", finding="a proof")
    claim = Claim("(1)", "(6.1) holds", lambda: proven, erratum="(6.1) is printed for (7.1)")
    made = (judged.Judgement(7, claim, proven, None, 0.5),)
    monkeypatch.setattr(judged, "audit", lambda *_: judged.Audit(made))
    _, out, _ = ask("audit")
    assert "erratum    (6.1) is printed for (7.1)" in out
    assert made[0].record()["erratum"] == "(6.1) is printed for (7.1)"
    assert "Erratum: (6.1) is printed for (7.1)" in judged.page(made, 7)


def test_an_interrupted_proof_prints_what_is_done(ask, monkeypatch):
    proofs = import_module("lawproof.proof.prover")
    original = proofs.prove
    seen = []

    def interrupted(system, law, **options):
        seen.append(law.name)
        if len(seen) == 3:
            raise KeyboardInterrupt
        return original(system, law, **options)

    monkeypatch.setattr(proofs, "prove", interrupted)
    code, out, err = ask("prove", "veselova", "--again")
    assert code == 130
    assert "energy" in out
    assert "proven" in out
    assert "interrupted: " in err
    assert "laws have no verdict; verdicts are saved, and the same command resumes" in err


# --- proven where a condition holds --------------------------------------------------------


@pytest.fixture
def conditional(monkeypatch):
    """The momentum of every system is proven where a condition holds."""
    proofs = import_module("lawproof.proof.prover")
    original = proofs.prove

    def where(system, law, **options):
        found = original(system, law, **options)
        if law.name != "momentum":
            return found
        return replace(found, decision="proven where", conditions=("gamma_3 > 0", "not k = 0"))

    monkeypatch.setattr(proofs, "prove", where)
    monkeypatch.setattr("nonholonomic.classification.facts.prove", where)


def test_conditions_are_told_and_do_not_count_as_proven(ask, conditional):
    code, out, _ = ask("prove", "veselova", "--again")
    assert code == 1
    assert "1 proven where a condition holds" in out
    assert "momentum: proven where gamma_3 > 0, not k = 0" in out
    code, out, _ = ask("prove", "veselova", "--again", "--json")
    assert code == 1
    rows = {row["law"]: row for row in json.loads(out)}
    assert rows["momentum"]["verdict"] == "proven where"
    assert rows["momentum"]["conditions"] == ["gamma_3 > 0", "not k = 0"]
    assert rows["energy"]["verdict"] == "proven"
    assert rows["energy"]["conditions"] == []


def test_show_names_the_conditions_and_counts_without_the_law(ask, conditional):
    _, out, _ = ask("show", "veselova", "--again", "--json")
    place = json.loads(out)["place"]
    assert {"law": "momentum", "why": "proven where gamma_3 > 0, not k = 0"} in place[
        "ignored_laws"
    ]
    assert "momentum" not in {fact["law"] for fact in place["integrals"]}


@pytest.mark.slow
def test_the_report_names_the_conditions(ask, conditional, tmp_path):
    assert ask("study", "veselova", "-o", "report", "--set", "run.until=0.5")[0] == 0
    page = (tmp_path / "report" / "report.html").read_text()
    assert '<td class="proven-where">proven where gamma_3 &gt; 0, not k = 0</td>' in page
    assert "momentum</a>; proven where gamma_3 &gt; 0, not k = 0." in page
