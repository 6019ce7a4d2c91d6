"""Valid certificates check, whatever they use; the command line says how it went."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from certificate_checker import BadInputError, CheckError, check
from certificate_checker.__main__ import main
from checker import examples

Certificate = dict[str, Any]


@pytest.mark.parametrize("example", examples.ALL, ids=lambda e: e.__name__)
def test_valid_certificates_check(example: Callable[[], Certificate]) -> None:
    check(example())


@pytest.mark.parametrize("example", examples.ALL, ids=lambda e: e.__name__)
def test_valid_certificates_check_after_a_journey(example: Callable[[], Certificate]) -> None:
    check(json.loads(json.dumps(example())))


def test_a_missing_sign_is_noticed() -> None:
    for part in (0, 1):
        certificate = examples.root()
        del certificate["proofs"][part]
        with pytest.raises(CheckError, match="do not cover all signs"):
            check(certificate)


def test_a_root_without_its_sign_is_noticed() -> None:
    certificate = examples.root()
    for proof in certificate["proofs"]:
        proof["signs"] = []
    with pytest.raises(CheckError, match="a root of the law is none of factors with known signs"):
        check(certificate)


def test_conditions_make_other_signs_unnecessary() -> None:
    certificate = examples.root()
    certificate["proofs"] = certificate["proofs"][:1]
    certificate |= {"verdict": "proven where", "conditions": ["2*x > 0"]}
    certificate["sample"]["x"] = "1"
    check(certificate)
    certificate["conditions"] = ["2*x < 0"]
    with pytest.raises(CheckError, match="sample does not satisfy"):
        check(certificate)
    certificate["sample"]["x"] = "-1"
    with pytest.raises(CheckError, match="do not cover all signs"):
        check(certificate)


def test_a_case_left_open_needs_its_condition() -> None:
    certificate = examples.somewhere()
    for conditions in (["not x = 0"], ["not y + 1 = 0"], ["y > 0"]):
        with pytest.raises(CheckError):
            check({**certificate, "conditions": conditions})
    certificate["verdict"] = "proven"
    del certificate["conditions"]
    with pytest.raises(CheckError, match="left unproven"):
        check(certificate)


def test_an_empty_level_proves_nothing() -> None:
    certificate = examples.oscillator()
    certificate["claim"]["law"]["on"] = ["1"]
    with pytest.raises(CheckError, match="does not satisfy a condition"):
        check(certificate)


def test_an_isomorphism_must_not_lose_dimensions() -> None:
    certificate = examples.carried()
    law = certificate["claim"]["law"]
    law["map"] = [["X", "0*x"], ["V", "0*v"]]
    with pytest.raises(CheckError, match="the rank is not the stated one"):
        check(certificate)


def test_a_logarithm_for_positive_numbers_is_none_for_all() -> None:
    """2 log x is not log x² where x < 0."""
    ring = ["aux0", "x"]
    from checker.made import identity, law, poly, proof, proven, residual, system, zero

    claim = {
        "system": system({"x": "0"}),
        "law": law("Identity", value=["log(x**2)*(x - x)"]),
    }
    place = {"numerator": poly("x", ring), "denominator": []}
    made = proof(
        ring,
        auxiliary=[["aux0", {"kind": "known", "name": "log", "of": [place]}]],
        residuals=[residual("0", [], ring)],
        tree=zero(identity(0, [], ring)),
    )
    with pytest.raises(CheckError, match="the argument of aux0 is none of the law"):
        check(proven(claim, made, sample={"x": "1"}))


def test_a_divisor_tells_nothing_of_what_it_is_divided_by() -> None:
    """y = (x y)/x does not say that x is not zero."""
    certificate = examples.empty()
    proof = certificate["proofs"][0]
    x, y = ([["1", [i, 1]]] for i in (0, 1))
    xy = [["1", [0, 1, 1, 1]]]
    proof["divisors"][0]["factors"] = [[xy, 1], [x, -1]]
    with pytest.raises(CheckError, match="may vanish"):
        check(certificate)
    proof["divisors"][0]["factors"] = [[y, 1]]
    check(certificate)


def test_a_reason_that_is_no_text_is_refused() -> None:
    certificate = examples.squares()
    certificate["proofs"][0]["positive"][0]["from"] = []
    with pytest.raises(CheckError, match="is not a text"):
        check(certificate)


@pytest.mark.parametrize("bad", [None, 3, [], {}, {"format": "other"}])
def test_what_is_no_certificate(bad: Any) -> None:
    with pytest.raises(BadInputError, match="not a certificate"):
        check(bad)


def test_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    good, wrong, no = (tmp_path / f"{n}.json" for n in ("good", "wrong", "no"))
    good.write_text(json.dumps(examples.oscillator()))
    certificate = examples.oscillator()
    certificate["claim"]["law"]["value"] = "v**2/2 + k*x**2"
    wrong.write_text(json.dumps(certificate))
    no.write_text('{"format": 1, "format": 2}')
    assert main([str(good)]) == 0
    assert capsys.readouterr().out.startswith(f"{good}: checks; a false one would pass with")
    assert main([str(good), str(wrong)]) == 1
    out = capsys.readouterr().out
    assert "wrong.json: does not check: proof 0: residual 0 is not that of the law" in out
    assert main([str(wrong), str(no)]) == 2
    assert "a name occurs twice" in capsys.readouterr().err
    assert main([str(tmp_path / "missing")]) == 2
    assert "cannot be read" in capsys.readouterr().err
    assert main([]) == 2
    assert main(["--help"]) == 0


def test_it_runs_without_sympy_and_the_rest(tmp_path: Path) -> None:
    file = tmp_path / "certificate.json"
    file.write_text(json.dumps(examples.root()))
    code = (
        "import sys, runpy\n"
        f"sys.argv = ['check', {str(file)!r}]\n"
        "try: runpy.run_module('certificate_checker', run_name='__main__')\n"
        "except SystemExit as end: assert end.code == 0, end.code\n"
        "wrong = ('sympy', 'flowlanes', 'lawproof')\n"
        "print('\\n'.join(m for m in sys.modules if m.split('.')[0] in wrong))\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "".join(done.stdout.splitlines()[1:]) == ""
