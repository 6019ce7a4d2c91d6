"""The site as a reader meets it: built by `make site`, opened from its folder in Chromium."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from browser import Opened, browsers

pytestmark = pytest.mark.browser

SITE = Path(__file__).parents[2] / "build" / "site"

#: Texts whose contrast with what is behind them is below that of WCAG AA.
PALE = """
() => {
  const channels = (text) => text.match(/[\\d.]+/g).map(Number);
  const light = (c) => {
    const [r, g, b] = c.slice(0, 3).map((v) => (v / 255 <= 0.04045 ? v / 3294.6 : ((v / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const behind = (element) => {
    for (let e = element; e !== null; e = e.parentElement) {
      const c = channels(getComputedStyle(e).backgroundColor);
      if (c.length < 4 || c[3] > 0.5) return c;
    }
    return matchMedia("(prefers-color-scheme: dark)").matches ? [0, 0, 0] : [255, 255, 255];
  };
  const found = new Set();
  const walker = document.createTreeWalker(document.querySelector("main") ?? document.body, NodeFilter.SHOW_TEXT);
  for (let node; (node = walker.nextNode()); ) {
    const element = node.parentElement;
    if (node.textContent.trim() === "" || !element.checkVisibility({ opacityProperty: true, visibilityProperty: true })) continue;
    const style = getComputedStyle(element);
    const [a, b] = [light(channels(style.color)), light(behind(element))];
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    const large = parseFloat(style.fontSize) >= 24 || (parseFloat(style.fontSize) >= 18.66 && style.fontWeight >= 700);
    if (ratio < (large ? 3 : 4.5)) found.add(`${element.tagName}.${element.className} ${style.color} ${ratio.toFixed(2)}: ${node.textContent.trim().slice(0, 40)}`);
  }
  return [...found];
}
"""  # noqa: E501

LOOKS = {
    "light": {"color_scheme": "light", "viewport": {"width": 1280, "height": 900}},
    "dark": {"color_scheme": "dark", "viewport": {"width": 1280, "height": 900}},
    "phone": {"color_scheme": "light", "viewport": {"width": 390, "height": 844}},
}


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    if not (SITE / "index.html").exists():
        pytest.skip("there is no site: make site builds it")
    with browsers() as launch:
        browser = launch()
        yield browser
        browser.close()


def pages() -> list[Path]:
    """One page of each folder, and all of those without many like them."""
    found = [path for path in sorted(SITE.rglob("*.html")) if "_static" not in path.parts]
    many = [
        path
        for path in found
        if path.parent.name in ("systems", "experiments", "live")
        or path.parent.parent.name == "reference"
    ]
    return [*(path for path in found if path not in many), *many[::8]]


@pytest.mark.campaign
@pytest.mark.parametrize("look", LOOKS)
def test_every_page_is_its_own_and_readable(chromium: Any, look: str) -> None:
    faults: dict[str, list[str]] = {}
    for path in pages():
        shown = Opened(chromium, path, **LOOKS[look])
        shown.page.wait_for_timeout(150)
        wrong = [
            url for url in shown.requests if not url.startswith(("file:", "blob:", "data:"))
        ] + shown.complaints
        wrong += shown.page.evaluate(
            "() => [...document.images].filter((i) => !i.alt.trim()).map((i) => `no words: ${i.src}`)"  # noqa: E501
        )
        wide = shown.page.evaluate("document.documentElement.scrollWidth")
        if wide > LOOKS[look]["viewport"]["width"] + 1:
            wrong.append(f"{wide} pixels wide")
        if path.parent.name != "live":
            wrong += shown.page.evaluate(PALE)
        if wrong:
            faults[path.relative_to(SITE).as_posix()] = wrong
        shown.context.close()
    assert faults == {}


@pytest.mark.campaign
def test_the_search_finds_a_word(chromium: Any) -> None:
    shown = Opened(chromium, SITE / "index.html")
    shown.page.goto((SITE / "search.html").as_uri() + "?q=rattleback")
    shown.page.wait_for_selector("#search-results li a")
    assert shown.page.locator("#search-results li a").count() > 3


@pytest.mark.campaign
def test_filters_choose_claims_and_systems(chromium: Any) -> None:
    shown = Opened(chromium, SITE / "audit" / "index.html").page
    every = shown.locator("#claims > li:visible").count()
    shown.select_option("select[name=printed]", "refuted")
    refuted = shown.locator("#claims > li:visible").count()
    assert 0 < refuted < every
    assert shown.locator("form.filter output").inner_text() == f"{refuted} of {every}"
    shown.fill("input[name=words]", "no claim has these words")
    assert shown.locator("#claims > li:visible").count() == 0
