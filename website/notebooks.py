"""Pages of the course as notebooks: the same cells that the site runs, for Jupyter."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import jupytext
from fences import LIVE, with_cells
from nbformat import NotebookNode

ROOT = Path(__file__).parents[1]


def notebook(text: str) -> NotebookNode:
    """A page of Markdown as a notebook.

    Parameters
    ----------
    text : str
        What is in the repository.

    Returns
    -------
    NotebookNode
        Without outputs. Solutions stand open, as no cell of a notebook can fold others; pages
        of the course lead to notebooks, and what else they lead to is on the site.
    """
    text = re.sub(r"^<details><summary>(.*?)</summary>$", r"***\1.***", text, flags=re.M)
    text = re.sub(r"^</details>\n", "", text, flags=re.M)
    text = re.sub(LIVE, r"[\1, live](../../live/\1.html\2)", text, flags=re.M)
    text = re.sub(r"\]\((section-\d+)\.md", r"](\1.ipynb", text)
    text = re.sub(r"\]\(((?!https?:)[^)#]+)\.md", r"](\1.html", text)
    cells = jupytext.reads(with_cells(text), fmt="md:myst")
    cells.metadata = NotebookNode(kernelspec=cells.metadata["kernelspec"])
    for place, cell in enumerate(cells.cells):
        # by chance otherwise, so that the file would be another each time
        cell.id = f"cell-{place}"
    return cells


def notebooks() -> Iterator[tuple[str, str]]:
    """The notebooks of the course, by their place on the site, as JSON."""
    for path in sorted((ROOT / "docs" / "course").glob("section-*.md")):
        place = path.relative_to(ROOT).with_suffix(".ipynb").as_posix()
        yield place, jupytext.writes(notebook(path.read_text(encoding="utf-8")), fmt="ipynb")
