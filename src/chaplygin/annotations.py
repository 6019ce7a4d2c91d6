"""The annotations of functions and classes, with names looked up that only type checkers need."""

from __future__ import annotations

import ast
import builtins
import inspect
import sys
from collections.abc import Iterable, Mapping
from functools import cache
from importlib import import_module
from importlib.util import resolve_name
from types import ModuleType
from typing import Any, get_type_hints


def annotations_of(
    thing: Any, modules: Iterable[str], further: Mapping[str, Any]
) -> dict[str, Any]:
    """The annotations of a function or a method by argument; Any where one cannot be had.

    Parameters
    ----------
    thing : function or class
    modules : iterable of str
        Names of the modules in whose names the annotations are written.
    further : mapping of str to object
        Names that those modules need not have.
    """
    return get_type_hints(thing, None, _Scope(modules, further), include_extras=True)


class _Scope(dict[str, Any]):
    """Names of modules; those that they import for type checkers alone are looked up."""

    def __init__(self, modules: Iterable[str], further: Mapping[str, Any]) -> None:
        self.further = further
        self.modules = [sys.modules[module] for module in modules]
        for module in self.modules:
            self |= vars(module)

    def __missing__(self, name: str) -> Any:
        if hasattr(builtins, name):
            return getattr(builtins, name)
        if name in self.further:
            return self.further[name]
        for module in self.modules:
            if (origin := _imports_for_type_checkers(module).get(name)) is None:
                continue
            where, what = origin
            own = where.partition(".")[0] == __package__
            # what is no part of this program, and not in use, has no values
            source = import_module(where) if own else sys.modules.get(where)
            return getattr(source, what, Any) if what else source or _UnknownModule()
        return Any


class _UnknownModule:
    """A module that is not in use, so that nothing is known of what it defines."""

    def __getattr__(self, name: str) -> Any:
        return Any


@cache
def _imports_for_type_checkers(module: ModuleType) -> dict[str, tuple[str, str]]:
    """What a module imports under ``if TYPE_CHECKING``: by name its module, and its name there."""
    origins: dict[str, tuple[str, str]] = {}
    try:
        source = inspect.getsource(module)
    except (OSError, TypeError):  # a module that is not written in Python
        return origins
    for block in ast.parse(source).body:
        if not (isinstance(block, ast.If) and ast.unparse(block.test) == "TYPE_CHECKING"):
            continue
        for statement in block.body:
            if isinstance(statement, ast.Import):
                origins |= {item.asname or item.name: (item.name, "") for item in statement.names}
            elif isinstance(statement, ast.ImportFrom):
                relative = "." * statement.level + (statement.module or "")
                where = resolve_name(relative, module.__package__ or "")
                origins |= {
                    item.asname or item.name: (where, item.name) for item in statement.names
                }
    return origins
