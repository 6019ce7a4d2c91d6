"""A laboratory for nonholonomic mechanics: equations, laws, motions and reports.

>>> import chaplygin
>>> ball = chaplygin.Body(1.0, (1.0, 1.5, 2.1), chaplygin.Ball(1.0))
>>> system = chaplygin.rolling_system(ball, chaplygin.Plane(), "marble")
>>> print(system.title)
Rolling body

The names come from the packages of which the laboratory is made; each is imported when it is first
used, so that importing this one costs nothing.
"""

import ast
from importlib import import_module
from pathlib import Path


def _modules_by_name() -> dict[str, str]:
    """The modules of the public names, as the stub beside this file imports them."""
    stub = ast.parse(Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
    return {
        alias.name: "." * node.level + (node.module or "")
        for node in stub.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }


_MODULES = _modules_by_name()
__all__ = sorted(_MODULES)  # noqa: PLE0605


def __dir__() -> list[str]:
    return __all__


def __getattr__(name: str) -> object:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module = _MODULES[name]
    found = (
        import_module(f".{name}", __name__)
        if module == "."
        else getattr(import_module(module, __name__), name)
    )
    globals()[name] = found
    return found
