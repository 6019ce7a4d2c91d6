"""The packages of the workspace as they lie here: their modules, and who imports whom."""

from __future__ import annotations

import ast
import gc
from collections import defaultdict
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[1]

#: Each package may import those before it; the laboratory finds audits by their entry points.
ORDER = (
    "certificate_checker",
    "flowlanes",
    "lawproof",
    "nonholonomic",
    "borisov_mamaev_2008",
    "chaplygin",
)
HOMES = {name: ROOT / "packages" / name.replace("_", "-") / "src" / name for name in ORDER}

Graph = Mapping[str, set[str]]


def files(*names: str) -> list[Path]:
    """The modules of packages, of all where none is named."""
    return [path for name in names or ORDER for path in sorted(HOMES[name].rglob("*.py"))]


@cache
def tree(path: Path) -> ast.Module:
    """The syntax tree of a file, for reading alone: whoever changes one parses it anew."""
    # a million nodes would wake the collector again and again, with all of SymPy in memory
    woken = gc.isenabled()
    gc.disable()
    try:
        return ast.parse(path.read_text(encoding="utf-8"))
    finally:
        if woken:
            gc.enable()


@cache
def nodes(path: Path) -> tuple[ast.AST, ...]:
    """All nodes of a file, in the order of `ast.walk`."""
    return tuple(ast.walk(tree(path)))


def nodes_of(path: Path, *kinds: type[ast.AST]) -> Iterator[ast.AST]:
    """The nodes of a file of some kinds."""
    return (node for node in nodes(path) if isinstance(node, kinds))


def module_name(path: Path, home: Path) -> str:
    """The dotted name of a module, from the file and the folder of its package."""
    parts = path.relative_to(home.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def modules(homes: Mapping[str, Path]) -> dict[str, Path]:
    """Files of packages by the dotted names of the modules."""
    return {module_name(path, home): path for home in homes.values() for path in home.rglob("*.py")}


@cache
def own_modules() -> dict[str, Path]:
    """Files of the workspace by the dotted names of the modules."""
    return modules(HOMES)


@cache
def own_imports() -> dict[str, set[str]]:
    """Which module of the workspace imports which; nothing is read before a test asks."""
    return imports(HOMES)


def imports(homes: Mapping[str, Path]) -> dict[str, set[str]]:
    """Which module imports which: at the top, in a function, for types alone, and by its name.

    What a package as a whole offers may come from anywhere in it.
    """
    named = modules(homes)
    graph: dict[str, set[str]] = {name: set() for name in named if name not in homes}
    for name, targets in graph.items():
        for base, inner in names_taken(named[name], name, tuple(homes)):
            whole = f"{base}.{inner}".strip(".")
            target = whole if whole in named else base
            if target in named and target != name and target != name.split(".")[0]:
                targets.add(target)
    return graph


def names_taken(path: Path, name: str, packages: tuple[str, ...]) -> Iterator[tuple[str, str]]:
    """Modules of packages from which a file imports, with the names that it takes from them."""
    here = name.split(".") if path.stem == "__init__" else name.split(".")[:-1]
    for node in nodes_of(path, ast.ImportFrom, ast.Import, ast.Call):
        if isinstance(node, ast.ImportFrom):
            parts = (node.module or "").split(".")
            if node.level:
                parts = [*here[: len(here) - node.level + 1], *filter(None, parts)]
            if parts[0] in packages:
                yield from ((".".join(parts), alias.name) for alias in node.names)
        elif isinstance(node, ast.Import):
            for alias in node.names:
                if alias.name.split(".")[0] in packages:
                    yield alias.name, ""
        elif isinstance(node, ast.Call):
            # what is looked up by its name is imported too
            yield from ((module, "") for module in _named(node, here, packages))


def _named(call: ast.Call, here: list[str], packages: tuple[str, ...]) -> Iterator[str]:
    """Modules that a call names by a string; of a template, its folder."""
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
        if text.split(".")[0] in packages and (
            "." in text or called in ("import_module", "PackageLoader", "files")
        ):
            yield text
        elif called == "import_module" and (dots := len(text) - len(text.lstrip("."))):
            yield ".".join([*here[: len(here) - dots + 1], text.lstrip(".")])


def folded(graph: Graph, named: Mapping[str, Path], depth: int) -> dict[str, set[str]]:
    """The same graph between folders: those of the packages, and `depth` − 1 below them."""

    def folder(module: str) -> str:
        parts = module.split(".")
        # a module directly in a package stands for itself
        inner = parts if named[module].stem == "__init__" or len(parts) == 2 else parts[:-1]
        return ".".join(inner[:depth])

    between: dict[str, set[str]] = defaultdict(set)
    for module, targets in graph.items():
        between[folder(module)] |= {folder(target) for target in targets} - {folder(module)}
    return between


def circles(graph: Graph) -> list[set[str]]:
    """The strongly connected parts of a graph that have several nodes."""
    numbers: dict[str, int] = {}
    lowest: dict[str, int] = {}
    stack: list[str] = []
    found = []

    # Tarjan's algorithm, with the calls kept in a list in place of recursion
    def visit(start: str) -> None:
        calls = [(start, iter(sorted(graph.get(start, ()))))]
        numbers[start] = lowest[start] = len(numbers)
        stack.append(start)
        while calls:
            node, rest = calls[-1]
            other = next(rest, None)
            if other is None:
                calls.pop()
                if calls:
                    parent = calls[-1][0]
                    lowest[parent] = min(lowest[parent], lowest[node])
                if lowest[node] == numbers[node]:
                    members = set()
                    while node not in members:
                        members.add(stack.pop())
                    if len(members) > 1:
                        found.append(members)
            elif other not in numbers:
                numbers[other] = lowest[other] = len(numbers)
                stack.append(other)
                calls.append((other, iter(sorted(graph.get(other, ())))))
            elif other in stack:
                lowest[node] = min(lowest[node], numbers[other])

    for node in graph:
        if node not in numbers:
            visit(node)
    return found


def borders() -> dict[str, set[str]]:
    """Names that other packages take from each package, as ``module:name``."""
    crossing: dict[str, set[str]] = {name: set() for name in ORDER}
    named = modules(HOMES)
    for module, path in named.items():
        own = module.split(".")[0]
        # the doors offer what there is
        if path.stem == "__init__" and module == own:
            continue
        for base, name in names_taken(path, module, ORDER):
            package = base.split(".")[0]
            if package != own:
                crossing[package].add(f"{base}:{name}" if name else base)
    return crossing
