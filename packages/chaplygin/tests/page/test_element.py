"""The page of a system: all in one file, nothing in it can end a script, nothing is fetched."""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
import re
from html.parser import HTMLParser

from chaplygin.page.element import element, front_end, page

HOSTILE = "</script><img src=x onerror=alert(1)>&<!--<script>"
MODEL = {"title": HOSTILE, "wasm": None, "recorded": None, "experiment": HOSTILE}


class Tags(HTMLParser):
    """The tags of a page, and the texts of its scripts."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.tags: list[str] = []
        self.attributes: list[tuple[str, str | None]] = []
        self.texts: dict[str, str] = {}

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.attributes += attributes

    def handle_data(self, data: str) -> None:
        if self.tags:
            self.texts[self.tags[-1]] = self.texts.get(self.tags[-1], "") + data


def tags(html: str) -> Tags:
    parser = Tags()
    parser.feed(html)
    return parser


def packed(html: str) -> dict[str, object]:
    """What the page carries."""
    found = re.search(r'type="text/plain">([^<]*)</script>', html)
    assert found is not None
    content: dict[str, object] = json.loads(gzip.decompress(base64.b64decode(found[1])))
    return content


def test_no_text_of_a_model_becomes_html() -> None:
    parser = tags(page(MODEL))
    assert "img" not in parser.tags
    assert parser.tags.count("script") == 2
    assert parser.texts["h1"].strip() == HOSTILE
    assert packed(page(MODEL))["source"] == {"kind": "recorded", "model": MODEL}


def test_a_page_has_no_address_of_another_file() -> None:
    for name, value in tags(page(MODEL)).attributes:
        assert name not in ("src", "href", "action", "srcset", "data", "formaction"), (name, value)


def test_the_policy_names_the_scripts_by_their_digests_and_forbids_to_fetch() -> None:
    part = element(MODEL)
    loader = re.search(r"<script>(.*)</script>", part.html, re.DOTALL)
    assert loader is not None
    for script in (loader[1], front_end()):
        digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
        assert f"'sha256-{digest}'" in part.policy
    assert "unsafe-eval" not in part.policy.replace("wasm-unsafe-eval", "")
    assert "connect-src 'none'" in part.policy
    assert "connect-src 'self'" in element(MODEL, base="/token/").policy


def test_the_same_model_gives_the_same_page() -> None:
    assert page(MODEL) == page(MODEL)


def test_a_model_with_a_module_computes_in_the_page() -> None:
    source = packed(page({**MODEL, "wasm": "AGFzbQ=="}))["source"]
    assert isinstance(source, dict)
    assert source["kind"] == "wasm"
