"""Numbers of a working precision."""

from __future__ import annotations

import sys

import pytest

from flowlanes.flow.taylor.working_numbers import PrecisionError, number_type


def test_doubles_need_nothing() -> None:
    assert number_type("double") is float


def test_without_heyoka_34_digits_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "heyoka", None)
    with pytest.raises(PrecisionError, match=r"install flowlanes\[taylor\], or use method 'gauss'"):
        number_type("quad")
