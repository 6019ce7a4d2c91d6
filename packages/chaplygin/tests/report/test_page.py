"""The page of a report: what stands on it, and how it is set."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

from chaplygin.experiment.models.experiment import load_experiment, parse_experiment
from chaplygin.experiment.study import Study
from chaplygin.report.page import _legend
from chaplygin.report.study_output import write_study

EXAMPLES = Path(__file__).parents[4] / "examples"


#: A mechanism, and a body that takes many seconds.
BOTH = ["sleigh.toml", pytest.param("heavy-disk", marks=pytest.mark.slow)]


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], str]:
    """The report of a short motion; proofs are given up at once."""

    @cache
    def made(name: str) -> str:
        folder = tmp_path_factory.mktemp("report")
        (folder / "figures").mkdir()
        short = ["run.until=0.2", "run.samples=5"]
        if name.endswith(".toml"):
            experiment = load_experiment(EXAMPLES / name, short)
        else:
            experiment = parse_experiment(f'[system]\nname = "{name}"\n', "x", short)
        write_study(Study.from_experiment(experiment), folder, force=True, total_budget=0)
        return (folder / "report.html").read_text(encoding="utf-8")

    return made


@pytest.mark.slow
@pytest.mark.parametrize("name", BOTH)
def test_contents_lead_to_headings(name: str, page: Callable[[str], str]) -> None:
    text = page(name)
    links = re.findall(r'<li><a href="#([\w-]+)">', text)
    assert links[:3] == ["equations", "motion", "constant"]
    assert set(links) <= set(re.findall(r'<h2 id="([\w-]+)"', text))


@pytest.mark.slow
def test_the_start_is_a_table(page: Callable[[str], str]) -> None:
    (table,) = re.findall(r'<table id="start">.*?</table>', page("sleigh.toml"), re.S)
    rows = re.findall(r'<td class="number">(.*?)</td><td>(.*?)</td><td>(.*?)</td>', table)
    assert rows == [
        ("0.4", "rad", "heading"),
        ("−1", "m/s", "velocity along the blade"),
        ("0.05", "rad/s", "angular velocity"),
    ]


@pytest.mark.slow
def test_a_mechanism_is_drawn(page: Callable[[str], str]) -> None:
    assert 'id="plan_view"' in page("sleigh.toml")


@pytest.mark.slow
def test_a_body_has_its_attitude_and_the_friction_it_needs(page: Callable[[str], str]) -> None:
    body = page("heavy-disk")
    for name in ("attitude", "normal_force", "friction_ratio"):
        assert f'id="{name}"' in body
    assert "m/s²" in body[: body.index("<nav>")]
    (vectors,) = re.findall('<table id="start">.*?</table>', body, re.S)
    assert "rad/s" in vectors and "angular velocity" in vectors


@pytest.mark.parametrize("name", BOTH)
def test_numbers_and_letters_are_set_alike(name: str, page: Callable[[str], str]) -> None:
    parts = ("style", "svg", "pre", "script")
    text = re.sub("|".join(f"<{p}.*?</{p}>" for p in parts), "", page(name), flags=re.S)
    words = re.sub(r"<[^>]*>", " ", text)
    assert not re.search(r"\d[eE][+-]?\d", words)
    assert not re.search(r"(?<![\w)])-\d", words)
    assert not re.search(r"\w\^\d", words)
    assert "\N{GREEK PHI SYMBOL}" not in text and "03D5" not in text
    assert not re.search(r"\+\s*[−-]", words)


def test_every_figure_is_there_for_wide_and_narrow_screens(page: Callable[[str], str]) -> None:
    text = page("sleigh.toml")
    assert text.count("on-wide") - text.count(".on-wide") == text.count("<figure")
    # one more has the shapes of the letters
    assert text.count("<svg") == 2 * text.count("<figure") + 1
    assert "prefers-color-scheme: dark" in text
    # the style sheet gives each colour that figures leave to it
    dark = text[text.index("prefers-color-scheme: dark") :]
    for name in set(re.findall(r"var\(--(curve-\w+|ink|paper|faint|quiet)", dark)):
        assert f"--{name}:" in dark


def test_what_is_wider_than_the_line_says_how_wide(page: Callable[[str], str]) -> None:
    widths = [
        int(w)
        for w in re.findall(
            r'<math displaystyle="true" style="--width: (\d+)"', page("sleigh.toml")
        )
    ]
    assert widths and all(width > 0 for width in widths)


def test_letters_stand_one_below_the_other() -> None:
    shown = _legend("In body axes: M momentum; r arm; slip: velocity; E is the unit tensor.")
    assert shown["words"] == "In body axes: "
    assert shown["letters"] == ["M momentum", "r arm", "slip: velocity", "E is the unit tensor"]
    assert _legend("The state: γ vertical.") == {"words": "The state: γ vertical.", "letters": []}
    assert _legend("") == {}
