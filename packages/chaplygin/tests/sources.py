"""The sources of the package, each read and parsed once for all tests that look at code."""

from __future__ import annotations

import ast
import gc
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import chaplygin

HOME = Path(chaplygin.__file__).parent


@cache
def files(home: Path = HOME) -> tuple[Path, ...]:
    """The Python files below a folder."""
    return tuple(sorted(home.rglob("*.py")))


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
