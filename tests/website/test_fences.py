"""Pages become cells for the builder alone, and every page of docs/ is on the site."""

from __future__ import annotations

import re
import sys
from fnmatch import fnmatch
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
PAGE = """# Balls

```python
print(1)
```

```sh run
ls
```

```python not-run
forever()
```
"""


@pytest.fixture
def website(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Imports a module of the folder of the site."""
    monkeypatch.setattr(sys, "path", [str(ROOT / "website"), *sys.path])
    return import_module


def test_fences_of_python_are_cells(website: Any, capsys: pytest.CaptureFixture[str]) -> None:
    cells = website("fences").with_cells(PAGE)
    assert cells.startswith("---\nfile_format: mystnb\n")
    assert "```{code-cell} ipython3\nprint(1)\n```" in cells
    fences = website("fences")
    assert f"```{{code-cell}} ipython3\n{fences.BEFORE}ls\n{fences.AFTER}```" in cells
    exec(fences.BEFORE + "echo rolls\n" + fences.AFTER, {})
    assert capsys.readouterr().out == "rolls\n"
    assert "```python\nforever()\n```" in cells
    assert website("fences").with_cells("# Words\n") == "# Words\n"


def test_every_page_is_in_a_list() -> None:
    lists = [p.read_text() for p in (ROOT / "website" / "pages").rglob("*.md")]
    listed = re.findall(r"^(?:docs|packages)/\S+$", "\n".join(lists), re.M)
    pages = [*ROOT.glob("docs/**/*.md"), *ROOT.glob("packages/*/docs/**/*.md")]
    for path in [*pages, *ROOT.glob("packages/*/CONTRIBUTING.md")]:
        name = path.relative_to(ROOT).with_suffix("").as_posix()
        assert any(fnmatch(name, pattern) for pattern in listed), f"{name} is in no list"


def test_a_page_stands_in_the_section_of_its_package() -> None:
    """Each section lists pages of its packages; the prover has the checker with it."""
    sections = {
        "engine": {"flowlanes"},
        "prover": {"lawproof", "certificate-checker"},
        "mechanics": {"nonholonomic"},
        "laboratory": {"chaplygin"},
        "audit": {"borisov-mamaev-2008"},
    }
    for section, packages in sections.items():
        text = (ROOT / "website" / "pages" / f"{section}.md").read_text()
        assert set(re.findall(r"^packages/([\w-]+)/", text, re.M)) == packages, section


def test_live_pages_stand_where_they_are_asked_for(website: Any) -> None:
    text = website("fences").with_live_pages("a\n\n<!-- live: rattleback#t=1 -->\n", "../../")
    assert '<iframe src="../../live/rattleback.html#t=1" title="rattleback, live"' in text


def test_faults_of_pages_are_found(website: Any, tmp_path: Path) -> None:
    (tmp_path / "a.html").write_text(
        '<p id="x"></p><a href="b.html#y">b</a><a href="#x">x</a><a href="c.html">c</a>'
        '<img src="b.html"><img src="b.html" alt="words"><script src="https://host.test/s.js"></script>'
    )
    (tmp_path / "b.html").write_text('<a href="a.html#x">a</a>')
    assert website("links").faults(tmp_path) == [
        "a.html: https://host.test/s.js is loaded from elsewhere",
        "a.html: the picture b.html has no words",
        "a.html: there is no anchor b.html#y",
        "a.html: there is no c.html",
    ]
