"""``chaplygin find`` as a user meets it."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from chaplygin.cli import main
from chaplygin.cli.find import special
from lawproof import search
from lawproof.search import SearchResult, SearchSpace
from nonholonomic.catalogue import from_catalogue

Answer = tuple[int, str, str]
Ask = Callable[..., Answer]


@pytest.fixture
def find(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> Ask:
    """Run the command in an empty folder; exit code, standard output, standard error."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: str) -> Answer:
        with monkeypatch.context() as patched, pytest.raises(SystemExit) as end:
            patched.setattr(sys, "argv", ["chaplygin", "find", *arguments])
            main()
        out, err = capsys.readouterr()
        return int(end.value.code or 0), out, err

    return run


@pytest.mark.slow
def test_integrals_are_printed_as_on_paper(find: Ask) -> None:
    code, out, _ = find("integrals", "chaplygin-ball")
    assert code == 0
    assert "F₁ = (M, γ)\n      proven; repeats area, (7.2)" in out
    assert "F₂ = M²\n      proven; repeats momentum, (7.4)" in out
    assert "F₃ = (M, ω)\n      proven; repeats energy" in out


@pytest.mark.slow
def test_a_condition_on_the_parameters(find: Ask) -> None:
    code, out, _ = find(
        "integrals", "ball-around-sphere", "--at", "k=-1", "--degree", "1", "--gamma-degree", "1"
    )
    assert code == 0
    assert "where k = −1" in out
    assert "proven; repeats linear, (8.3)" in out
    code, out, _ = find("integrals", "ball-around-sphere", "--degree", "1")
    assert code == 1
    assert "none" in out


@pytest.mark.slow
def test_a_measure_with_an_exponent_in_the_parameters(find: Ask) -> None:
    code, out, _ = find("measure", "rubber-ball-on-sphere")
    assert code == 0
    assert "ρ = (γ, A γ)^(1 / (2 k))\n      proven" in out


def test_symmetries(find: Ask) -> None:
    code, out, _ = find(
        "symmetries", "veselova", "--at", "I_1 = I_2", "--degree", "1", "--gamma-degree", "1"
    )
    assert code == 0
    assert "ω ↦ " in out
    assert "γ ↦ (−γ₂, γ₁, 0)" in out or "γ ↦ (γ₂, −γ₁, 0)" in out
    assert "proven" in out


@pytest.mark.parametrize("kind", ["integrals", "measure", "symmetries"])
def test_json(find: Ask, kind: str) -> None:
    code, out, _ = find(kind, "lagrange-top", "--json", "--degree", "1", "--gamma-degree", "1")
    made = json.loads(out)
    assert code == 0
    assert (made["kind"], made["system"], made["complete"]) == (kind, "lagrange-top", True)
    assert made["found"]
    assert {law["verdict"] for law in made["found"]} == {"proven"}


@pytest.mark.slow
def test_a_file_of_the_user(find: Ask, tmp_path: Path) -> None:
    (tmp_path / "body.toml").write_text(
        "[body]\nmass = 1.0\ninertia = [1.0, 1.5, 2.1]\n"
        '[body.shape]\nkind = "ball"\nradius = 1.0\n'
        '[surface]\nkind = "plane"\n[contact]\nmodel = "rubber"\n'
        "[start]\ngamma = [0.0, 0.0, 1.0]\nomega = [0.3, 0.2, 0.0]\n[run]\nuntil = 1.0\n"
    )
    code, out, _ = find("integrals", "body.toml", "--denominator", "1")
    assert code == 0
    assert out.count("proven") == 2
    assert "divided" not in out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("laws", "veselova"), "must be one of integrals, measure, symmetries"),
        (("integrals", "veselova", "--degree", "60"), "GB"),
        (("integrals", "veselova", "--at", "J=1"), "unknown name 'J'"),
        (("integrals", "veselova", "--on", "(M, γ)"), "no vector or tensor 'M'"),
        (("integrals", "veselova", "--on", "γ² = 3"), "is empty"),
        (("measure", "veselova", "--base", "(γ, B γ)"), "no vector or tensor 'B'"),
        (("integrals", "veselovo"), "veselova"),
    ],
)
def test_mistakes_end_with_2(find: Ask, arguments: tuple[str, ...], words: str) -> None:
    code, out, err = find(*arguments)
    assert code == 2
    assert words in err
    assert "Traceback" not in err
    assert not out


@pytest.mark.slow
def test_ctrl_c_keeps_what_is_found(find: Ask, monkeypatch: pytest.MonkeyPatch) -> None:
    original = search.integrals

    def interrupted(question: SearchSpace, progress: Any) -> Iterator[SearchResult]:
        yield next(original(question, progress))
        raise KeyboardInterrupt

    monkeypatch.setattr(search, "SEARCHES", {"integrals": interrupted})
    code, out, err = find("integrals", "chaplygin-ball")
    assert code == 130
    assert "F₁ = (M, γ)" in out
    assert "F₂" not in out
    assert "interrupted" in err
    code, out, _ = find("integrals", "chaplygin-ball", "--json")
    assert json.loads(out)["complete"] is False


@pytest.mark.slow
def test_a_proof_out_of_reach_is_said_so(find: Ask) -> None:
    code, out, _ = find("integrals", "rubber-chaplygin-ball", "--effort", "1e-9")
    assert code == 0
    assert "only observed, undecided" in out


@pytest.mark.slow
def test_conditions_of_a_proof_are_told(find: Ask, monkeypatch: pytest.MonkeyPatch) -> None:
    original = search.integrals

    def where(question: SearchSpace, progress: Any) -> Iterator[SearchResult]:
        for finding in original(question, progress):
            assert finding.verdict is not None
            verdict = replace(finding.verdict, decision="proven where", conditions=("k > 0",))
            yield replace(finding, verdict=verdict)

    monkeypatch.setattr(search, "SEARCHES", {"integrals": where})
    code, out, _ = find("integrals", "chaplygin-ball")
    assert code == 0
    assert "proven where k > 0; repeats" in out
    assert "observed" not in out
    _, out, _ = find("integrals", "chaplygin-ball", "--json")
    found = json.loads(out)["found"]
    assert {f["verdict"] for f in found} == {"proven where"}
    assert all(f["conditions"] == ["k > 0"] for f in found)


@pytest.mark.slow
def test_special_parameters_are_searched_as_they_are(find: Ask) -> None:
    """A body of revolution has a symmetry; for any body there is none."""
    asked = ("symmetries", "chaplygin-ball", "--set", "I_1=1.5", "--degree", "1")
    code, out, err = find(*asked)
    assert code == 0
    assert "where I₁ = I₂" in out
    assert (
        "searched where I_1 = I_2, as the parameters are; --at none searches for arbitrary" in err
    )
    code, out, err = find(*asked, "--at", "none")
    assert code == 1
    assert "where" not in out + err


def test_what_is_special() -> None:
    ball = from_catalogue("chaplygin-ball", I_1=2.0, I_2=2.0, I_3=2.0)
    assert special(ball) == ("I_1 = I_2", "I_1 = I_3")
    assert special(from_catalogue("rattleback")) == ("c_1 = 0", "c_2 = 0")
    assert special(from_catalogue("chaplygin-ball")) == ()


SLEIGH = """
title = "sleigh"
parameters = {m = 1.0, I = 0.7, a = 0.3}
constraints = {velocity = ["v"]}
start = {u = -1.0, omega = 0.05}

[frame]
coordinates = ["x", "y", "phi"]
velocities = ["u", "v", "omega"]
rates = {x = "u*cos(phi) - v*sin(phi)", y = "u*sin(phi) + v*cos(phi)", phi = "omega"}

[lagrangian]
kinetic = "m*(u**2 + (v + a*omega)**2)/2 + I*omega**2/2"
"""


@pytest.mark.slow
def test_a_measure_is_decided_besides_the_search(find: Ask) -> None:
    Path("sleigh.toml").write_text(SLEIGH)
    code, out, _ = find("measure", "sleigh.toml", "--json")
    answer = json.loads(out)
    assert code == 0
    assert answer["existence"]["decision"] == "conditional"
    assert "it exists if and only if a = 0" in answer["existence"]["statement"]
    code, out, _ = find("measure", "rattleback")
    assert code == 1
    found, decided = out.split("\n\n")[1:]
    assert found.strip() == "none of this form"
    assert "has no smooth invariant measure" in decided
    assert max(map(len, out.splitlines())) <= 100


@pytest.mark.slow
def test_without_body_or_mechanism_nothing_is_decided(find: Ask) -> None:
    code, out, _ = find("measure", "suslov", "--json")
    assert code == 1
    assert "existence" not in json.loads(out)


def test_an_equilibrium_excludes_a_measure_of_equations(find: Ask) -> None:
    Path("damped.toml").write_text(
        """
        equations = {state = ["x", "v"], rates = {x = "v", v = "-x - 0.1*v"}}
        start = {x = 1.0, v = 0.0}
        """
    )
    code, out, _ = find("measure", "damped.toml", "--json")
    assert code == 1
    assert "the equilibrium x = 0, v = 0" in json.loads(out)["excluded"]
    assert "no invariant measure has a density" in find("measure", "damped.toml")[1]
