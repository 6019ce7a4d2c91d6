"""The workspace: packages in their order, no circle of imports, one home for each name."""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from importlib import import_module
from pathlib import Path

import pytest

from workspace import (
    HOMES,
    ORDER,
    ROOT,
    borders,
    circles,
    files,
    folded,
    imports,
    own_imports,
    own_modules,
    tree,
)


def test_no_imports_run_in_a_circle() -> None:
    graph = own_imports()
    assert len(graph) > 500
    assert graph["flowlanes.system.system"] >= {"flowlanes.system.vectors"}
    assert circles(graph) == []


@pytest.mark.parametrize("depth", [1, 2, 3])
def test_packages_and_folders_form_no_circle(depth: int) -> None:
    graph = folded(own_imports(), own_modules(), depth)
    assert circles(graph) == []


def test_packages_import_those_before_them() -> None:
    graph = folded(own_imports(), own_modules(), 1)
    assert graph["nonholonomic"] == {"flowlanes", "lawproof"}
    for name, targets in graph.items():
        assert targets <= set(ORDER[: ORDER.index(name)]), name
    # an audit is found by its entry point
    assert "borisov_mamaev_2008" not in graph["chaplygin"]


def test_no_text_of_a_package_leads_to_a_later_one() -> None:
    """In docstrings, examples and strings as well; only metadata name what is found there."""
    wrong = []
    for place, name in enumerate(ORDER[:-1]):
        later = "|".join(set(ORDER[place + 1 :]))
        pattern = re.compile(
            rf"\b(?:import (?:{later})\b|from (?:{later})\b|(?:{later})\.[A-Za-z_]+\b)"
        )
        for path in files(name):
            for line in path.read_text(encoding="utf-8").splitlines():
                wrong += [
                    f"{path.relative_to(HOMES[name])}: {found[0]}"
                    for found in pattern.finditer(line)
                    if not _is_mathematician(line, found)
                ]
    assert wrong == []


def _is_mathematician(line: str, found: re.Match[str]) -> bool:
    """Whether Chaplygin is meant: a module of that name in the catalogue or the audit."""
    before = line[: found.start()]
    if found[0].startswith("chaplygin."):
        return not before.endswith(("`", "`~", ">>> "))
    return found[0] == "import chaplygin" and "from " in before


@pytest.mark.parametrize(
    ("line", "excused"),
    [
        ("from ..catalogue import chaplygin", True),
        ("S = chaplygin.S", True),
        ("    >>> import chaplygin as ch", False),
        (">>> from chaplygin import prove", False),
        ("See :func:`chaplygin.study`.", False),
    ],
)
def test_the_mathematician_is_told_from_the_package(line: str, excused: bool) -> None:
    pattern = re.compile(r"(?:import|from) chaplygin\b|chaplygin\.[A-Za-z_]+")
    found = pattern.search(line)
    assert found is not None
    assert _is_mathematician(line, found) == excused


@pytest.mark.parametrize("name", ORDER)
def test_the_names_that_cross_a_border_are_listed(name: str) -> None:
    """A list that changes is changed with it: python scripts/borders.py writes it."""
    listed = (HOMES[name].parents[1] / "public.txt").read_text(encoding="utf-8").split()
    assert listed == sorted(borders()[name])


@pytest.mark.parametrize(
    "line",
    [
        "from .b import f",
        "def g():\n    from . import b",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from package.b import f",
        "import package.b",
        "from importlib import import_module\nimport_module('package.b')",
        "import importlib\nimportlib.import_module('.b', __package__)",
        "import importlib\nimportlib.import_module(f'package.b.{1}')",
        "from jinja2 import PackageLoader\nPackageLoader('package.b')",
    ],
)
def test_every_kind_of_import_is_seen(tmp_path: Path, line: str) -> None:
    home = tmp_path / "package"
    home.mkdir()
    (home / "__init__.py").write_text("")
    (home / "a.py").write_text(line)
    (home / "b.py").write_text("from .a import g")
    assert circles(imports({"package": home})) == [{"package.a", "package.b"}]


#: The one file of the engine that names every Greek letter, as the table by which they are printed.
GREEK_LETTERS = "printing/symbol_names.py"


def test_the_engine_does_not_know_rolling() -> None:
    """Starts and variables of bodies are matters of their conventions; see `Conventions`."""
    words = re.compile(r"omega|gamma|attitude", re.IGNORECASE)
    found = {
        path.relative_to(HOMES["flowlanes"]).as_posix(): words.findall(text)
        for path in files("flowlanes")
        if words.search(text := path.read_text(encoding="utf-8"))
    }
    assert found == {GREEK_LETTERS: ["Gamma", "Omega"]}


def test_folders_say_what_is_in_them() -> None:
    for path in files():
        if path.stem == "__init__":
            assert ast.get_docstring(tree(path)), path
        assert (path.parent / "__init__.py").exists(), path


def test_a_public_name_has_one_home() -> None:
    for package in ("flowlanes", "lawproof", "nonholonomic", "chaplygin"):
        door = import_module(package)
        homes = defaultdict(list)
        for module, path in own_modules().items():
            # a section of the audit names its functions after the claims of the paper
            if not module.startswith("borisov_mamaev_2008.section_"):
                for name in _defined(path):
                    homes[name].append(module)
        folders = {path.parent.name for path in HOMES[package].glob("*/__init__.py")}
        public = set(door.__all__) - folders - {"__version__"}
        assert {name: homes[name] for name in public if len(homes[name]) != 1} == {}
        for name in public:
            assert getattr(import_module(homes[name][0]), name) is getattr(door, name)


def test_a_name_is_imported_from_the_module_that_defines_it() -> None:
    """Packages alone pass names on; mypy refuses a name that a module itself has imported."""
    for path in files():
        text = path.read_text(encoding="utf-8")
        assert path.stem == "__init__" or "\n__all__" not in text, path


def _defined(path: Path) -> set[str]:
    """Functions, classes and values that a file defines for others."""
    defined: set[str] = set()
    for node in tree(path).body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            defined.add(node.name)
        targets = node.targets if isinstance(node, ast.Assign) else []
        if isinstance(node, ast.AnnAssign):
            targets = [node.target]
        defined |= {target.id for target in targets if isinstance(target, ast.Name)}
    return {name for name in defined if not name.startswith("_")}


def hidden_by_modules(home: Path) -> list[str]:
    """Names that a folder binds and that a module of the folder, once imported, replaces."""
    found = []
    for init in home.rglob("__init__.py*"):
        below = {path.stem for path in init.parent.iterdir()}
        for node in ast.parse(init.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.ImportFrom) and node.module:
                bound = {alias.asname or alias.name for alias in node.names}
                # what a stub names is looked up late, when the module may have taken the place
                eager = node.level == 1 and init.suffix == ".py"
                origin = node.module if eager else None
                found += [f"{init.parent.name}.{name}" for name in (bound & below) - {origin}]
    return found


def test_no_module_replaces_a_name_of_its_folder(tmp_path: Path) -> None:
    for name, text in {"__init__": "from .a import b, a", "a": "a = b = 1", "b": ""}.items():
        (tmp_path / f"{name}.py").write_text(text)
    assert hidden_by_modules(tmp_path) == [f"{tmp_path.name}.b"]
    assert [name for home in HOMES.values() for name in hidden_by_modules(home)] == []


#: Files that turn vectors into components themselves: what makes formulas may, what computes takes
#: the scalar form of a system.  The number may only fall.
FILES_WITH_COMPONENTS = 38


def test_few_files_turn_vectors_into_components() -> None:
    word = re.compile(r"\bto_components\b")
    found = [str(path) for path in files() if word.search(path.read_text(encoding="utf-8"))]
    assert len(found) <= FILES_WITH_COMPONENTS, found


def imported_names(text: str) -> set[str]:
    """The modules, and the names in modules, that a text imports: programs in strings as well."""
    found = set()
    for module, names, plain in re.findall(
        r"^[ \t\"']*(?:from ([\w.]+) import (?:\(\n)?(.*)|import ([\w.]+))", text, re.MULTILINE
    ):
        found |= (
            {plain} if plain else {module, *(f"{module}.{n}" for n in re.findall(r"\w+", names))}
        )
    return found


def test_imports_of_a_text_are_seen() -> None:
    text = "from a import b, c\nimport d.e\nfrom f.g import (\n    h,\n)\nP = 'import k'\n"
    assert imported_names(text) >= {"a", "a.b", "a.c", "d.e", "f.g"}
    assert imported_names("    'from chaplygin import x; '") >= {"chaplygin"}


def test_tests_stand_with_a_package_that_has_all_they_need() -> None:
    """Tests and their helpers import no later package, nor the helpers of its tests."""
    homes = {name: home.parents[1] / "tests" for name, home in HOMES.items()}
    helpers = {
        ".".join(path.relative_to(home).with_suffix("").parts): place
        for place, home in enumerate(homes.values())
        for path in home.rglob("*.py")
    }
    wrong = []
    for place, home in enumerate(homes.values()):
        for path in home.rglob("*.py"):
            taken = imported_names(path.read_text(encoding="utf-8"))
            later = {name for name in taken if helpers.get(name, 0) > place}
            later |= {name for name in taken if name.split(".")[0] in ORDER[place + 1 :]}
            if later:
                wrong.append(f"{path.relative_to(ROOT)}: {', '.join(sorted(later))}")
    assert wrong == []


def test_tests_do_not_hide_a_package() -> None:
    for name in ORDER:
        assert not (ROOT / "tests" / name).exists()
        assert not any((home.parents[1] / "tests" / name).exists() for home in HOMES.values())
