"""Python fences of plain Markdown pages as cells that are run.

The pages stay what any reader of Markdown shows; only the builder of the site sees cells.
A fence marked ``sh run`` is run by a shell, one marked ``python not-run`` is only shown. The remark
``<!-- live: NAME -->`` on a line of its own puts the live page of an exhibit of the gallery there.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any
from zlib import crc32

#: A live page of the gallery, with its address inside.
LIVE = r"^<!-- live: ([\w-]+)(#\S*)? -->$"
HEADER = "---\nfile_format: mystnb\nkernelspec: {name: python3, display_name: Python 3}\n---\n"
#: Around the lines of a shell, so that Python runs them and prints what they say at once, in 80
#: columns and without the colours for which Jupyter asks.
BEFORE = """import os, subprocess
environment = {k: v for k, v in os.environ.items() if "COLOR" not in k} | {"COLUMNS": "80"}
print(subprocess.run(["sh", "-ec", r'''
"""
AFTER = """'''], check=True, text=True, env=environment, stdout=-1, stderr=-2).stdout.rstrip())
"""


def with_cells(text: str) -> str:
    """A page of Markdown as a notebook of MyST; one without cells stays as it is."""
    cells = re.sub(r"^```python$", "```{code-cell} ipython3", text, flags=re.M)
    cells = re.sub(
        r"^```sh run\n(.*?)^```$",
        lambda found: f"```{{code-cell}} ipython3\n{BEFORE}{found[1]}{AFTER}```",
        cells,
        flags=re.M | re.S,
    )
    cells = re.sub(r"^```python not-run$", "```python", cells, flags=re.M)
    # an arrow a line is readable as it is
    cells = cells.replace("```mermaid\n", "```text\n")
    return cells if "```{code-cell}" not in cells else HEADER + cells


def with_live_pages(text: str, up: str) -> str:
    """A page with the live pages that it asks for; `up` leads from it to the front page."""
    frame = (
        "```{raw} html\n"
        rf'<figure class="live"><iframe src="{up}live/\1.html\2" title="\1, live" loading="lazy">'
        rf'</iframe><figcaption><a href="{up}live/\1.html\2">In a page of its own</a>'
        "</figcaption></figure>\n```"
    )
    return re.sub(LIVE, frame, text, flags=re.M)


def with_notebook(text: str, name: str) -> str:
    """A page of the course with a link to itself as a notebook, below its heading."""
    file = f"{name.rpartition('/')[2]}.ipynb"
    link = f'<p class="quiet"><a href="{file}" download>This page as a notebook</a></p>'
    heading, rest = text.split("\n", 1)
    return f"{heading}\n\n```{{raw}} html\n{link}\n```\n{rest}"


def live_pages(text: str) -> list[str]:
    """Names of the live pages that a page asks for."""
    return [name for name, _ in re.findall(LIVE, text, flags=re.M)]


def _read(app: Any, name: str, source: list[str]) -> None:
    text = with_notebook(source[0], name) if name.startswith("docs/course/") else source[0]
    source[0] = with_cells(with_live_pages(text, "../" * name.count("/")))
    if source[0].startswith(HEADER):
        print(f"page: {name}", file=sys.stderr, flush=True)


def _name_shells(app: Any, tree: Any) -> None:
    """A cell that a shell runs is shown as lines of a shell."""
    from docutils import nodes

    for block in tree.findall(nodes.literal_block):
        if block.astext().startswith(BEFORE):
            text = block.astext().removeprefix(BEFORE).removesuffix(AFTER.rstrip()).rstrip()
            block.replace_self(nodes.literal_block(text, text, language="sh"))


def setup(app: Any) -> dict[str, Any]:
    """Connect to Sphinx; pages are read anew where the program, or this file, is another."""
    app.connect("source-read", _read)
    app.connect("doctree-read", _name_shells)
    read_by = crc32(Path(__file__).read_bytes())
    return {"version": "1", "env_version": read_by, "parallel_read_safe": True}
