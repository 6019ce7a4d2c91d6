"""The Chromium of the system, in which pages are looked at."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from needs import optional

NAMES = ("chromium", "chromium-browser", "google-chrome")


@contextmanager
def browsers() -> Iterator[Callable[..., Any]]:
    """Starts browsers, by default with WebGL by software; the test is skipped without one."""
    place = next(filter(None, map(shutil.which, NAMES)), None)
    if place is None:
        pytest.skip("Chromium: not installed; scripts/chromium.sh does so")
    playwright = optional("playwright.sync_api")
    software = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    with playwright.sync_playwright() as started:
        yield lambda *arguments: started.chromium.launch(
            executable_path=place, args=["--no-sandbox", *(arguments or software)]
        )


#: Waits until a laboratory is mounted and shows its first motion.
READY = """
() => new Promise((resolve, reject) => {
  const look = () => window.chaplygin
    ? window.chaplygin.ready.then(() => resolve(true), (why) => reject(why))
    : setTimeout(look, 20);
  look();
})
"""


class Opened:
    """A page, with what it asked for and what it complained of."""

    def __init__(self, chromium: Any, address: str | Path, **settings: Any) -> None:
        settings = {"offline": isinstance(address, Path), **settings}
        self.context = chromium.new_context(**settings)
        self.page = self.context.new_page()
        self.requests: list[str] = []
        self.complaints: list[str] = []
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.page.on(
            "console",
            lambda message: (
                self.complaints.append(message.text) if message.type == "error" else None
            ),
        )
        self.page.goto(address.as_uri() if isinstance(address, Path) else address)

    def ready(self) -> Opened:
        """The same page, when its first motion is shown."""
        self.page.evaluate(READY)
        return self

    @property
    def strangers(self) -> list[str]:
        """Requests that leave the page: all but its own address and what it made itself."""
        own = self.page.url.partition("#")[0]
        return [
            url
            for url in self.requests
            if url.partition("#")[0] != own and not url.startswith(("blob:", "data:"))
        ]
