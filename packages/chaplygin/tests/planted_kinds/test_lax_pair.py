"""A planted kind of law is proven, refuted, printed, written to files and reported."""

import json
from dataclasses import replace

import pytest
import sympy as sp

import chaplygin as ch
import lawproof
from certificate_checker import CheckError, check
from cli.test_cli import ask
from flowlanes.formulas.digest import digest
from flowlanes.system.vectors import to_components
from nonholonomic.system_files.write import tables_of
from planted_kinds.lax_pair import LaxPair

__all__ = ["ask"]

a1, a2, b1, b2, b3 = sp.symbols("a_1 a_2 b_1 b_2 b_3", real=True)
FIELD = {
    a1: a1 * (b2 - b1),
    a2: a2 * (b3 - b2),
    b1: 2 * a1**2,
    b2: 2 * (a2**2 - a1**2),
    b3: -2 * a2**2,
}
L = sp.Matrix([[b1, a1, 0], [a1, b2, a2], [0, a2, b3]])
A = sp.Matrix([[0, a1, 0], [-a1, 0, a2], [0, -a2, 0]])
PAIR = LaxPair("flaschka", L, A, "Flaschka's matrices", source="(F)")
TODA = ch.System("toda", "Toda lattice of three particles", FIELD, laws=(PAIR,))

FILE = """
title = "Toda lattice"
equations.state = ["a_1", "a_2", "b_1", "b_2", "b_3"]
[equations.rates]
a_1 = "a_1*(b_2 - b_1)"
a_2 = "a_2*(b_3 - b_2)"
b_1 = "2*a_1**2"
b_2 = "2*(a_2**2 - a_1**2)"
b_3 = "-2*a_2**2"
[laws.others.flaschka]
kind = "LaxPair"
L = [["b_1", "a_1", "0"], ["a_1", "b_2", "a_2"], ["0", "a_2", "b_3"]]
A = [["0", "a_1", "0"], ["-a_1", "0", "a_2"], ["0", "-a_2", "0"]]
[start]
a_1 = 0.5
a_2 = 0.25
b_1 = 0.0
b_2 = 0.1
b_3 = -0.1
[run]
until = 1.0
"""


def test_it_is_proven_with_a_certificate_that_checks():
    verdict = lawproof.proof.prove_with_certificate(TODA, PAIR)
    assert verdict.decision == "proven"
    assert verdict.law == "flaschka"
    check(verdict.certificate)
    assert verdict.certificate["claim"]["law"]["kind"] == "Identity"
    # a certificate of another pair does not pass with the same proof
    forged = json.loads(json.dumps(verdict.certificate))
    forged["claim"]["law"]["value"][0] += " + a_1"
    with pytest.raises(CheckError):
        check(forged)


def test_a_wrong_one_is_refuted_with_a_witness_that_checks():
    wrong = replace(PAIR, name="wrong", A=2 * A)
    verdict = lawproof.proof.prove_with_certificate(TODA, wrong)
    assert verdict.decision == "refuted"
    check(verdict.certificate)


def test_it_is_printed_and_shown():
    text = str(TODA)
    assert "Lax pair" in text
    assert "dL/dt = A L - L A" in text
    assert r"\text{dL/dt}" in TODA._repr_html_() or "dL/dt" in TODA._repr_html_()


def test_its_scalar_form_is_itself():
    assert PAIR.scalar is PAIR
    assert to_components(PAIR.L) == L


def test_numbers_do_not_depend_on_it():
    assert digest(TODA) == digest(replace(TODA, laws=()))


def test_a_file_states_it_and_is_written_again():
    study = ch.Study.from_experiment(ch.parse_experiment(FILE))
    (law,) = study.system.laws
    assert isinstance(law, LaxPair)
    assert ch.prove(study.system, law).decision == "proven"
    written = tables_of(study.system)["laws"]["others"]["flaschka"]
    assert written["kind"] == "LaxPair"
    assert written["L"][0] == ["b_1", "a_1", "0"]
    assert (
        ch.Study.from_experiment(ch.parse_experiment(study.complete_toml())).system.laws
        == study.system.laws
    )


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('"LaxPair"', '"Lax"', "there is no kind of law 'Lax'; known are LaxPair"),
        ("A = [[", "B = [[", "a LaxPair has no 'B'"),
        ('A = [["0", "a_1", "0"], ["-a_1", "0", "a_2"], ["0", "-a_2", "0"]]\n', "", "needs A"),
    ],
)
def test_a_mistake_in_its_table_is_one_sentence(old, new, words):
    with pytest.raises(ch.InputError, match=words):
        ch.Study.from_experiment(ch.parse_experiment(FILE.replace(old, new))).system  # noqa: B018


def test_the_command_line_proves_and_reports_it(ask, tmp_path):
    path = tmp_path / "toda.toml"
    path.write_text(FILE)
    code, out, _ = ask("prove", str(path))
    assert code == 0
    assert "Lax pair" in out
    assert "proven" in out
    code, out, _ = ask("study", str(path), "--output", str(tmp_path / "out"))
    assert code == 0
    report = next((tmp_path / "out").rglob("*.html")).read_text()
    assert "Lax pair" in report
    assert "<mi>dL/dt</mi>" in report
