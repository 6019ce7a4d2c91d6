"""Checks a built site: every link to a page, an anchor or a file leads somewhere within it.

python website/links.py build/site
"""

from __future__ import annotations

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class _Page(HTMLParser):
    """What a page links to, loads, and can be linked to by; pictures that say nothing."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.anchors: set[str] = set()
        self.wordless: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Collect what one element has."""
        found = dict(attrs)
        self.anchors |= {found[key] or "" for key in ("id", "name") if key in found}
        if tag == "a" and found.get("href"):
            self.links.append(found["href"] or "")
        if tag in ("img", "script", "iframe", "source", "video") and found.get("src"):
            self.loaded.append(found["src"] or "")
        if tag == "link" and found.get("href"):
            self.loaded.append(found["href"] or "")
        if tag == "img" and not (found.get("alt") or "").strip():
            self.wordless.append(found.get("src") or "")


def faults(site: Path) -> list[str]:
    """Links that lead nowhere, things loaded from elsewhere, pictures without words.

    Parameters
    ----------
    site : Path
        The folder of a built site.

    Returns
    -------
    list of str
        One sentence for each.
    """
    pages = {
        path: _Page(path.read_text(encoding="utf-8"))
        for path in site.rglob("*.html")
        if path.parts[-2] != "_static"
    }
    found: list[str] = []
    for path, page in pages.items():
        where = path.relative_to(site)
        found += [f"{where}: the picture {source} has no words" for source in page.wordless]
        for link in dict.fromkeys([*page.links, *page.loaded]):
            target = urlsplit(link)
            if target.scheme or target.netloc:
                if link in page.loaded and target.scheme != "data":
                    found.append(f"{where}: {link} is loaded from elsewhere")
                continue
            place = (path.parent / unquote(target.path)).resolve() if target.path else path
            if not place.is_file():
                found.append(f"{where}: there is no {link}")
            elif place in pages and unquote(target.fragment) not in {"", *pages[place].anchors}:
                found.append(f"{where}: there is no anchor {link}")
    return sorted(found)


if __name__ == "__main__":
    wrong = faults(Path(sys.argv[1]).resolve())
    print("\n".join(wrong) or "every link leads somewhere")
    sys.exit(bool(wrong))
