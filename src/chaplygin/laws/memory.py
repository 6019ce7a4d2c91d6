"""Verdicts kept on disk between processes, each under a digest of everything it depends on.

A verdict depends on the system, the law, the text of the prover and the versions of the exact
arithmetic; whatever changes one of them makes another digest, so that nothing stale is read.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import tempfile
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import platformdirs
import sympy as sp

from ..statements import Law
from ..system import System
from .verdict import Verdict

__all__ = ["digest", "fingerprint", "recall", "remember", "source_text"]


def folder() -> Path:
    """Where verdicts are kept; the variable CHAPLYGIN_CACHE overrides the user's own place."""
    chosen = os.environ.get("CHAPLYGIN_CACHE")
    home = Path(chosen) if chosen else Path(platformdirs.user_cache_dir("chaplygin"))
    return home / "verdicts"


@cache
def source_text(*rooms: str) -> str:
    """The text of the modules in some rooms of the package, or of the whole package."""
    home = Path(__file__).parent.parent
    roots = [home / room for room in rooms] or [home]
    paths = sorted(p for r in roots for p in ([r] if r.is_file() else r.rglob("*.py")))
    return "".join(f"{path.relative_to(home)}\n{path.read_text()}" for path in paths)


def digest(*parts: str) -> str:
    """A name for a verdict that depends on `parts` and on the versions of the arithmetic."""
    versions = (f"{name} {version(name)}" for name in ("python-flint", "sympy"))
    return hashlib.sha256("\x00".join((*parts, *versions)).encode()).hexdigest()


def fingerprint(system: System, law: Law) -> str:
    """A name for the verdict on a law of a system."""
    shape = (
        system.field,
        system.definitions,
        system.relations,
        tuple((p.symbol, p.default) for p in system.parameters),
        tuple(guard.value for guard in system.guards),
    )
    return digest(_written(shape), _written(law), source_text("laws"))


def _written(value: Any) -> str:
    """Everything a value is made of, as text."""
    if isinstance(value, sp.Basic | sp.MatrixBase):
        return str(sp.srepr(value))
    if isinstance(value, System):
        return _written((value.field, value.definitions, value.relations))
    if isinstance(value, tuple | list):
        return f"({', '.join(map(_written, value))})"
    if isinstance(value, Law):
        parts = {name: v for name, v in vars(value).items() if name != "as_printed"}
        return f"{type(value).__name__}{ {n: _written(v) for n, v in parts.items()} }"
    return repr(value)


def recall(name: str) -> Verdict | None:
    """The verdict kept under a name, if there is one that can be read."""
    try:
        content: dict[str, Any] = json.loads((folder() / f"{name}.json").read_text())
        return Verdict(**content)
    except (OSError, ValueError, TypeError):
        return None


def remember(name: str, verdict: Verdict) -> None:
    """Keep a verdict; where the disk does not allow it, it is computed again next time."""
    content = {n: v for n, v in vars(verdict).items() if n != "certificate"}
    with contextlib.suppress(OSError):
        folder().mkdir(parents=True, exist_ok=True)
        handle, path = tempfile.mkstemp(dir=folder())
        with os.fdopen(handle, "w") as stream:
            json.dump(content, stream)
        Path(path).replace(folder() / f"{name}.json")
