"""A system as a page element: front end, model and machine code, all within the page.

All data are packed into one base64 text, so that nothing in it can end a script or be read as HTML,
and are unpacked by the browser. The content security policy of the page identifies every script by
a digest and forbids network access.
"""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import TypeAlias

import jinja2
from markupsafe import Markup

from flowlanes.errors import InputError

from .._version import __version__

#: The page model of a system; see :mod:`chaplygin.page.page_model`.
PageModel: TypeAlias = Mapping[str, object]

#: The folder of the front end, built from ``web/``.
STATIC = Path(str(files("chaplygin.page") / "static"))

#: Unpacks the front end and mounts the element, or keeps the still image if the browser cannot.
_LOADER = """\
(async () => {
  const data = document.getElementById("chaplygin-data");
  const place = document.getElementById("chaplygin-lab");
  // the still is painted first
  await new Promise((go) => { requestAnimationFrame(() => setTimeout(go)); setTimeout(go, 500); });
  try {
    const packed = Uint8Array.from(atob(data.textContent.trim()), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const { script, source } = JSON.parse(await new Response(stream).text());
    const program = document.createElement("script");
    program.textContent = script;
    document.head.append(program);
    data.remove();
    ChaplyginLab.mount(place, source);
  } catch (problem) {
    console.error(problem);
    place.dataset.failed = "true";
  }
})();
"""


@dataclass(frozen=True)
class Element:
    """A part of a page.

    Attributes
    ----------
    html : Markup
        HTML for the body, to be inserted once in a page.
    policy : str
        Permissions of the page, for its ``Content-Security-Policy``.
    """

    html: Markup
    policy: str


@cache
def front_end() -> str:
    """The script of the front end, which includes its style sheet.

    Raises
    ------
    InputError
        If the package was installed without it.
    """
    try:
        return (STATIC / "lab.js").read_text(encoding="utf-8")
    except FileNotFoundError:
        raise InputError(
            "this copy of the package has no front end: build it with make web, which needs Node"
        ) from None


def policy(scripts: Sequence[str], connect: str = "'none'") -> str:
    """The content security policy of a page: its scripts and WebAssembly run, nothing is fetched.

    Parameters
    ----------
    scripts : sequence of str
        Texts of the scripts.
    connect : str
        Permitted source of requests: ``'none'``, or ``'self'`` for the page of a server.
    """
    digests = (
        base64.b64encode(hashlib.sha256(script.encode()).digest()).decode() for script in scripts
    )
    allowed = " ".join(f"'sha256-{digest}'" for digest in digests)
    return (
        f"default-src 'none'; script-src {allowed} 'wasm-unsafe-eval' blob:; worker-src blob:; "
        "style-src 'unsafe-inline'; img-src data: blob:; media-src blob:; "
        f"connect-src {connect}; base-uri 'none'; form-action 'none'"
    )


def element(model: PageModel, still: str = "", base: str | None = None) -> Element:
    """An interactive system as part of a page.

    Parameters
    ----------
    model : mapping
        The result of :func:`chaplygin.page.page_model.page_model`.
    still : str
        HTML shown until the first frame, without WebGL, and in print.
    base : str, optional
        The path of a running laboratory from which the page was served; it performs computations
        that the page cannot.

    Raises
    ------
    InputError
        If the package was installed without its front end.
    """
    script = front_end()
    if base is not None:
        source: dict[str, object] = {"kind": "http", "base": base, "model": model}
    else:
        source = {"kind": "wasm" if model.get("wasm") else "recorded", "model": model}
    text = json.dumps({"script": script, "source": source}, allow_nan=False)
    packed = base64.b64encode(gzip.compress(text.encode(), 9, mtime=0)).decode()
    html = (
        '<div id="chaplygin-lab" class="chaplygin-lab">'
        f'<div class="chaplygin-still">{still}</div></div>\n'
        f'<script id="chaplygin-data" type="text/plain">{packed}</script>\n'
        f"<script>{_LOADER}</script>"
    )
    return Element(Markup(html), policy([_LOADER, script], "'none'" if base is None else "'self'"))


def page(model: PageModel, still: str = "", base: str | None = None) -> str:
    """A self-contained page, which needs no other file and no network.

    Parameters
    ----------
    model, still, base
        As of :func:`element`.

    Returns
    -------
    str
        HTML.
    """
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("chaplygin.page", "templates"),
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )
    part = element(model, still, base)
    return environment.get_template("page.html").render(
        title=model["title"], policy=part.policy, element=part.html, version=__version__
    )
