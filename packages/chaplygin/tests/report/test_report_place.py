"""The section of the report on the hierarchy of dynamics: every law linked to its verdict."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache

import pytest

from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from chaplygin.report.study_output import write_study
from spread import spread


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], str]:
    """The report of a short motion, by the name of its system."""

    @cache
    def page(name: str) -> str:
        folder = tmp_path_factory.mktemp(name)
        made = Study.from_experiment(
            parse_experiment(f'[system]\nname = "{name}"\n[run]\nuntil = 0.2\nsamples = 5\n')
        )
        (folder / "figures").mkdir()
        write_study(made, folder, force=True)
        return (folder / "report.html").read_text(encoding="utf-8")

    return page


@pytest.mark.slow
@pytest.mark.parametrize("name", spread(["chaplygin-ball", "rattleback"]))
def test_links_lead_to_verdicts(name: str, report: Callable[[str], str]) -> None:
    page = report(name)
    anchors = re.findall(r'<tr id="(law-[^"]+)">.*?class="(\w+)"', page)
    assert len(dict(anchors)) == len(anchors)
    links = set(re.findall(r'href="#(law-[^"]+)"', page))
    assert links
    assert {dict(anchors)[link] for link in links} == {"proven"}


@pytest.mark.slow
def test_a_level_has_its_own_table(report: Callable[[str], str]) -> None:
    page = report("chaplygin-ball")
    assert "Place in the hierarchy of dynamics" in page
    assert "On (M, γ) = 0" in page
    assert page.count('class="facts place"') == 2
    assert "integrable by Euler and Jacobi" in page
