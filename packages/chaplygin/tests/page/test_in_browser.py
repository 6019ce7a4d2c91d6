"""Pages in headless Chromium, without a network: they play, compute, print, and ask nobody."""

from __future__ import annotations

import io
import threading
from collections.abc import Callable, Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from PIL import Image

from browser import Opened, browsers
from chaplygin.experiment.contact.mode_intervals import mode_intervals
from chaplygin.experiment.models.experiment import load_experiment, parse_experiment
from chaplygin.experiment.study import Study, dataset_of
from chaplygin.page.element import page
from chaplygin.page.study_page import study_model
from chaplygin.report.drawing.modes import MODE_STYLES
from chaplygin.report.study_output import write_study

pytestmark = pytest.mark.browser

EXAMPLES = Path(__file__).parents[4] / "examples"


@pytest.fixture(scope="module")
def launch() -> Iterator[Callable[..., Any]]:
    with browsers() as started:
        yield started


@pytest.fixture(scope="module")
def chromium(launch: Callable[..., Any]) -> Any:
    return launch()


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report of the rattleback, without proofs."""
    folder = tmp_path_factory.mktemp("report")
    (folder / "figures").mkdir()
    study = Study.from_experiment(load_experiment(EXAMPLES / "rattleback.toml"))
    write_study(study, folder, force=True, total_budget=0)
    return folder / "report.html"


def page_of(study: Study, folder: Path) -> Path:
    path = folder / "page.html"
    path.write_text(page(study_model(study, dataset_of(study, study.trajectory()))), "utf-8")
    return path


@pytest.mark.parametrize("name", ["rattleback", "coin", "ball_in_a_bowl", "tippe_top"])
def test_the_body_is_where_the_trajectory_says(name: str, chromium: Any, tmp_path: Path) -> None:
    study = Study.from_experiment(
        load_experiment(EXAMPLES / f"{name}.toml", ["run.until=2", "run.samples=41"])
    )
    dataset = dataset_of(study, study.trajectory())
    opened = Opened(chromium, page_of(study, tmp_path)).ready()
    for index in (0, 7, 20, 33, 40):
        time = float(dataset["time"][index])
        pose = opened.page.evaluate(
            "t => (window.chaplygin.seek(t), window.chaplygin.pose())", time
        )
        assert pose["t"] == pytest.approx(time, abs=1e-12)
        for key in ("centre", "contact"):
            assert pose[key] == pytest.approx(dataset[key].values[index].tolist(), abs=1e-9)
        attitude = np.array(pose["attitude"])
        assert abs(attitude @ dataset["attitude"].values[index]) == pytest.approx(1.0, abs=1e-12)
    assert opened.strangers == []
    assert opened.complaints == []


def test_a_page_computes_motions_sections_and_laws(chromium: Any, tmp_path: Path) -> None:
    text = 'system = {name = "unbalanced-ball"}\nrun = {until = 10.0, samples = 21}\n'
    study = Study.from_experiment(parse_experiment(text))
    opened = Opened(chromium, page_of(study, tmp_path)).ready()
    run = opened.page.evaluate
    motion = run("() => window.chaplygin.motion(10, 21)")
    dataset = dataset_of(study, study.trajectory())
    gamma = np.array(motion["gamma"]).reshape(-1, 3)
    assert np.allclose(gamma, dataset["gamma"].values, rtol=0, atol=1e-10)
    # a changed start changes the motion, and the laws hold along it as well
    usual = next(p.default for p in study.system.parameters if str(p.symbol) == "c_3")
    run("c => window.chaplygin.set({parameters: {c_3: c}})", 0.5 * usual)
    changed = run("() => window.chaplygin.motion(10, 21)")
    assert np.abs(np.array(changed["gamma"]).reshape(-1, 3) - gamma).max() > 1e-3
    energy = next(law for law in run("() => window.chaplygin.laws()") if law["name"] == "energy")
    assert abs(energy["drift"]) < 1e-9
    names = [str(symbol) for symbol in study.system.symbols]
    rows = run("() => window.chaplygin.section({on: 'gamma_1', direction: 1, points: 20})")
    assert len(rows) == 20
    assert max(abs(row[names.index("gamma_1")]) for row in rows) < 1e-9
    assert opened.strangers == []


#: The colour of the bar under the first plot, in the middle of a stretch of time.
UNDER_THE_PLOT = """
(share) => {
  const plot = document.querySelector(".lab-plot .uplot");
  const [over, canvas] = [plot.querySelector(".u-over"), plot.querySelector("canvas")];
  const [inner, outer] = [over, canvas].map((each) => each.getBoundingClientRect());
  const ratio = canvas.width / outer.width;
  const x = (inner.left - outer.left + share * inner.width) * ratio;
  const y = (inner.bottom - outer.top + 7) * ratio;
  const [r, g, b] = canvas.getContext("2d").getImageData(Math.round(x), Math.round(y), 1, 1).data;
  return [r, g, b];
}
"""


def test_a_motion_with_friction_is_coloured_by_mode(chromium: Any, tmp_path: Path) -> None:
    study = Study.from_experiment(
        load_experiment(EXAMPLES / "bouncing_ball.toml", ["run.until=2", "run.samples=101"])
    )
    dataset = dataset_of(study, study.trajectory())
    intervals = mode_intervals(dataset)
    names = {interval.mode for interval in intervals}
    assert names == {"flight", "rolling"}
    opened = Opened(chromium, page_of(study, tmp_path)).ready()
    for key in (".lab-scene .lab-modes", ".lab-deck .lab-modes"):
        words = opened.page.locator(f"{key} > span").all_inner_texts()
        assert words == [mode for mode in MODE_STYLES if mode in names]
    low, high = float(dataset["time"][0]), float(dataset["time"][-1])
    for interval in intervals:
        if interval.end - interval.begin < 0.02 * (high - low):
            continue
        middle = (interval.begin + interval.end) / 2
        opened.page.evaluate("t => window.chaplygin.seek(t)", middle)
        now = opened.page.locator('.lab-deck .lab-modes > [aria-current="true"]')
        assert now.all_inner_texts() == [interval.mode]
        drawn = opened.page.evaluate(UNDER_THE_PLOT, (middle - low) / (high - low))
        colour = np.array(to_rgb(MODE_STYLES[interval.mode].colour)) * 255
        assert np.abs(np.array(drawn) - colour).max() <= 2
    # the path in the scene has the colours of the modes, and none of those of time
    picture = np.array(Image.open(io.BytesIO(opened.page.locator(".lab-canvas").screenshot())))

    def pixels(colour: str) -> int:
        off = picture[..., :3].astype(float) - np.array(to_rgb(colour)) * 255
        return int((np.abs(off).max(axis=-1) < 12).sum())

    assert min(pixels(MODE_STYLES[mode].colour) for mode in names) > 50
    assert pixels("#cf4f5b") == 0
    assert opened.complaints == []


def test_a_report_opens_with_the_scene_and_prints_the_still(chromium: Any, report: Path) -> None:
    opened = Opened(chromium, report).ready()
    still, live = opened.page.locator(".chaplygin-still"), opened.page.locator(".lab-scene canvas")
    assert live.first.is_visible()
    assert not still.is_visible()
    opened.page.emulate_media(media="print")
    assert still.is_visible()
    assert not live.first.is_visible()
    assert opened.strangers == []
    assert opened.complaints == []


@pytest.mark.parametrize("width", [390, 1280, 3840])
def test_a_report_is_never_wider_than_the_screen(width: int, chromium: Any, report: Path) -> None:
    opened = Opened(chromium, report, viewport={"width": width, "height": 900}).ready()
    widest = opened.page.evaluate("() => document.documentElement.scrollWidth")
    assert widest <= width


#: Equations, or their right sides, that are wider than their place: their text, whether they
#: scroll, and how large they are beside the text around.
CUT = """
() => [...document.querySelectorAll('.chaplygin-formula, .chaplygin-formula .right')]
  .filter((each) => each.clientWidth > 0 && each.scrollWidth > each.clientWidth + 1)
  .map((each) => {
    const size = (element) => parseFloat(getComputedStyle(element).fontSize);
    const sizes = [...each.querySelectorAll('math')].map((math) => size(math) / size(each));
    return [each.textContent, getComputedStyle(each).overflowX, Math.min(...sizes)];
  })
"""


@pytest.mark.slow
@pytest.mark.parametrize("width", [390, 1280])
@pytest.mark.parametrize("name", ["tippe_top", "trailer"])
def test_no_equation_is_cut(name: str, width: int, chromium: Any, tmp_path: Path) -> None:
    """On a phone what would be too small to be read scrolls."""
    study = Study.from_experiment(
        load_experiment(EXAMPLES / f"{name}.toml", ["run.until=0.01", "run.samples=11"])
    )
    write_study(study, tmp_path, force=True, total_budget=0)
    opened = Opened(
        chromium, tmp_path / "report.html", viewport={"width": width, "height": 900}
    ).ready()
    assert opened.page.locator(".chaplygin-formula").count() > 2
    wide = opened.page.evaluate(CUT)
    assert not wide or width == 390
    for _, overflow, smallest in wide:
        assert overflow == "auto"
        assert smallest == pytest.approx(0.6, abs=0.01)


def test_the_still_stays_without_javascript(chromium: Any, report: Path) -> None:
    opened = Opened(chromium, report, java_script_enabled=False)
    assert opened.page.locator(".chaplygin-still svg").first.is_visible()


def test_the_still_stays_without_webgl(launch: Callable[..., Any], report: Path) -> None:
    opened = Opened(launch("--disable-3d-apis"), report).ready()
    assert opened.page.locator(".chaplygin-still svg").first.is_visible()


def test_a_report_can_fetch_nothing(chromium: Any, report: Path) -> None:
    asked: list[str] = []

    class Listener(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            asked.append(self.path)
            self.send_response(200)
            self.send_header("Access-Control-Allow-Origin", "*")
            self.end_headers()

        def log_message(self, format: str, *args: object) -> None:
            pass

    with HTTPServer(("127.0.0.1", 0), Listener) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_port}/"
        fetched = "a => fetch(a).then(() => 'fetched', () => 'refused')"
        image = """a => new Promise((resolve) => {
          const picture = new Image();
          picture.onload = picture.onerror = () => resolve("over");
          picture.src = a;
        })"""
        opened = Opened(chromium, report, offline=False)
        assert opened.page.evaluate(fetched, f"{address}fetch") == "refused"
        opened.page.evaluate(image, f"{address}image.png")
        assert asked == []
        # it would have been heard
        free = chromium.new_page()
        free.goto(f"{address}page")
        free.close()
        assert asked[:1] == ["/page"]
        server.shutdown()


def test_the_report_of_a_rattleback_is_small(report: Path) -> None:
    assert report.stat().st_size <= 1_200_000
