"""What is said of a system depends neither on what is kept on disk nor on what ran before."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from chaplygin.cli import main
from lawproof.proof.prover import prove, prove_all
from nonholonomic.catalogue import CATALOGUE, entry

Say = Callable[..., str]

#: Of every kind: laws that show has no effort for, isomorphisms, mechanisms, absent measures.
SAMPLE = sorted({*list(CATALOGUE)[3::16], "rubber-disk", "rattleback"})


@pytest.fixture
def say(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Say:
    """What a command prints, run in a folder of the test's own."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: str) -> str:
        monkeypatch.setattr(sys, "argv", ["chaplygin", *arguments])
        with pytest.raises(SystemExit):
            main()
        return capsys.readouterr().out

    return run


@pytest.mark.slow
@pytest.mark.parametrize("name", SAMPLE)
def test_show_says_the_same_cold_warm_and_after_proofs(
    say: Say, name: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path / "empty"))
    cold = say("show", name)
    assert say("show", name) == cold
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path / "after proofs"))
    prove_all(entry(name).system())
    assert say("show", name) == cold
    assert say("show", name, "--json") == say("show", name, "--json")


@pytest.mark.slow
def test_show_says_what_it_has_no_effort_for(
    say: Say, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path / "cache"))
    assert prove(entry("rubber-disk").system(), "measure")
    sentence = " ".join(say("show", "rubber-disk").split())
    assert "measure: undecided: not decided with an effort of " in sentence
    assert "No invariant measure is proven (measure is undecided" in sentence
    assert "chaplygin prove rubber-disk" in sentence
    assert "chaplygin prove" not in say("show", "veselova")


@pytest.mark.slow
def test_a_report_says_the_same_cold_warm_and_after_proofs(
    say: Say, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def verdicts(folder: str) -> str:
        say("study", "veselova", "-o", folder, "--set", "run.until=0.5")
        page = (tmp_path / folder / "report.html").read_text()
        laws = re.findall(r'<tr id="law-.*?</tr>', page, re.DOTALL)
        (place,) = re.findall(r'<h2 id="place">.*?<h2', page, re.DOTALL)
        assert laws
        return "\n".join((*laws, place))

    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path / "empty"))
    cold = verdicts("cold")
    assert verdicts("warm") == cold
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path / "after proofs"))
    prove_all(entry("veselova").system())
    assert verdicts("after") == cold
