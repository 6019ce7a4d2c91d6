"""References in docstrings: to the page of a public name, or as plain code to what is internal.

A name that the program does not have stays unresolved, which is a warning, and so an error.
"""

from __future__ import annotations

import inspect
from importlib import import_module
from typing import Any

#: Packages whose names docstrings mention.
PACKAGES = (
    "flowlanes",
    "lawproof",
    "certificate_checker",
    "nonholonomic",
    "chaplygin",
    "borisov_mamaev_2008",
)


def found(target: str) -> Any:
    """What a dotted name of the package means; None if there is nothing of that name."""
    parts = target.split(".")
    for cut in range(len(parts), 0, -1):
        try:
            thing: Any = import_module(".".join(parts[:cut]))
        except ImportError:
            continue
        for part in parts[cut:]:
            thing = getattr(thing, part, None)
        return thing
    return None


def home_of(thing: Any) -> str:
    """The package in which something is defined; empty for a plain value."""
    return str(getattr(inspect.unwrap(thing), "__module__", "")).split(".")[0]


def _resolve(app: Any, env: Any, node: Any, content: Any) -> Any:
    if node.get("refdomain") != "py":
        return None
    target = node["reftarget"]
    thing = found(target if target.split(".")[0] in PACKAGES else f"chaplygin.{target}")
    if thing is None:
        return None
    name = target.rpartition(".")[2]
    page = f"reference/{home_of(thing)}/{name}"
    if page in env.all_docs and getattr(import_module(home_of(thing)), name, None) is thing:
        from sphinx.util.nodes import make_refnode

        return make_refnode(app.builder, node["refdoc"], page, None, content)
    return content


def setup(app: Any) -> dict[str, Any]:
    """Connect to Sphinx."""
    app.connect("missing-reference", _resolve)
    return {"version": "1", "parallel_read_safe": True}
