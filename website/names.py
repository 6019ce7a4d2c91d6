"""References in docstrings: to the page of a public name, or as plain code to what is internal.

A name that the program does not have stays unresolved, which is a warning, and so an error.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

from reference_pages import public

#: Packages whose names docstrings mention.
PACKAGES = (
    "borisov_mamaev_2008",
    "certificate_checker",
    "chaplygin",
    "flowlanes",
    "lawproof",
    "nonholonomic",
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


def _resolve(app: Any, env: Any, node: Any, content: Any) -> Any:
    if node.get("refdomain") != "py":
        return None
    target = node["reftarget"]
    thing = found(target if target.split(".")[0] in PACKAGES else f"chaplygin.{target}")
    if thing is None:
        return None
    name = target.rpartition(".")[2]
    if f"reference/names/{name}" in env.all_docs and public(name) is thing:
        from sphinx.util.nodes import make_refnode

        return make_refnode(app.builder, node["refdoc"], f"reference/names/{name}", None, content)
    return content


def setup(app: Any) -> dict[str, Any]:
    """Connect to Sphinx."""
    app.connect("missing-reference", _resolve)
    return {"version": "1", "parallel_read_safe": True}
