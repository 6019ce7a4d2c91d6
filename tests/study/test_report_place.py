"""The section of the report on the hierarchy of dynamics: every law linked to its verdict."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from chaplygin.study.experiment import loads
from chaplygin.study.folder import write_study
from chaplygin.study.prepare import prepare


def report(name: str, folder: Path) -> str:
    """The report of a short motion."""
    made = prepare(loads(f'[system]\nname = "{name}"\n[run]\nuntil = 0.2\nsamples = 5\n'))
    (folder / "figures").mkdir()
    write_study(made, folder, force=True, progress=lambda done: None)
    return (folder / "report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["chaplygin-ball", "rattleback"])
def test_links_lead_to_verdicts(name: str, tmp_path: Path) -> None:
    page = report(name, tmp_path)
    anchors = re.findall(r'<tr id="(law-[^"]+)">.*?class="(\w+)"', page)
    assert len(dict(anchors)) == len(anchors)
    links = set(re.findall(r'href="#(law-[^"]+)"', page))
    assert links
    assert {dict(anchors)[link] for link in links} == {"proven"}


def test_a_level_has_its_own_table(tmp_path: Path) -> None:
    page = report("chaplygin-ball", tmp_path)
    assert "Place in the hierarchy of dynamics" in page
    assert "On (M, γ) = 0" in page
    assert page.count('class="facts place"') == 2
    assert "integrable by Euler and Jacobi" in page
