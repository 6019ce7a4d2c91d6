"""Kept verdicts: found again only for the same question, and worth what they cost."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from flowlanes.files import cache as core_cache
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Integral
from flowlanes.system.system import Guard, Parameter, System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from lawproof.proof.verdict_cache import fingerprint, load_verdict, store_verdict
from nonholonomic.catalogue import entry

x, p, k = real_symbol("x"), real_symbol("p"), real_symbol("k")
ENERGY = Integral("energy", p**2 / 2 + k * x**2 / 2)
OSCILLATOR = System(
    "oscillator",
    "Oscillator",
    {x: p, p: -k * x},
    parameters=(Parameter(k, "stiffness", 2.0),),
    laws=(ENERGY,),
)


@pytest.fixture(autouse=True)
def empty(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A place of the test's own, with nothing kept."""
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path))


def with_parameter(**changes: Any) -> System:
    """The oscillator with another parameter."""
    return replace(OSCILLATOR, parameters=(replace(OSCILLATOR.parameters[0], **changes),))


OTHER = {
    "default": with_parameter(default=3.0),
    "admissible": with_parameter(admissible=(k > 0,)),
    "another domain": with_parameter(admissible=(k >= 0,)),
    "guard": replace(OSCILLATOR, guards=(Guard("out", 1 - x, "it is out"),)),
    "guard that may be passed": replace(
        OSCILLATOR, guards=(Guard("out", 1 - x, "it is out", lift_off=True),)
    ),
    "field": replace(OSCILLATOR, field={x: p, p: -x}),
    "relation": replace(OSCILLATOR, relations=(x - p,)),
}
SAME = {
    "unit": with_parameter(unit="N/m"),
    "meaning": with_parameter(meaning="constant of the spring"),
    "title": replace(OSCILLATOR, title="A spring"),
}


def test_whatever_a_proof_may_depend_on_makes_another_name() -> None:
    names = [fingerprint(system, ENERGY) for system in (OSCILLATOR, *OTHER.values())]
    assert len(set(names)) == len(OTHER) + 1


@pytest.mark.parametrize("what", SAME)
def test_what_is_for_the_reader_does_not(what: str) -> None:
    assert fingerprint(SAME[what], ENERGY) == fingerprint(OSCILLATOR, ENERGY)


@pytest.mark.parametrize("what", OTHER)
def test_the_target_of_an_isomorphism_counts_as_much(what: str) -> None:
    def onto(target: System) -> str:
        return fingerprint(OSCILLATOR, Isomorphism("same", target, {x: x, p: p}))

    assert onto(OTHER[what]) != onto(OSCILLATOR)


def test_another_program_makes_another_name(monkeypatch: pytest.MonkeyPatch) -> None:
    before = fingerprint(OSCILLATOR, ENERGY)
    monkeypatch.setattr(core_cache, "computation_digest", lambda: "mended")
    assert fingerprint(OSCILLATOR, ENERGY) != before


# --- effort --------------------------------------------------------------------------------

DISK = entry("rubber-disk").system()


def outcome(verdict: Verdict) -> Verdict:
    """A verdict but for the time it took."""
    return replace(verdict, seconds=0.0)


def efforts() -> tuple[int, ...]:
    """Some that are too small, just too small, just enough and more than enough."""
    needed = prove(DISK, "spin").effort
    return (1, needed // 2, needed - 1, needed, needed + 1, 10 * needed)


@pytest.mark.slow
def test_what_is_kept_changes_no_verdict(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    allowed = efforts()
    alone = []
    for number, effort in enumerate(allowed):
        monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path / f"cold {number}"))
        alone.append(outcome(prove(DISK, "spin", effort=effort)))
    assert alone[0].decision == "undecided"
    assert [bool(verdict) for verdict in alone] == [False] * 3 + [True] * 3
    for order in (range(6), reversed(range(6))):
        monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path / f"warm {order}"))
        for number in order:
            assert outcome(prove(DISK, "spin", effort=allowed[number])) == alone[number]


@pytest.mark.slow
def test_effort_is_the_same_whatever_was_proven_before(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    costs = []
    for order in (DISK.laws[:2], DISK.laws[1::-1]):
        monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path / order[0].name))
        costs.append({law.name: prove(DISK, law).effort for law in order})
    assert costs[0] == costs[1]
    assert all(costs[0].values())


def test_a_failed_attempt_is_not_repeated_and_does_not_stand_in_the_way() -> None:
    few = prove(DISK, "spin", effort=1000)
    assert few.decision == "undecided"
    name = fingerprint(DISK, next(law for law in DISK.laws if law.name == "spin"))
    assert load_verdict(name, 1000) == few
    assert load_verdict(name, 999) is None
    assert load_verdict(name, 1001) is None
    assert prove(DISK, "spin")
    assert load_verdict(name, 1000) == few
    assert load_verdict(name, 1001) is None


def test_what_little_effort_led_to_is_not_taken_for_what_more_leads_to() -> None:
    partly = Verdict("law", "proven where", conditions=("x > 0",), effort=50)
    store_verdict("name", partly, 50)
    assert load_verdict("name", 50) == partly
    assert load_verdict("name", 51) is None
    assert load_verdict("name", 49) is None
    wholly = Verdict("law", "proven", effort=70)
    store_verdict("name", wholly, 100)
    assert [load_verdict("name", effort) for effort in (50, 70, 71, 100, 10**9)] == [
        partly,
        None,
        wholly,
        wholly,
        wholly,
    ]
    assert load_verdict("name") == wholly


def test_what_cannot_be_read_is_not_there(tmp_path: Path) -> None:
    store_verdict("name", Verdict("law", "proven", effort=1), 2)
    assert load_verdict("name", 2)
    (path,) = tmp_path.iterdir()
    path.write_text("{")
    assert load_verdict("name", 2) is None
