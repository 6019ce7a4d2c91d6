"""Files that a page gives: the experiment, tables and drawings, as other programs read them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

import chaplygin as ch
from browser import Opened, browsers
from chaplygin.experiment.study import dataset_of
from chaplygin.page.element import page
from chaplygin.page.study_page import study_model
from needs import optional
from page.motions import study_of

pytestmark = pytest.mark.browser

Open = Callable[[str], Opened]
Download = Callable[[Opened, str], Path]


@pytest.fixture(scope="module")
def open_page(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Open]:
    with browsers() as launch:
        chromium = launch()

        def opened(name: str) -> Opened:
            study = study_of(name)
            path = tmp_path_factory.mktemp("page") / "page.html"
            path.write_text(page(study_model(study, dataset_of(study, study.trajectory()))))
            return Opened(chromium, path).ready()

        yield opened


@pytest.fixture
def download(tmp_path: Path) -> Download:
    def downloaded(opened: Opened, button: str) -> Path:
        opened.page.get_by_role("tab", name="Save").click()
        with opened.page.expect_download() as given:
            opened.page.get_by_role("button", name=button, exact=True).click()
        path = tmp_path / given.value.suggested_filename
        given.value.save_as(path)
        return path

    return downloaded


@pytest.mark.parametrize(
    ("name", "parameters", "start"),
    [
        ("unbalanced_ball.toml", {"c_3": 0.25, "I_2": 1.6, "g": 9.0}, {"gamma_2": -0.2}),
        ("rattleback.toml", {"b_2": 0.035, "c_1": 0.001}, {"omega_3": -4.5}),
        ("egg.toml", {"e": 0.2, "m": 0.06}, {"heading": 0.4}),
        ("trailer.toml", {"m": 1.1, "K": 0.25}, {"x": 0.5}),
        ("marble-ball-on-cone", {"b": 0.25}, {"omega_1": 9.0}),
    ],
)
def test_an_experiment_runs_as_the_page_does(
    name: str,
    parameters: dict[str, float],
    start: dict[str, float],
    open_page: Open,
    download: Download,
) -> None:
    opened = open_page(name)
    change = {"parameters": parameters, "start": start}
    opened.page.evaluate("change => window.chaplygin.set(change)", change)
    path = download(opened, "Experiment")
    assert "#" not in path.read_text()
    study = ch.Study.from_experiment(ch.load_experiment(path))
    motion = study.trajectory()
    expected = dataset_of(study, motion)
    samples = expected.sizes["time"]
    found = opened.page.evaluate(
        "([until, samples]) => window.chaplygin.motion(until, samples)", [study.until, samples]
    )
    early = slice(0, max(2, samples // 10))
    for variable in map(str, study.system.state):
        wanted = expected[variable].values.reshape(samples, -1)
        got = np.array(found[variable], float).reshape(samples, -1)
        np.testing.assert_allclose(got[early], wanted[early], rtol=1e-9, atol=1e-9)
    assert opened.complaints == []


def test_tables_and_drawings_are_read_elsewhere(open_page: Open, download: Download) -> None:
    pandas = optional("pandas")
    opened = open_page("unbalanced_ball.toml")
    opened.page.get_by_role("tab", name="Section").click()
    orbits = opened.page.locator(".lab-panel-section .lab-orbits")
    orbits.get_by_title("1000 points").wait_for(timeout=60_000)
    table = pandas.read_csv(download(opened, "Data"))
    motion = opened.page.evaluate("() => window.chaplygin.motion(20, 601)")
    assert table["time (s)"].is_monotonic_increasing
    assert not table.isna().any(axis=None)
    assert table["omega_3 (rad/s)"][0] == motion["omega"][2]
    assert {"gamma_1", "attitude_w", "centre_x (m)"} <= set(table.columns)
    points = pandas.read_csv(download(opened, "Points of the section"))
    assert list(points["orbit"]) == [1] * 1000
    assert len(points.columns) == 3
    space = "{http://www.w3.org/2000/svg}"
    for button in ("Section", "Plots"):
        drawing = ElementTree.parse(download(opened, button)).getroot()
        assert drawing.tag == f"{space}svg"
        assert len(list(drawing.iter(f"{space}text"))) > 5
        assert "NaN" not in ElementTree.tostring(drawing, "unicode")
    assert opened.complaints == []
