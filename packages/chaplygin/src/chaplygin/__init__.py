"""A laboratory for nonholonomic mechanics: equations, laws, motions and reports.

>>> import chaplygin
>>> ball = chaplygin.Body(1.0, (1.0, 1.5, 2.1), chaplygin.Ball(1.0))
>>> system = chaplygin.rolling_system(ball, chaplygin.Plane(), "marble")
>>> print(system.title)
Rolling body

The names come from the packages of which the laboratory is made; each is imported when it is first
used, so that importing this one costs nothing.  What is not here is in the package that makes it:
`flowlanes` for any vector field, `lawproof` for laws, `nonholonomic` for mechanics, and the folders
of this one for reports, pages and files.
"""

import ast
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

_PACKAGES = ("flowlanes", "lawproof", "nonholonomic")
_STUB = ast.parse(Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
#: The modules of the names, as the stub beside this file imports them.
_MODULES = {
    alias.name: "." * node.level + (node.module or "")
    for node in _STUB.body
    if isinstance(node, ast.ImportFrom)
    for alias in node.names
}
(__all__,) = (ast.literal_eval(node.value) for node in _STUB.body if isinstance(node, ast.Assign))


def __dir__() -> list[str]:
    return [*__all__, "__version__"]


def __getattr__(name: str) -> object:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}{_elsewhere(name)}")
    found = getattr(import_module(_MODULES[name], __name__), name)
    globals()[name] = found
    return found


def _elsewhere(name: str) -> str:
    """The package or the folder in which there is something of this name."""
    if name.startswith("_"):
        return ""
    for package in _PACKAGES:
        if name in import_module(package).__all__:
            return f"; it is {package}.{name}"
    return f"; write: import {__name__}.{name}" if find_spec(f"{__name__}.{name}") else ""
