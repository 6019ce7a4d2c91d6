"""The house: imports run in no circle, names have one home, folders say what is in them."""

from __future__ import annotations

import ast
import sys
from collections import defaultdict
from collections.abc import Iterator, Mapping
from functools import cache
from importlib import import_module
from pathlib import Path

import pytest

import chaplygin
from sources import HOME, files, nodes_of, tree

Graph = Mapping[str, set[str]]


@cache
def modules(home: Path) -> dict[str, Path]:
    """Dotted names below a package, and their files; the package itself is ``""``."""
    named = {}
    for path in files(home):
        parts = path.relative_to(home).with_suffix("").parts
        named[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return named


@cache
def imports(home: Path) -> dict[str, set[str]]:
    """Which module imports which: at the top, in a function, and for types alone.

    What the package as a whole offers may come from anywhere.
    """
    named = modules(home)
    graph: dict[str, set[str]] = {name: set() for name in named if name}
    for name, targets in graph.items():
        for base, inner in _imported(named[name], name, home.name):
            whole = f"{base}.{inner}".strip(".")
            target = whole if whole in named else base
            if target in named and target not in ("", name):
                targets.add(target)
    return graph


def _imported(path: Path, name: str, package: str) -> Iterator[tuple[str, str]]:
    """Modules below the package from which a file imports, with what it takes from them."""
    here = name.split(".") if path.stem == "__init__" else name.split(".")[:-1]
    for node in nodes_of(path, ast.ImportFrom, ast.Import, ast.Call):
        if isinstance(node, ast.ImportFrom):
            parts = (node.module or "").split(".")
            if node.level:
                parts = [*here[: len(here) - node.level + 1], *filter(None, parts)]
            elif parts[0] == package:
                parts = parts[1:]
            else:
                continue
            yield from ((".".join(parts), alias.name) for alias in node.names)
        elif isinstance(node, ast.Import):
            for alias in node.names:
                first, *rest = alias.name.split(".")
                if first == package and rest:
                    yield ".".join(rest), ""
        elif isinstance(node, ast.Call):
            # what is looked up by its name is imported too
            yield from ((module, "") for module in _named(node, here, package))


def _named(call: ast.Call, here: list[str], package: str) -> Iterator[str]:
    """Modules below the package that a call names by a string; of a template, its folder."""
    called = (
        call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
    )
    for argument in call.args:
        texts = argument.values if isinstance(argument, ast.JoinedStr) else [argument]
        text = texts[0].value if texts and isinstance(texts[0], ast.Constant) else None
        if not isinstance(text, str):
            continue
        if len(texts) > 1:
            text = text.rpartition(".")[0]
        if text.startswith(f"{package}."):
            yield text.partition(".")[2]
        elif called == "import_module" and (dots := len(text) - len(text.lstrip("."))):
            yield ".".join([*here[: len(here) - dots + 1], text.lstrip(".")])


def folded(graph: Graph, home: Path, depth: int) -> dict[str, set[str]]:
    """The same between folders."""
    named = modules(home)

    def folder(module: str) -> str:
        parts = module.split(".")
        inner = parts if named[module].stem == "__init__" else parts[:-1] or parts
        return "/".join(inner[:depth])

    between: dict[str, set[str]] = defaultdict(set)
    for module, targets in graph.items():
        between[folder(module)] |= {folder(target) for target in targets} - {folder(module)}
    return between


def circles(graph: Graph) -> list[set[str]]:
    """The strongly connected parts of a graph that have several nodes."""
    sys.setrecursionlimit(10_000)
    numbers: dict[str, int] = {}
    lowest: dict[str, int] = {}
    stack: list[str] = []
    found = []

    def visit(node: str) -> None:
        numbers[node] = lowest[node] = len(numbers)
        stack.append(node)
        for other in graph.get(node, ()):
            if other not in numbers:
                visit(other)
                lowest[node] = min(lowest[node], lowest[other])
            elif other in stack:
                lowest[node] = min(lowest[node], numbers[other])
        if lowest[node] == numbers[node]:
            members = set()
            while node not in members:
                members.add(stack.pop())
            if len(members) > 1:
                found.append(members)

    for node in graph:
        if node not in numbers:
            visit(node)
    return found


def test_no_imports_run_in_a_circle() -> None:
    graph = imports(HOME)
    assert len(graph) > 500
    assert graph["core.system"] >= {"core.vectors", "core.laws"}
    assert circles(graph) == []


@pytest.mark.parametrize("depth", [1, 2])
def test_folders_form_no_circle(depth: int) -> None:
    graph = folded(imports(HOME), HOME, depth)
    assert "core" in graph["mechanics" if depth == 1 else "mechanics/rolling"]
    assert circles(graph) == []


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
    assert circles(imports(home)) == [{"a", "b"}]


def test_folders_are_at_most_two_deep_and_say_what_is_in_them() -> None:
    folders = {path.parent for path in files()}
    assert [f for f in folders if len(f.relative_to(HOME).parts) > 2] == []
    inits = {path for path in files() if path.name == "__init__.py"}
    assert folders - {path.parent for path in inits} == set()
    assert [path for path in inits if not ast.get_docstring(tree(path))] == []


def test_a_public_name_has_one_home() -> None:
    homes = defaultdict(list)
    for module, path in modules(HOME).items():
        # a section of the audit names its functions after the claims of the paper
        if module and not module.startswith("borisov_mamaev.section_"):
            for name in _defined(path):
                homes[name].append(module)
    folders = {path.parent.name for path in HOME.glob("*/__init__.py")}
    public = set(chaplygin.__all__) - folders - {"__version__"}
    assert {name: homes[name] for name in public if len(homes[name]) != 1} == {}
    for name in public:
        assert getattr(import_module(f"chaplygin.{homes[name][0]}"), name) is getattr(
            chaplygin, name
        )


def test_a_name_is_imported_from_the_module_that_defines_it() -> None:
    """Packages alone pass names on; mypy refuses a name that a module itself has imported."""
    found = [path for path in files() if path.stem != "__init__" and "__all__" in _bound(path)]
    assert found == []


def _bound(path: Path) -> set[str]:
    """Names of functions, classes and values that a file binds at its top level."""
    bound: set[str] = set()
    for node in tree(path).body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            bound.add(node.name)
        targets = node.targets if isinstance(node, ast.Assign) else []
        if isinstance(node, ast.AnnAssign):
            targets = [node.target]
        bound |= {target.id for target in targets if isinstance(target, ast.Name)}
    return bound


def _defined(path: Path) -> set[str]:
    """Functions, classes and values that a file defines for others."""
    return {name for name in _bound(path) if not name.startswith("_")}


def hidden_by_modules(home: Path) -> list[str]:
    """Names that a folder binds and that a module of the folder, once imported, replaces."""
    found = []
    for init in home.rglob("__init__.py*"):
        below = {path.stem for path in init.parent.iterdir()}
        for node in tree(init).body:
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
    assert hidden_by_modules(HOME) == []


def test_tests_do_not_hide_the_package() -> None:
    assert not (Path(__file__).parent / "chaplygin").exists()
