"""Reversible equations."""

from __future__ import annotations

import pytest

from flow.backwards import runs_backwards
from flowlanes.orbits.sign_reversal import reversal
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.fields.budget import EFFORT
from lawproof.proof.prover import prove
from nonholonomic.catalogue import entry
from nonholonomic.classification.classifier import classify_laws
from nonholonomic.classification.facts import ProofBudget


@pytest.mark.parametrize(
    ("name", "flipped"),
    [
        ("rattleback", ["M"]),
        ("unbalanced-rubber-ball", ["omega"]),
        ("chaplygin-sleigh", ["v", "Omega"]),
        ("chaplygin-ball-gyrostat", []),
    ],
)
def test_known_systems(name: str, flipped: list[str]) -> None:
    assert list(map(str, reversal(entry(name).system()))) == flipped


def test_the_prover_agrees() -> None:
    system = entry("chaplygin-sleigh").system()
    chosen = {str(name) for name in reversal(system)}
    signs = {s: -1 for s in system.symbols if str(s) in chosen}
    assert prove(system, runs_backwards(system, signs))
    assert not prove(system, runs_backwards(system, {}))


def test_parities_follow_through_definitions() -> None:
    x, y, f, g = map(real_symbol, "xyfg")
    even = System("even", "Even", {x: y, y: f * g + 1}, definitions={f: y**3, g: x * y})
    assert reversal(even) == (y,)
    mixed = System("mixed", "Mixed", {x: y + 1, y: f}, definitions={f: x + y})
    assert reversal(mixed) == ()


@pytest.mark.slow
def test_what_it_means_is_told() -> None:
    budget = ProofBudget(EFFORT // 10)
    system = entry("rattleback").system()
    standing = classify_laws(system, budget.verdicts(system), budget)
    assert standing.reversal == ("M",)
    assert "to every attracting set there belongs a repelling" in str(standing)
    ball = entry("chaplygin-ball").system()
    assert "repelling" not in str(classify_laws(ball, budget.verdicts(ball), budget))
