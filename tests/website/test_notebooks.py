"""The course as notebooks: each runs from top to bottom, wherever it is opened."""

from __future__ import annotations

import re
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from needs import optional

nbformat, nbclient = optional("nbformat"), optional("nbclient")

ROOT = Path(__file__).parents[2]
PAGES = sorted((ROOT / "docs" / "course").glob("section-*.md"))
PAGE = """# §1 Balls

It rolls: [§2](section-02.md), [more](../charts.md), [a paper](https://example.org/a.md).

<!-- live: rattleback -->

```python
print(6 * 7)
```

<details><summary>Solution</summary>

```python
raise ArithmeticError("slips")
```

</details>
"""


@pytest.fixture
def notebooks(monkeypatch: pytest.MonkeyPatch) -> Any:
    """The module of the site that makes notebooks."""
    monkeypatch.setattr(sys, "path", [str(ROOT / "website"), *sys.path])
    return import_module("notebooks")


def run(notebook: nbformat.NotebookNode, folder: Path) -> nbformat.NotebookNode:
    """A notebook after it was run from top to bottom in a folder, in a process of its own."""
    resources = {"metadata": {"path": str(folder)}}
    return nbclient.NotebookClient(notebook, timeout=900, resources=resources).execute()


def test_a_page_becomes_a_notebook(notebooks: Any) -> None:
    made = notebooks.notebook(PAGE)
    nbformat.validate(made)
    assert [cell.cell_type for cell in made.cells] == ["markdown", "code", "markdown", "code"]
    words = made.cells[0].source
    assert (
        "[§2](section-02.ipynb), [more](../charts.html), [a paper](https://example.org/a.md)"
        in words
    )
    assert "[rattleback, live](../../live/rattleback.html)" in words
    assert made.cells[1].source == "print(6 * 7)"
    assert made.cells[2].source == "***Solution.***"
    assert notebooks.notebook(PAGE) == made


def test_the_notebooks_are_the_pages(notebooks: Any) -> None:
    found = dict(notebooks.notebooks())
    assert list(found) == [f"docs/course/{path.stem}.ipynb" for path in PAGES]
    for path in PAGES:
        made = nbformat.reads(found[f"docs/course/{path.stem}.ipynb"], as_version=4)
        fences = re.findall(r"^```python\n(.*?)\n```$", path.read_text(), re.M | re.S)
        assert [cell.source for cell in made.cells if cell.cell_type == "code"] == fences


@pytest.mark.slow
def test_a_cell_that_fails_ends_the_notebook(notebooks: Any, tmp_path: Path) -> None:
    with pytest.raises(nbclient.exceptions.CellExecutionError, match="slips"):
        run(notebooks.notebook(PAGE), tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.stem)
def test_a_notebook_runs_from_top_to_bottom(page: Path, notebooks: Any, tmp_path: Path) -> None:
    made = run(notebooks.notebook(page.read_text(encoding="utf-8")), tmp_path)
    cells = [cell for cell in made.cells if cell.cell_type == "code"]
    assert all(cell.execution_count for cell in cells)
    silent = [cell.source for cell in cells if not cell.outputs]
    assert not [source for source in silent if set(re.findall(r"^\w+", source, re.M)) != {"import"}]
