"""``chaplygin prove`` and ``chaplygin audit`` as a user meets them."""

from __future__ import annotations

import json
from importlib import import_module

import pytest

from chaplygin.laws.certificate import check
from cli.test_cli import ask

__all__ = ["ask"]


def test_prove_prints_a_verdict_for_every_law(ask):
    code, out, _ = ask("prove", "veselova")
    assert code == 0
    assert "proven" in out
    assert "refuted" not in out
    assert "(6.4)" in out


def test_prove_as_json_has_the_fields_of_the_audit(ask):
    code, out, _ = ask("prove", "veselova", "--json")
    assert code == 0
    rows = json.loads(out)
    fields = {"source", "statement", "printed", "corrected", "verdict", "note", "seconds"}
    assert all(fields <= set(row) for row in rows)
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


def test_one_law_by_its_name(ask):
    code, out, _ = ask("prove", "veselova", "--law", "momentum", "--json")
    assert code == 0
    assert [row["law"] for row in json.loads(out)] == ["momentum"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("prove", "veselova", "--law", "spin"), "its laws are"),
        (("prove", "veselow"), "did you mean 'veselova'"),
        (("prove", "veselova", "--seconds", "0"), "must be positive"),
        (("audit", "--section", "13"), "sections 1 to 12"),
        (("audit", "--workers", "0"), "at least one process"),
        (("audit", "-o", "missing/audit.html"), "no folder missing"),
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
    assert check(certificate)
    code, _, err = ask("prove", "veselova", "--law", "momentum", "--certificate", "c.json")
    assert code == 2
    assert "exists already" in err


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


def test_audit_as_json(ask):
    code, out, _ = ask("audit", "--section", "6", "--json", "--workers", "1")
    assert code == 0
    rows = json.loads(out)
    assert {"source", "statement", "printed", "seconds"} <= set(rows[0])
    wrong = [row for row in rows if row["printed"] == "refuted"]
    assert wrong
    assert all(row["verdict"] == "proven" and row["corrected"] for row in wrong)
    assert any("(6.1)" in row["source"] for row in wrong)


def test_an_interrupted_proof_prints_what_is_done(ask, monkeypatch):
    proofs = import_module("chaplygin.laws.prove")
    original = proofs.prove
    seen = []

    def interrupted(system, law, **options):
        seen.append(law.name)
        if len(seen) == 3:
            raise KeyboardInterrupt
        return original(system, law, **options)

    monkeypatch.setattr(proofs, "prove", interrupted)
    code, out, err = ask("prove", "veselova")
    assert code == 1
    assert "energy" in out
    assert "proven" in out
    assert "interrupted" in err
    assert "were not tried" in err
