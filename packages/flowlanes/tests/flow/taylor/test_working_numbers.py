"""Numbers of a working precision."""

from __future__ import annotations

import sys

import pytest

from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from flowlanes.errors import InputError
from flowlanes.flow.taylor.working_numbers import PrecisionError, number_type


def test_doubles_need_nothing() -> None:
    assert number_type("double") is float


def test_without_heyoka_34_digits_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "heyoka", None)
    with pytest.raises(PrecisionError, match=r"install flowlanes\[taylor\], or use method 'gauss'"):
        number_type("quad")


def test_the_sentence_names_the_key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "heyoka", None)
    study = Study.from_experiment(
        parse_experiment('[system]\nname = "veselova"\n[run]\nuntil = 1\nprecision = "quad"\n')
    )
    with pytest.raises(InputError, match=r"line 5, run\.precision: precision 'quad'"):
        study.trajectory()
