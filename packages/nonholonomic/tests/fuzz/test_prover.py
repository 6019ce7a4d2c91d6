"""The prover before planted laws: what it proves is true, what it refutes is not, none crash it."""

from __future__ import annotations

import pytest
from hypothesis import given, settings, strategies as st

from fuzz.campaign import run, tried
from fuzz.judge import GRAVE
from fuzz.planter import FAMILIES, planted_case

COUNT = 300
BLOCK = 500
SECONDS = 10.0


@pytest.fixture(autouse=True)
def forgotten(tmp_path, monkeypatch):
    """Verdicts on planted laws are not kept."""
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path))


def grave(seed, numbers):
    """The cases that went wrong, a line for each."""
    found = list(run(seed, iter(numbers), SECONDS, processes=1))
    assert len(found) == len(numbers)
    assert sum(o.outcome == "right" for o in found) > 0.6 * len(found)
    return [
        f"--seed {seed} --show {o.number}: {o.family}: {o.outcome}: {o.told}"
        for o in found
        if o.outcome in GRAVE
    ]


@pytest.mark.slow
def test_planted_laws_are_judged_rightly():
    assert grave(1, range(COUNT)) == []


@pytest.mark.slow
@pytest.mark.parametrize("block", range(10))
def test_thousands_of_planted_laws_are_judged_rightly(block):
    assert grave(2, range(block * BLOCK, (block + 1) * BLOCK)) == []


@pytest.mark.slow
@settings(max_examples=len(FAMILIES))
@given(st.integers(3, 10**6), st.integers(0, 10**4))
def test_laws_planted_from_any_seed_are_judged_rightly(seed, number):
    outcome, told = tried(planted_case(seed, number))
    assert outcome not in GRAVE, told
