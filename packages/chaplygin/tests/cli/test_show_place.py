"""``chaplygin show`` ends with the place in the hierarchy of dynamics."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from chaplygin.cli import main

EXAMPLES = Path(__file__).parents[4] / "examples"


def shown(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *arguments: object
) -> str:
    """What `show` prints."""
    monkeypatch.setattr(sys, "argv", ["chaplygin", "show", *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        main()
    assert not end.value.code
    return capsys.readouterr().out


def test_text_ends_with_the_place(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    before, _, after = shown(monkeypatch, capsys, "veselova").partition(
        "Place in the hierarchy of dynamics\n"
    )
    assert "Source:" in before
    assert "integrable by Euler and Jacobi" in after
    assert "No attracting sets" in after


def test_other_forms_do_not(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for form in ("latex", "julia", "toml"):
        assert "hierarchy" not in shown(monkeypatch, capsys, "veselova", "--as", form)


def test_json_holds_it(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    standing = json.loads(shown(monkeypatch, capsys, "veselova", "--json"))["place"]
    assert (standing["dimension"], standing["count"], standing["remaining"]) == (4, 2, 2)
    assert standing["kinds"][0]["name"] == "euler-jacobi"


@pytest.mark.slow
def test_relations_with_angles(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert "4-dimensional" in shown(monkeypatch, capsys, EXAMPLES / "trailer.toml")
    assert "3-dimensional" in shown(monkeypatch, capsys, EXAMPLES / "driven_pendulum.toml")
