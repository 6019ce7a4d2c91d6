"""The precision that a file asks for."""

from __future__ import annotations

import sys

import pytest

import chaplygin as ch


def test_without_heyoka_the_sentence_names_the_key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "heyoka", None)
    study = ch.Study.from_experiment(
        ch.parse_experiment('[system]\nname = "veselova"\n[run]\nuntil = 1\nprecision = "quad"\n')
    )
    with pytest.raises(ch.InputError, match=r"line 5, run\.precision: precision 'quad'"):
        study.trajectory()
