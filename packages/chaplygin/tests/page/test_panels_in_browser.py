"""Panels of a page in headless Chromium: diagrams, charts, addresses, keys."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs

import pytest

import chaplygin as ch
from browser import Opened, browsers
from chaplygin.experiment.study import dataset_of
from chaplygin.page.element import page
from chaplygin.page.study_page import study_model
from needs import optional
from page.motions import study_of

pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def open_page(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[..., Opened]]:
    with browsers() as launch:
        chromium = launch()

        def opened(name: str, fragment: str = "", **settings: Any) -> Opened:
            study = study_of(name)
            path = tmp_path_factory.mktemp("page") / "page.html"
            path.write_text(page(study_model(study, dataset_of(study, study.trajectory()))))
            address = f"{path.as_uri()}{fragment}"
            return Opened(chromium, address, offline=True, **settings).ready()

        yield opened


def values(opened: Opened) -> dict[str, float]:
    laws = opened.page.evaluate("() => window.chaplygin.laws()")
    return {law["name"]: law["value"] for law in laws}


def test_a_click_into_a_bifurcation_diagram_shows_a_motion_on_that_torus(
    open_page: Callable[..., Opened],
) -> None:
    opened = open_page("chaplygin-ball")
    before = values(opened)
    opened.page.get_by_role("tab", name="Bifurcation diagram").click()
    sheet = opened.page.locator(".lab-panel-bifurcation .lab-sheet")
    box = sheet.bounding_box()
    place = {"x": 0.3 * box["width"], "y": 0.7 * box["height"]}
    sheet.hover(position=place)
    tip = opened.page.locator(".lab-panel-bifurcation .lab-tip").inner_text()
    energy, area = (float(part.split("= ")[1].replace("−", "-")) for part in tip.split(", "))
    sheet.click(position=place)
    opened.page.wait_for_function("() => location.hash.includes('state=')", timeout=60_000)
    after = values(opened)
    assert (after["energy"], after["area"]) == pytest.approx((energy, area), abs=2e-3)
    assert after["momentum"] == pytest.approx(before["momentum"], rel=1e-12)
    # the closed form knows this motion, with two frequencies
    text = parse_qs(opened.page.url.partition("#lab&")[2])["state"][0]
    state = [float(number) for number in text.split()]
    form = ch.solve(study_of("chaplygin-ball").system, state[:6]).form
    assert form.motion == "two-frequency motion on a torus"
    assert opened.complaints == []


def test_a_chart_over_points_of_a_section_answers_a_click(open_page: Callable[..., Opened]) -> None:
    opened = open_page("unbalanced-ball")
    opened.page.get_by_role("tab", name="Chart").click()
    panel = opened.page.locator(".lab-panel-chart")
    panel.get_by_label("Time up to which each motion is followed").fill("20")
    panel.get_by_label("points", exact=True).select_option("50")
    panel.get_by_role("button", name="Compute").click()
    message = opened.page.locator(".lab-message")
    message.get_by_text("points have a value").wait_for(timeout=300_000)
    assert int(message.inner_text().split()[0]) > 1250
    energy = values(opened)["energy"]
    panel.locator(".lab-sheet").click()
    opened.page.wait_for_function("() => location.hash.includes('state=')", timeout=60_000)
    assert values(opened)["energy"] == pytest.approx(energy, rel=1e-9)
    assert opened.complaints == []


def test_an_address_holds_view_section_and_picture(open_page: Callable[..., Opened]) -> None:
    opened = open_page("unbalanced-ball")
    scene = opened.page.locator(".lab-scene")
    scene.focus()
    for key in ("ArrowLeft", "ArrowLeft", "+", "f"):
        scene.press(key)
    opened.page.get_by_role("tab", name="Section").click()
    opened.page.get_by_label("direction").select_option("-1")
    opened.page.wait_for_function("() => location.hash.includes('section=')")
    fragment = opened.page.evaluate("() => location.hash")
    assert {"view", "section", "show"} <= parse_qs(fragment.removeprefix("#lab&")).keys()
    again = open_page("unbalanced-ball", fragment)
    assert again.page.get_by_role("tab", name="Section").get_attribute("aria-selected") == "true"
    assert again.page.get_by_label("direction").input_value() == "-1"
    again.page.locator(".lab-scene").press("r")
    again.page.wait_for_function("() => !location.hash.includes('view=')")
    assert again.complaints == []


def test_a_slider_moves_a_ball_with_its_surface_and_undo_takes_it_back(
    open_page: Callable[..., Opened],
) -> None:
    opened = open_page("marble-ball-on-ellipsoid")
    field = opened.page.locator(".lab-slider", has_text="a1").get_by_role("textbox")
    before = field.input_value()
    field.fill("2.5")
    field.press("Enter")
    message = opened.page.locator(".lab-message")
    message.get_by_text("the nearest admissible one is taken").wait_for()
    start = opened.page.evaluate("() => (window.chaplygin.seek(0), window.chaplygin.pose().centre)")
    sizes = (2.5, 2.5, 2.0)
    assert sum((x / a) ** 2 for x, a in zip(start, sizes, strict=True)) == pytest.approx(1.0)
    opened.page.keyboard.press("Escape")
    opened.page.locator(".lab-scene").press("Control+z")
    opened.page.wait_for_function("() => !location.hash.includes('p.a_1')")
    assert field.input_value() == before


def test_all_is_reached_and_heard_by_keyboard(open_page: Callable[..., Opened]) -> None:
    opened = open_page("unbalanced-ball", reduced_motion="reduce")
    unnamed = """() => [...document.querySelectorAll(
      '.chaplygin-lab button, .chaplygin-lab input, .chaplygin-lab select, [role=application]')]
      .filter((each) => !(each.getAttribute('aria-label') || each.title || each.innerText.trim()
        || each.labels?.length)).map((each) => each.outerHTML)"""
    assert opened.page.evaluate(unnamed) == []
    assert opened.page.locator(".lab-message").get_attribute("aria-live") == "polite"
    reached: set[str] = set()
    name = "() => document.activeElement.getAttribute('role') || document.activeElement.tagName"
    for _ in range(60):
        opened.page.keyboard.press("Tab")
        reached.add(opened.page.evaluate(name))
    assert {"application", "BUTTON", "SELECT", "INPUT", "tab"} <= reached
    # whoever wants less motion is not played to unasked
    now = "() => window.chaplygin.pose().t"
    assert opened.page.evaluate(now) == 0
    opened.page.locator(".lab-scene").press(" ")
    opened.page.wait_for_function("() => window.chaplygin.pose().t > 0")
    opened.page.locator(".lab-scene").press("Home")
    opened.page.locator(".lab-scene").press(" ")
    opened.page.get_by_role("tab", name="Section").click()
    sheet = opened.page.locator(".lab-panel-section .lab-sheet")
    orbits = opened.page.locator(".lab-panel-section .lab-orbits")
    orbits.get_by_title("1000 points").wait_for(timeout=60_000)
    for key in ("ArrowRight", "ArrowUp", "Enter"):
        sheet.press(key)
    orbits.get_by_role("button").nth(1).wait_for(timeout=60_000)


def test_film_picture_and_model_are_downloaded(
    open_page: Callable[..., Opened], tmp_path: Path
) -> None:
    opened = open_page("rattleback", viewport={"width": 500, "height": 500})
    opened.page.get_by_label("speed").select_option(label="10×")
    opened.page.get_by_role("tab", name="Save").click()
    begins = {"Body in motion": b"glTF", "Picture": b"\x89PNG", "Film": b"ftyp"}
    for name, words in begins.items():
        with opened.page.expect_download(timeout=180_000) as download:
            opened.page.get_by_role("button", name=name, exact=True).click()
        path = tmp_path / download.value.suggested_filename
        download.value.save_as(path)
        assert words in path.read_bytes()[:12]
    av = optional("av")
    with av.open(str(path)) as film:
        frames = list(film.decode(video=0))
    # eight seconds at ten times the speed, thirty frames a second
    assert len(frames) == 24
    assert max(frames[0].width, frames[0].height) == 1280
    assert frames[0].to_ndarray(format="gray").std() > 5.0
    assert opened.complaints == []
