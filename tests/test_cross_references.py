"""What docs and docstrings refer to exists: modules, names in them, files."""

from __future__ import annotations

import re
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import pytest

import chaplygin
from nonholonomic.system_files.open_kinds import GROUP
from workspace import HOMES, ORDER, modules

TOP = Path(__file__).parents[1]
PAGES = [
    *TOP.glob("*.md"),
    *TOP.glob("packages/*/*.md"),
    *(page for docs in (TOP / "docs", *TOP.glob("packages/*/docs")) for page in docs.rglob("*.md")),
]

#: ``flowlanes.flow.trajectory``, but not ``chaplygin.toml`` or an address on the web.
_PACKAGES = "|".join(ORDER)
DOTTED = re.compile(rf"(?<![\w./-])(?:{'|'.join(ORDER)})(?:\.[A-Za-z_]\w*)+(?![\w/]|\.\w)")
#: ``ch.integrate``, as after ``import chaplygin as ch``.
SHORT = re.compile(r"(?<![\w.])ch\.([A-Za-z_]\w*)")
SUFFIXES = {
    "cff",
    "csv",
    "html",
    "io",
    "json",
    "md",
    "nc",
    "org",
    "png",
    "py",
    "svg",
    "toml",
    "zarr",
}
#: ``flow/trajectory.py``; of a file that a reader is to write, the text says so.
FILE = re.compile(r"`((?:[a-z_]+/)+\w+\.py)`")
TO_WRITE = {
    "packages/nonholonomic/src/nonholonomic/catalogue/mechanisms/skate.toml",
    "packages/certificate-checker/tests/checker/test_forged_point.py",
    "packages/lawproof/tests/proof/darboux.py",
    "packages/lawproof/tests/proof/test_darboux.py",
    "packages/nonholonomic/tests/mechanics/shapes/test_egg.py",
    "packages/nonholonomic/tests/planted_kinds/egg.py",
}
#: The file of a link or picture, without the heading in it.
LINK = re.compile(r"\]\(([^)\s#]+)")
ROLE = re.compile(r":(?:mod|func|class|meth|data|attr):`~?([.\w]+)`")


def exists(dotted: str) -> bool:
    """Whether a dotted name is that of a module, or of something in one."""
    parts = dotted.split(".")
    for count in range(len(parts), 0, -1):
        try:
            thing: object = import_module(".".join(parts[:count]))
        except ModuleNotFoundError:
            continue
        for name in parts[count:]:
            if name in getattr(thing, "__dataclass_fields__", {}):
                return True
            if not hasattr(thing, name):
                return False
            thing = getattr(thing, name)
        return True
    return False


def lost_names(text: str) -> Iterator[str]:
    """Dotted names in a page that nothing has; a group of entry points is no name."""
    for name in sorted(set(SHORT.findall(text))):
        if not hasattr(chaplygin, name):
            yield f"ch.{name}"
    for name in sorted(set(DOTTED.findall(text))):
        if name.rpartition(".")[2] not in SUFFIXES and name != GROUP and not exists(name):
            yield name


def lost_roles(module: str, path: Path) -> Iterator[str]:
    """Names that the docstrings of a module refer to and nothing has."""
    package = module if path.stem == "__init__" else module.rpartition(".")[0]
    for name in sorted(set(ROLE.findall(path.read_text(encoding="utf-8")))):
        if any(
            exists(f"{place}.{name.lstrip('.')}".lstrip(".")) for place in ("", module, package)
        ):
            continue
        classes = (
            thing for thing in vars(import_module(module)).values() if isinstance(thing, type)
        )
        if not any(hasattr(of, name) for of in classes):
            yield f"{module}: {name}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(TOP)))
def test_names_and_files_in_pages(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    assert list(lost_names(text)) == []
    files = set(FILE.findall(text)) - TO_WRITE
    roots = (TOP, *(home.parent for home in HOMES.values()), page.parent)
    assert [file for file in files if not any((root / file).exists() for root in roots)] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(TOP)))
def test_links_lead_to_files(page: Path) -> None:
    text = re.sub(r"^```.*?^```$|^    [^\n]*$", "", page.read_text("utf-8"), flags=re.M | re.S)
    links = [link for link in LINK.findall(text) if not re.match(r"https?:|mailto:", link)]
    assert [link for link in links if not (page.parent / link).exists()] == []


def test_a_page_has_a_name_of_its_own() -> None:
    """Code refers to pages as ``docs/NAME.md``: of its own package, or of the one it names."""
    names = [page.name for page in TOP.glob("packages/*/docs/*.md") if page.name != "index.md"]
    assert [name for name in set(names) if names.count(name) > 1] == []


@pytest.mark.slow
def test_names_in_docstrings() -> None:
    assert [
        name for module, path in modules(HOMES).items() for name in lost_roles(module, path)
    ] == []


def test_a_lost_name_is_reported() -> None:
    text = "`flowlanes.flow.trajectory.Trajectory` is kept, `flowlanes.flow.course.Course` is not"
    assert list(lost_names(text)) == ["flowlanes.flow.course.Course"]
    assert list(lost_names("`ch.prove` and `ch.sample_level`")) == ["ch.sample_level"]
