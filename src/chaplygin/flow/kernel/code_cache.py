"""Compiled code kept on disk between processes.

An entry is native code, so it is only ever read as :mod:`chaplygin.core.private_files` reads; its
name is a digest of everything that shaped it (formulas, tolerance, versions, processor).  A cache
that cannot be used is no error: the code is compiled again.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import pickle
import platform
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

from ...core import private_files
from ...core.source_digest import core

__all__ = ["digest", "folder", "remember"]

_KEEP = 200
_AT_HAND = 32


def folder() -> Path:
    """Where compiled code is kept; the variable CHAPLYGIN_CACHE overrides the user's own place."""
    place = private_files.home()
    return place if os.environ.get("CHAPLYGIN_CACHE") else place / "compiled"


def _processor() -> str:
    """What the compiled code was made for, to the last instruction set."""
    info = Path("/proc/cpuinfo")
    if info.exists():
        lines = info.read_text().splitlines()
        return "".join(sorted({x for x in lines if x.startswith(("flags", "Features", "model"))}))
    return platform.processor()


def digest(*parts: str) -> str:
    """A name for code shaped by `parts`, on this machine and with these versions."""
    text = "\x00".join(
        (
            *parts,
            core(),
            platform.platform(),
            platform.python_version(),
            _processor(),
            *(f"{name} {version(name)}" for name in ("chaplygin", "heyoka", "numpy", "sympy")),
        )
    )
    return hashlib.sha256(text.encode()).hexdigest()


def _read(path: Path) -> Any:
    content = private_files.read_private(path)
    if content is None:
        return None
    with contextlib.suppress(OSError):
        path.touch()
    try:
        return pickle.loads(content)
    except Exception:
        # whatever it may be that libraries built otherwise cannot take apart
        return None


def _write(path: Path, entry: Any) -> None:
    if not private_files.write_private(path, pickle.dumps(entry)):
        return
    with contextlib.suppress(OSError):
        entries = sorted(path.parent.glob("*.code"), key=lambda p: p.stat().st_mtime)
        for old in entries[:-_KEEP]:
            old.unlink(missing_ok=True)


def _version(path: Path) -> tuple[int, int] | None:
    """Which version of a file is there; None if there is none."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size


#: Entries of this process, with the version of the file that they were read from or written to.
_at_hand: dict[Path, tuple[Any, tuple[int, int] | None]] = {}


def remember(name: str, make: Callable[[], Any]) -> tuple[Any, bool]:
    """The entry called `name`, and whether it was found; made and kept if it was not."""
    path = folder() / f"{name}.code"
    if path in _at_hand and _at_hand[path][1] == _version(path):
        return _at_hand[path][0], True
    entry = _read(path)
    found = entry is not None
    if not found:
        entry = make()
        _write(path, entry)
    if len(_at_hand) >= _AT_HAND:
        del _at_hand[next(iter(_at_hand))]
    _at_hand[path] = entry, _version(path)
    return entry, found
