"""The gallery: a card and a page for every system of the catalogue and every example."""

from __future__ import annotations

import ast
import re
import shutil
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

import jinja2
from exhibits import ROOT, Exhibit, defines_system

HOME = Path(__file__).parent
PICTURES = ROOT / "docs" / "pictures"
#: By what the cards can be chosen, and the fields that say it.
FACETS = {"contact": "contact", "surface": "surface", "class": "classes", "known": "known"}

#: Folders of the pages: systems of the catalogue, then experiments of examples/.
FOLDERS = ("systems", "experiments")


@dataclass(frozen=True)
class Script:
    """An example that is no experiment: its file, what it says of itself, a picture it draws."""

    file: str
    line: str
    picture: str


def pages(exhibits: list[Exhibit], store: Path, live: Path) -> Iterator[tuple[str, str]]:
    """Pages for Sphinx by their place; writes the live pages and what is downloaded into `live`.

    Parameters
    ----------
    exhibits : list of Exhibit
    store : Path
        Where the pictures and models of the exhibits are.
    live : Path
        Folder of the site's own files.
    """
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HOME / "templates"),
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )
    live.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(ROOT / "packages/chaplygin/src/chaplygin/page/static/lab.js", live / "lab.js")
    page = environment.get_template("live.html")
    for exhibit in exhibits:
        name = exhibit.name
        shutil.copyfile(store / f"{name}.png", live / f"{name}.png")
        (live / f"{name}.toml").write_text(exhibit.experiment, encoding="utf-8")
        packed = (store / f"{name}.txt").read_text(encoding="ascii")
        written = page.render(**asdict(exhibit), packed=packed, folder=folder(exhibit))
        (live / f"{name}.html").write_text(written, encoding="utf-8")
        text = environment.get_template("exhibit.md").render(asdict(exhibit))
        yield f"gallery/{folder(exhibit)}/{name}.md", text
    found = list(scripts())
    for script in found:
        shutil.copyfile(ROOT / "examples" / script.file, live / script.file)
        if script.picture:
            shutil.copyfile(PICTURES / script.picture, live / script.picture)
    index = environment.get_template("gallery.md")
    yield (
        "gallery/index.md",
        index.render(
            exhibits=exhibits,
            scripts=found,
            facets=facets(exhibits),
            folder=folder,
            folders=[kind for kind in FOLDERS if kind in map(folder, exhibits)],
        ),
    )


def folder(exhibit: Exhibit) -> str:
    """The folder of a page, one of `FOLDERS`."""
    return FOLDERS["/" in exhibit.what]


def facets(exhibits: Iterable[Exhibit]) -> list[tuple[str, list[str]]]:
    """What there is to choose from."""
    found = []
    for facet, field in FACETS.items():
        values = (getattr(exhibit, field) for exhibit in exhibits)
        several = (value if isinstance(value, tuple | list) else (value,) for value in values)
        found.append((facet, sorted({one for listed in several for one in listed})))
    return found


def scripts() -> Iterator[Script]:
    """The examples that are scripts, each with a picture of the pages of docs/ that it draws."""
    names = {path.name for path in PICTURES.iterdir()}
    for path in sorted((ROOT / "examples").glob("*.py")):
        if defines_system(path):
            continue
        text = path.read_text(encoding="utf-8")
        line = (ast.get_docstring(ast.parse(text)) or path.stem).splitlines()[0]
        drawn = [name for name in re.findall(r"(\w+)(?:\.png)?\"", text) if f"{name}.png" in names]
        own = [path.stem] if f"{path.stem}.png" in names else []
        yield Script(path.name, line, next((f"{name}.png" for name in own + drawn), ""))
