"""Speed of pages in headless Chromium: opening, a slider, a click into a section, frames.

WebGL is rendered in software, as on a machine without a graphics card.  With `--peers PYTHON`, an
interpreter with viser and NiceGUI, the same motion is played in their scenes alternately with
ours; a server sends them each pose 60 times a second.  With `--chart`, also MEGNO for 200 x 200
starts to t = 100, in the page and by native code on all processors.
"""

from __future__ import annotations

import argparse
import json
import math
import shutil
import socket
import subprocess
import tempfile
import time
from pathlib import Path
from statistics import median

import numpy as np
from playwright.sync_api import Browser, Page, sync_playwright

from chaplygin import Study, parse_experiment
from chaplygin.experiment.friction_studies.chart_task import chart_task
from chaplygin.experiment.study import dataset_of
from chaplygin.page.element import page
from chaplygin.page.page_model import live_page_model
from chaplygin.page.study_page import study_model
from flowlanes.scans.grid import Axis

SYSTEMS = ("unbalanced-ball", "rattleback", "marble-ball-on-torus", "heavy-disk")
NAMES = ("chromium", "chromium-browser", "google-chrome")
BY_SOFTWARE = "--no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader"
HERE = Path(__file__).parent
SECONDS = 5.0
SIZE, UNTIL = 200, 100.0


def opened(chromium: Browser, address: str) -> Page:
    view = chromium.new_page(viewport={"width": 1280, "height": 900})
    view.add_init_script(path=HERE / "page_times.js")
    view.goto(address)
    return view


def clicks(view: Page, count: int) -> list[float]:
    """Milliseconds from each click into the section to its thousand points.

    NaN where the motion has not crossed the section often enough after 20 s; some motions never
    do.
    """
    view.get_by_role("tab", name="Section").click()
    view.wait_for_timeout(3000)
    sheet = view.locator(".lab-panel-section .lab-sheet")
    box = sheet.bounding_box()
    if box is None:
        raise RuntimeError("the page shows no section")
    spent = []
    for angle in 2.4 * np.arange(count):
        x, y = 0.5 + 0.15 * np.cos(angle), 0.5 + 0.15 * np.sin(angle)
        view.evaluate("times.click()")
        sheet.click(position={"x": x * box["width"], "y": y * box["height"]})
        spent.append(float(view.evaluate("times.clicked")))
        view.wait_for_timeout(400)
    return spent


def chart_seconds(view: Page, x: str, y: str) -> float:
    """Seconds for a chart of starts in the page."""
    view.get_by_role("tab", name="Chart").click()
    tools = view.get_by_role("toolbar", name="Chart")
    for label, chosen in (("across", x), ("up", y), ("points", str(SIZE))):
        tools.get_by_label(label, exact=True).select_option(chosen)
    time_field = tools.get_by_role("textbox")
    time_field.fill(str(UNTIL))
    time_field.press("Tab")
    view.wait_for_timeout(3000)
    tools.get_by_role("button", name="Compute").click()
    words = view.get_by_text("computed in").first
    words.wait_for(timeout=18e5)
    return float(words.inner_text().partition("computed in ")[2].split()[0])


def native_chart_seconds(study: Study, x: str, y: str) -> float:
    """Seconds for the same chart by native code."""
    inputs = {row["name"]: row for row in live_page_model(study)["start_inputs"]}
    axes = [Axis(n, inputs[n]["low"], inputs[n]["high"], SIZE) for n in (x, y)]
    task, _ = chart_task(study, "megno", *axes, t_end=UNTIL)
    task.work(0, 2)
    began = time.perf_counter()
    for block in range(task.blocks):
        task.work(*task.members(block))
    return time.perf_counter() - began


def peer_frames(chromium: Browser, python: str, peer: str, poses: Path) -> float:
    """Frames per second of a motion in the scene of another program."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = [python, HERE / "contest" / "scenes.py", peer, poses, str(port)]
    quiet = subprocess.DEVNULL
    with subprocess.Popen(command, stdout=quiet, stderr=quiet) as server:
        try:
            for _ in range(100):
                with socket.socket() as trial:
                    if trial.connect_ex(("127.0.0.1", port)) == 0:
                        break
                time.sleep(0.2)
            view = opened(chromium, f"http://127.0.0.1:{port}")
            view.wait_for_selector("canvas")
            view.wait_for_timeout(4000)
            rate = float(view.evaluate("seconds => times.frames(seconds)", SECONDS))
            view.close()
            return rate
        finally:
            server.terminate()


def row(
    chromium: Browser, name: str, count: int, peers: str | None, chart: bool, folder: Path
) -> dict[str, object]:
    study = Study.from_experiment(parse_experiment(f'system = {{name = "{name}"}}'))
    motion = dataset_of(study, study.trajectory())
    path = folder / f"{name}.html"
    path.write_text(page(study_model(study, motion)))
    openings = []
    for _ in range(3):
        view = opened(chromium, path.as_uri())
        openings.append(view.evaluate("times.opening()"))
        view.close()
    paint, ready = np.median(openings, axis=0)
    view = opened(chromium, path.as_uri())
    view.evaluate("times.opening()")
    # the first move compiles the programs of the graphics card
    slider = median(view.evaluate("count => times.slider(count)", count)[1:])
    spent = clicks(view, count)
    returned = [time for time in spent if math.isfinite(time)]
    view.close()
    view = opened(chromium, path.as_uri())
    view.evaluate("times.opening()")
    view.locator(".lab-play").click()
    rates = {"chaplygin": float(view.evaluate("seconds => times.frames(seconds)", SECONDS))}
    view.close()
    if peers is not None:
        poses = folder / f"{name}.npz"
        np.savez(poses, attitude=motion["attitude"], centre=motion["centre"])
        rates |= {peer: peer_frames(chromium, peers, peer, poses) for peer in ("viser", "nicegui")}
    charts = {}
    if chart:
        view = opened(chromium, path.as_uri())
        view.evaluate("times.opening()")
        x, y = "omega_1", "omega_3"
        charts["chart_s"] = chart_seconds(view, x, y)
        view.close()
        charts["native_chart_s"] = native_chart_seconds(study, x, y)
    return {
        "system": name,
        "first_paint_ms": float(paint),
        "ready_ms": float(ready),
        "slider_ms": slider,
        "click_ms": median(returned) if returned else math.nan,
        "clicks_without_return": count - len(returned),
        "frames_per_second": rates,
        **charts,
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--quick", action="store_true", help="the first system alone")
    parser.add_argument("--peers", metavar="PYTHON", help="an interpreter with viser and NiceGUI")
    parser.add_argument("--chart", action="store_true", help="a chart too, which takes minutes")
    options = parser.parse_args()
    place = next(filter(None, map(shutil.which, NAMES)), None)
    if place is None:
        parser.error("there is no Chromium on this machine")
    rows = []
    with sync_playwright() as started, tempfile.TemporaryDirectory() as folder:
        chromium = started.chromium.launch(executable_path=place, args=BY_SOFTWARE.split())
        for name in SYSTEMS[: 1 if options.quick else None]:
            one = row(chromium, name, 12, options.peers, options.chart, Path(folder))
            rows.append(one)
            if not options.json:
                print(", ".join(f"{key} {value}" for key, value in one.items()), flush=True)
    if options.json:
        print(json.dumps(rows))


if __name__ == "__main__":
    main()
